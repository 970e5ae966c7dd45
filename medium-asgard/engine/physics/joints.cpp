#include "physics/joints.h"

#include "expression/tape.h"
#include "scene/joint_types.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace physics {

using scene::JointType;

namespace {

// The same beside it: what rounding makes of a direction that is along an axis.
Vector cleaned(Vector v) {
    constexpr double rounding = 1e-15;
    for (Eigen::Index i = 0; i < 3; ++i)
        if (std::abs(v[i]) < rounding)
            v[i] = 0;
    return v;
}

constexpr double stopResolution = 1e-9; // of the scene's size: lower hops and gaps are none

// Of length 1: the world's axis that is the farthest from n, without its part along n.
Vector acrossOf(const Vector& n) {
    Eigen::Index least = 0;
    n.cwiseAbs().minCoeff(&least);
    const Vector axis = Vector::Unit(least);
    return cleaned((axis - n * n.dot(axis)).normalized());
}

const expression::Phase& phaseAt(const expression::Unknown& unknown, double time) {
    const auto after = std::ranges::upper_bound(unknown.phases, time, {}, &expression::Phase::from);
    return after == unknown.phases.begin() ? unknown.phases.front() : *(after - 1);
}

} // namespace

JointReader::JointReader(Graph& g, const scene::Scene& scene, Scope& scope,
                         std::span<const BodyMotion> bodies, std::vector<std::string>& faults)
    : g_(g), scene_(scene), scope_(scope), bodies_(bodies), faults_(faults),
      world_(fixedBody(g, {Vector::Zero(), Quaternion::Identity()})) {
    for (const scene::Joint& joint : scene.joints)
        frames_.push_back(frameOf(joint));
    for (std::size_t j = 0; j < frames_.size() && faults_.empty(); ++j)
        nameJoint(j);
    scope_.setJoints(nodes_);
}

// ---------------------------------------------------------------------------------------------
// Frames

std::optional<std::size_t> JointReader::bodyNamed(const std::string& name) const {
    const auto found = std::ranges::find(bodies_, name, &BodyMotion::name);
    return found == bodies_.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - bodies_.begin()));
}

const BodySymbols& JointReader::bodyOf(const End& end) const {
    return end.body ? bodies_[*end.body].symbols : world_;
}

geometry::Pose JointReader::poseOf(const End& end) const {
    return end.body ? bodies_[*end.body].start
                    : geometry::Pose{Vector::Zero(), Quaternion::Identity()};
}

JointReader::Frame JointReader::frameOf(const scene::Joint& joint) {
    Frame frame;
    auto& [first, second] = frame.ends;
    const auto find = [&](End& end, const std::string& name) {
        end.body = bodyNamed(name);
        if (!end.body)
            faults_.push_back("joint \"" + joint.name + "\": no body named \"" + name + "\"");
    };
    find(first, joint.body1);
    if (joint.body2)
        find(second, *joint.body2);
    if (!faults_.empty())
        return frame;
    first.arm = scope_.armTo(*first.body, joint.offset1);
    const geometry::Pose one = poseOf(first), two = poseOf(second);
    const Vector point = one.position + one.attitude * first.arm;
    if (joint.offset2)
        second.arm = second.body ? scope_.armTo(*second.body, joint.offset2) : *joint.offset2;
    else if (joint.type != JointType::distance)
        second.arm = cleaned(two.attitude.conjugate() * (point - two.position));
    findAxes(joint, frame);
    frame.size = sizeOf(frame);
    return frame;
}

// docs/scene-language.md, "Joints": which axis belongs to which body.
void JointReader::findAxes(const scene::Joint& joint, Frame& frame) const {
    auto& [first, second] = frame.ends;
    const Quaternion one = poseOf(first).attitude, two = poseOf(second).attitude;
    first.axis = joint.axis.isZero(0) ? Vector(Vector::UnitZ()) : Vector(joint.axis.normalized());
    Vector axis = cleaned(one * first.axis);
    if (joint.type == JointType::universal) {
        const Vector other =
            joint.axis2 ? cleaned(two * joint.axis2->normalized()) : acrossOf(axis);
        second.axis = cleaned(two.conjugate() * other);
        first.across = cleaned(one.conjugate() * other);
        second.across = cleaned(two.conjugate() * axis);
        return;
    }
    if (joint.axis2 && joint.type != JointType::planar)
        axis = cleaned(two * joint.axis2->normalized());
    Vector across = acrossOf(axis);
    if (joint.type == JointType::planar) {
        Vector along = joint.axis2 ? Vector(two * *joint.axis2) : Vector(two * Vector::UnitX());
        if (!joint.axis2 && along.cross(axis).norm() < 1e-9)
            along = two * Vector::UnitY();
        across = cleaned((along - axis * axis.dot(along)).normalized());
    }
    const Vector third = cleaned(axis.cross(across));
    second.axis = cleaned(two.conjugate() * axis);
    for (End* const end : {&first, &second}) {
        const Quaternion back = poseOf(*end).attitude.conjugate();
        end->across = cleaned(back * across);
        end->third = cleaned(back * third);
    }
}

double JointReader::sizeOf(const Frame& frame) const {
    constexpr double ofDistance = 1e-4; // from the origin
    double size = 0;
    for (const End& end : frame.ends) {
        if (end.body)
            size = std::max({size, bodies_[*end.body].mass.radius, end.arm.norm()});
        const geometry::Pose pose = poseOf(end);
        size = std::max(size, ofDistance * (pose.position + pose.attitude * end.arm).norm());
    }
    return size;
}

std::vector<std::size_t> JointReader::movingOf(const Frame& frame) const {
    std::vector<std::size_t> moving;
    for (const End& end : frame.ends)
        if (end.body && !bodies_[*end.body].isFixed)
            moving.push_back(*end.body);
    return moving;
}

// ---------------------------------------------------------------------------------------------
// Conditions and coordinates

BodyRates JointReader::ratesOf(const End& end, const Along& along) const {
    const NodeVector zero = constant(g_, Vector::Zero());
    BodyRates rates{zero, zero};
    if (!along.set || !end.body || bodies_[*end.body].isFixed)
        return rates;
    const BodyMotion& body = bodies_[*end.body];
    const auto rateOfUnknown = [&](std::size_t unknown) {
        return phaseAt(along.set->unknowns[unknown], along.time).derivative;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        rates.acceleration[i] = rateOfUnknown(body.unknown(dx) + i);
        rates.spinRate[i] = rateOfUnknown(body.unknown(w1) + i);
    }
    return rates;
}

JetVector JointReader::carried(const End& end, const Vector& v, const Along& along) {
    return carriedJet(g_, bodyOf(end), ratesOf(end, along), v);
}

// Places first: far from the origin their difference is small and exact.
JetVector JointReader::apart(const Frame& frame, const Along& along) {
    const auto& [first, second] = frame.ends;
    const JetVector centres = difference(g_, centreJet(bodyOf(first), ratesOf(first, along)),
                                         centreJet(bodyOf(second), ratesOf(second, along)));
    return sum(
        g_, centres,
        difference(g_, carried(first, first.arm, along), carried(second, second.arm, along)));
}

JetVector JointReader::turning(const Frame& frame, const Along& along) {
    const auto& [first, second] = frame.ends;
    return difference(g_, spinJet(g_, bodyOf(first), ratesOf(first, along)),
                      spinJet(g_, bodyOf(second), ratesOf(second, along)));
}

std::vector<Jet> JointReader::conditionsOf(std::size_t joint, const Along& along) {
    const scene::Joint& said = scene_.joints[joint];
    const Frame& frame = frames_[joint];
    const auto& [first, second] = frame.ends;
    const JetVector d = apart(frame, along), n1 = carried(first, first.axis, along),
                    n2 = carried(second, second.axis, along),
                    e1 = carried(first, first.across, along),
                    e2 = carried(second, second.across, along),
                    f2 = carried(second, second.third, along);
    std::vector<Jet> made;
    const auto meet = [&] {
        for (std::size_t i = 0; i < 3; ++i)
            made.push_back({d.value[i], d.rate[i], d.second[i]});
    };
    const auto turnAbout = [&](const JetVector& a, const JetVector& b) {
        made.push_back(scaled(g_, frame.size, product(g_, a, b)));
    };
    const auto slide = [&] {
        made.push_back(product(g_, e2, d));
        made.push_back(product(g_, f2, d));
    };
    switch (said.type) {
    case JointType::fixed:
    case JointType::hinge:
    case JointType::ball:
    case JointType::universal:
        meet();
        break;
    case JointType::slider:
    case JointType::cylindrical:
    case JointType::screw:
        slide();
        break;
    case JointType::planar:
        made.push_back(product(g_, n2, d));
        break;
    case JointType::distance:
        if (scene::isRigidDistance(said))
            made.push_back(difference(g_, length(g_, d), constantJet(g_, frame.start[0])));
        return made;
    }
    if (said.type == JointType::ball)
        return made;
    turnAbout(n1, said.type == JointType::universal ? n2 : e2);
    if (said.type == JointType::universal)
        return made;
    turnAbout(n1, f2);
    if (said.type == JointType::fixed || said.type == JointType::slider)
        turnAbout(e1, f2);
    if (said.type == JointType::screw) {
        const double perAngle = said.pitch / (2 * std::numbers::pi);
        const Jet slid = difference(g_, product(g_, n2, d), constantJet(g_, frame.start[0]));
        made.push_back(difference(g_, slid, scaled(g_, perAngle, coordinateOf(joint, 0, along))));
    }
    return made;
}

Jet JointReader::angleOf(const Frame& frame, std::size_t coordinate, const JetVector& axis,
                         const Along& along) {
    const JetVector spin = turning(frame, along);
    const Node q = frame.angles[coordinate];
    Node second = g_.add(dot(g_, axis.rate, spin.value), dot(g_, axis.value, spin.rate));
    // What moves the angle without the bodies moves conditions that read it; it is 0 but for drift.
    const auto angle = std::ranges::find(angles_, q, &Angle::symbol);
    if (along.set && angle != angles_.end() && angle->tie)
        second = g_.add(second, *angle->tie);
    return {q, dot(g_, axis.value, spin.value), second};
}

Jet JointReader::coordinateOf(std::size_t joint, std::size_t coordinate, const Along& along) {
    const Frame& frame = frames_[joint];
    const auto& [first, second] = frame.ends;
    const auto carriedBySecond = [&](const Vector& v) { return carried(second, v, along); };
    const auto slid = [&](const Vector& direction) {
        return difference(g_, product(g_, carriedBySecond(direction), apart(frame, along)),
                          constantJet(g_, frame.start[coordinate]));
    };
    switch (scene_.joints[joint].type) {
    case JointType::distance:
        return length(g_, apart(frame, along));
    case JointType::ball:
        return ballAngle(frame, along);
    case JointType::universal:
        return angleOf(frame, coordinate,
                       coordinate == 0 ? carried(first, first.axis, along)
                                       : carriedBySecond(second.axis),
                       along);
    case JointType::slider:
        return slid(second.axis);
    case JointType::cylindrical:
        if (coordinate == 1)
            return slid(second.axis);
        break;
    case JointType::planar:
        if (coordinate < 2)
            return slid(coordinate == 0 ? second.across : second.third);
        break;
    case JointType::hinge:
    case JointType::screw:
    case JointType::fixed:
        break;
    }
    return angleOf(frame, coordinate, carriedBySecond(second.axis), along);
}

// With a and b the three axes of the first and of the second body, which agree at the start,
//     sin q  axis = sum b x a / 2,     cos q = (sum a.b - 1) / 2.
Jet JointReader::ballAngle(const Frame& frame, const Along& along) {
    const auto& [first, second] = frame.ends;
    NodeVector axis = constant(g_, Vector::Zero());
    Node trace = g_.constant(-1);
    const std::array<Vector End::*, 3> axes{&End::axis, &End::across, &End::third};
    for (const auto of : axes) {
        const NodeVector a = carried(first, first.*of, along).value,
                         b = carried(second, second.*of, along).value;
        axis = add(g_, axis, cross(g_, b, a));
        trace = g_.add(trace, dot(g_, a, b));
    }
    const Node sine = g_.apply(Op::sqrt, dot(g_, axis, axis));
    const NodeVector spin = turning(frame, along).value;
    const Node zero = g_.constant(0);
    const Node rate =
        g_.apply(Op::select, g_.apply(Op::equal, sine, zero),
                 g_.apply(Op::sqrt, dot(g_, spin, spin)), g_.divide(dot(g_, spin, axis), sine));
    return {g_.apply(Op::atan2, sine, trace), rate, zero};
}

// s cos q - c sin q, where s and c are the sine and the cosine of the angle between the bodies.
JointReader::Condition JointReader::tieOf(std::size_t joint, std::size_t coordinate,
                                          const Along& along) {
    const Frame& frame = frames_[joint];
    const auto& [first, second] = frame.ends;
    const JetVector e1 = carried(first, first.across, along),
                    e2 = carried(second, second.across, along);
    Jet sine, cosine;
    if (scene_.joints[joint].type == JointType::universal) {
        const JetVector a1 = carried(first, first.axis, along),
                        a2 = carried(second, second.axis, along);
        cosine = coordinate == 0 ? product(g_, e1, a2) : product(g_, a1, e2);
        sine = coordinate == 0 ? product(g_, e1, cross(g_, a1, a2))
                               : product(g_, a1, cross(g_, a2, e2));
    } else {
        cosine = product(g_, e1, e2);
        sine = product(g_, e1, carried(second, second.third, along));
    }
    const Node q = frame.angles[coordinate];
    const Node sinQ = g_.apply(Op::sin, q), cosQ = g_.apply(Op::cos, q);
    const auto angle = std::ranges::find(angles_, q, &Angle::symbol);
    const Node rateOfQ = g_.add(coordinateOf(joint, coordinate, along).rate, *angle->tie);
    const auto size = g_.constant(frame.size);
    const Node gap = g_.subtract(g_.multiply(sine.value, cosQ), g_.multiply(cosine.value, sinQ));
    const Node moved = g_.subtract(g_.multiply(sine.rate, cosQ), g_.multiply(cosine.rate, sinQ));
    const Node turned = g_.multiply(
        rateOfQ, g_.add(g_.multiply(sine.value, sinQ), g_.multiply(cosine.value, cosQ)));
    return {.jet = {g_.multiply(size, gap), g_.multiply(size, g_.subtract(moved, turned)), {}},
            .order = Condition::Order::first};
}

// ---------------------------------------------------------------------------------------------
// Multipliers and forces

// The symbols of its angles, and what its lengths are at the start.
void JointReader::nameJoint(std::size_t joint) {
    const scene::Joint& said = scene_.joints[joint];
    Frame& frame = frames_[joint];
    const auto kinds = scene::traitsOf(said.type).coordinates;
    const auto& [first, second] = frame.ends;
    const geometry::Pose one = poseOf(first), two = poseOf(second);
    const Vector d =
        one.position + one.attitude * first.arm - two.position - two.attitude * second.arm;
    const std::vector<std::size_t> moving = movingOf(frame);
    frame.angles.resize(kinds.size());
    frame.start.assign(std::max<std::size_t>(kinds.size(), 1), 0);
    if (said.type == JointType::distance) {
        frame.start[0] = d.norm();
        if (!(frame.start[0] > 0))
            faults_.push_back("line " + std::to_string(said.source.line) + ": joint \"" +
                              said.name +
                              "\": its points are in one place, and their distance has "
                              "no direction; a joint of type ball holds two points together");
    }
    JointNodes nodes;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const bool isOwnUnknown =
            kinds[k] == scene::CoordinateKind::angle && said.type != JointType::ball;
        if (isOwnUnknown && !moving.empty())
            frame.angles[k] = g_.symbol(said.name + ".q" + scene::coordinateSuffix(said.type, k));
        else
            frame.angles[k] = g_.constant(0);
        const Vector direction = said.type == JointType::planar && k == 0   ? second.across
                                 : said.type == JointType::planar && k == 1 ? second.third
                                                                            : second.axis;
        if (said.type != JointType::distance && !isOwnUnknown)
            frame.start[k] = (two.attitude * direction).dot(d);
        const Jet jet = coordinateOf(joint, k, {});
        nodes.q.push_back(jet.value);
        nodes.dq.push_back(jet.rate);
        nodes.motor.push_back(g_.constant(0));
        if (isOwnUnknown && !moving.empty())
            angles_.push_back(
                {frame.angles[k], jet.rate, frame.size, moving.front(), std::nullopt});
    }
    if (said.type == JointType::screw)
        frame.start[0] = (two.attitude * second.axis).dot(d);
    nodes.force = nodes.couple = constant(g_, Vector::Zero());
    nodes_.push_back(std::move(nodes));
}

void JointReader::addKept(const scene::Source& source, const std::string& element,
                          std::vector<std::size_t> bodies,
                          std::function<Condition(const Along&)> make) {
    Kept kept;
    kept.element = element;
    kept.line = source.line;
    kept.multiplier = g_.symbol(element + ".condition" + std::to_string(kept_.size()));
    kept.owner = bodies.front();
    kept.bodies = std::move(bodies);
    kept.make = std::move(make);
    kept.release = release_;
    kept_.push_back(std::move(kept));
}

void JointReader::push(Node rate, Node force, const Contribution& from,
                       std::span<const std::size_t> bodies,
                       std::vector<Contribution>& contributions) {
    for (const std::size_t body : bodies) {
        const BodySymbols& s = bodies_[body].symbols;
        Contribution made = from;
        made.body = body;
        for (std::size_t i = 0; i < 3; ++i) {
            made.force[i] = g_.multiply(differentiate(g_, rate, s.velocity[i]), force);
            made.torque[i] = g_.multiply(differentiate(g_, rate, s.spin[i]), force);
        }
        contributions.push_back(std::move(made));
    }
}

void JointReader::keepRow(Node rate, std::span<const std::size_t> bodies) {
    JointRow& made = rows_.emplace_back();
    made.multiplier = kept_.size() - 1; // its unknown is known later
    std::vector<JointPush>& row = made.pushes;
    for (const std::size_t body : bodies) {
        const BodySymbols& s = bodies_[body].symbols;
        JointPush push{.body = body, .linear = {}, .angular = {}};
        for (std::size_t i = 0; i < 3; ++i) {
            push.linear[i] = differentiate(g_, rate, s.velocity[i]);
            push.angular[i] = differentiate(g_, rate, s.spin[i]);
        }
        if (!s.isSpinInWorldAxes)
            push.angular = s.toWorld(g_, push.angular);
        row.push_back(push);
    }
}

void JointReader::contribute(std::vector<Contribution>& contributions) {
    for (std::size_t j = 0; j < frames_.size(); ++j) {
        const std::vector<std::size_t> moving = movingOf(frames_[j]);
        if (moving.empty())
            continue;
        const scene::Joint& joint = scene_.joints[j];
        const std::size_t first = contributions.size();
        Contribution from;
        from.kind = Contribution::Kind::joint;
        from.element = j;
        releaseBy(joint.release, joint.source, joint.name, moving.front());
        if (joint.type == JointType::screw)
            tie(j, 0);
        const std::vector<Jet> conditions = conditionsOf(j, {});
        for (std::size_t r = 0; r < conditions.size(); ++r) {
            addKept(joint.source, joint.name, moving, [this, j, r](const Along& along) {
                return Condition{conditionsOf(j, along)[r], Condition::Order::second};
            });
            keepRow(conditions[r].rate, moving);
            push(conditions[r].rate, kept_.back().multiplier, from, moving, contributions);
        }
        for (std::size_t k = 0; k < joint.coordinates.size(); ++k)
            drive(j, k, contributions);
        addForce(j, std::span(contributions).subspan(first));
    }
    for (std::size_t i = 0; i < scene_.gears.size(); ++i)
        keepGear(i, contributions);
    scope_.setJoints(nodes_);
    readReleases();
}

// All that the joint does to its first body, about its point; of a fixed one, against the second.
void JointReader::addForce(std::size_t joint, std::span<const Contribution> contributions) {
    const auto& [first, second] = frames_[joint].ends;
    const bool isFirst = first.body && !bodies_[*first.body].isFixed;
    const End& end = isFirst ? first : second;
    JointNodes& nodes = nodes_[joint];
    for (const Contribution& c : contributions) {
        if (c.body != *end.body)
            continue;
        const BodySymbols& s = bodies_[c.body].symbols;
        const NodeVector arm = s.toWorld(g_, constant(g_, end.arm));
        const NodeVector torque = s.isSpinInWorldAxes ? c.torque : s.toWorld(g_, c.torque);
        const NodeVector couple = subtract(g_, torque, cross(g_, arm, c.force));
        const Node sign = g_.constant(isFirst ? 1 : -1);
        nodes.force = add(g_, nodes.force, scaled(g_, sign, c.force));
        nodes.couple = add(g_, nodes.couple, scaled(g_, sign, couple));
    }
}

std::optional<Node> JointReader::parsed(const scene::Expression& text, const scene::Source& source,
                                        const std::string& what, scene::Reading reading) {
    const auto made = scope_.parse(g_, text, reading);
    if (const auto* node = std::get_if<Node>(&made))
        return *node;
    faults_.push_back("line " + std::to_string(source.line) + ": " + what + ": " +
                      std::get<expression::SyntaxError>(made).message);
    return std::nullopt;
}

// Motor, spring and damper push along the coordinate; a speed or a place is held by a multiplier
// that does.
void JointReader::drive(std::size_t joint, std::size_t coordinate,
                        std::vector<Contribution>& contributions) {
    const scene::Joint& said = scene_.joints[joint];
    const scene::JointCoordinate& c = said.coordinates[coordinate];
    const std::string suffix = scene::coordinateSuffix(said.type, coordinate);
    const std::string of = suffix + " of joint \"" + said.name + "\"";
    const Jet jet = coordinateOf(joint, coordinate, {});
    const std::vector<std::size_t> moving = movingOf(frames_[joint]);
    Contribution from;
    from.kind = Contribution::Kind::joint;
    from.element = joint;
    if (c.position && c.maxMotor)
        faults_.push_back("line " + std::to_string(said.source.line) + ": -max_motor" + of +
                          " is computed with -speed only; leave it out");
    if (c.lower || c.upper)
        limit(joint, coordinate, contributions);
    if (c.friction > 0)
        brake(joint, coordinate, contributions);
    Node force = g_.constant(0);
    if (c.stiffness != 0)
        force = g_.multiply(g_.constant(-c.stiffness), g_.subtract(jet.value, g_.constant(c.rest)));
    if (c.damping != 0)
        force = g_.subtract(force, g_.multiply(g_.constant(c.damping), jet.rate));
    Node& motor = nodes_[joint].motor[coordinate];
    if (c.motor)
        if (const auto node = parsed(*c.motor, said.source, "-motor" + of, scene::Reading::state)) {
            motor = *node;
            force = g_.add(force, *node);
        }
    const bool isPosition = c.position.has_value();
    if (c.speed || isPosition) {
        const auto node =
            isPosition
                ? parsed(*c.position, said.source, "-position" + of, scene::Reading::positions)
                : parsed(*c.speed, said.source, "-speed" + of, scene::Reading::state);
        if (!node)
            return;
        if (isPosition)
            tie(joint, coordinate);
        const auto read = scope_.trajectoriesReadBy(g_, std::span(&*node, 1));
        addKept(said.source, said.name, moving, [=, this](const Along& along) {
            const Node now =
                along.set ? substitute(g_, *node, scope_.piecesFrom(g_, read, along.time)) : *node;
            const Node rate = rateOf(now, along);
            const Jet wanted =
                isPosition ? Jet{now, rate, rateOf(rate, along)} : Jet{g_.constant(0), now, rate};
            return Condition{difference(g_, coordinateOf(joint, coordinate, along), wanted),
                             isPosition ? Condition::Order::second : Condition::Order::velocity};
        });
        kept_.back().trajectories = read;
        if (c.maxMotor)
            kept_.back().bounds = {-*c.maxMotor, *c.maxMotor, 0};
        else
            keepRow(jet.rate, moving);
        motor = kept_.back().multiplier;
    }
    if (!g_.isConstant(force, 0))
        push(jet.rate, releasable(force, said.source, said.name, moving), from, moving,
             contributions);
    if (c.speed || isPosition)
        push(jet.rate, motor, from, moving, contributions);
}

void JointReader::releaseBy(const std::optional<scene::Expression>& text,
                            const scene::Source& source, const std::string& element,
                            std::size_t owner) {
    release_.reset();
    if (!text)
        return;
    release_ = g_.symbol(element + ".release");
    releases_.push_back({.symbol = *release_,
                         .text = *text,
                         .line = source.line,
                         .element = element,
                         .value = g_.constant(0),
                         .owner = owner});
}

// What a joint does may release it: that is known when all joints are.
void JointReader::readReleases() {
    for (Release& release : releases_) {
        const auto made = scope_.parse(g_, release.text, scene::Reading::release);
        if (const auto* node = std::get_if<Node>(&made))
            release.value = *node;
        else
            faults_.push_back("line " + std::to_string(release.line) + ": -release of \"" +
                              release.element +
                              "\": " + std::get<expression::SyntaxError>(made).message);
    }
}

Node JointReader::releasable(Node force, const scene::Source& source, const std::string& element,
                             const std::vector<std::size_t>& moving) {
    if (!release_)
        return force;
    addKept(source, element, moving, {});
    const Node multiplier = kept_.back().multiplier, rate = g_.subtract(multiplier, force);
    kept_.back().make = [rate](const Along&) {
        return Condition{{rate, rate, rate}, Condition::Order::value};
    };
    return multiplier;
}

// A stop at each end: the coordinate's distance from it as a length, and a force that only pushes
// away.
void JointReader::limit(std::size_t joint, std::size_t coordinate,
                        std::vector<Contribution>& contributions) {
    const scene::Joint& said = scene_.joints[joint];
    const scene::JointCoordinate& c = said.coordinates[coordinate];
    const auto kinds = scene::traitsOf(said.type).coordinates;
    const bool isAngle = kinds[coordinate] == scene::CoordinateKind::angle;
    const double size = isAngle ? frames_[joint].size : 1;
    const std::vector<std::size_t> moving = movingOf(frames_[joint]);
    Contribution from;
    from.kind = Contribution::Kind::joint;
    from.element = joint;
    tie(joint, coordinate);
    for (const auto& [end, sign] : {std::pair(c.lower, 1.0), std::pair(c.upper, -1.0)}) {
        if (!end)
            continue;
        const double factor = sign * size, at = *end;
        const auto distance = [=, this](const Along& along) {
            return physics::scaled(
                g_, factor,
                difference(g_, coordinateOf(joint, coordinate, along), constantJet(g_, at)));
        };
        addKept(said.source, said.name, moving, [distance](const Along& along) {
            return Condition{distance(along), Condition::Order::second};
        });
        kept_.back().bounds = {0, std::numeric_limits<double>::infinity(), c.limitRestitution};
        push(distance({}).rate, kept_.back().multiplier, from, moving, contributions);
    }
}

// Dry friction holds the coordinate while less than its most does.
void JointReader::brake(std::size_t joint, std::size_t coordinate,
                        std::vector<Contribution>& contributions) {
    const scene::Joint& said = scene_.joints[joint];
    const double most = said.coordinates[coordinate].friction;
    const std::vector<std::size_t> moving = movingOf(frames_[joint]);
    Contribution from;
    from.kind = Contribution::Kind::joint;
    from.element = joint;
    addKept(said.source, said.name, moving, [=, this](const Along& along) {
        return Condition{coordinateOf(joint, coordinate, along), Condition::Order::velocity};
    });
    kept_.back().bounds = {-most, most, 0};
    push(coordinateOf(joint, coordinate, {}).rate, kept_.back().multiplier, from, moving,
         contributions);
}

void JointReader::keepGear(std::size_t gear, std::vector<Contribution>& contributions) {
    const scene::Gear& said = scene_.gears[gear];
    struct Term {
        std::size_t joint, coordinate;
        double ratio;
    };
    std::vector<Term> terms;
    std::vector<std::size_t> moving;
    for (const scene::Gear::Term& term : said.terms) {
        const auto found = std::ranges::find(scene_.joints, term.joint, &scene::Joint::name);
        if (found == scene_.joints.end())
            continue;
        const auto joint = static_cast<std::size_t>(found - scene_.joints.begin());
        terms.push_back({joint, term.coordinate, term.ratio});
        tie(joint, term.coordinate);
        for (const std::size_t body : movingOf(frames_[joint]))
            if (std::ranges::find(moving, body) == moving.end())
                moving.push_back(body);
    }
    if (moving.empty())
        return;
    releaseBy(said.release, said.source, said.name, moving.front());
    const auto jetOf = [this, terms](const Along& along) {
        Jet all = constantJet(g_, 0);
        for (const Term& term : terms)
            all = sum(
                g_, all,
                physics::scaled(g_, term.ratio, coordinateOf(term.joint, term.coordinate, along)));
        return all;
    };
    addKept(said.source, said.name, moving, [jetOf](const Along& along) {
        return Condition{jetOf(along), Condition::Order::second};
    });
    Contribution from;
    from.kind = Contribution::Kind::gear;
    from.element = gear;
    keepRow(jetOf({}).rate, moving);
    push(jetOf({}).rate, kept_.back().multiplier, from, moving, contributions);
}

// A coordinate that is an unknown of its own is kept with the attitudes.
void JointReader::tie(std::size_t joint, std::size_t coordinate) {
    const Node symbol = frames_[joint].angles[coordinate];
    const auto angle = std::ranges::find(angles_, symbol, &Angle::symbol);
    if (angle == angles_.end() || angle->tie)
        return;
    const scene::Joint& said = scene_.joints[joint];
    addKept(said.source, said.name, movingOf(frames_[joint]),
            [=, this](const Along& along) { return tieOf(joint, coordinate, along); });
    angle->tie = kept_.back().multiplier;
}

// ---------------------------------------------------------------------------------------------
// Unknowns

Node JointReader::rateOf(Node node, const Along& along) {
    if (!along.set)
        return g_.constant(0);
    Node rate = differentiate(g_, node, scope_.time());
    for (const Node symbol : symbolsOf(g_, std::span(&node, 1))) {
        const auto unknown = unknownOf_.find(symbol.index);
        if (unknown != unknownOf_.end())
            rate = g_.add(
                rate,
                g_.multiply(differentiate(g_, node, symbol),
                            phaseAt(along.set->unknowns[unknown->second], along.time).derivative));
    }
    return rate;
}

void JointReader::addUnknown(expression::EquationSet& set, const Angle& angle) const {
    expression::Unknown unknown;
    unknown.name = g_.name(angle.symbol);
    unknown.symbol = angle.symbol;
    unknown.lengthPerUnit = angle.size;
    unknown.phases.emplace_back();
    unknown.phases[0].derivative = angle.tie ? g_.add(angle.rate, *angle.tie) : angle.rate;
    set.unknowns.push_back(std::move(unknown));
}

// Its condition is another whenever a body that it moves, or a trajectory that it reads, has
// another phase.
void JointReader::addUnknown(expression::EquationSet& set, const Kept& kept) {
    std::set<double> times{-std::numeric_limits<double>::infinity()};
    for (const std::size_t body : kept.bodies)
        for (std::size_t i = 0; i < bodyUnknowns; ++i)
            for (const expression::Phase& phase :
                 set.unknowns[bodies_[body].firstUnknown + i].phases)
                times.insert(phase.from);
    for (const std::size_t trajectory : kept.trajectories)
        for (const TrajectoryPiece& piece : scope_.trajectory(trajectory).pieces)
            times.insert(piece.from);
    expression::Unknown unknown;
    unknown.name = kept.element;
    unknown.symbol = kept.multiplier;
    for (const double time : times) {
        const Condition condition = kept.make({&set, time});
        expression::Phase phase;
        phase.from = time;
        phase.condition.emplace();
        const auto& [value, rate, second] = condition.jet;
        using Order = Condition::Order;
        const bool isFirst = condition.order == Order::first || condition.order == Order::value;
        phase.derivative = isFirst ? rate : second;
        if (!isFirst)
            phase.condition->rate = rate;
        if (condition.order == Order::first || condition.order == Order::second)
            phase.condition->gap = value;
        phase.condition->release = kept.release;
        phase.condition->low = kept.bounds.low;
        phase.condition->high = kept.bounds.high;
        phase.condition->restitution = kept.bounds.restitution;
        phase.condition->resolution = stopResolution * extents().first;
        const auto isSame = [&](const expression::Phase& last) {
            return last.derivative == phase.derivative &&
                   last.condition->gap == phase.condition->gap &&
                   last.condition->rate == phase.condition->rate;
        };
        if (unknown.phases.empty() || !isSame(unknown.phases.back()))
            unknown.phases.push_back(phase);
    }
    set.unknowns.push_back(std::move(unknown));
}

std::vector<JointRow> JointReader::addUnknowns(expression::EquationSet& set,
                                               std::vector<std::size_t>& owners,
                                               std::vector<std::string>& notes) {
    for (const Angle& angle : angles_) {
        addUnknown(set, angle);
        owners.push_back(angle.owner);
    }
    for (const Release& release : releases_) {
        expression::Unknown unknown;
        unknown.name = g_.name(release.symbol);
        unknown.symbol = release.symbol;
        unknown.phases.emplace_back();
        unknown.phases[0].derivative = g_.constant(0);
        unknown.phases[0].given = release.value;
        set.unknowns.push_back(std::move(unknown));
        owners.push_back(release.owner);
    }
    for (std::size_t u = 0; u < set.unknowns.size(); ++u)
        unknownOf_.emplace(set.unknowns[u].symbol.index, u);
    const std::size_t first = set.unknowns.size();
    for (const Kept& kept : kept_) {
        addUnknown(set, kept);
        owners.push_back(kept.owner);
    }
    if (first < set.unknowns.size())
        checkStart(set, first, notes);
    for (JointRow& row : rows_)
        row.multiplier += first;
    return std::move(rows_);
}

// Gaps and their rates as the scene was written.
void JointReader::checkStart(const expression::EquationSet& set, std::size_t first,
                             std::vector<std::string>& notes) {
    constexpr double resolved = 1e-6; // of the scene's size: a smaller gap is closed
    std::vector<Node> inputs{set.time}, outputs;
    std::vector<double> values{scene_.simulator.start};
    for (const expression::Unknown& unknown : set.unknowns) {
        inputs.push_back(unknown.symbol);
        values.push_back(unknown.initial);
    }
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        const auto& condition = *phaseAt(set.unknowns[first + k], scene_.simulator.start).condition;
        outputs.push_back(condition.gap.value_or(g_.constant(0)));
        outputs.push_back(condition.rate.value_or(g_.constant(0)));
    }
    std::vector<double> found(outputs.size());
    expression::Tape::Scratch scratch;
    expression::Tape(g_, inputs, outputs).evaluate(values, found, scratch);
    const auto [size, speed] = extents();
    std::map<std::pair<int, std::string>, std::pair<double, double>> worst;
    for (std::size_t k = 0; k < kept_.size(); ++k) {
        const bool isStop = kept_[k].bounds.low == 0;
        if (isStop && found[2 * k] < -resolved * size)
            faults_.push_back("line " + std::to_string(kept_[k].line) + ": joint \"" +
                              kept_[k].element + "\" starts outside its limits");
        if (isStop || kept_[k].bounds.high < std::numeric_limits<double>::infinity())
            continue;
        auto& [gap, rate] = worst[{kept_[k].line, kept_[k].element}];
        gap = std::hypot(gap, found[2 * k]);
        rate = std::hypot(rate, found[2 * k + 1]);
    }
    for (const auto& [element, miss] : worst) {
        const std::string where =
            "line " + std::to_string(element.first) + ": \"" + element.second + "\": ";
        char text[200];
        if (!(miss.first <= resolved * size)) {
            std::snprintf(text, sizeof text,
                          "its bodies miss each other by %.4g at the start; place them so that "
                          "the joint closes",
                          miss.first);
            faults_.push_back(where + text);
        } else if (!(miss.second <= resolved * speed)) {
            std::snprintf(text, sizeof text,
                          "the velocities at the start differ by %.4g from what it allows; they "
                          "are changed by as little energy as possible",
                          miss.second);
            notes.push_back(where + text);
        }
    }
}

// The size of the box of all moving bodies at the start, and their largest speed.
std::pair<double, double> JointReader::extents() const {
    Eigen::AlignedBox3d box;
    double speed = 0;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const BodyMotion& body = bodies_[b];
        if (body.isFixed)
            continue;
        const Vector reach = Vector::Constant(body.mass.radius);
        box.extend(Vector(body.start.position - reach));
        box.extend(Vector(body.start.position + reach));
        speed =
            std::max(speed, scene_.bodies[b].initialVelocity.norm() +
                                body.mass.radius * scene_.bodies[b].initialAngularVelocity.norm());
    }
    const double size = box.isEmpty() ? 1 : box.sizes().maxCoeff();
    return {size, std::max(speed, 1e-6 * size)};
}

} // namespace physics
