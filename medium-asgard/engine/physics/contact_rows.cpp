#include "physics/contact_rows.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using expression::Condition;
using expression::Phase;
using Kind = GapConstraint::Kind;

constexpr double resolved = 1e-9; // of the smaller part: gaps lower than that are none

const Phase& inForce(const expression::Unknown& unknown, double time) {
    const auto after = std::ranges::upper_bound(unknown.phases, time, {}, &Phase::from);
    return after == unknown.phases.begin() ? unknown.phases.front() : *(after - 1);
}

Node lengthOf(Graph& g, const NodeVector& v) { return g.apply(Op::sqrt, dot(g, v, v)); }

NodeVector unit(Graph& g, const NodeVector& v) {
    const Node length = lengthOf(g, v);
    return {g.divide(v[0], length), g.divide(v[1], length), g.divide(v[2], length)};
}

// The axis of the world that is most nearly across; of several the last, which a scene in a plane
// of x and y has across it.
Vector acrossAxis(const Vector& normal) {
    int best = 2;
    for (const int axis : {1, 0})
        if (std::abs(normal[axis]) < std::abs(normal[best]) - 1e-9)
            best = axis;
    return Vector::Unit(best);
}

} // namespace

ContactRows::ContactRows(expression::EquationSet& set, const EquationsOfMotion& free, double time)
    : set_(set), g_(set.graph), free_(free), time_(time) {
    for (std::size_t i = 0; i < set.unknowns.size(); ++i)
        unknownOf_.emplace(set.unknowns[i].symbol.index, i);
}

Node ContactRows::rateOf(std::size_t unknown) const {
    const auto other = rates_.find(unknown);
    return other != rates_.end() ? other->second
                                 : inForce(set_.unknowns[unknown], time_).derivative;
}

// d/dt along the motion.
Node ContactRows::along(Node value) {
    Node rate = differentiate(g_, value, set_.time);
    for (const Node symbol : symbolsOf(g_, std::span(&value, 1)))
        if (const auto unknown = unknownOf_.find(symbol.index); unknown != unknownOf_.end())
            rate = g_.add(rate,
                          g_.multiply(differentiate(g_, value, symbol), rateOf(unknown->second)));
    return rate;
}

// ----------------------------------------------------------------------------------- geometry

NodeVector ContactRows::apartOf(const ContactPlace& place, const GapConstraint& gap) {
    const BodySymbols &body = symbols(place.body), &support = symbols(place.support);
    return add(g_, subtract(g_, body.position, support.position),
               subtract(g_, body.toWorld(g_, constant(g_, gap.bodyPoint)),
                        support.toWorld(g_, constant(g_, gap.supportPoint))));
}

NodeVector ContactRows::normalOf(const ContactPlace& place, const GapConstraint& gap) {
    const BodySymbols &body = symbols(place.body), &support = symbols(place.support);
    switch (gap.kind) {
    case Kind::onSupportPlane:
        return support.toWorld(g_, constant(g_, gap.normal));
    case Kind::onBodyPlane:
        return body.toWorld(g_, constant(g_, gap.normal));
    case Kind::roundOnPoint:
        return unit(g_, apartOf(place, gap));
    case Kind::roundOnLine: {
        const NodeVector apart = apartOf(place, gap);
        const NodeVector edge = support.toWorld(g_, constant(g_, gap.supportEdge));
        return unit(g_, subtract(g_, apart, scaled(g_, dot(g_, edge, apart), edge)));
    }
    case Kind::edgeOnEdge:
    case Kind::tilt:
        break;
    }
    const NodeVector a = body.toWorld(g_, constant(g_, gap.bodyEdge));
    const NodeVector b = support.toWorld(g_, constant(g_, gap.supportEdge));
    return unit(g_, gap.flipped ? cross(g_, b, a) : cross(g_, a, b));
}

Node ContactRows::gapOf(const ContactPlace& place, const GapConstraint& gap) {
    return g_.subtract(dot(g_, normalOf(place, gap), apartOf(place, gap)), g_.constant(gap.radius));
}

// Where an edge of the body comes nearest to one of the support, on the body's.
NodeVector ContactRows::crossingOf(const ContactPlace& place, const GapConstraint& gap) {
    const BodySymbols &body = symbols(place.body), &support = symbols(place.support);
    const NodeVector a = body.toWorld(g_, constant(g_, gap.bodyEdge));
    const NodeVector b = support.toWorld(g_, constant(g_, gap.supportEdge));
    const NodeVector apart = apartOf(place, gap);
    const Node both = dot(g_, a, b);
    const Node way = g_.divide(g_.subtract(g_.multiply(both, dot(g_, b, apart)), dot(g_, a, apart)),
                               g_.subtract(g_.constant(1), g_.multiply(both, both)));
    const NodeVector start = add(g_, body.position, body.toWorld(g_, constant(g_, gap.bodyPoint)));
    return add(g_, start, scaled(g_, way, a));
}

// The point to which sides refer, and about which a sphere of the body lies.
NodeVector ContactRows::placeOf(const ContactPlace& place, const GapConstraint& gap) {
    const BodySymbols &body = symbols(place.body), &support = symbols(place.support);
    if (gap.kind == Kind::edgeOnEdge)
        return crossingOf(place, gap);
    if (gap.kind == Kind::onBodyPlane)
        return add(g_, support.position, support.toWorld(g_, constant(g_, gap.supportPoint)));
    return add(g_, body.position, body.toWorld(g_, constant(g_, gap.bodyPoint)));
}

// Of several points their middle, as a point of the body; directions follow the normal.
ContactRows::Frame ContactRows::frameOf(const ContactPlace& place) {
    const GapConstraint& gap = place.points[0].gap;
    Frame frame;
    frame.normal = normalOf(place, gap);
    const BodySymbols& body = symbols(place.body);
    if (place.points.size() > 1) {
        frame.point = add(g_, body.position, body.toWorld(g_, constant(g_, place.centre)));
    } else {
        frame.point = placeOf(place, gap);
        const double inward = gap.kind == Kind::onBodyPlane ? gap.radius : -place.bodyRadius;
        frame.point = add(g_, frame.point, scaled(g_, g_.constant(inward), frame.normal));
    }
    const Vector axis = acrossAxis(place.normal);
    const bool isPlane = gap.kind == Kind::onSupportPlane || gap.kind == Kind::onBodyPlane;
    if (isPlane) { // directions of the plane
        const Vector n = gap.normal;
        const Vector second = (acrossAxis(n) - n * n.dot(acrossAxis(n))).normalized();
        const BodySymbols& owner = gap.kind == Kind::onBodyPlane ? body : symbols(place.support);
        frame.along = {owner.toWorld(g_, constant(g_, n.cross(second))),
                       owner.toWorld(g_, constant(g_, second))};
        return frame;
    }
    const NodeVector fixed = constant(g_, axis);
    const NodeVector second =
        unit(g_, subtract(g_, fixed, scaled(g_, dot(g_, fixed, frame.normal), frame.normal)));
    frame.along = {cross(g_, frame.normal, second), second};
    return frame;
}

NodeVector ContactRows::velocityAt(std::size_t body, const NodeVector& point,
                                   const Vector& surface) {
    const BodySymbols& s = symbols(body);
    const NodeVector arm = subtract(g_, point, s.position);
    return add(g_, add(g_, s.velocity, cross(g_, s.worldSpin(g_), arm)),
               s.toWorld(g_, constant(g_, surface)));
}

// --------------------------------------------------------------------------------------- rows

void ContactRows::addRow(const ContactPlace& place, Node multiplier, std::optional<Node> gap,
                         Node rate, Condition condition) {
    condition.gap = gap;
    condition.rate = rate;
    condition.resolution = resolved * place.size;
    rows_.push_back({multiplier, gap, rate, std::move(condition)});
    for (const std::size_t body : {place.body, place.support}) {
        const BodyMotion& motion = free_.bodies[body];
        if (motion.isFixed)
            continue;
        const Held held = unyieldingAt(free_, body, time_);
        Push push{.body = body, .linear = {}, .angular = {}, .multiplier = multiplier};
        for (std::size_t i = 0; i < 3; ++i) {
            push.linear[i] = held.position[i] ? g_.constant(0)
                                              : differentiate(g_, rate, motion.symbols.velocity[i]);
            push.angular[i] =
                held.attitude ? g_.constant(0) : differentiate(g_, rate, motion.symbols.spin[i]);
        }
        pushes_.push_back(push);
    }
}

std::vector<Node> ContactRows::landingsOf(const ContactPlace& place) {
    std::vector<Node> heights;
    if (place.landings.empty())
        return heights;
    const GapConstraint& gap = place.points[0].gap;
    const BodySymbols &body = symbols(place.body), &support = symbols(place.support);
    const NodeVector normal = normalOf(place, gap);
    const NodeVector on =
        gap.kind == Kind::onSupportPlane
            ? add(g_, support.position, support.toWorld(g_, constant(g_, gap.supportPoint)))
        : gap.kind == Kind::onBodyPlane
            ? add(g_, body.position, body.toWorld(g_, constant(g_, gap.bodyPoint)))
            : crossingOf(place, gap);
    for (const ContactPlace::Landing& landing : place.landings) {
        const BodySymbols& owner = symbols(landing.body);
        const NodeVector at =
            add(g_, owner.position, owner.toWorld(g_, constant(g_, landing.vertex)));
        const Node height = dot(g_, normal, subtract(g_, at, on));
        heights.push_back(
            g_.add(landing.isAbove ? height : g_.negate(height), g_.constant(landing.room)));
    }
    return heights;
}

void ContactRows::addNormals(const ContactPlace& place, std::span<const Node> multipliers) {
    for (std::size_t k = 0; k < place.points.size(); ++k) {
        const ContactPoint& point = place.points[k];
        Condition condition;
        condition.low = 0;
        condition.leaving = place.leaving;
        if (k == 0)
            condition.valid = landingsOf(place);
        const NodeVector at = placeOf(place, point.gap);
        for (const ContactPoint::Side& side : point.sides) {
            const BodySymbols& owner = symbols(side.body);
            const NodeVector local = owner.toBody(g_, subtract(g_, at, owner.position));
            condition.valid.push_back(
                g_.add(dot(g_, constant(g_, side.inward), local), g_.constant(side.offset)));
        }
        const Node gap = g_.subtract(gapOf(place, point.gap), g_.constant(point.start));
        addRow(place, multipliers[k], gap, along(gap), std::move(condition));
    }
}

void ContactRows::addFriction(const ContactPlace& place, const Frame& frame,
                              std::span<const Node> multipliers) {
    const ContactFriction& of = place.friction;
    const std::size_t first = place.points.size(), count = of.reach > 0 ? 3 : 2;
    expression::Friction disc;
    disc.normals.assign(multipliers.begin(),
                        multipliers.begin() + static_cast<std::ptrdiff_t>(first));
    for (std::size_t i = 0; i < count; ++i)
        disc.rows.push_back(multipliers[first + i]);
    disc.sticking = of.sticking;
    disc.sliding = of.sliding;
    Condition condition;
    condition.friction = disc;
    const NodeVector speed = subtract(g_, velocityAt(place.body, frame.point, of.bodySurface),
                                      velocityAt(place.support, frame.point, of.supportSurface));
    for (std::size_t i = 0; i < 2; ++i)
        addRow(place, multipliers[first + i], std::nullopt, dot(g_, frame.along[i], speed),
               condition);
    if (count < 3)
        return;
    const NodeVector turning =
        subtract(g_, symbols(place.body).worldSpin(g_), symbols(place.support).worldSpin(g_));
    addRow(place, multipliers[first + 2], std::nullopt,
           g_.multiply(g_.constant(of.reach), dot(g_, frame.normal, turning)), condition);
}

// The couple that resists rolling, over the size: its multiplier is a force.
void ContactRows::addRolling(const ContactPlace& place, const Frame& frame,
                             std::span<const Node> multipliers) {
    const std::size_t first = place.rows() - 2;
    expression::Friction disc;
    disc.normals.assign(multipliers.begin(),
                        multipliers.begin() + static_cast<std::ptrdiff_t>(place.points.size()));
    disc.rows = {multipliers[first], multipliers[first + 1]};
    disc.sticking = disc.sliding = place.friction.rolling / place.size;
    Condition condition;
    condition.friction = disc;
    const NodeVector turning =
        subtract(g_, symbols(place.body).worldSpin(g_), symbols(place.support).worldSpin(g_));
    for (std::size_t i = 0; i < 2; ++i)
        addRow(place, multipliers[first + i], std::nullopt,
               g_.multiply(g_.constant(place.size), dot(g_, frame.along[i], turning)), condition);
}

void ContactRows::addContact(const ContactPlace& place, std::span<const Node> multipliers) {
    addNormals(place, multipliers);
    if (!place.hasFriction() && !place.rolls())
        return;
    const Frame frame = frameOf(place);
    if (place.hasFriction())
        addFriction(place, frame, multipliers);
    if (place.rolls())
        addRolling(place, frame, multipliers);
}

// ---------------------------------------------------------------------------------- equations

std::vector<ContactRows::Equation> ContactRows::velocities(std::span<const std::size_t> bodies) {
    std::vector<Equation> equations;
    for (const std::size_t body : bodies) {
        const BodyMotion& motion = free_.bodies[body];
        if (motion.isFixed)
            continue;
        const Held held = unyieldingAt(free_, body, time_);
        NodeVector linear = constant(g_, Vector::Zero()), angular = linear;
        for (const Push& push : pushes_)
            if (push.body == body) {
                linear = add(g_, linear, scaled(g_, push.multiplier, push.linear));
                angular = add(g_, angular, scaled(g_, push.multiplier, push.angular));
            }
        const Matrix inverse =
            held.attitude ? Matrix(Matrix::Zero()) : Matrix(motion.mass.inertia.inverse());
        NodeMatrix rows;
        for (int i = 0; i < 3; ++i)
            rows[static_cast<std::size_t>(i)] = constant(g_, inverse.row(i));
        const NodeVector turning = times(g_, rows, angular);
        const Node inverseMass = g_.constant(1 / motion.mass.mass);
        const auto give = [&](BodyUnknown first, std::size_t i, Node more) {
            const std::size_t unknown = motion.unknown(first) + i;
            const expression::Unknown& free = free_.set.unknowns[unknown];
            Equation equation{.unknown = unknown, .phase = inForce(free, time_), .later = {}};
            if (equation.phase.given)
                return;
            equation.phase.from = time_;
            equation.phase.jump.reset();
            equation.phase.derivative = g_.add(equation.phase.derivative, more);
            for (const Phase& phase : free.phases)
                if (phase.from > time_)
                    equation.later.push_back(phase);
            rates_[unknown] = equation.phase.derivative;
            equations.push_back(std::move(equation));
        };
        for (std::size_t i = 0; i < 3; ++i) {
            give(dx, i, g_.multiply(inverseMass, linear[i]));
            give(w1, i, turning[i]);
        }
    }
    return equations;
}

std::vector<Phase> ContactRows::conditions() {
    std::vector<Phase> phases;
    for (Row& row : rows_) {
        Phase phase;
        phase.from = time_;
        phase.derivative = along(row.rate);
        phase.condition = row.condition;
        phases.push_back(std::move(phase));
    }
    return phases;
}

std::vector<ContactRows::Equation> ContactRows::others(std::span<const std::size_t> bodies) {
    std::vector<Equation> equations;
    for (std::size_t u = 0; u < free_.set.unknowns.size(); ++u) {
        Phase phase = inForce(set_.unknowns[u], time_);
        if (!phase.condition || !phase.condition->rate)
            continue;
        const std::vector<Node> read = symbolsOf(g_, std::span(&*phase.condition->rate, 1));
        const bool isConcerned = std::ranges::any_of(bodies, [&](std::size_t body) {
            const BodyMotion& motion = free_.bodies[body];
            return !motion.isFixed && std::ranges::any_of(read, [&](Node symbol) {
                const auto of = unknownOf_.find(symbol.index);
                return of != unknownOf_.end() && of->second >= motion.firstUnknown &&
                       of->second < motion.firstUnknown + bodyUnknowns;
            });
        });
        if (!isConcerned)
            continue;
        phase.from = time_;
        phase.derivative = along(*phase.condition->rate);
        Equation equation{.unknown = u, .phase = phase, .later = {}};
        for (const Phase& later : free_.set.unknowns[u].phases)
            if (later.from > time_)
                equation.later.push_back(later);
        equations.push_back(std::move(equation));
    }
    return equations;
}

} // namespace physics
