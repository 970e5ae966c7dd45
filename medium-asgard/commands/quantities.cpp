#include "commands/quantities.h"

#include "charts/plots.h"
#include "editing/number_text.h"
#include "framing/extent.h"
#include "scene/joint_types.h"

#include <cmath>
#include <optional>

namespace commands {

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

enum class Inertia { alike, principal, any }; // about all axes; about the body's axes

Inertia inertiaOf(const scene::Scene& scene, const scene::Body& body) {
    if (const auto& given = body.inertia) {
        const auto& [xx, yy, zz, xy, xz, yz] = *given;
        return xy != 0 || xz != 0 || yz != 0 ? Inertia::any
               : xx == yy && yy == zz        ? Inertia::alike
                                             : Inertia::principal;
    }
    const scene::ShapeSet* set = scene::findShapeSet(scene, body.shape);
    if (!set || set->parts.size() != 1 || set->parts[0].rotation != geometry::Vector::Zero() ||
        std::holds_alternative<scene::HullShape>(set->parts[0].shape))
        return Inertia::any;
    return std::holds_alternative<scene::SphereShape>(set->parts[0].shape) ? Inertia::alike
                                                                           : Inertia::principal;
}

// Of the way of its centre of mass, and of its turning.
std::string kineticEnergy(const Names& names, Inertia inertia) {
    const auto square = [](const std::string& one) { return "(" + one + ")^2"; };
    const std::string way = names.of("mass") + "*" + square(names.length("dx", "dy", "dz"));
    if (inertia == Inertia::alike)
        return "0.5*(" + way + " + " + names.of("ixx") + "*" +
               square(names.length("wx", "wy", "wz")) + ")";
    // The angular velocity along the body's axes.
    const auto product = [&](const char* a, const char* b) {
        return names.of(a) + "*" + names.of(b);
    };
    const auto along = [&](const char* x, const char* y, const char* z, const char* u,
                           const char* v, const char* wx, const char* wy, const char* wz) {
        return "(1 - 2*(" + product(u, u) + " + " + product(v, v) + "))*" + names.of(wx) +
               " + 2*(" + product(x, y) + " + " + product("qw", z) + ")*" + names.of(wy) +
               " + 2*(" + product(x, z) + " - " + product("qw", y) + ")*" + names.of(wz);
    };
    const std::string about[] = {along("qx", "qy", "qz", "qy", "qz", "wx", "wy", "wz"),
                                 along("qy", "qz", "qx", "qz", "qx", "wy", "wz", "wx"),
                                 along("qz", "qx", "qy", "qx", "qy", "wz", "wx", "wy")};
    std::string sum = way + " + " + names.of("ixx") + "*" + square(about[0]) + " + " +
                      names.of("iyy") + "*" + square(about[1]) + " + " + names.of("izz") + "*" +
                      square(about[2]);
    const auto mixed = [&](const char* entry, std::size_t a, std::size_t b) {
        sum += " + 2*" + names.of(entry) + "*(" + about[a] + ")*(" + about[b] + ")";
    };
    if (inertia == Inertia::any) {
        mixed("ixy", 0, 1);
        mixed("ixz", 0, 2);
        mixed("iyz", 1, 2);
    }
    return "0.5*(" + sum + ")";
}

std::vector<Quantity> ofBody(const scene::Scene& scene, const scene::Body& body,
                             const Names& names) {
    const std::string way = "m", speed = "m/s";
    const std::string velocity = names.length("dx", "dy", "dz");
    const geometry::Vector up = render::upOf(scene);
    const auto place = [&](const std::string& label, Eigen::Index axis) {
        return up[axis] > 0.99 ? "Height, " + label : label;
    };
    return {{place("&x", 0), names.of("x"), way},
            {place("&y", 1), names.of("y"), way},
            {place("&z", 2), names.of("z"), way},
            {"&Speed", velocity, speed},
            {"Velocity along x", names.of("dx"), speed},
            {"Velocity along y", names.of("dy"), speed},
            {"Velocity along z", names.of("dz"), speed},
            {"&Momentum", names.of("mass") + " * " + velocity, "kg m/s"},
            {"&Kinetic energy", kineticEnergy(names, inertiaOf(scene, body)), "J"},
            {"&Angle about z", names.of("rz"), "rad"},
            {"Angular velocity about z", names.of("wz"), "rad/s"}};
}

// The angle of a pendulum from where it hangs straight down, right-handed about the axis: that of
// the way from the joint's point to the body's centre of mass, wherever the joint is moved.
// `across`: the direction in which a small positive angle leads.
std::string angleFromBelow(const scene::Joint& joint, const geometry::Vector& up,
                           const geometry::Vector& across) {
    const auto along = [&](const geometry::Vector& direction) { // an axis of the world, either way
        Eigen::Index axis = 0;
        direction.cwiseAbs().maxCoeff(&axis);
        const std::string letter(1, "xyz"[axis]);
        const std::string body = joint.body1 + "." + letter, point = joint.name + ".p" + letter;
        return direction[axis] > 0 ? body + " - " + point : point + " - " + body;
    };
    return "atan2(" + along(across) + ", " + along(-up) + ")";
}

// An axis of the world, or none.
std::optional<geometry::Vector> worldAxis(const geometry::Vector& direction) {
    Eigen::Index axis = 0;
    const double most = direction.normalized().cwiseAbs().maxCoeff(&axis);
    constexpr double straight = 1 - 1e-9;
    if (!(most > straight))
        return std::nullopt;
    return geometry::Vector(geometry::Vector::Unit(axis) * (direction[axis] > 0 ? 1 : -1));
}

// "": it is none that hangs from a point of the world.
std::string angleOfPendulum(const scene::Scene& scene, const scene::Joint& joint) {
    const scene::Body* body = scene::findBody(scene, joint.body1);
    const scene::Body* other = joint.body2 ? scene::findBody(scene, *joint.body2) : nullptr;
    if (!body || body->fixed || (joint.body2 && !(other && other->fixed)))
        return {};
    const geometry::Vector up = render::upOf(scene);
    if (joint.type == scene::JointType::distance) {
        if (joint.offset1 || joint.body2 || !joint.offset2)
            return {};
        // About z as a rule; where that is upwards, about x.
        const geometry::Vector axis =
            std::abs(up.z()) < 0.5 ? geometry::Vector::UnitZ() : geometry::Vector::UnitX();
        return angleFromBelow(joint, up, axis.cross(-up));
    }
    if (joint.type != scene::JointType::hinge || !joint.offset1)
        return {};
    const geometry::Pose pose{body->initialPosition, body->initialAttitude};
    const auto axis = worldAxis(pose.attitude * joint.axis);
    if (!axis || std::abs(axis->dot(up)) > 0.5)
        return {};
    return angleFromBelow(joint, up, axis->cross(-up));
}

std::vector<Quantity> ofJoint(const scene::Scene& scene, const Names& names,
                              const scene::Joint& joint) {
    std::vector<Quantity> all;
    const std::string fromBelow = angleOfPendulum(scene, joint);
    if (!fromBelow.empty())
        all.push_back({"&Angle from straight down", fromBelow, "rad", "angle of " + joint.name});
    const auto& coordinates = scene::traitsOf(joint.type).coordinates;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const std::string which = scene::coordinateSuffix(joint.type, i);
        const std::string shown = which.empty() ? "" : " " + which;
        const bool isAngle = coordinates[i] == scene::CoordinateKind::angle;
        all.push_back({(!isAngle            ? "&Distance"
                        : fromBelow.empty() ? "&Angle"
                                            : "A&ngle of the joint") +
                           shown,
                       names.of("q" + which), isAngle ? "rad" : "m"});
        all.push_back({"&Rate" + shown, names.of("dq" + which), isAngle ? "rad/s" : "m/s"});
        const scene::JointCoordinate& own = joint.coordinates[i];
        if (own.motor || own.speed || own.position)
            all.push_back({"&Motor" + shown, names.of("motor" + which), isAngle ? "N m" : "N"});
    }
    all.push_back({"&Force", names.length("fx", "fy", "fz"), "N"});
    all.push_back({"C&ouple", names.length("tx", "ty", "tz"), "N m"});
    return all;
}

} // namespace

std::string worded(const Quantity& quantity) {
    std::string label = quantity.label;
    std::erase(label, '&');
    const std::string unit = charts::saidAs(quantity.unit).unit;
    return unit.empty() ? label : label + ", " + unit;
}

std::vector<Quantity> quantitiesOf(const scene::Scene& scene, const Element& element) {
    const std::string name = editing::nameOf(scene, element);
    if (name.empty())
        return {};
    const Names names(name);
    switch (element.kind) {
    case Kind::body:
        return ofBody(scene, scene.bodies[element.index], names);
    case Kind::joint:
        return ofJoint(scene, names, scene.joints[element.index]);
    case Kind::link:
        if (!scene.links[element.index].spring)
            return {};
        return {{"&Length", names.of("length"), "m"}, {"&Force", names.of("force"), "N"}};
    case Kind::rope:
        return {{"&Tension", names.of("tension"), "N"}};
    case Kind::contact:
        return {{"&Normal force", names.of("n"), "N"}, {"&Slip", names.of("slip"), "m/s"}};
    default:
        return {};
    }
}

namespace {

constexpr Kind measured[] = {Kind::body, Kind::joint, Kind::link, Kind::rope, Kind::contact};

} // namespace

std::vector<Measured> quantitiesOf(const scene::Scene& scene) {
    std::vector<Measured> all;
    for (const Kind kind : measured)
        for (std::size_t i = 0; editing::sourceOf(scene, {kind, i}); ++i)
            if (kind != Kind::body || !scene.bodies[i].fixed)
                if (auto quantities = quantitiesOf(scene, Element{kind, i}); !quantities.empty())
                    all.push_back({{kind, i}, std::move(quantities)});
    return all;
}

editing::NewElement plotOf(const std::string& text, const scene::Scene& scene,
                           const std::string& expression, const std::string& curve) {
    editing::NewElement plot{Kind::plot,
                             editing::unusedName(text, scene, Kind::plot, "plot"),
                             {"-values", "{{" + expression + "}}"},
                             {}};
    if (!curve.empty())
        plot.words.insert(plot.words.end(), {"-labels", "{{" + curve + "}}"});
    for (const Kind kind : {Kind::body, Kind::link, Kind::joint, Kind::rope, Kind::contact})
        for (std::size_t i = 0; editing::sourceOf(scene, {kind, i}); ++i)
            if (const std::string name = editing::nameOf(scene, {kind, i});
                !name.empty() && expression.find(name + ".") != std::string::npos)
                plot.behind.push_back({kind, i});
    return plot;
}

} // namespace commands
