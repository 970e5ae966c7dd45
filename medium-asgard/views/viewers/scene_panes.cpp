#include "viewers/scene_panes.h"

#include "faults/fault_list.h"
#include "picture/scene_display.h"
#include "properties/properties_pane.h"
#include "scenelist/scene_list.h"
#include "workbench/playback.h"

namespace views {

namespace {

void openValues(Panes& panes, SceneDocument& document, const editing::Element& element) {
    document.select({element});
    panes.show("properties");
    if (auto* pane = qobject_cast<PropertiesPane*>(panes.content("properties")))
        pane->begin();
}

} // namespace

void addScenePanes(
    Panes& panes, SceneDocument& document, SceneDisplay& display, Playback& playback,
    const Windows& windows,
    const std::function<void(const editing::Element&, const QPoint& global)>& showMenu) {
    const auto remove = [&display](std::vector<editing::Element> elements) {
        display.editing().remove(std::move(elements));
    };
    const auto open = [&panes, &document](const editing::Element& element) {
        openValues(panes, document, element);
    };
    panes.add(
        {"properties", QObject::tr("Properties"), Qt::RightDockWidgetArea,
         [&document, &display, windows, remove] {
             auto* pane =
                 new PropertiesPane(document, {windows.showText, windows.openShapeEditor, remove});
             const auto look = [&display, pane] {
                 pane->setUsualAxis(geometry::Vector::Unit(display.sight().facing()));
             };
             QObject::connect(&display, &SceneDisplay::cameraChanged, pane, look);
             QObject::connect(pane, &PropertiesPane::added, &display, &SceneDisplay::showWhole);
             look();
             return pane;
         },
         "status", QKeySequence(Qt::Key_F4)});
    panes.add({"sceneList",
               QObject::tr("Scene List"),
               Qt::LeftDockWidgetArea,
               [&document, &display, open, showMenu, remove] {
                   const auto nameOf = [&document](const editing::Element& body) {
                       return editing::nameOf(*document.shown().scene, body);
                   };
                   const auto isHidden = [&display, nameOf](const editing::Element& body) {
                       return display.hidden().contains(nameOf(body));
                   };
                   const auto hide = [&display, nameOf](const editing::Element& body, bool hidden) {
                       std::set<std::string> names = display.hidden();
                       if (hidden)
                           names.insert(nameOf(body));
                       else
                           names.erase(nameOf(body));
                       display.setHidden(std::move(names));
                   };
                   auto* list = new SceneList(document, {open, showMenu, remove, isHidden, hide});
                   QObject::connect(&display, &SceneDisplay::hiddenChanged, list,
                                    &SceneList::showHidden);
                   return list;
               },
               {},
               QKeySequence(Qt::SHIFT | Qt::Key_F4)});
    panes.add({"faults", QObject::tr("Faults"), Qt::BottomDockWidgetArea,
               [&document, &playback, show = windows.showText] {
                   return new FaultList(document,
                                        {[&playback](double time) { playback.seek(time); }, show});
               },
               "plots", // beside it there would be no room for words
               QKeySequence(Qt::CTRL | Qt::Key_F9)});
}

} // namespace views
