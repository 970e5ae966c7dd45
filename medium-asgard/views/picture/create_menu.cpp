#include "picture/create_menu.h"

#include "picture/scene_display.h"
#include "plain/plain.h"
#include "plots/plot_dialog.h"
#include "point_edits/shape_library.h"
#include "script/numbers.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>

#include <algorithm>

namespace views {

namespace {

void askForParameter(SceneDocument& document, SceneDisplay& display) {
    QDialog dialog(&display);
    dialog.setWindowTitle(QObject::tr("New Parameter"));
    auto* form = new QFormLayout(&dialog);
    auto* name = new QLineEdit(QString::fromStdString(editing::unusedName(
        document.text(), *document.shown().scene, editing::Kind::parameter, "p")));
    auto* value = new QLineEdit(QStringLiteral("1"));
    auto* minimum = new QLineEdit(QStringLiteral("0"));
    auto* maximum = new QLineEdit(QStringLiteral("2"));
    form->addRow(QObject::tr("&Name"), name);
    form->addRow(QObject::tr("&Value"), value);
    form->addRow(QObject::tr("From"), minimum);
    form->addRow(QObject::tr("To"), maximum);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    const auto number = [](const QLineEdit* field) {
        return script::decimalNumber(field->text().toStdString());
    };
    const auto check = [=, scene = document.shown().scene] {
        const auto now = number(value), least = number(minimum), most = number(maximum);
        buttons->button(QDialogButtonBox::Ok)
            ->setEnabled(editing::isFreeName(*scene, name->text().toStdString()) && now && least &&
                         most && *least <= *now && *now <= *most);
    };
    for (QLineEdit* field : {name, value, minimum, maximum})
        QObject::connect(field, &QLineEdit::textChanged, &dialog, check);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    check();
    if (dialog.exec() == QDialog::Accepted)
        display.creating().start(newParameter(
            name->text().toStdString(), value->text().trimmed().toStdString(),
            minimum->text().trimmed().toStdString(), maximum->text().trimmed().toStdString()));
}

// As large as it is seen well where it is put.
template <class Shape> void startBody(SceneDisplay& display, const Shape& shape) {
    Recipe recipe = newBody(shape);
    recipe.sized = [shape](double times) { return newBody(shape, times); };
    display.creating().start(std::move(recipe));
}

void fillBodies(QMenu* menu, SceneDocument& document, SceneDisplay& display) {
    menu->clear();
    menu->addAction(QObject::tr("New &Sphere"), &display,
                    [&display] { startBody(display, BasicShape::sphere); });
    menu->addAction(QObject::tr("New &Box"), &display,
                    [&display] { startBody(display, BasicShape::box); });
    const std::pair<QString, const char*> round[] = {{QObject::tr("New &Wheel"), "Wheel"},
                                                     {QObject::tr("New &Capsule"), "Capsule"},
                                                     {QObject::tr("New Co&ne"), "Cone"},
                                                     {QObject::tr("New &Tube"), "Tube"},
                                                     {QObject::tr("New B&owl"), "Bowl"}};
    for (const auto& [label, name] : round)
        menu->addAction(
            plain::ours(label), &display,
            [&display, &shape = editing::libraryShape(name)] { startBody(display, shape); });
    menu->addAction(plain::ours(QObject::tr("Two Wheels on an A&xle")), &display,
                    [&display] { display.creating().start(newWheels()); });
    menu->actions().back()->setToolTip(plain::tip(
        QObject::tr("At the sides of a body, on hinges: two such pairs make a car of a box")));
    menu->addAction(plain::ours(QObject::tr("New &Floor Below All")), &display,
                    [&display] { display.creating().start(newFloor()); });
    QMenu* library = menu->addMenu(QObject::tr("New from the &Library"));
    for (const editing::LibraryShape& shape : editing::shapeLibrary())
        library->addAction(plain::caption(QString::fromStdString(shape.name)), &display,
                           [&display, &shape] { startBody(display, shape); });
    menu->addSeparator(); // what grows stands below: the rest stays where the hand knows it
    for (const scene::ShapeSet& set : document.shown().scene->shapeSets)
        menu->addAction(plain::caption(QString::fromStdString(set.name)), &display,
                        [&document, &display, name = set.name] {
                            display.creating().start([&document, name] {
                                const auto* now =
                                    scene::findShapeSet(*document.shown().scene, name);
                                return newBody(name, now ? now->parts : std::vector<scene::Part>());
                            });
                        });
}

} // namespace

void askForPlot(SceneDocument& document, SceneDisplay& display) {
    const auto& selected = document.selected();
    PlotDialog dialog(document.shown(), &display,
                      selected.empty() ? std::nullopt : std::optional(selected.front()));
    if (dialog.exec() == QDialog::Accepted)
        display.creating().start(
            newPlot(dialog.expression().toStdString(), dialog.name().toStdString()));
}

Recipe newWeight(SceneDisplay& display) {
    return newWeight(
        display.arrowLength(false), [&display](std::size_t body) { return display.massOf(body); },
        usualGravity(*display.drawing().scene));
}

void addJointTypes(QMenu* menu,
                   const std::function<void(const QString&, std::function<Recipe()>)>& add) {
    const auto joint = [&](const QString& label, const QString& tip, scene::JointType type) {
        add(label, [type] { return newJoint(type); });
        menu->actions().back()->setToolTip(plain::tip(tip));
    };
    menu->setToolTipsVisible(true);
    joint(QObject::tr("&Hinge"), QObject::tr("It turns about one axis: a pendulum, a door"),
          scene::JointType::hinge);
    joint(QObject::tr("&Slider"), QObject::tr("It slides along one line: a drawer, a piston"),
          scene::JointType::slider);
    joint(QObject::tr("&Ball"), QObject::tr("It turns any way about one point: a shoulder"),
          scene::JointType::ball);
    joint(QObject::tr("&Fixed"), QObject::tr("Two bodies move as one"), scene::JointType::fixed);
    joint(QObject::tr("&Distance"), QObject::tr("A massless rod between two points"),
          scene::JointType::distance);
    joint(QObject::tr("&Cylindrical"),
          QObject::tr("It slides along one line and turns about it: a piston rod"),
          scene::JointType::cylindrical);
    joint(QObject::tr("&Universal"),
          QObject::tr("It turns about two axes that cross: the joint of a drive shaft"),
          scene::JointType::universal);
    joint(QObject::tr("&Planar"), QObject::tr("It slides and turns in one plane: an air puck"),
          scene::JointType::planar);
    joint(QObject::tr("Scre&w"), QObject::tr("It turns as it slides: a screw, a vice"),
          scene::JointType::screw);
    add(QObject::tr("&Gear"), newGear);
    menu->actions().back()->setToolTip(
        plain::tip(QObject::tr("Two wheels, or a wheel and a rack, roll on each other")));
}

void buildCreateMenu(QMenu* menu, SceneDocument& document, SceneDisplay& display) {
    QMenu* bodies = menu->addMenu(QObject::tr("&Body"));
    bodies->setObjectName("createBody");
    bodies->setToolTipsVisible(true);
    QObject::connect(bodies, &QMenu::aboutToShow, bodies,
                     [bodies, &document, &display] { fillBodies(bodies, document, display); });
    fillBodies(bodies, document, display);
    const auto add = [&](QMenu* to, const QString& label, std::function<Recipe()> recipe) {
        to->addAction(plain::ours(label), &display,
                      [&display, recipe = std::move(recipe)] { display.creating().start(recipe); });
    };
    QMenu* forces = menu->addMenu(QObject::tr("&Force"));
    forces->setObjectName("createForce");
    forces->setToolTipsVisible(true);
    add(forces, QObject::tr("&Constant"),
        [&display] { return newForce(false, display.arrowLength(false)); });
    add(forces, QObject::tr("&Gravity for One Body"), [&display] { return newWeight(display); });
    add(forces, QObject::tr("Gravity for the &Selected Bodies"), [&document, &display] {
        std::vector<std::size_t> selected;
        for (const editing::Element& element : document.selected())
            if (element.kind == editing::Kind::body)
                selected.push_back(element.index);
        return weightFor(selected, usualGravity(*display.drawing().scene));
    });
    add(forces, QObject::tr("Gravity for &All Bodies"),
        [&display] { return weightForAll(usualGravity(*display.drawing().scene)); });
    add(forces, QObject::tr("Attraction of T&wo Bodies"), newAttraction);
    add(forces, QObject::tr("Attraction of All &Bodies"), attractionOfAll);
    add(forces, QObject::tr("&Orbit Round a Body"), newOrbit);
    forces->actions().back()->setToolTip(
        plain::tip(QObject::tr("Both attract each other, and one goes round the other in a circle, "
                               "as a planet round its sun")));
    add(forces, QObject::tr("By a &Trajectory"), [] { return newTrajectoryForce(false); });
    QMenu* torques = menu->addMenu(QObject::tr("&Torque"));
    add(torques, QObject::tr("&Constant"),
        [&display] { return newForce(true, display.arrowLength(true)); });
    add(torques, QObject::tr("By a &Trajectory"), [] { return newTrajectoryForce(true); });
    QMenu* joints = menu->addMenu(QObject::tr("Jo&int"));
    joints->setObjectName("createJoint");
    addJointTypes(joints, [&](const QString& label, std::function<Recipe()> recipe) {
        add(joints, label, std::move(recipe));
    });
    add(menu, QObject::tr("&Rope"), newRope);
    menu->actions().back()->setObjectName("createRope");
    menu->actions().back()->setToolTip(
        plain::tip(QObject::tr("It pulls and never pushes, through points and around wheels")));
    QMenu* springs = menu->addMenu(QObject::tr("&Spring"));
    springs->setObjectName("createSpring");
    add(springs, QObject::tr("To Another &Body"), [] { return newSpring(Wanted::body); });
    add(springs, QObject::tr("To a &Point"), [] { return newSpring(Wanted::point); });
    QMenu* links = menu->addMenu(QObject::tr("&Link"));
    links->setObjectName("createLink");
    links->setToolTipsVisible(true);
    links->menuAction()->setToolTip(plain::tip(
        QObject::tr("A stiff spring, which gives a little. A hinge, a rail or a rod is a joint")));
    add(links, QObject::tr("Body to &Body"), [] { return newLink(Wanted::body); });
    add(links, QObject::tr("Body to &Point"), [] { return newLink(Wanted::point); });
    add(links, QObject::tr("Body to &Trajectory"), [] { return newLink(Wanted::trajectory); });
    QMenu* lights = menu->addMenu(QObject::tr("Li&ght Source"));
    add(lights, QObject::tr("&Directional"), [] { return newLight(false); });
    add(lights, QObject::tr("&Point"), [] { return newLight(true); });
    menu->addSeparator();
    add(menu, QObject::tr("&Measure a Distance"), measure);
    menu->addSeparator();
    add(menu, QObject::tr("Tra&jectory"), newTrajectory);
    add(menu, QObject::tr("&Attach Trajectory"), attachTrajectory);
    menu->addSeparator();
    menu->addAction(QObject::tr("&Parameter…"), &display,
                    [&document, &display] { askForParameter(document, display); });
    menu->addAction(QObject::tr("Pl&ot…"), &display,
                    [&document, &display] { askForPlot(document, display); });
}

} // namespace views
