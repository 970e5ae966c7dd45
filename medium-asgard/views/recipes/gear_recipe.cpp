// Create > Joint > Gear: two bodies that turn on hinges, or slide, roll on each other.
//
// A wheel of radius r that turns by q about the axis a moves its rim by q r (a x n), where n leads
// from the axis to the place of contact; a rack that slides by q moves by q a. Both go the same way
// there: that gives dq1 = R dq2. Wheels touch between their axes, or one is inside of the other.
// A shape without a radius has the rest of the distance of the axes, or half of it.
#include "recipes/recipe_words.h"
#include "recipes/recipes.h"

#include "editing/number_text.h"
#include "scene/joint_types.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

using editing::Kind;

// A body on its joint, as it stands at the start.
struct Geared {
    std::size_t joint = 0;
    bool slides = false;
    double sense = 1;  // -1: the joint counts the turn of the other body
    Vector axis;       // world, unit
    Vector place;      // world: a point of the axis, of a rack its middle
    double radius = 0; // 0: its shape has none
    double inner = 0;  // of a ring: where a wheel in it rolls
};

double radiusOf(const scene::ShapeSet* shape) {
    double radius = 0;
    for (const scene::Part& part : shape ? shape->parts : std::vector<scene::Part>())
        radius = std::max(radius, std::visit(
                                      []<class Shape>(const Shape& one) {
                                          if constexpr (requires { one.radius; })
                                              return one.radius;
                                          else if constexpr (requires { one.outer; })
                                              return one.outer;
                                          else
                                              return 0.0;
                                      },
                                      part.shape));
    return radius;
}

double innerOf(const scene::ShapeSet* shape) {
    double inner = 0;
    for (const scene::Part& part : shape ? shape->parts : std::vector<scene::Part>())
        if (const auto* tube = std::get_if<scene::TubeShape>(&part.shape))
            inner = std::max(inner, tube->inner);
    return inner;
}

// The joint of which it is the first body, else one of which it is the second.
std::optional<Geared> gearedOf(const scene::Scene& scene, std::size_t index) {
    const scene::Body& body = scene.bodies[index];
    for (const bool isFirst : {true, false})
        for (std::size_t i = 0; i < scene.joints.size(); ++i) {
            const scene::Joint& joint = scene.joints[i];
            const auto kinds = scene::traitsOf(joint.type).coordinates;
            if (!scene::traitsOf(joint.type).hasAxis || kinds.size() != 1 ||
                (isFirst ? joint.body1 : joint.body2.value_or("")) != body.name)
                continue;
            const scene::Body* holder = scene::findBody(scene, joint.body1);
            Geared found;
            found.joint = i;
            found.slides = kinds.front() == scene::CoordinateKind::length;
            found.sense = isFirst ? 1 : -1;
            found.axis = (holder->initialAttitude * joint.axis).normalized();
            found.place =
                found.slides
                    ? body.initialPosition
                    : Vector(holder->initialPosition +
                             holder->initialAttitude * joint.offset1.value_or(Vector::Zero()));
            const scene::ShapeSet* shape = scene::findShapeSet(scene, body.shape);
            found.radius = radiusOf(shape);
            found.inner = innerOf(shape);
            return found;
        }
    return std::nullopt;
}

Vector across(const Vector& way, const Vector& axis) { return way - way.dot(axis) * axis; }

// Of the wheel's rim where the rack is, for a turn of 1: along the rack.
double rollOn(const Geared& wheel, const Geared& rack) {
    Vector toRack = across(across(rack.place - wheel.place, wheel.axis), rack.axis);
    const double away = toRack.norm();
    if (away < 1e-9) // the rack's line meets the axis
        toRack = wheel.axis.cross(rack.axis);
    const double radius = wheel.radius > 0 ? wheel.radius : std::max(away, 1e-3);
    const double along = wheel.axis.cross(toRack.normalized()).dot(rack.axis);
    return (along < 0 ? -1 : 1) * radius * wheel.sense * rack.sense;
}

double ratioOf(const Geared& one, const Geared& other) {
    if (one.slides && other.slides)
        return one.sense * other.sense;
    if (one.slides)
        return rollOn(other, one);
    if (other.slides)
        return 1 / rollOn(one, other);
    const double apart = across(other.place - one.place, one.axis).norm();
    double first = one.radius, second = other.radius;
    const bool isInside = first > 0 && second > 0 && apart < std::max(first, second);
    if (const double inner = first < second ? other.inner : one.inner; isInside && inner > 0)
        (first < second ? second : first) = inner;
    if (first <= 0 && second <= 0)
        first = second = 1; // alike
    else if (first <= 0 || second <= 0)
        (first <= 0 ? first : second) = std::max(apart - std::max(first, second), 1e-3);
    const double same = one.axis.dot(other.axis) < 0 ? -1 : 1;
    return (isInside ? 1 : -1) * same * one.sense * other.sense * second / first;
}

Judged judge(const scene::Scene& scene, const std::vector<Indicated>& shown,
             const Indicated& next) {
    const QString name = QString::fromStdString(scene.bodies[*next.body].name);
    const auto found = gearedOf(scene, *next.body);
    if (!found)
        return {
            QObject::tr("%1 neither turns on a hinge nor slides: make that joint first.").arg(name),
            false};
    const QString joint = QString::fromStdString(scene.joints[found->joint].name);
    if (shown.empty())
        return {QObject::tr("%1, on %2").arg(name, joint), true};
    const auto first = gearedOf(scene, *shown.front().body);
    if (first->joint == found->joint)
        return {QObject::tr("%1 is on the same joint, %2.").arg(name, joint), false};
    return {QObject::tr("%1, on %2: ratio %3")
                .arg(name, joint,
                     QString::fromStdString(editing::numberText(ratioOf(*first, *found), 1e-6))),
            true};
}

} // namespace

Recipe newGear() {
    Recipe recipe;
    recipe.label = QObject::tr("New Gear");
    recipe.steps = {
        showWholeBody(QObject::tr("Click on a wheel that turns on a hinge, or on a rack that "
                                  "slides.")),
        showWholeBody(QObject::tr("Click on the wheel, or the rack, that it rolls on."))};
    for (Step& step : recipe.steps)
        step.judge = judge;
    recipe.make = [](const std::string& text, const scene::Scene& scene,
                     const std::vector<Indicated>& shown) {
        const auto one = gearedOf(scene, *shown[0].body), other = gearedOf(scene, *shown[1].body);
        std::vector<editing::NewElement> made;
        if (one && other)
            made.push_back({Kind::gear,
                            editing::unusedName(text, scene, Kind::gear, "gear"),
                            {"-joint1", scene.joints[one->joint].name, "-joint2",
                             scene.joints[other->joint].name, "-ratio",
                             editing::numberText(ratioOf(*one, *other), 1e-6)},
                            {{Kind::joint, one->joint}, {Kind::joint, other->joint}}});
        return made;
    };
    return recipe;
}

} // namespace views
