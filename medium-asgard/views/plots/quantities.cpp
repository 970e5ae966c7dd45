#include "plots/quantities.h"

#include "editing/number_text.h"
#include "scene/joint_types.h"

#include <QObject>

namespace views {

using editing::Element;
using editing::Kind;

namespace {

// "b1.x", and what is made of it.
class Names {
public:
    explicit Names(std::string name) : name_(std::move(name)) {}
    [[nodiscard]] std::string of(const std::string& quantity) const {
        return name_ + "." + quantity;
    }
    [[nodiscard]] std::string length(const char* x, const char* y, const char* z) const {
        return "hypot(" + of(x) + ", " + of(y) + ", " + of(z) + ")";
    }

private:
    std::string name_;
};

std::vector<Quantity> ofBody(const Names& names) {
    const QString way = QStringLiteral("m"), speed = QStringLiteral("m/s");
    const std::string velocity = names.length("dx", "dy", "dz");
    return {
        {QObject::tr("&x"), names.of("x"), way},
        {QObject::tr("&y"), names.of("y"), way},
        {QObject::tr("&z"), names.of("z"), way},
        {QObject::tr("&Speed"), velocity, speed},
        {QObject::tr("Velocity along x"), names.of("dx"), speed},
        {QObject::tr("Velocity along y"), names.of("dy"), speed},
        {QObject::tr("Velocity along z"), names.of("dz"), speed},
        {QObject::tr("&Momentum"), names.of("mass") + " * " + velocity, QStringLiteral("kg m/s")},
        {QObject::tr("&Angle about z"), names.of("rz"), QStringLiteral("rad"), true},
        {QObject::tr("Angular velocity about z"), names.of("wz"), QStringLiteral("rad/s")}};
}

// Of a pendulum: a rod from a point of the world to a body's centre of mass. "": another joint.
std::string angleOfRod(const scene::Joint& joint) {
    if (joint.type != scene::JointType::distance || joint.offset1 || joint.body2 || !joint.offset2)
        return {};
    const auto number = [](double value) { return editing::numberText(value, 0); };
    const geometry::Vector& top = *joint.offset2;
    return "atan2(" + joint.body1 + ".x - (" + number(top.x()) + "), " + number(top.y()) + " - " +
           joint.body1 + ".y)";
}

std::vector<Quantity> ofJoint(const Names& names, const scene::Joint& joint) {
    std::vector<Quantity> all;
    const auto& coordinates = scene::traitsOf(joint.type).coordinates;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const std::string which = scene::coordinateSuffix(joint.type, i);
        const QString shown = which.empty() ? QString() : QString::fromStdString(" " + which);
        const bool isAngle = coordinates[i] == scene::CoordinateKind::angle;
        all.push_back({(isAngle ? QObject::tr("&Angle") : QObject::tr("&Distance")) + shown,
                       names.of("q" + which),
                       isAngle ? QStringLiteral("rad") : QStringLiteral("m")});
        all.push_back({QObject::tr("&Rate") + shown, names.of("dq" + which),
                       isAngle ? QStringLiteral("rad/s") : QStringLiteral("m/s")});
        const scene::JointCoordinate& own = joint.coordinates[i];
        if (own.motor || own.speed || own.position)
            all.push_back({QObject::tr("&Motor") + shown, names.of("motor" + which),
                           isAngle ? QStringLiteral("N m") : QStringLiteral("N")});
    }
    if (const auto angle = angleOfRod(joint); !angle.empty())
        all.push_back({QObject::tr("&Angle from below, about z"), angle, QStringLiteral("rad")});
    all.push_back({QObject::tr("&Force"), names.length("fx", "fy", "fz"), QStringLiteral("N")});
    all.push_back({QObject::tr("C&ouple"), names.length("tx", "ty", "tz"), QStringLiteral("N m")});
    return all;
}

} // namespace

std::vector<Quantity> quantitiesOf(const scene::Scene& scene, const Element& element) {
    const std::string name = editing::nameOf(scene, element);
    if (name.empty())
        return {};
    const Names names(name);
    switch (element.kind) {
    case Kind::body:
        return ofBody(names);
    case Kind::joint:
        return ofJoint(names, scene.joints[element.index]);
    case Kind::link:
        if (!scene.links[element.index].spring)
            return {};
        return {{QObject::tr("&Length"), names.of("length"), QStringLiteral("m")},
                {QObject::tr("&Force"), names.of("force"), QStringLiteral("N")}};
    case Kind::rope:
        return {{QObject::tr("&Tension"), names.of("tension"), QStringLiteral("N")}};
    case Kind::contact:
        return {{QObject::tr("&Normal force"), names.of("n"), QStringLiteral("N")},
                {QObject::tr("&Slip"), names.of("slip"), QStringLiteral("m/s")}};
    default:
        return {};
    }
}

namespace {

constexpr Kind measured[] = {Kind::body, Kind::joint, Kind::link, Kind::rope, Kind::contact};

} // namespace

QString unitOf(const scene::Scene& scene, const std::string& expression) {
    for (const Kind kind : measured)
        for (std::size_t i = 0; editing::sourceOf(scene, {kind, i}); ++i)
            if (expression.find(editing::nameOf(scene, {kind, i}) + ".") != std::string::npos)
                for (const Quantity& one : quantitiesOf(scene, Element{kind, i}))
                    if (one.expression == expression)
                        return one.unit;
    return {};
}

std::vector<Measured> quantitiesOf(const scene::Scene& scene) {
    std::vector<Measured> all;
    for (const Kind kind : measured)
        for (std::size_t i = 0; editing::sourceOf(scene, {kind, i}); ++i)
            if (kind != Kind::body || !scene.bodies[i].fixed)
                if (auto quantities = quantitiesOf(scene, Element{kind, i}); !quantities.empty())
                    all.push_back({{kind, i}, std::move(quantities)});
    return all;
}

} // namespace views
