// Create > Body > Two Wheels on an Axle: one at either side of a body, each on a hinge of its own.
//
// The axle goes through the body along that of its axes that looks at the viewer most, by round
// numbers, and as high as an axle that is there. Wheels reach below the body and leave room for a
// second pair; all wheels of a body have one shape. Where they would be inside of what the body
// stands on, the body is raised: it stands on them then.
#include "editing/number_text.h"
#include "framing/extent.h"
#include "gestures/picking.h"
#include "gestures/snapping.h"
#include "gestures/standing.h"
#include "physics/mass.h"
#include "point_edits/shape_edit.h"
#include "recipes/recipe_words.h"
#include "recipes/recipes.h"
#include "scene/shape_of.h"

#include <QObject>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace views {

namespace {

using editing::Kind;
using editing::NewElement;
using Eigen::Index;

// A cylinder about an axis of the body.
struct Wheel {
    std::string shape;                 // "": one that is not there yet
    const scene::Body* like = nullptr; // one that is there
    double radius = 0, width = 0;
    Vector middle; // in the frame of the body
};

struct Axle {
    std::size_t body = 0;
    Index along = 2, up = 1;
    Wheel wheel;        // in its middle plane
    Vector first, last; // the middles of both wheels
    bool raises = false;
    Vector raised; // the body's place, world
};

Index largest(const Vector& v) {
    Index axis = 0;
    v.cwiseAbs().maxCoeff(&axis);
    return axis;
}

// Those that turn about this axis of the body.
std::vector<Wheel> wheelsOf(const scene::Scene& scene, const scene::Body& body, Index along) {
    std::vector<Wheel> wheels;
    for (const scene::Joint& joint : scene.joints) {
        const scene::Body* one = scene::findBody(scene, joint.body1);
        const scene::ShapeSet* set = one ? scene::findShapeSet(scene, one->shape) : nullptr;
        if (joint.type != scene::JointType::hinge || joint.body2 != body.name || !set ||
            set->parts.size() != 1 || largest(joint.axis) != along)
            continue;
        if (const auto* round = std::get_if<scene::CylinderShape>(&set->parts.front().shape))
            wheels.push_back(
                {set->name, one, round->radius, round->height,
                 body.initialAttitude.conjugate() * (one->initialPosition - body.initialPosition)});
    }
    return wheels;
}

scene::Part partOf(const Wheel& wheel, Index along) {
    scene::Part part;
    part.shape = scene::CylinderShape{wheel.radius, wheel.width};
    constexpr double quarter = std::numbers::pi / 2;
    if (along != 1) // a cylinder's axis is y
        part.rotation = along == 2 ? Vector(quarter, 0, 0) : Vector(0, 0, quarter);
    return part;
}

double rounded(double length) {
    return std::stod(editing::numberText(length, editing::decimalStep(0.1 * length)));
}

Wheel usualWheel(const Vector& sizes, Index along) {
    const double one = sizes[(along + 1) % 3], other = sizes[(along + 2) % 3];
    Wheel wheel;
    wheel.radius = rounded(std::min(0.6 * std::min(one, other), 0.2 * std::max(one, other)));
    wheel.width = rounded(0.5 * wheel.radius);
    return wheel;
}

// The pointer's place on the body, by round numbers.
Vector placeOn(const Indicated& shown, const geometry::Box& box, const Axle& axle,
               const std::vector<Wheel>& others) {
    constexpr double apart = 5, reach = 12; // pixels
    const double step = gestures::roundStep(apart * shown.resolution);
    Vector place = shown.onBody;
    for (Index i = 0; i < 3; ++i)
        place[i] = std::clamp(step * std::round(place[i] / step), box.min()[i], box.max()[i]);
    place[axle.along] = box.center()[axle.along];
    for (const Wheel& other : others)
        if (std::abs(shown.onBody[axle.up] - other.middle[axle.up]) < reach * shown.resolution)
            place[axle.up] = other.middle[axle.up];
    return place;
}

// Raised so far that its wheels reach as low as the body did, where they would be inside of
// something. What joints hold stays: it would not hang together any more.
void raise(const scene::Scene& scene, Axle& axle, const geometry::Box& box, const Vector& upwards) {
    const scene::Body& body = scene.bodies[axle.body];
    axle.raised = body.initialPosition;
    const double sign = upwards[axle.up] < 0 ? -1 : 1;
    const double bottom = sign > 0 ? box.min()[axle.up] : -box.max()[axle.up];
    const double below = axle.wheel.radius - (sign * axle.wheel.middle[axle.up] - bottom);
    const bool isHeld = std::ranges::any_of(scene.joints, [&](const scene::Joint& joint) {
        return joint.body1 == body.name || joint.body2 == body.name;
    });
    if (below <= 0 || body.fixed || isHeld)
        return;
    scene::ShapeSet set;
    set.parts = {partOf(axle.wheel, axle.along)};
    const auto made = scene::shapeOf(set);
    const auto* shape = std::get_if<geometry::Shape>(&made);
    const geometry::Pose pose{body.initialPosition, body.initialAttitude};
    axle.raises =
        shape && std::ranges::any_of(std::array{axle.first, axle.last}, [&](const Vector& middle) {
            return gestures::isInsideOfOthers(scene, *shape, {pose.toWorld(middle), pose.attitude},
                                              axle.body);
        });
    if (axle.raises)
        axle.raised += pose.attitude * (sign * below * Vector::Unit(axle.up));
}

// None: the body has no sides, or never moves.
std::optional<Axle> axleAt(const scene::Scene& scene, const Indicated& shown) {
    const scene::Body& body = scene.bodies[*shown.body];
    const gestures::ShapePointer shape = gestures::shapeOf(scene, body.name);
    if (!shape || gestures::isEndless(*shape) || body.fixed)
        return std::nullopt;
    const geometry::Box box = geometry::bounds(*shape);
    Axle axle;
    axle.body = *shown.body;
    axle.along = largest(shown.attitude.conjugate() * shown.sight);
    Vector upwards = shown.attitude.conjugate() * render::upOf(scene);
    upwards[axle.along] = 0;
    axle.up = upwards.norm() > 1e-6 ? largest(upwards) : (axle.along + 1) % 3;
    const std::vector<Wheel> others = wheelsOf(scene, body, axle.along);
    axle.wheel = others.empty() ? usualWheel(box.sizes(), axle.along) : others.front();
    axle.wheel.middle = placeOn(shown, box, axle, others);
    axle.first = axle.last = axle.wheel.middle;
    axle.first[axle.along] = box.max()[axle.along] + axle.wheel.width / 2;
    axle.last[axle.along] = box.min()[axle.along] - axle.wheel.width / 2;
    raise(scene, axle, box, upwards);
    return axle;
}

Judged judgeWheels(const scene::Scene& scene, const std::vector<Indicated>&,
                   const Indicated& next) {
    const QString name = QString::fromStdString(scene.bodies[*next.body].name);
    if (scene.bodies[*next.body].fixed) // a slope, say, under the car that was meant
        return {QObject::tr("%1 is fixed and rolls nowhere: wheels are for a body that moves.")
                    .arg(name),
                false};
    const auto axle = axleAt(scene, next);
    if (!axle)
        return {QObject::tr("%1 has no sides for wheels.").arg(name), false};
    const Vector& middle = axle->wheel.middle;
    const std::string place = listed(middle, 1e-3 * axle->wheel.radius);
    return {QObject::tr("%1: an axle at %2, wheels of radius %3")
                    .arg(name, QString::fromStdString(place.substr(1, place.size() - 2)),
                         QString::fromStdString(
                             editing::numberText(axle->wheel.radius, 1e-3 * axle->wheel.radius))) +
                (axle->raises ? QObject::tr("; it stands on them") : QString()),
            true};
}

std::vector<Outline> outlinesOfWheels(const scene::Scene& scene, const Indicated& next) {
    std::vector<Outline> made;
    if (const auto axle = next.body ? axleAt(scene, next) : std::nullopt) {
        const geometry::Pose pose{axle->raised, scene.bodies[axle->body].initialAttitude};
        for (const Vector& middle : {axle->first, axle->last})
            made.push_back(
                {{partOf(axle->wheel, axle->along)}, {pose.toWorld(middle), pose.attitude}});
    }
    return made;
}

// It goes with the body.
void addVelocity(NewElement& wheel, const scene::Scene& scene, const scene::Body& body,
                 const Vector& middle) {
    constexpr double fine = 1e-9;
    const Vector& spin = body.initialAngularVelocity;
    scene::ShapeReader shapes;
    const auto mass = physics::MassReader(scene, shapes).massOf(body);
    const auto* known = std::get_if<physics::BodyMass>(&mass);
    const Vector center = known ? known->centroid : Vector(Vector::Zero());
    const Vector velocity =
        body.initialVelocity + spin.cross(body.initialAttitude * (middle - center));
    if (velocity.norm() > fine)
        wheel.words.insert(wheel.words.end(), {"-init_dpos", listed(velocity, fine)});
    if (spin.norm() > fine)
        wheel.words.insert(wheel.words.end(), {"-init_drot", listed(spin, fine)});
}

std::string writtenColor(const std::string& text, const scene::Body* body) {
    for (const scene::Argument& one :
         body ? body->source.arguments : std::vector<scene::Argument>())
        if (one.option == "-color" && one.literal)
            return text.substr(one.word.from, one.word.to - one.word.from);
    return {};
}

std::vector<NewElement> makeWheels(const std::string& text, const scene::Scene& scene,
                                   const std::vector<Indicated>& shown) {
    const auto axle = axleAt(scene, shown[0]);
    if (!axle)
        return {};
    const scene::Body& body = scene.bodies[axle->body];
    const geometry::Pose pose{axle->raised, body.initialAttitude};
    constexpr double fine = 1e-9; // so that they touch
    std::vector<NewElement> made;
    std::string shape = axle->wheel.shape;
    if (shape.empty()) {
        shape = editing::unusedName(text, scene, Kind::shapeSet, "wheel");
        made.push_back({Kind::shapeSet,
                        shape,
                        {"-desc", editing::descriptionText({partOf(axle->wheel, axle->along)})},
                        {}});
    }
    std::vector<NewElement> joints;
    std::vector<std::string> taken{shape};
    for (const Vector& middle : {axle->first, axle->last}) {
        NewElement wheel{Kind::body,
                         editing::unusedName(text, scene, Kind::body, "wheel", taken),
                         placeWords(pose.toWorld(middle), pose.attitude, fine),
                         {{Kind::body, axle->body}},
                         shape};
        addVelocity(wheel, scene, body, middle);
        const std::string color = writtenColor(text, axle->wheel.like);
        addRoomWords(wheel, scene, false, !color.empty());
        if (!color.empty())
            wheel.words.insert(wheel.words.end(), {"-color", color});
        taken.push_back(wheel.name);
        NewElement hinge{Kind::joint,
                         editing::unusedName(text, scene, Kind::joint, "hinge", taken),
                         {"-type", "hinge", "-body1", wheel.name, "-body2", body.name},
                         {}};
        if (axle->along != 2)
            hinge.words.insert(hinge.words.end(), {"-axis", listed(Vector::Unit(axle->along), 1)});
        taken.push_back(hinge.name);
        made.push_back(std::move(wheel));
        joints.push_back(std::move(hinge));
    }
    made.insert(made.end(), joints.begin(), joints.end());
    return made;
}

std::vector<editing::Wish> movesForWheels(const scene::Scene& scene,
                                          const std::vector<Indicated>& shown) {
    const auto axle = axleAt(scene, shown[0]);
    if (!axle || !axle->raises)
        return {};
    const auto numbers = [](const Vector& v) { return std::vector{v.x(), v.y(), v.z()}; };
    return {{{Kind::body, axle->body},
             "-init_pos",
             {},
             numbers(axle->raised),
             1e-9,
             {0, 0, 0},
             numbers(scene.bodies[axle->body].initialPosition)}};
}

} // namespace

Recipe newWheels() {
    Recipe recipe;
    recipe.label = QObject::tr("New Wheels");
    Step where = showBody(QObject::tr("Click on the side of a body, where the axle of the two "
                                      "wheels goes through it."));
    where.judge = judgeWheels;
    where.outlines = outlinesOfWheels;
    recipe.steps = {where};
    recipe.make = makeWheels;
    recipe.moves = movesForWheels;
    return recipe;
}

} // namespace views
