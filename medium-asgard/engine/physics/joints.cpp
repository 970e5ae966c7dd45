#include "physics/joints.h"

#include "scene/joint_types.h"

#include <algorithm>
#include <limits>

namespace physics {

using scene::JointType;

JointReader::JointReader(Graph& g, const scene::Scene& scene, Scope& scope,
                         std::span<const BodyMotion> bodies, JointMultipliers& multipliers,
                         std::vector<std::string>& faults)
    : g_(g), scene_(scene), scope_(scope), bodies_(bodies), faults_(faults),
      frames_(g, scene, scope, bodies, faults), kinematics_(g, scene, frames_, bodies),
      multipliers_(multipliers) {
    for (std::size_t j = 0; j < frames_.size() && faults_.empty(); ++j)
        nameJoint(j);
    scope_.setJoints(nodes_);
}

void JointReader::nameJoint(std::size_t joint) {
    const JointFrame& frame = frames_[joint];
    JointNodes nodes;
    for (std::size_t k = 0; k < frame.angles.size(); ++k) {
        const Jet jet = kinematics_.coordinate(joint, k, {});
        nodes.q.push_back(jet.value);
        nodes.dq.push_back(jet.rate);
        nodes.motor.push_back(g_.constant(0));
        if (g_.op(frame.angles[k]) == Op::symbol)
            multipliers_.addAngle(frame.angles[k], jet.rate, frame.size,
                                  frames_.moving(joint).front());
    }
    nodes.force = nodes.couple = constant(g_, Vector::Zero());
    nodes.point = kinematics_.pointOf(joint, 1);
    nodes_.push_back(std::move(nodes));
}

void JointReader::addArms(std::span<BodyMotion> bodies) const {
    for (std::size_t j = 0; j < frames_.size(); ++j)
        for (const JointEnd& end : frames_[j].ends)
            if (end.body && end.arm.norm() > bodies[*end.body].mass.radius)
                bodies[*end.body].arms.push_back(end.arm);
}

void JointReader::contribute(std::vector<Contribution>& contributions) {
    contributions_ = &contributions;
    for (std::size_t j = 0; j < frames_.size(); ++j)
        if (!frames_.moving(j).empty())
            keepJoint(j);
    for (std::size_t i = 0; i < scene_.gears.size(); ++i)
        keepGear(i);
    scope_.setJoints(nodes_);
}

void JointReader::keepJoint(std::size_t joint) {
    const scene::Joint& of = scene_.joints[joint];
    const std::vector<std::size_t> moving = frames_.moving(joint);
    const std::size_t first = contributions_->size();
    from_ = {};
    from_.kind = Contribution::Kind::joint;
    from_.element = joint;
    multipliers_.begin({of.name, moving, frames_[joint].size}, of.release);
    for (std::size_t k = 0; k < of.coordinates.size(); ++k)
        tie({joint, k});
    const std::vector<Jet> conditions = kinematics_.conditions(joint, {});
    for (std::size_t r = 0; r < conditions.size(); ++r) {
        const Node multiplier = multipliers_.add([this, joint, r](const Along& along) {
            return JointCondition{.jet = kinematics_.conditions(joint, along)[r]};
        });
        multipliers_.keepThroughBlows(conditions[r]);
        push(conditions[r].rate, multiplier);
    }
    for (std::size_t k = 0; k < of.coordinates.size(); ++k)
        drive({joint, k});
    addForce(joint, std::span(*contributions_).subspan(first));
}

// All that the joint does to its first body, about its point; of a fixed one, against the second.
void JointReader::addForce(std::size_t joint, std::span<const Contribution> contributions) {
    const auto& [first, second] = frames_[joint].ends;
    const bool isFirst = first.body && !bodies_[*first.body].isFixed;
    const JointEnd& end = isFirst ? first : second;
    const NodeVector point = kinematics_.pointOf(joint, 0);
    JointNodes& nodes = nodes_[joint];
    for (const Contribution& c : contributions) {
        if (c.body != *end.body)
            continue;
        const BodySymbols& s = bodies_[c.body].symbols;
        const NodeVector arm = subtract(g_, point, s.position);
        const NodeVector torque = s.isSpinInWorldAxes ? c.torque : s.toWorld(g_, c.torque);
        const NodeVector couple = subtract(g_, torque, cross(g_, arm, c.force));
        const Node sign = g_.constant(isFirst ? 1 : -1);
        nodes.force = add(g_, nodes.force, scaled(g_, sign, c.force));
        nodes.couple = add(g_, nodes.couple, scaled(g_, sign, couple));
    }
}

// ---------------------------------------------------------------------------------------------
// Drives

std::string JointReader::optionOf(const Coordinate& c, const char* option) const {
    const scene::Joint& joint = scene_.joints[c.joint];
    return option + scene::coordinateSuffix(joint.type, c.place) + " of joint \"" + joint.name +
           "\"";
}

std::optional<Node> JointReader::parsed(const Coordinate& c, const scene::Expression& text,
                                        const char* option, scene::Reading reading) {
    const auto made = scope_.parse(g_, text, reading);
    if (const auto* node = std::get_if<Node>(&made))
        return *node;
    faults_.push_back(optionOf(c, option) + ": " + std::get<expression::SyntaxError>(made).message);
    return std::nullopt;
}

// Motor, spring and damper push along the coordinate; a speed or a place is held by a multiplier
// that does.
void JointReader::drive(const Coordinate& c) {
    const scene::JointCoordinate& of = said(c);
    const Jet jet = kinematics_.coordinate(c.joint, c.place, {});
    if (of.lower || of.upper)
        limit(c);
    if (of.friction > 0)
        brake(c, jet);
    const std::vector<std::size_t> moving = frames_.moving(c.joint);
    if (const Node force = springOf(c, jet); !g_.isConstant(force, 0))
        push(jet.rate, multipliers_.releasable(force));
    if (of.motor)
        if (const auto node = parsed(c, *of.motor, "-motor", scene::Reading::state)) {
            nodes_[c.joint].motor[c.place] = multipliers_.releasable(*node);
            push(jet.rate, nodes_[c.joint].motor[c.place]);
        }
    if (of.speed || of.position)
        hold(c, jet);
}

Node JointReader::springOf(const Coordinate& c, const Jet& jet) {
    const scene::JointCoordinate& of = said(c);
    Node force = g_.constant(0);
    if (of.stiffness != 0) {
        const Node stretched = g_.subtract(jet.value, g_.constant(of.rest));
        force = g_.multiply(g_.constant(-of.stiffness), stretched);
        energies_.push_back(
            g_.multiply(g_.constant(0.5 * of.stiffness), g_.multiply(stretched, stretched)));
    }
    if (of.damping != 0)
        force = g_.subtract(force, g_.multiply(g_.constant(of.damping), jet.rate));
    return force;
}

void JointReader::hold(const Coordinate& c, const Jet& jet) {
    const scene::JointCoordinate& of = said(c);
    const bool isPosition = of.position.has_value();
    const bool isRate = !isPosition || of.maxMotor; // what has slipped stays
    const auto given = isPosition ? parsed(c, *of.position, "-position", scene::Reading::positions)
                                  : parsed(c, *of.speed, "-speed", scene::Reading::state);
    if (!given)
        return;
    const auto node = std::optional(multipliers_.located(*given));
    const auto read = scope_.trajectoriesReadBy(g_, std::span(&*node, 1));
    const auto make = [this, c, wanted = *node, read, isPosition, isRate](const Along& along) {
        const Node now =
            along.set
                ? multipliers_.onBranches(
                      substitute(g_, wanted, scope_.piecesFrom(g_, read, along.time)), along.time)
                : wanted;
        const Node rate = multipliers_.rateOf(now, along);
        const Jet jetOfWanted = isPosition ? Jet{now, rate, multipliers_.rateOf(rate, along)}
                                           : Jet{g_.constant(0), now, rate};
        using Order = JointCondition::Order;
        return JointCondition{
            difference(g_, kinematics_.coordinate(c.joint, c.place, along), jetOfWanted),
            isRate ? Order::velocity : Order::second};
    };
    const JointBounds bounds =
        of.maxMotor ? JointBounds{-*of.maxMotor, *of.maxMotor, 0} : JointBounds{};
    const Node motor = multipliers_.add(make, bounds, read, {*node});
    if (!of.maxMotor)
        multipliers_.keepThroughBlows(jet);
    nodes_[c.joint].motor[c.place] = motor;
    push(jet.rate, motor);
}

// A stop at each end: the coordinate's distance from it as a length, and a force that only pushes
// away.
void JointReader::limit(const Coordinate& c) {
    const scene::JointCoordinate& of = said(c);
    const auto kinds = scene::traitsOf(scene_.joints[c.joint].type).coordinates;
    const bool isAngle = kinds[c.place] == scene::CoordinateKind::angle;
    const double size = isAngle ? frames_[c.joint].size : 1;
    for (const auto& [end, sign] : {std::pair(of.lower, 1.0), std::pair(of.upper, -1.0)}) {
        if (!end)
            continue;
        const auto distance = [this, c, factor = sign * size, at = *end](const Along& along) {
            const Jet q = kinematics_.coordinate(c.joint, c.place, along);
            return physics::scaled(g_, factor, difference(g_, q, constantJet(g_, at)));
        };
        const Node multiplier = multipliers_.add(
            [distance](const Along& along) { return JointCondition{.jet = distance(along)}; },
            {0, std::numeric_limits<double>::infinity(), of.limitRestitution});
        multipliers_.keepThroughBlows(distance({}));
        push(distance({}).rate, multiplier);
    }
}

// Dry friction holds the coordinate while less than its most does.
void JointReader::brake(const Coordinate& c, const Jet& jet) {
    const double most = said(c).friction;
    const Node multiplier = multipliers_.add(
        [this, c](const Along& along) {
            return JointCondition{kinematics_.coordinate(c.joint, c.place, along),
                                  JointCondition::Order::velocity};
        },
        {-most, most, 0});
    push(jet.rate, multiplier);
}

void JointReader::keepGear(std::size_t gear) {
    const scene::Gear& said = scene_.gears[gear];
    struct Term {
        Coordinate coordinate;
        double ratio;
    };
    std::vector<Term> terms;
    std::vector<std::size_t> moving;
    for (const scene::Gear::Term& term : said.terms) {
        const auto found = std::ranges::find(scene_.joints, term.joint, &scene::Joint::name);
        if (found == scene_.joints.end())
            continue;
        const auto joint = static_cast<std::size_t>(found - scene_.joints.begin());
        terms.push_back({{joint, term.coordinate}, term.ratio});
        for (const std::size_t body : frames_.moving(joint))
            if (std::ranges::find(moving, body) == moving.end())
                moving.push_back(body);
    }
    if (moving.empty())
        return;
    const double size = frames_[terms[0].coordinate.joint].size;
    multipliers_.begin({said.name, moving, size, "gear"}, said.release);
    const auto jetOf = [this, terms](const Along& along) {
        Jet all = constantJet(g_, 0);
        for (const auto& [c, ratio] : terms)
            all =
                sum(g_, all, physics::scaled(g_, ratio, kinematics_.gone(c.joint, c.place, along)));
        return all;
    };
    const Node multiplier = multipliers_.add(
        [jetOf](const Along& along) { return JointCondition{.jet = jetOf(along)}; });
    const Jet jet = jetOf({});
    multipliers_.keepThroughBlows(jet);
    from_ = {};
    from_.kind = Contribution::Kind::gear;
    from_.element = gear;
    push(jet.rate, multiplier);
}

// An angle that is an unknown of its own is kept with the attitudes.
void JointReader::tie(const Coordinate& c) {
    const Node symbol = frames_[c.joint].angles[c.place];
    if (!multipliers_.needsTie(symbol))
        return;
    const Node multiplier = multipliers_.add([this, c](const Along& along) {
        return JointCondition{kinematics_.tie(c.joint, c.place, along),
                              JointCondition::Order::first};
    });
    multipliers_.tie(symbol, multiplier);
    kinematics_.setTie(symbol, multiplier);
}

} // namespace physics
