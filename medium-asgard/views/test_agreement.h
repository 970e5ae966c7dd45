// All windows of a scene agree with its text once nothing is being computed.
//
// Each function gives the first thing that disagrees, as a sentence; "" means that all agree. The
// motion is that of TestWorkshop: the text alone tells where bodies are at any time.
#pragma once

#include "editing/changes.h"
#include "faults/fault_list.h"
#include "properties/properties_pane.h"
#include "scenelist/scene_list.h"
#include "viewers/editor.h"
#include "views/test_workshop.h"
#include "workbench/playback.h"

#include <QPointer>

#include <algorithm>
#include <string>

namespace views {

// The scene that is shown is the text's, and its faults are.
inline std::string disagreementOfScene(const SceneDocument& document) {
    const script::ReadResult read = theReader().read(document.text());
    if (read.usable != document.sceneIsCurrent())
        return read.usable ? "a text without errors is not shown" : "a text with errors is shown";
    if (read.usable == document.hasErrors())
        return "the errors that are told are not the text's";
    if (!read.usable)
        return {};
    if (document.shownText() != document.text())
        return "the scene is of another text";
    const auto changes = editing::changesBetween({document.shownText(), *document.shown().scene},
                                                 {document.text(), read.scene});
    const bool same = changes.added.empty() && changes.removed.empty() &&
                      std::ranges::none_of(changes.kept, &editing::Kept::modified);
    return same ? std::string() : "the scene is not what the text says";
}

inline std::string sentenceOf(const geometry::Vector& place) {
    std::string all;
    for (Eigen::Index i = 0; i < 3; ++i)
        all += (i > 0 ? ", " : "") + std::to_string(place[i]);
    return all;
}

// While a test waits, events are handled: a window that was to close goes.
template <class Window> QList<QPointer<Window>> guarded(const QList<Window*>& windows) {
    return {windows.begin(), windows.end()};
}

// The handle of a body stands where the text says.
inline std::string disagreementOfPicture(SceneDocument& document,
                                         const QPointer<GraphicalViewer>& viewer) {
    viewer->playback().pause();
    SceneDisplay& display = viewer->display();
    if (!display.isVisible() || display.width() < 2 || display.height() < 2)
        return {};
    display.grab(); // it gets its size
    const bool shown = waitFor([&] {
        if (viewer)
            display.bringUpToDate();
        return !viewer || display.showsNewest();
    });
    if (!viewer)
        return {};
    if (!shown)
        return "a picture of " + std::to_string(document.shown().scene->bodies.size()) +
               " bodies does not come: " + std::to_string(display.width()) + " by " +
               std::to_string(display.height()) + ", at a scale of " +
               std::to_string(display.camera().scale);
    const Shown& wanted = document.shown();
    if (display.drawing().scene != wanted.scene.get() || display.drawing().motion != wanted.motion)
        return "a picture is of another scene or motion";
    for (const render::Handle& handle : display.handles().handles) {
        if (handle.kind != render::HandleKind::position)
            continue;
        if (handle.element >= wanted.scene->bodies.size())
            return "a handle of no body";
        const scene::Body& body = wanted.scene->bodies[handle.element];
        const geometry::Vector& place = body.initialPosition; // handles show the start
        constexpr double near = 1e-6;
        if ((handle.base - place).norm() > near * (1 + place.norm()))
            return std::string(handle.movable ? "" : "un") + "movable body " + body.name +
                   " stands at " + sentenceOf(handle.base) + " and not at " + sentenceOf(place) +
                   " at " + std::to_string(display.time()) + " s";
    }
    return {};
}

inline std::string disagreementOfText(const SceneDocument& document, LanguageViewer& viewer) {
    if (viewer.hasDraft() || viewer.draft() == document.text())
        return {};
    return "a text without a draft is not the document's";
}

inline std::string disagreementOfList(const SceneDocument& document,
                                      const QPointer<SceneList>& list) {
    if (!list->isVisible() || !document.sceneIsCurrent())
        return {};
    const bool named = waitFor([&] { // it follows a moment later
        if (!list)
            return true;
        for (const editing::Element& element : editing::elementsOf(*document.shown().scene)) {
            const QTreeWidgetItem* item = list->itemOf(element);
            if (element.kind == editing::Kind::body &&
                (!item ||
                 item->text(0).toStdString() != document.shown().scene->bodies[element.index].name))
                return false;
        }
        return true;
    });
    return named ? std::string() : "the scene list has other bodies";
}

inline std::string disagreementOfProperties(const SceneDocument& document,
                                            const QPointer<PropertiesPane>& pane) {
    const auto& selected = document.selected();
    if (!pane->isVisible() || selected.size() != 1 || !document.sceneIsCurrent() ||
        selected.front().kind != editing::Kind::body || pane->name().hasFocus() ||
        pane->name().isModified() || !pane->fault().isEmpty()) // what is typed stays
        return {};
    const std::string name = document.shown().scene->bodies[selected.front().index].name;
    const bool shown = waitFor([&] { return !pane || pane->name().text().toStdString() == name; });
    return shown ? std::string() : "the properties are of another body than " + name;
}

// Of all windows.
inline std::string disagreement(Editor& editor) {
    SceneDocument& document = editor.document();
    if (!settle(document))
        return "something is computed without end";
    std::string found = disagreementOfScene(document);
    const auto add = [&](const std::string& one) { found = found.empty() ? one : found; };
    for (const QPointer<GraphicalViewer>& viewer : guarded(editor.graphicalViewers())) {
        if (viewer)
            add(disagreementOfPicture(document, viewer));
        if (viewer)
            for (const auto& list : guarded(viewer->findChildren<SceneList*>()))
                if (list)
                    add(disagreementOfList(document, list));
        if (viewer)
            for (const auto& pane : guarded(viewer->findChildren<PropertiesPane*>()))
                if (pane)
                    add(disagreementOfProperties(document, pane));
    }
    for (const QPointer<LanguageViewer>& viewer : guarded(editor.languageViewers()))
        if (viewer)
            add(disagreementOfText(document, *viewer));
    return found;
}

// All steps back are the first bytes, all forth the last; every view follows.
inline std::string disagreementOfUndo(Editor& editor, const std::string& first) {
    SceneDocument& document = editor.document();
    if (document.canUndo()) { // ends a gesture
        document.undo();
        document.redo();
    }
    const std::string last = document.text();
    int steps = 0;
    for (; document.canUndo(); ++steps)
        document.undo();
    if (document.text() != first)
        return "undo does not lead to the first bytes";
    if (const std::string found = disagreement(editor); !found.empty())
        return "after undo: " + found;
    for (; steps > 0; --steps)
        document.redo();
    return document.text() == last ? disagreement(editor) : "redo does not lead to the last bytes";
}

} // namespace views
