#include "scene/units.h"

#include "expression/graph.h"
#include "scene/joint_types.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <unordered_map>
#include <utility>

namespace scene {

namespace {

using expression::Node;
using expression::Op;

//                            m   kg  s  rad
constexpr Dimension number{}, length{1}, mass{0, 1}, duration{0, 0, 1}, angle{0, 0, 0, 1};
constexpr Dimension velocity{1, 0, -1}, spin{0, 0, -1, 1}, force{1, 1, -2};
constexpr Dimension energy{2, 1, -2}, torque{2, 1, -2, -1}, inertia{2, 1};
constexpr Dimension momentum{1, 1, -1}, angularMomentum{2, 1, -1};

Dimension ofBody(BodyQuantity q) {
    using enum BodyQuantity;
    if (q <= z || q == px || q == py || q == pz)
        return length;
    if (q <= dz || q >= pdx)
        return velocity;
    if (q <= wz)
        return spin;
    if (q <= qz)
        return number;
    if (isTurn(q))
        return angle;
    return q == scene::BodyQuantity::mass ? scene::mass : inertia;
}

Dimension ofJoint(JointQuantity q, bool isAngle) {
    if (q == JointQuantity::q)
        return isAngle ? angle : length;
    if (q == JointQuantity::dq)
        return isAngle ? spin : velocity;
    if (q == JointQuantity::motor)
        return isAngle ? torque : force;
    if (q >= JointQuantity::px)
        return length;
    return q >= JointQuantity::tx ? torque : force;
}

Dimension ofContact(ContactQuantity q) {
    if (q == ContactQuantity::state)
        return number;
    if (q == ContactQuantity::slip)
        return velocity;
    if (q >= ContactQuantity::px)
        return length;
    return q >= ContactQuantity::tx ? torque : force;
}

Dimension ofScene(SceneQuantity q) {
    if (q == SceneQuantity::energy)
        return energy;
    if (q == SceneQuantity::collisions)
        return number;
    return q >= SceneQuantity::lx ? angularMomentum : momentum;
}

// --- the calculus ------------------------------------------------------------------------------

// Of a value: known, or any (a plain number in a sum), or none that anybody knows.
struct Measure {
    enum class State { known, any, unknown } state = State::unknown;
    Dimension dimension = {};

    static Measure known(const Dimension& d) { return {State::known, d}; }
    static Measure any() { return {State::any}; }
};

Measure product(const Measure& a, const Measure& b, int sign) {
    if (a.state != Measure::State::known || b.state != Measure::State::known)
        return {};
    const Dimension &d = a.dimension, &e = b.dimension;
    return Measure::known({d.length + sign * e.length, d.mass + sign * e.mass,
                           d.time + sign * e.time, d.angle + sign * e.angle});
}

// Terms that differ in radians alone go together: a rate times a radius is a speed.
Measure sum(const Measure& a, const Measure& b) {
    if (a.state == Measure::State::any)
        return b;
    if (b.state == Measure::State::any || a.state == Measure::State::unknown)
        return a;
    Dimension d = a.dimension, e = b.dimension;
    if (b.state == Measure::State::unknown || d == e)
        return b.state == Measure::State::unknown ? b : a;
    d.angle = e.angle = 0;
    return d == e ? Measure::known(d) : Measure();
}

class Calculus {
public:
    using Known = std::unordered_map<std::uint32_t, std::optional<Dimension>>; // of symbols
    Calculus(const expression::Graph& graph, const Known& symbols)
        : graph_(graph), symbols_(symbols) {}

    [[nodiscard]] Measure of(Node root) {
        for (const Node node : expression::reachable(graph_, std::array{root}))
            found_[node.index] = made(node);
        return found_[root.index];
    }

private:
    [[nodiscard]] Measure at(Node node) const { return found_.at(node.index); }
    // A number that formulas have as a factor counts as one.
    [[nodiscard]] Measure factor(Node node) const {
        if (graph_.op(node) != Op::constant)
            return at(node);
        for (const double plain : {1.0, 2.0, 0.5})
            if (std::abs(graph_.value(node)) == plain)
                return Measure::known(number);
        return {};
    }
    [[nodiscard]] Measure power(Node base, Node exponent) const {
        const Measure a = at(base);
        if (a.state != Measure::State::known || graph_.op(exponent) != Op::constant)
            return a.state == Measure::State::known && a.dimension == number ? a : Measure();
        const double n = graph_.value(exponent);
        const auto times = [&](int p) { return static_cast<int>(std::lround(p * n)); };
        const Dimension &d = a.dimension,
                        all{times(d.length), times(d.mass), times(d.time), times(d.angle)};
        const auto isWhole = [&](int p, int q) { return std::abs(p * n - q) < 1e-9; };
        return isWhole(d.length, all.length) && isWhole(d.mass, all.mass) &&
                       isWhole(d.time, all.time) && isWhole(d.angle, all.angle)
                   ? Measure::known(all)
                   : Measure();
    }
    [[nodiscard]] Measure made(Node node) const {
        const auto arguments = graph_.arguments(node);
        switch (graph_.op(node)) {
        case Op::constant:
        case Op::parameter:
            return Measure::any();
        case Op::symbol: {
            const auto known = symbols_.find(node.index);
            return known != symbols_.end() && known->second ? Measure::known(*known->second)
                                                            : Measure();
        }
        case Op::negate:
        case Op::abs:
        case Op::floor:
        case Op::ceil:
            return at(arguments[0]);
        case Op::asin:
        case Op::acos:
        case Op::atan:
        case Op::atan2:
            return Measure::known(angle);
        case Op::add:
        case Op::subtract:
        case Op::hypot:
        case Op::min:
        case Op::max:
            return sum(at(arguments[0]), at(arguments[1]));
        case Op::select:
            return sum(at(arguments[1]), at(arguments[2]));
        case Op::multiply:
            return product(factor(arguments[0]), factor(arguments[1]), 1);
        case Op::divide:
            return product(factor(arguments[0]), factor(arguments[1]), -1);
        case Op::sqrt:
            return rooted(at(arguments[0]));
        case Op::power:
            return power(arguments[0], arguments[1]);
        default: // sin, exp, comparisons
            return Measure::known(number);
        }
    }
    [[nodiscard]] static Measure rooted(const Measure& a) {
        const Dimension& d = a.dimension;
        if (a.state != Measure::State::known || d.length % 2 != 0 || d.mass % 2 != 0 ||
            d.time % 2 != 0)
            return {};
        return Measure::known({d.length / 2, d.mass / 2, d.time / 2, d.angle / 2});
    }

    const expression::Graph& graph_;
    const Known& symbols_;
    std::unordered_map<std::uint32_t, Measure> found_;
};

// --- words -------------------------------------------------------------------------------------

std::string along(std::string_view quantity, std::string_view what) {
    return std::string(what) + quantity.back();
}

// Of a body's, a joint's, a spring's, ... quantity.
std::string wordsOfQuantity(const Named& named, std::string_view quantity) {
    const bool hasAxis = !quantity.empty() && quantity.back() >= 'x' && quantity.back() <= 'z';
    const std::string_view kind = quantity.substr(0, quantity.size() - (hasAxis ? 1 : 0));
    if (std::holds_alternative<BodyName>(named)) {
        if (hasAxis && kind == "d")
            return along(quantity, "velocity along ");
        if (hasAxis && kind == "w")
            return along(quantity, "angular velocity about ");
        if (hasAxis && kind == "r")
            return along(quantity, "angle about ");
    }
    if (hasAxis && kind == "f")
        return along(quantity, "force along ");
    if (hasAxis && kind == "t")
        return along(quantity, "torque about ");
    if (std::holds_alternative<ContactName>(named) && quantity == "n")
        return "normal force";
    return std::string(quantity);
}

std::string wordsOfCoordinate(const Scene& scene, const JointName& name) {
    const Joint& joint = scene.joints[name.joint];
    const bool isAngle = traitsOf(joint.type).coordinates[name.coordinate] == CoordinateKind::angle;
    const std::string suffix = coordinateSuffix(joint.type, name.coordinate);
    const std::string which = suffix.empty() ? "" : " " + suffix;
    if (name.quantity == JointQuantity::motor)
        return "motor" + which;
    const std::string what = isAngle ? "angle" : "distance";
    return (name.quantity == JointQuantity::dq ? "rate of the " + what : what) + which;
}

} // namespace

std::string unitNamed(const Dimension& named) {
    Dimension dimension = named;
    if (dimension.angle > 0 && (dimension.length != 0 || dimension.mass != 0))
        dimension.angle = 0; // I w² is an energy
    static constexpr std::pair<Dimension, const char*> names[] = {
        {force, "N"}, {energy, "J"}, {torque, "N m"}, {{2, 1, -3}, "W"}, {{0, 1, -2}, "N/m"}};
    for (const auto& [known, name] : names)
        if (dimension == known)
            return name;
    std::string over, under;
    const auto write = [&](int power, const char* unit) {
        if (power == 0)
            return;
        std::string& into = power > 0 ? over : under;
        into += (into.empty() ? "" : " ") + std::string(unit);
        if (std::abs(power) == 2)
            into += "²";
        else if (std::abs(power) == 3)
            into += "³";
        else if (std::abs(power) > 3)
            into += "^" + std::to_string(std::abs(power));
    };
    write(dimension.mass, "kg");
    write(dimension.length, "m");
    write(dimension.angle, "rad");
    write(dimension.time, "s");
    if (under.empty())
        return over;
    const bool isOne = under.find(' ') == std::string::npos;
    return (over.empty() ? "1" : over) + "/" + (isOne ? under : "(" + under + ")");
}

std::optional<Dimension> Units::dimensionOf(const Named& named) const {
    if (std::holds_alternative<TimeName>(named))
        return duration;
    if (const auto* name = std::get_if<BodyName>(&named))
        return ofBody(name->quantity);
    if (const auto* name = std::get_if<JointName>(&named)) {
        const auto kinds = traitsOf(scene_.joints[name->joint].type).coordinates;
        return ofJoint(name->quantity, name->coordinate < kinds.size() &&
                                           kinds[name->coordinate] == CoordinateKind::angle);
    }
    if (const auto* name = std::get_if<SpringName>(&named))
        return name->quantity == SpringQuantity::length ? length : force;
    if (const auto* name = std::get_if<RopeName>(&named))
        return name->span ? force : length;
    if (const auto* name = std::get_if<ContactName>(&named))
        return ofContact(name->quantity);
    if (const auto* name = std::get_if<SceneName>(&named))
        return ofScene(name->quantity);
    return std::nullopt;
}

std::string Units::of(const std::string& expression) const {
    expression::Graph graph;
    Calculus::Known symbols;
    const expression::Names meaning = [&](expression::Graph& g, std::string_view name,
                                          std::span<const Node> arguments,
                                          bool isCall) -> expression::Meaning {
        const Named named = names_.find(
            name, isCall ? std::optional(arguments.size()) : std::nullopt, Reading::quantities);
        if (const auto* fault = std::get_if<NameFault>(&named))
            return {std::nullopt, fault->message, fault->suggestion};
        const Node node = g.symbol(name);
        symbols[node.index] = dimensionOf(named);
        return {node, "", ""};
    };
    const auto parsed = expression::parse(graph, expression, meaning);
    const auto* root = std::get_if<Node>(&parsed);
    if (!root)
        return {};
    const Measure measure = Calculus(graph, symbols).of(*root);
    return measure.state == Measure::State::known ? unitNamed(measure.dimension) : "";
}

std::string Units::wordsOf(const std::string& expression) const {
    const Named named = names_.find(expression, std::nullopt, Reading::quantities);
    if (std::holds_alternative<NameFault>(named) || std::holds_alternative<ParameterName>(named))
        return {};
    if (std::holds_alternative<TimeName>(named))
        return "time";
    const std::size_t dot = expression.rfind('.');
    const std::string owner = expression.substr(0, dot), quantity = expression.substr(dot + 1);
    if (std::holds_alternative<SceneName>(named))
        return owner == "scene" && quantity != "energy" ? "" : quantity;
    const auto* joint = std::get_if<JointName>(&named);
    const std::string words = joint && joint->quantity <= JointQuantity::motor
                                  ? wordsOfCoordinate(scene_, *joint)
                                  : wordsOfQuantity(named, quantity);
    return words + " of " + owner;
}

} // namespace scene
