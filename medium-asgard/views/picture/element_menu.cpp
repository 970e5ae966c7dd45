#include "picture/element_menu.h"

#include "commands/beside.h"
#include "gestures/handle_meaning.h"
#include "picture/create_menu.h"
#include "picture/scene_display.h"
#include "plain/plain.h"

#include <QMenu>

#include <algorithm>

namespace views {

using editing::Element;
using editing::Kind;
using render::HandleKind;

namespace {

constexpr double reach = 14; // pixels, as of a drag

class Building {
public:
    Building(QMenu& menu, SceneDocument& document, SceneDisplay& display, const MenuPlace& place,
             const MenuWindows& windows)
        : menu_(menu), document_(document), display_(display), place_(place), windows_(windows) {}

    void element();
    void background();

private:
    [[nodiscard]] const scene::Scene& scene() const { return *document_.shown().scene; }
    void values();
    void body();
    void trajectory();
    void charts();
    void addPlots();
    // A Create command that begins with the body.
    void create(QMenu* menu, const QString& label, std::function<Recipe()> recipe);

    QMenu& menu_;
    SceneDocument& document_;
    SceneDisplay& display_;
    const MenuPlace& place_;
    const MenuWindows& windows_;
    std::optional<Creating::Aim> aim_; // at the body
};

// Each handle of the element asks for its exact value; those of its kind that are not shown come
// from a body alone.
void Building::values() {
    std::vector<render::Handle> handles;
    for (const render::Handle& handle : display_.handles().handles)
        if (gestures::elementOf(handle) == *place_.element && handle.movable &&
            (handle.kind != HandleKind::trajectoryPoint ||
             (place_.handle && handle.part == place_.handle->part)))
            handles.push_back(handle);
    if (handles.empty() && place_.handle)
        handles.push_back(*place_.handle);
    for (const render::Handle& handle : handles) {
        QAction* action = menu_.addAction(
            QObject::tr("Exact %1…")
                .arg(plain::caption(QString::fromStdString(gestures::quantityOf(scene(), handle)))),
            &display_, [&display = display_, handle] {
                display.editing().choose(handle.kind, handle.element, handle.part);
                display.editing().openEntry();
            });
        if (place_.handle && handle.kind == place_.handle->kind &&
            handle.part == place_.handle->part)
            menu_.setDefaultAction(action);
    }
}

void Building::create(QMenu* menu, const QString& label, std::function<Recipe()> recipe) {
    menu->addAction(plain::ours(label), &display_,
                    [&display = display_, recipe = std::move(recipe), aim = aim_] {
                        display.creating().start(recipe, aim);
                    });
}

void Building::body() {
    SceneDisplay& display = display_;
    const std::size_t index = place_.element->index;
    const scene::Body& one = scene().bodies[index];
    aim_ = display.creating().aimAt(*place_.element, place_.position);
    menu_.addAction(QObject::tr("&Size…"), &display_,
                    [&display, index] { display.editing().openSize(index); });
    menu_.addAction(QObject::tr("S&urface…"), &display_,
                    [&display, index] { display.editing().openSurface(index); });
    QAction* fixed = menu_.addAction(QObject::tr("Fi&xed"), &display_, [&display, index](bool on) {
        display.editing().setFixed(index, on);
    });
    fixed->setCheckable(true);
    fixed->setChecked(one.fixed);
    menu_.addAction(QObject::tr("S&hape Editor"), &display_,
                    [&display, shape = QString::fromStdString(one.shape)] {
                        Q_EMIT display.editing().shapeWanted(shape);
                    });
    menu_.addSeparator();
    QMenu* force = menu_.addMenu(QObject::tr("New &Force"));
    create(force, QObject::tr("&Constant"),
           [&display] { return newForce(false, display.arrowLength(false)); });
    create(force, QObject::tr("&Gravity"), [&display] { return newWeight(display); });
    create(force, QObject::tr("By a &Trajectory"), [] { return newTrajectoryForce(false); });
    QMenu* torque = menu_.addMenu(QObject::tr("New &Torque"));
    create(torque, QObject::tr("&Constant"),
           [&display] { return newForce(true, display.arrowLength(true)); });
    create(torque, QObject::tr("By a &Trajectory"), [] { return newTrajectoryForce(true); });
    QMenu* joint = menu_.addMenu(QObject::tr("New &Joint"));
    addJointTypes(joint, [&](const QString& label, std::function<Recipe()> recipe) {
        create(joint, label, std::move(recipe));
    });
    QMenu* spring = menu_.addMenu(QObject::tr("New Sp&ring"));
    create(spring, QObject::tr("To Another &Body"), [] { return newSpring(Wanted::body); });
    create(spring, QObject::tr("To a &Point"), [] { return newSpring(Wanted::point); });
    QMenu* link = menu_.addMenu(QObject::tr("New &Link"));
    create(link, QObject::tr("To Another &Body"), [] { return newLink(Wanted::body); });
    create(link, QObject::tr("To a &Point"), [] { return newLink(Wanted::point); });
    create(link, QObject::tr("To a &Trajectory"), [] { return newLink(Wanted::trajectory); });
    create(&menu_, QObject::tr("&Attach Trajectory"), attachTrajectory);
}

void Building::trajectory() {
    if (place_.handle && place_.handle->kind == HandleKind::trajectoryPoint)
        menu_.addAction(QObject::tr("New &Point After It"), &display_,
                        [&display = display_] { display.editing().addPointAfterMarked(); });
    menu_.addAction(QObject::tr("&Trajectory Editor"), &display_,
                    [open = windows_.openTrajectoryEditor] { open(); });
}

void Building::element() {
    const Element element = *place_.element;
    const std::string name = editing::describe(scene(), element);
    menu_.addSection(QString::fromStdString(name));
    values();
    if (element.kind == Kind::body)
        body();
    if (element.kind == Kind::trajectory)
        trajectory();
    charts();
    menu_.addSeparator();
    if (element.kind == Kind::body)
        menu_.addAction(QObject::tr("Hid&e"), &display_,
                        [&display = display_, element] { display.hide({element}); });
    if (windows_.duplicate)
        menu_.addAction(QObject::tr("Dupl&icate"), &display_, windows_.duplicate);
    if (windows_.copy)
        menu_.addAction(QObject::tr("Cop&y"), &display_, windows_.copy);
    menu_.addAction(QObject::tr("Show in the Te&xt"), &display_, [show = windows_.showText] {
        show(); // it is selected, and so is its command
    });
    const bool isPoint = place_.handle && place_.handle->kind == HandleKind::trajectoryPoint;
    menu_.addAction(isPoint ? QObject::tr("&Remove Point") : QObject::tr("&Delete"), &display_,
                    [&display = display_] { display.editing().deleteMarked(); });
    if (isPoint)
        menu_.addAction(QObject::tr("&Delete the Trajectory"), &display_,
                        [&display = display_, element] { display.editing().remove({element}); });
}

void Building::charts() {
    const std::vector<commands::Quantity> all = commands::quantitiesOf(scene(), *place_.element);
    if (all.empty())
        return;
    SceneDisplay& display = display_;
    QMenu* plots = menu_.addMenu(QObject::tr("New &Plot of"));
    QMenu* beside = menu_.addMenu(QObject::tr("Show &Beside It"));
    for (const commands::Quantity& one : all) {
        plots->addAction(plain::ours(QString::fromStdString(one.label)), &display_,
                         [&display, expression = one.expression, name = one.name] {
                             display.creating().start(newPlot(expression, name));
                         });
        QAction* meter = beside->addAction(
            plain::ours(QString::fromStdString(one.label)), &display_, [&display, one] {
                if (const QString why = display.meters().toggle(one); !why.isEmpty())
                    display.editing().say(why);
            });
        meter->setCheckable(true);
        meter->setChecked(commands::isBeside(scene(), one));
    }
}

// What is charted is no part of a picture; here it can be got at all the same.
void Building::addPlots() {
    const auto& plots = scene().plots;
    if (plots.empty())
        return;
    QMenu* all = menu_.addMenu(QObject::tr("P&lots"));
    for (std::size_t i = 0; i < plots.size(); ++i) {
        const Element element = {Kind::plot, i};
        QMenu* one = all->addMenu(
            plain::caption(QString::fromStdString(editing::describe(scene(), element))));
        one->addAction(QObject::tr("&Chart"), &display_, [open = windows_.openPlots] { open(); });
        one->addAction(QObject::tr("Show in the Te&xt"), &display_,
                       [&document = document_, element, show = windows_.showText] {
                           document.select({element});
                           show();
                       });
        one->addAction(QObject::tr("&Delete"), &display_,
                       [&display = display_, element] { display.editing().remove({element}); });
    }
}

void Building::background() {
    buildCreateMenu(menu_.addMenu(QObject::tr("&Create")), document_, display_);
    addPlots();
    menu_.addSeparator();
    if (!display_.hidden().empty())
        menu_.addAction(QObject::tr("Sho&w All Bodies"), &display_,
                        [&display = display_] { display.setHidden({}); });
    if (windows_.paste)
        menu_.addAction(QObject::tr("P&aste"), &display_, windows_.paste);
    menu_.addAction(QObject::tr("&Select All"), &display_,
                    [&display = display_] { display.selecting().selectAll(); });
    menu_.addAction(QObject::tr("Centre of &Rotation Here"), &display_,
                    [&display = display_, at = place_.position] { display.centerAt(at); });
    menu_.addAction(QObject::tr("&Frame All"), &display_,
                    [&display = display_] { display.frameAll(); });
}

// While its scene changes it stays, unless what it is about may be another element.
void closeWithElement(QMenu& menu, SceneDocument& document, const Element& element) {
    const auto before = document.shown().scene;
    QObject::connect(&document, &SceneDocument::sceneChanged, &menu,
                     [&menu, &document, before, element] {
                         const scene::Scene& now = *document.shown().scene;
                         if (countOf(*before, element.kind) != countOf(now, element.kind) ||
                             editing::nameOf(*before, element) != editing::nameOf(now, element))
                             menu.close();
                     });
}

} // namespace

MenuPlace menuPlaceAt(SceneDocument& document, SceneDisplay& display, const QPointF& position) {
    MenuPlace place{position, {}, {}};
    const Eigen::Vector2d pixels = display.inPixels(position);
    const render::HandleSet& set = display.handles();
    const gestures::Sight sight = display.sight();
    const double near = reach * display.devicePixelRatioF();
    if (const auto handle = gestures::handleAt(set, sight, pixels, near)) {
        place.handle = set.handles[*handle];
        place.element = gestures::elementOf(*place.handle);
    } else if (const auto joint = gestures::jointAt(display.drawn(), sight, pixels, near)) {
        place.handle = joint;
        place.element = gestures::elementOf(*joint);
    } else if (const auto body = gestures::bodyAt(display.drawn(), sight, pixels)) {
        place.element = Element{Kind::body, body->body};
        const auto& start = document.shown().scene->bodies[body->body].initialPosition;
        place.handle = render::Handle{HandleKind::position, body->body, 0, start, start};
    } else if (display.display().trajectories) {
        if (const auto path = gestures::trajectoryAt(*document.shown().scene, sight, pixels, near))
            place.element = Element{Kind::trajectory, *path};
    }
    return place;
}

MenuPlace menuPlaceOfSelection(SceneDocument& document, SceneDisplay& display) {
    MenuPlace place{QRectF(display.rect()).center(), {}, display.editing().marked()};
    if (place.handle) {
        place.element = gestures::elementOf(*place.handle);
        place.position = display.fromPixels(display.sight().pixels(place.handle->place));
    } else if (!document.selected().empty()) {
        place.element = document.selected().front();
    }
    return place;
}

std::unique_ptr<QMenu> elementMenu(SceneDocument& document, SceneDisplay& display,
                                   const MenuPlace& place, const MenuWindows& windows) {
    auto menu = std::make_unique<QMenu>(&display);
    Building building(*menu, document, display, place, windows);
    if (place.element)
        building.element();
    else
        building.background();
    if (place.element)
        closeWithElement(*menu, document, *place.element);
    return menu;
}

} // namespace views
