// The request of an entry of exact values: some numbers of one element, as they stand in the text,
// and the change of the text that gives them others.
#pragma once

#include "editing/value_edit.h"
#include "gestures/ground.h"
#include "handles/handles.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace commands {

struct AskedValue {
    std::string text;  // that all of it is about
    std::string title; // "b1: velocity"
    std::string label; // of the change, for undo
    std::string note;  // said below, ""
    std::vector<std::string> names;
    std::vector<double> now;
    std::vector<std::string> written; // "" where nothing stands
    // For these values; exactly the present ones: whether they can be changed at all.
    std::function<editing::Answer(const std::vector<double>&)> answer;
};

// The numbers as fields show them: as they are written, or without the last digits, which are the
// rounding's.
[[nodiscard]] std::vector<std::string> shownNumbers(const AskedValue& asked);
// The numbers typed over them. A field that nobody changed keeps its number to the last bit. None:
// a field has no number.
[[nodiscard]] std::optional<std::vector<double>>
typedNumbers(const AskedValue& asked, const std::vector<std::string>& fields);

// Each is asked of the scene that was read from the text; nothing is previewed or finished.
[[nodiscard]] AskedValue askedOf(const gestures::Ground& of, const render::Handle& handle);
// Of a body whose shape is one part that has sizes (point_edits/shape_points.h); none: of another.
[[nodiscard]] std::optional<AskedValue> askedSize(const gestures::Ground& of, std::size_t body);
// How it bounces, slides and rolls: restitution, friction while it slides and while it sticks, and
// rolling friction.
[[nodiscard]] AskedValue askedSurface(const gestures::Ground& of, std::size_t body);
// Whether it never moves: 1 or 0.
[[nodiscard]] AskedValue askedFixed(const gestures::Ground& of, std::size_t body);

// The handles of an element, shown or not, that exact values can be asked for: one of each
// quantity, and no points of trajectories.
[[nodiscard]] std::vector<render::Handle> handlesOf(const scene::Scene& scene,
                                                    const simulation::MotionPointer& motion,
                                                    const editing::Element& element);

// A body that is led by a trajectory cannot be fixed; "": it can.
[[nodiscard]] std::string whyNotFixed(const scene::Scene& scene, std::size_t body);

} // namespace commands
