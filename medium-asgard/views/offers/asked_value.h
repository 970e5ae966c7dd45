// The request of an entry of exact values: some numbers of one element, as they stand in the text,
// and the change of the text that gives them others.
#pragma once

#include "editing/value_edit.h"
#include "handles/handles.h"
#include "workbench/scene_document.h"

#include <QStringList>

namespace views {

struct AskedValue {
    std::string text; // that all of it is about
    QString title;    // "b1: velocity"
    QString label;    // of the change, for undo
    QString note;     // said below, ""
    QStringList names;
    std::vector<double> now;
    std::vector<std::string> written; // "" where nothing stands
    // For these values; exactly the present ones: whether they can be changed at all.
    std::function<editing::Answer(const std::vector<double>&)> answer;
};

// Each is asked of the scene that was read from the document's text.
[[nodiscard]] AskedValue askedOf(SceneDocument& document, const Shown& of,
                                 const render::Handle& handle);
// Of a body whose shape is one sphere (its radius) or one box (its edges); none: of another.
[[nodiscard]] std::optional<AskedValue> askedSize(SceneDocument& document, std::size_t body);
// How it bounces, slides and rolls: restitution, friction while it slides and while it sticks, and
// rolling friction.
[[nodiscard]] AskedValue askedSurface(SceneDocument& document, std::size_t body);
// Whether it never moves: 1 or 0.
[[nodiscard]] AskedValue askedFixed(SceneDocument& document, std::size_t body);

// A body that is led by a trajectory cannot be fixed; "": it can.
[[nodiscard]] QString whyNotFixed(const scene::Scene& scene, std::size_t body);

} // namespace views
