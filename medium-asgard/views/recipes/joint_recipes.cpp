// Create > Joint: the body that moves, then the place of the joint on another body or the ground.
// Create > Rope: the body to which it is tied, then its other points.
#include "editing/number_text.h"
#include "framing/extent.h"
#include "gestures/snapping.h"
#include "recipes/recipe_words.h"
#include "recipes/recipes.h"

#include "scene/joint_types.h"

#include <QObject>

namespace views {

namespace {

using editing::Kind;
using editing::NewElement;
using scene::JointType;

QString labelOf(JointType type) {
    switch (type) {
    case JointType::fixed:
        return QObject::tr("New Fixed Joint");
    case JointType::hinge:
        return QObject::tr("New Hinge");
    case JointType::slider:
        return QObject::tr("New Slider");
    case JointType::cylindrical:
        return QObject::tr("New Cylindrical Joint");
    case JointType::universal:
        return QObject::tr("New Universal Joint");
    case JointType::ball:
        return QObject::tr("New Ball Joint");
    case JointType::planar:
        return QObject::tr("New Planar Joint");
    case JointType::distance:
        return QObject::tr("New Distance");
    case JointType::screw:
        return QObject::tr("New Screw");
    }
    return {};
}

// Along which one body slides on the other.
bool hasLine(JointType type) {
    return type == JointType::slider || type == JointType::cylindrical || type == JointType::screw;
}

// A joint of two things that never move does nothing: a click beside what was meant, as a rule.
Judged judgeHold(const scene::Scene& scene, const std::vector<Indicated>& shown,
                 const Indicated& next) {
    const scene::Body& first = scene.bodies[*shown.front().body];
    if (!first.fixed || (next.body && !scene.bodies[*next.body].fixed))
        return {};
    const QString name = QString::fromStdString(first.name);
    return {next.body ? QObject::tr("%1 and %2 are fixed: a joint is for a body that moves.")
                            .arg(name, QString::fromStdString(scene.bodies[*next.body].name))
                      : QObject::tr("%1 is fixed, as the ground is: a joint is for a body that "
                                    "moves.")
                            .arg(name),
            false};
}

std::vector<Step> stepsOf(JointType type) {
    const bool isDistance = type == JointType::distance;
    Step first{
        Wanted::body,
        isDistance
            ? QObject::tr("Click where the rod is fastened on a body.")
            : QObject::tr("Click on the body that the joint holds, such as a wheel or a door."),
        ""};
    first.whole = !isDistance;
    first.deep = isDistance;
    Step second{Wanted::hold,
                isDistance ? QObject::tr("Click where its other end is: on another body, or beside "
                                         "all of them on the ground, or type x y z.")
                           : QObject::tr("Click where the joint is: on another body, as the middle "
                                         "of a wheel, or where there is none, for the ground; or "
                                         "type x y z."),
                ""};
    second.judge = judgeHold;
    std::vector<Step> steps{first, second};
    if (hasLine(type))
        steps.push_back({Wanted::point, QObject::tr("Click where it slides to."),
                         QObject::tr("Return: along x.")});
    return steps;
}

// The axis of the world that points at the viewer most.
Vector acrossThePicture(const Vector& sight) {
    Eigen::Index axis = 0;
    sight.cwiseAbs().maxCoeff(&axis);
    return Vector::Unit(axis);
}

// "-axis {0 0 1}" in the frame of body 1; nothing for z where that is what the type has by itself.
// A universal joint has a second one in the frame of body 2: both are level where that is possible,
// so that what hangs from it swings either way.
void addAxes(NewElement& joint, JointType type, const scene::Scene& scene,
             const std::vector<Indicated>& shown) {
    constexpr double steady = 1e-3;
    const scene::JointTraits& traits = scene::traitsOf(type);
    if (!traits.hasAxis)
        return;
    const auto add = [&](const char* option, const Vector& own) {
        joint.words.insert(joint.words.end(), {option, listed(own, steady)});
    };
    Vector axis = acrossThePicture(shown[0].sight);
    const Vector up = render::upOf(scene);
    if (type == JointType::universal && std::abs(axis.dot(up)) > 0.5)
        axis = std::abs(up.x()) > 0.5 ? Vector(Vector::UnitZ()) : Vector(Vector::UnitX());
    if (hasLine(type)) {
        const Vector way = shown[2].point - shown[1].point;
        axis = shown[2].given && way.norm() > 0 ? alongAxis(way).normalized() : Vector::UnitX();
    }
    const Vector own = shown[0].attitude.conjugate() * axis;
    if (!traits.isDefaultAxis || (own - Vector::UnitZ()).norm() > steady)
        add("-axis", own);
    if (type == JointType::universal)
        add("-axis2", shown[1].attitude.conjugate() * up.cross(axis));
    // In one turn it goes as far as one sees well.
    constexpr double pixels = 20;
    if (type == JointType::screw)
        joint.words.insert(
            joint.words.end(),
            {"-pitch", editing::numberText(gestures::roundStep(pixels * shown[0].resolution), 0)});
}

} // namespace

Recipe newJoint(JointType type) {
    Recipe recipe;
    recipe.label = labelOf(type);
    recipe.steps = stepsOf(type);
    recipe.make = [type](const std::string& text, const scene::Scene& scene,
                         const std::vector<Indicated>& shown) {
        const std::string word(scene::traitsOf(type).name);
        const Indicated &first = shown[0], &second = shown[1];
        const std::string stem = type == JointType::distance ? "rod" : word;
        NewElement joint{Kind::joint,
                         editing::unusedName(text, scene, Kind::joint, stem),
                         {"-type", word, "-body1", scene.bodies[*first.body].name},
                         {{Kind::body, *first.body}}};
        const auto add = [&](const char* option, const Vector& place, double resolution) {
            joint.words.insert(joint.words.end(), {option, listed(place, resolution)});
        };
        const bool isDistance = type == JointType::distance;
        if (isDistance && !first.atCenter)
            add("-offset1", first.onBody, first.resolution);
        if (!isDistance)
            add("-offset1", second.onFirst, second.resolution);
        if (second.body) {
            joint.words.insert(joint.words.end(), {"-body2", scene.bodies[*second.body].name});
            joint.behind.push_back({Kind::body, *second.body});
        }
        if (isDistance && !(second.body && second.atCenter))
            add("-offset2", second.body ? second.onBody : second.point, second.resolution);
        addAxes(joint, type, scene, shown);
        return std::vector{joint};
    };
    recipe.handles = &render::Display::jointHandles;
    return recipe;
}

Recipe newRope() {
    Recipe recipe;
    recipe.label = QObject::tr("New Rope");
    Step first{Wanted::body, QObject::tr("Click where the rope is tied to a body."), ""};
    first.deep = true;
    Step next{Wanted::hold,
              QObject::tr("Click where it goes: on another body, or beside all of them on the "
                          "ground."),
              QObject::tr("Return: the last one was its end.")};
    next.repeats = true;
    recipe.steps = {first, next};
    recipe.otherwise = QObject::tr("A rope has two ends.");
    recipe.make = [](const std::string& text, const scene::Scene& scene,
                     const std::vector<Indicated>& shown) {
        std::vector<NewElement> made;
        NewElement rope{Kind::rope, editing::unusedName(text, scene, Kind::rope, "rope"), {}, {}};
        std::string points;
        std::size_t count = 0;
        for (const Indicated& one : shown) {
            if (!one.given)
                continue;
            points += count++ == 0 ? "" : " ";
            if (!one.body) {
                points += listed(one.point, one.resolution);
                continue;
            }
            const std::string& body = scene.bodies[*one.body].name;
            points += one.atCenter ? "{" + body + "}"
                                   : "{" + body + " " + listed(one.onBody, one.resolution) + "}";
            rope.behind.push_back({Kind::body, *one.body});
        }
        rope.words = {"-points", "{" + points + "}"};
        if (count > 1)
            made.push_back(rope);
        return made;
    };
    return recipe;
}

} // namespace views
