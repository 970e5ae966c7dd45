#include "physics/contact_rows.h"

#include "expression/rate_along.h"
#include "physics/contact_press.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using expression::Condition;
using expression::Phase;
using Kind = SurfacePiece::Kind;
using surfaces::Term;
using surfaces::Triple;

constexpr double resolved = 1e-9; // of the smaller part: gaps lower than that are none
constexpr double lying = 5e-9;    // of the same: a rim whose far side is no higher lies flat

const Phase& inForce(const expression::Unknown& unknown, double time) {
    const auto after = std::ranges::upper_bound(unknown.phases, time, {}, &Phase::from);
    return after == unknown.phases.begin() ? unknown.phases.front() : *(after - 1);
}

Node lengthOf(Graph& g, const NodeVector& v) { return g.apply(Op::sqrt, dot(g, v, v)); }

NodeVector unit(Graph& g, const NodeVector& v) {
    const Node length = lengthOf(g, v);
    return {g.divide(v[0], length), g.divide(v[1], length), g.divide(v[2], length)};
}

NodeVector nodes(const Triple<Term>& v) { return {v.x.node, v.y.node, v.z.node}; }

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

// d/dt along the motion, of each.
std::vector<Node> ContactRows::along(std::span<const Node> values) {
    std::vector<Node> symbols{set_.time}, rates{g_.constant(1)};
    for (const Node symbol : symbolsOf(g_, values))
        if (const auto unknown = unknownOf_.find(symbol.index); unknown != unknownOf_.end()) {
            symbols.push_back(symbol);
            rates.push_back(rateOf(unknown->second));
        }
    std::vector<Node> found;
    for (const auto& row : gradients(g_, values, symbols)) {
        Node rate = g_.constant(0);
        for (const expression::Partial& partial : row)
            rate = g_.add(rate, g_.multiply(partial.derivative, rates[partial.symbol]));
        found.push_back(rate);
    }
    return found;
}

// ----------------------------------------------------------------------------------- geometry

Triple<Term> ContactRows::terms(const NodeVector& v) {
    return {{&g_, v[0], owner_}, {&g_, v[1], owner_}, {&g_, v[2], owner_}};
}

Node ContactRows::numberOf(double value) { return physics::numberOf(g_, value, owner_); }

NodeVector ContactRows::numbersOf(const Vector& v) { return physics::numbersOf(g_, v, owner_); }

Node ContactRows::amountOf(double value) { return g_.parameter(value, owner_, ++amounts_); }

surfaces::Place<Term> ContactRows::poseOf(std::size_t body) {
    const BodySymbols& of = symbols(body);
    return {terms(of.position),
            {terms(of.rotation[0]), terms(of.rotation[1]), terms(of.rotation[2])}};
}

ContactRows::Meeting ContactRows::meetingOf(const ContactPlace& place, const SurfaceGap& gap) {
    const surfaces::Nearest<Term> found =
        surfaces::nearestOf(gap, poseOf(place.body), poseOf(place.support));
    return {found.gap.node,     nodes(found.normal), nodes(found.contact),
            nodes(found.place), found.steady.node,   {nodes(found.arms[0]), nodes(found.arms[1])}};
}

// Directions follow the normal.
ContactRows::Frame ContactRows::frameOf(const ContactPlace& place) {
    const SurfaceGap& gap = place.points[0].gap;
    const Meeting meeting = meetingOf(place, gap);
    Frame frame;
    frame.normal = meeting.normal;
    frame.point = meeting.contact;
    const BodySymbols& body = symbols(place.body);
    if (place.centre) {
        frame.point = add(g_, body.position, body.toWorld(g_, numbersOf(*place.centre)));
    } else if (place.points.size() > 1) {
        for (std::size_t k = 1; k < place.points.size(); ++k)
            frame.point = add(g_, frame.point, meetingOf(place, place.points[k].gap).contact);
        const auto count = static_cast<double>(place.points.size());
        frame.point = scaled(g_, g_.constant(1 / count), frame.point);
    }
    // Differences of places, so that friction's rates read the places that its normal forces move:
    // the partition puts both into one component by that alone.
    frame.arms = {subtract(g_, frame.point, body.position),
                  subtract(g_, frame.point, symbols(place.support).position)};
    if (gap.isOnPlane()) { // directions of the plane
        const bool isBodys = gap.body.kind == Kind::plane;
        const Vector n = isBodys ? gap.body.axis : gap.support.axis;
        const Vector second = (acrossAxis(n) - n * n.dot(acrossAxis(n))).normalized();
        const BodySymbols& owner = isBodys ? body : symbols(place.support);
        frame.along = {owner.toWorld(g_, numbersOf(n.cross(second))),
                       owner.toWorld(g_, numbersOf(second))};
        return frame;
    }
    NodeVector fixed = constant(g_, acrossAxis(place.normal));
    for (const auto& [piece, owner] :
         {std::pair(&gap.body, place.body), std::pair(&gap.support, place.support)})
        if (piece->kind == Kind::line && piece->radius < 0) // round a tube there is no other
            fixed = symbols(owner).toWorld(g_, numbersOf(piece->axis));
    const NodeVector second =
        unit(g_, subtract(g_, fixed, scaled(g_, dot(g_, fixed, frame.normal), frame.normal)));
    frame.along = {cross(g_, frame.normal, second), second};
    return frame;
}

NodeVector ContactRows::velocityAt(std::size_t body, const NodeVector& arm) {
    const BodySymbols& s = symbols(body);
    return add(g_, s.velocity, cross(g_, s.worldSpin(g_), arm));
}

NodeVector ContactRows::slipOf(const ContactPlace& place, const Frame& frame) {
    const auto speed = [&](std::size_t body, std::size_t side, const Vector& surface) {
        return add(g_, velocityAt(body, frame.arms[side]),
                   symbols(body).toWorld(g_, numbersOf(surface)));
    };
    return subtract(g_, speed(place.body, 0, place.friction.bodySurface),
                    speed(place.support, 1, place.friction.supportSurface));
}

// --------------------------------------------------------------------------------------- rows

// The part along d of the velocity of the body at its arm less that of the support at its own.
ContactRows::Rate ContactRows::rateAlong(const ContactPlace& place, const NodeVector& d,
                                         const NodeVector& velocity, const Arms& arms) {
    const NodeVector back = scaled(g_, g_.constant(-1), d);
    return {dot(g_, d, velocity),
            {Twist{d, symbols(place.body).toSpinAxes(g_, cross(g_, arms[0], d))},
             Twist{back, symbols(place.support).toSpinAxes(g_, cross(g_, arms[1], back))}}};
}

// The spin of the body against the support about an axis, times a length.
ContactRows::Rate ContactRows::rateAbout(const ContactPlace& place, const NodeVector& axis,
                                         Node length) {
    const BodySymbols &body = symbols(place.body), &support = symbols(place.support);
    const NodeVector spin = subtract(g_, body.worldSpin(g_), support.worldSpin(g_));
    const NodeVector none = constant(g_, Vector::Zero()), by = scaled(g_, length, axis),
                     back = scaled(g_, g_.constant(-1), by);
    return {g_.multiply(length, dot(g_, axis, spin)),
            {Twist{none, body.toSpinAxes(g_, by)}, Twist{none, support.toSpinAxes(g_, back)}}};
}

void ContactRows::addRow(const ContactPlace& place, Node multiplier, std::optional<Node> gap,
                         const Rate& rate, Condition condition) {
    condition.gap = gap;
    condition.rate = rate.value;
    condition.resolution = resolved * place.size;
    rows_.push_back({owner_, multiplier, rate.value, std::move(condition), {}});
    for (std::size_t k = 0; k < 2; ++k)
        if (const std::size_t body = k == 0 ? place.body : place.support;
            !free_.bodies[body].isFixed)
            rows_.back().by.emplace_back(body, rate.by[k]);
}

std::vector<Node> ContactRows::landingsOf(const ContactPlace& place) {
    std::vector<Node> heights;
    if (place.landings.empty())
        return heights;
    const SurfaceGap& gap = place.points[0].gap;
    const Meeting meeting = meetingOf(place, gap);
    const auto at = [&](std::size_t body, const Vector& point) {
        const BodySymbols& owner = symbols(body);
        return add(g_, owner.position, owner.toWorld(g_, numbersOf(point)));
    };
    const NodeVector on = gap.support.kind == Kind::plane ? at(place.support, gap.support.place)
                          : gap.body.kind == Kind::plane  ? at(place.body, gap.body.place)
                                                          : meeting.contact;
    for (const ContactPlace::Landing& landing : place.landings) {
        const auto push = [&](Node lowest) {
            const Node room = amountOf(landing.room);
            heights.push_back(landing.isBeneath ? g_.subtract(room, lowest) : g_.add(lowest, room));
        };
        if (landing.gap) {
            push(meetingOf(place, *landing.gap).gap);
            continue;
        }
        const NodeVector up =
            landing.isAbove ? meeting.normal : scaled(g_, g_.constant(-1), meeting.normal);
        const Node reach =
            surfaces::lowest(landing.piece, poseOf(landing.body), terms(up)).reach.node;
        const Node height = dot(g_, up, subtract(g_, at(landing.body, landing.piece.place), on));
        push(g_.subtract(height, reach));
    }
    return heights;
}

Node ContactRows::sideOf(const ContactPoint::Side& side, const Meeting& meeting) {
    const BodySymbols& owner = symbols(side.body);
    const NodeVector at = add(g_, meeting.place, scaled(g_, numberOf(side.shift), meeting.normal));
    const NodeVector local = owner.toBody(g_, subtract(g_, at, owner.position));
    Node value = g_.add(dot(g_, numbersOf(side.inward), local), amountOf(side.offset));
    if (side.radial != 0) {
        const NodeVector from = subtract(g_, local, numbersOf(side.on));
        const Node far = lengthOf(g_, cross(g_, numbersOf(side.axis), from));
        value = g_.add(value, g_.multiply(numberOf(side.radial), far));
    }
    return value;
}

// Of a rim on a plane, how high its far side is above its lowest point. Where it comes to lie on
// the plane that point leaps to the far side: the contact ends before, and all of the rim touches.
std::optional<Node> ContactRows::tiltOf(const ContactPlace& place, const SurfaceGap& gap,
                                        const Meeting& meeting) {
    if (!gap.isOnPlane())
        return std::nullopt;
    const bool isBodys = gap.support.kind == Kind::plane; // the other piece
    const SurfacePiece& piece = isBodys ? gap.body : gap.support;
    if (piece.kind != Kind::circle)
        return std::nullopt;
    const Node reach =
        surfaces::lowest(piece, poseOf(isBodys ? place.body : place.support), terms(meeting.normal))
            .reach.node;
    return g_.subtract(g_.multiply(g_.constant(2), reach), numberOf(lying * place.size));
}

// Nearest points are at their nearest: a gap changes as the bodies move there, whatever the way of
// the points on their surfaces. A point piece may turn about its middle without a gap's change.
ContactRows::Rate ContactRows::openingOf(const ContactPlace& place, const SurfaceGap& gap,
                                         const Meeting& meeting) {
    Arms arms = meeting.arms;
    if (gap.body.kind == Kind::point)
        arms[0] = symbols(place.body).toWorld(g_, numbersOf(gap.body.place));
    if (gap.support.kind == Kind::point)
        arms[1] = symbols(place.support).toWorld(g_, numbersOf(gap.support.place));
    const NodeVector opening =
        subtract(g_, velocityAt(place.body, arms[0]), velocityAt(place.support, arms[1]));
    return rateAlong(place, meeting.normal, opening, arms);
}

void ContactRows::addNormals(const ContactPlace& place, std::span<const Node> multipliers) {
    for (std::size_t k = 0; k < place.points.size(); ++k) {
        const ContactPoint& point = place.points[k];
        Condition condition;
        condition.low = 0;
        condition.leaving = place.leaving;
        condition.hop = place.hop;
        condition.patch = multipliers[0];
        if (k == 0)
            condition.valid = landingsOf(place);
        const Meeting meeting = meetingOf(place, point.gap);
        for (const ContactPoint::Side& side : point.sides)
            condition.valid.push_back(sideOf(side, meeting));
        if (const auto tilt = tiltOf(place, point.gap, meeting))
            condition.valid.push_back(*tilt);
        if (point.gap.isCrossing())
            condition.valid.push_back(g_.subtract(meeting.steady, numberOf(leastSteady)));
        const Node gap = g_.subtract(meeting.gap, amountOf(point.start));
        addRow(place, multipliers[k], gap, openingOf(place, point.gap, meeting),
               std::move(condition));
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
    const NodeVector slip = slipOf(place, frame);
    for (std::size_t i = 0; i < 2; ++i)
        addRow(place, multipliers[first + i], std::nullopt,
               rateAlong(place, frame.along[i], slip, frame.arms), condition);
    if (count < 3)
        return;
    addRow(place, multipliers[first + 2], std::nullopt,
           rateAbout(place, frame.normal, numberOf(of.reach)), condition);
    addLevers(place, frame, multipliers);
}

void ContactRows::addLevers(const ContactPlace& place, const Frame& frame,
                            std::span<const Node> multipliers) {
    const std::size_t points = place.points.size();
    const std::span<Row> rows = std::span(rows_).last(3);
    std::vector<std::vector<Node>> levers;
    std::array<Node, 3> brought;
    brought.fill(g_.constant(0));
    const auto bring = [&](std::size_t row, Node lever, std::size_t point, Node what) {
        const Node pressed = g_.multiply(multipliers[point], lever);
        brought[row] = g_.add(brought[row], g_.multiply(pressed, what));
    };
    for (std::size_t k = 0; k < points; ++k) {
        const NodeVector arm =
            subtract(g_, meetingOf(place, place.points[k].gap).contact, frame.point);
        const NodeVector moves =
            scaled(g_, numberOf(1 / place.friction.reach), cross(g_, frame.normal, arm));
        levers.push_back({dot(g_, frame.along[0], moves), dot(g_, frame.along[1], moves)});
        for (std::size_t i = 0; i < 2; ++i) {
            bring(i, levers[k][i], k, rows[2].rate);
            bring(2, levers[k][i], k, multipliers[points + i]);
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].condition.friction->levers = levers;
        rows[i].condition.brought = brought[i];
    }
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
    for (std::size_t i = 0; i < 2; ++i)
        addRow(place, multipliers[first + i], std::nullopt,
               rateAbout(place, frame.along[i], numberOf(place.size)), condition);
}

void ContactRows::addContact(const ContactPlace& place, std::span<const Node> multipliers) {
    bodies_.insert({place.body, place.support});
    owner_ = multipliers[0];
    amounts_ = 0;
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
        for (const Row& row : rows_)
            for (const auto& [pushed, by] : row.by)
                if (pushed == body) {
                    linear = add(g_, linear, scaled(g_, row.multiplier, by.linear));
                    angular = add(g_, angular, scaled(g_, row.multiplier, by.angular));
                }
        for (std::size_t i = 0; i < 3; ++i)
            if (held.position[i])
                linear[i] = g_.constant(0);
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

// The rates of attitudes' matrices, R' = w x R, and of spins along the world's axes, R w, but for
// those of velocities with forces of contacts: shorter than what differentiation makes.
void ContactRows::addTurning(std::vector<Node>& moving, std::vector<Node>& rates) {
    std::set<std::uint32_t> known;
    const auto add = [&](Node node, Node rate) {
        if (g_.op(node) != Op::constant && known.insert(node.index).second) {
            moving.push_back(node);
            rates.push_back(rate);
        }
    };
    const auto rateOfSpin = [&](Node symbol) {
        const auto unknown = unknownOf_.find(symbol.index);
        return unknown == unknownOf_.end() || isPushed(unknown->second) ? g_.constant(0)
                                                                        : rateOf(unknown->second);
    };
    for (const std::size_t body : bodies_) {
        const BodySymbols& of = symbols(body);
        const NodeVector spin = of.worldSpin(g_);
        for (std::size_t k = 0; k < 3; ++k) {
            const NodeVector turning =
                cross(g_, spin, {of.rotation[0][k], of.rotation[1][k], of.rotation[2][k]});
            for (std::size_t i = 0; i < 3; ++i)
                add(of.rotation[i][k], turning[i]);
        }
        const NodeVector given = {rateOfSpin(of.spin[0]), rateOfSpin(of.spin[1]),
                                  rateOfSpin(of.spin[2])};
        const NodeVector along = times(g_, of.rotation, given);
        for (std::size_t i = 0; i < 3 && !of.isSpinInWorldAxes; ++i)
            add(spin[i], along[i]);
    }
}

// A velocity of a body in these contacts that no trajectory holds.
bool ContactRows::isPushed(std::size_t unknown) const {
    return std::ranges::any_of(bodies_, [&](std::size_t body) {
        const BodyMotion& motion = free_.bodies[body];
        if (motion.isFixed)
            return false;
        const std::size_t linear = motion.unknown(dx), angular = motion.unknown(w1);
        return ((unknown >= linear && unknown < linear + 3) ||
                (unknown >= angular && unknown < angular + 3)) &&
               !inForce(free_.set.unknowns[unknown], time_).given;
    });
}

void ContactRows::addPushes(expression::ConditionParts& parts, std::size_t body, const Twist& by) {
    const BodyMotion& motion = free_.bodies[body];
    const Held held = unyieldingAt(free_, body, time_);
    const Node inverseMass = g_.constant(1 / motion.mass.mass);
    const Matrix inverse =
        held.attitude ? Matrix(Matrix::Zero()) : Matrix(motion.mass.inertia.inverse());
    const auto add = [&](std::size_t unknown, Node factor, Node push) {
        if (!isPushed(unknown))
            return;
        const Node state = set_.unknowns[unknown].symbol;
        parts.by.push_back({state, factor});
        parts.pushes.push_back({state, push});
    };
    for (std::size_t i = 0; i < 3; ++i) {
        add(motion.unknown(dx) + i, by.linear[i],
            held.position[i] ? g_.constant(0) : g_.multiply(inverseMass, by.linear[i]));
        const auto row = inverse.row(static_cast<Eigen::Index>(i));
        add(motion.unknown(w1) + i, by.angular[i], dot(g_, constant(g_, row), by.angular));
    }
}

// Of all that rates read but the velocities that contacts push, whose own rates are long, together;
// of these by one product each.
void ContactRows::findParts() {
    std::vector<Node> rates, others{set_.time}, ofOthers{g_.constant(1)};
    for (const Row& row : rows_)
        rates.push_back(row.rate);
    for (const Node symbol : symbolsOf(g_, rates))
        if (const auto unknown = unknownOf_.find(symbol.index);
            unknown != unknownOf_.end() && !isPushed(unknown->second)) {
            others.push_back(symbol);
            ofOthers.push_back(rateOf(unknown->second));
        }
    addTurning(others, ofOthers);
    const std::vector<Node> steady = expression::ratesAlong(g_, rates, others, ofOthers);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        expression::ConditionParts parts{
            .owner = rows_[i].owner, .steady = steady[i], .by = {}, .pushes = {}};
        for (const auto& [body, by] : rows_[i].by)
            addPushes(parts, body, by);
        rows_[i].condition.parts = std::move(parts);
    }
}

std::vector<Phase> ContactRows::conditions() {
    findParts();
    std::vector<Phase> phases;
    for (const Row& row : rows_) {
        Phase phase;
        phase.from = time_;
        phase.condition = row.condition;
        phase.derivative = row.condition.parts->steady;
        for (const auto& [state, factor] : row.condition.parts->by)
            phase.derivative =
                g_.add(phase.derivative, g_.multiply(factor, rateOf(unknownOf_.at(state.index))));
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
        phase.derivative = along(std::span(&*phase.condition->rate, 1))[0];
        Equation equation{.unknown = u, .phase = phase, .later = {}};
        // Of a drive whose function changes later the bodies are in contact then, too.
        for (Phase later : free_.set.unknowns[u].phases) {
            if (!(later.from > time_))
                continue;
            if (later.condition && later.condition->rate)
                later.derivative = along(std::span(&*later.condition->rate, 1))[0];
            equation.later.push_back(std::move(later));
        }
        equations.push_back(std::move(equation));
    }
    return equations;
}

} // namespace physics
