#include "contacts/resting_bodies.h"

#include "collision/time_of_impact.h"
#include "contacts/bearing_rates.h"
#include "contacts/turns_beyond.h"
#include "equations/directions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace simulation {
namespace {

using solution::Histories;
using solution::infinity;

// Between looks at the forces, in the first two seconds, and then how many in a doubling of the
// time.
constexpr double firstStride = 0x1p-11, looks = 2048;
constexpr double sparse = 64;          // times that, where forces are constant
constexpr double notableChange = 0.02; // of a force, since it was looked at
// Of what bears, by Newton's method: the first leaves the square of what the integration errs, in
// speeds too, as the turn that it makes turns what they are along.
constexpr int corrections = 3;

std::array<double, physics::bodyUnknowns> unknownsOf(const physics::BodyMotion& body,
                                                     const BodyState& state) {
    return body.unknownsOf({state.position, state.velocity, state.attitude, state.angularVelocity});
}

// To the next look at forces, so long after the start. It does not depend on when the motion ends.
double strideAfter(double elapsed) {
    const double octave = elapsed > 0 ? std::exp2(std::ceil(std::log2(elapsed))) : 0;
    return std::max(octave / (2 * looks), firstStride);
}

bool isStandingFace(const MovingBody& support, const BodyRecord& record, const Footing& footing) {
    return record.isFixed && support.shape().parts[footing.supportPart].isPolyhedron() &&
           footing.constraints[0].kind == physics::GapConstraint::Kind::onSupportPlane;
}

} // namespace

RestingBodies::RestingBodies(const Colliders& world, double finish)
    : world_(world), finish_(finish) {
    for (const physics::BodyMotion& body : world.equations.bodies)
        names_.push_back(body.name);
}

// --- what is there --------------------------------------------------------------------------

physics::Held RestingBodies::heldOf(std::size_t body, double time) const {
    return physics::unyieldingAt(world_.equations, body,
                                 std::min(time, std::nextafter(finish_, world_.start)));
}

bool RestingBodies::canGiveWay(std::size_t body, double time) const {
    if (world_.records[body].isFixed)
        return false;
    const physics::Held held = heldOf(body, time);
    return std::ranges::count(held.position, true) < 3 ||
           (!held.attitude && !world_.moving[body].isBall());
}

bool RestingBodies::isFree(std::size_t body, double time) const {
    return !world_.records[body].isFixed &&
           std::ranges::count(heldOf(body, time).position, true) == 0;
}

bool RestingBodies::hopForEver(std::size_t a, std::size_t b, double time) const {
    return world_.restitutionOf({a, b}) == 1 && world_.moving[a].isBall() &&
           world_.moving[b].isBall() && isFree(a, time) && isFree(b, time);
}

double RestingBodies::nextPhase(std::size_t body, double time) const {
    double next = infinity;
    for (std::size_t i = 0; !world_.records[body].isFixed && i < physics::bodyUnknowns; ++i)
        for (const auto& phase :
             world_.equations.set.unknowns[world_.records[body].firstUnknown + i].phases)
            if (phase.from > time)
                next = std::min(next, phase.from);
    return next;
}

double RestingBodies::lastPhase(std::size_t body, double time) const {
    double last = world_.start;
    for (std::size_t i = 0; !world_.records[body].isFixed && i < physics::bodyUnknowns; ++i)
        for (const auto& phase :
             world_.equations.set.unknowns[world_.records[body].firstUnknown + i].phases)
            if (phase.from <= time)
                last = std::max(last, phase.from);
    return last;
}

physics::ImpactBody RestingBodies::impactBody(std::size_t body, double time,
                                              const BodyState& state) const {
    physics::ImpactBody impact{.centre = state.position,
                               .velocity = state.velocity,
                               .angularVelocity = state.angularVelocity};
    if (!canGiveWay(body, time))
        return impact;
    const physics::BodyMotion& motion = world_.equations.bodies[body];
    const physics::Held held = heldOf(body, time);
    impact.inverseMass = 1 / motion.mass.mass;
    for (std::size_t i = 0; i < 3; ++i)
        impact.moves[static_cast<Eigen::Index>(i)] = held.position[i] ? 0 : 1;
    if (!held.attitude) {
        const geometry::Matrix r = state.attitude.toRotationMatrix();
        impact.inverseInertia = r * motion.mass.inertia.inverse() * r.transpose();
    }
    return impact;
}

BodyState RestingBodies::bearingState(const Histories& histories, std::size_t body,
                                      double time) const {
    BodyState state = stateOf(world_.records[body], histories, time);
    const auto found = resting_.find(body);
    if (found == resting_.end() || !canGiveWay(body, time) || !state.angularVelocity.allFinite())
        return state;
    const physics::BodyMotion& motion = world_.equations.bodies[body];
    const physics::Held held = heldOf(body, time);
    for (int i = 0; i < corrections; ++i) {
        std::vector<BearingRow> rows;
        for (const Footing& footing : found->second.rest.footings) {
            const BodyState support = stateOf(world_.records[footing.support], histories, time);
            for (const physics::GapConstraint& constraint : footing.constraints)
                rows.push_back(bearingRow(constraint, world_.records[body], state, support));
        }
        state = bearingExactly(state, motion, held, rows);
    }
    return state;
}

Acceleration RestingBodies::freeAcceleration(const Histories& histories, std::size_t body,
                                             double time, const BodyState& state) const {
    const physics::BodyMotion& motion = world_.equations.bodies[body];
    if (!free_.contains(body)) {
        std::vector<expression::Node> outputs(motion.acceleration.begin(),
                                              motion.acceleration.end());
        outputs.insert(outputs.end(), motion.spinRate.begin(), motion.spinRate.end());
        const auto symbols = expression::symbolsOf(world_.equations.set.graph, outputs);
        Free made;
        std::vector<expression::Node> inputs;
        for (std::size_t i = 0; i < world_.equations.set.unknowns.size(); ++i)
            if (std::ranges::find(symbols, world_.equations.set.unknowns[i].symbol) !=
                symbols.end()) {
                made.reads.push_back(i);
                inputs.push_back(world_.equations.set.unknowns[i].symbol);
            }
        made.isConstant = symbols.empty();
        inputs.push_back(world_.equations.set.time);
        if (solution::lengthsDividedBy(world_.equations.set.graph, outputs).empty()) {
            made.tape = expression::Tape(world_.equations.set.graph, inputs, outputs);
        } else { // friction in a plane
            expression::Graph graph = world_.equations.set.graph;
            made.tape =
                expression::Tape(graph, inputs, solution::withoutForcesAtRest(graph, outputs));
        }
        free_.emplace(body, std::move(made));
    }
    const Free& free = free_.at(body);
    const auto own = unknownsOf(motion, state);
    std::vector<double> inputs;
    for (const std::size_t unknown : free.reads) {
        const std::size_t index = unknown - motion.firstUnknown;
        inputs.push_back(unknown >= motion.firstUnknown && index < physics::bodyUnknowns
                             ? own[index]
                             : histories.value(unknown, time));
    }
    inputs.push_back(time);
    std::array<double, 6> rates{};
    expression::Tape::Scratch scratch;
    free.tape.evaluate(inputs, rates, scratch);
    const Vector spinRate(rates[3], rates[4], rates[5]);
    return {Vector(rates[0], rates[1], rates[2]),
            world_.records[body].isSpinInWorldAxes ? spinRate : Vector(state.attitude * spinRate)};
}

bool RestingBodies::turns(std::size_t body, double time, const BodyState& state,
                          const Acceleration& acceleration) const {
    if (world_.records[body].isFixed)
        return false;
    // LIMIT: a rotation trajectory that starts without speed and without acceleration counts as
    // turning all the same; a free attitude without torque does not.
    return world_.equations.bodies[body].heldAt(time).attitude ||
           !state.angularVelocity.isZero(0) || !acceleration.angular.isZero(0);
}

Placed RestingBodies::placed(const Histories& histories, std::size_t body, double time,
                             const States& changed) const {
    const auto given = changed.find(body);
    Placed placed;
    placed.index = body;
    placed.record = &world_.records[body];
    placed.shape = &world_.moving[body].shape();
    placed.state =
        given != changed.end() ? given->second : stateOf(world_.records[body], histories, time);
    placed.acceleration = accelerationOf(world_.records[body], histories, time);
    placed.turns = turns(body, time, placed.state, placed.acceleration);
    return placed;
}

Rest RestingBodies::restAt(const Histories& histories, std::size_t body, double time,
                           std::span<const std::size_t> partners, const States& changed) const {
    RestQuestion question{.body = placed(histories, body, time, changed),
                          .mobility = {},
                          .free = {},
                          .supports = {},
                          .supportMobility = {},
                          .footings = {}};
    if (const auto now = resting_.find(body); now != resting_.end())
        for (const Footing& f : now->second.rest.footings)
            question.footings.push_back({f.support, f.bodyPart, f.supportPart});
    question.mobility = impactBody(body, time, question.body.state);
    question.free = freeAcceleration(histories, body, time, question.body.state);
    const physics::Held held = heldOf(body, time);
    if (held.attitude)
        question.free.angular = question.body.acceleration.angular;
    for (Eigen::Index i = 0; i < 3; ++i)
        if (held.position[static_cast<std::size_t>(i)])
            question.free.linear[i] = question.body.acceleration.linear[i];
    const bool isBodyFree = isFree(body, time);
    for (const std::size_t other : partners) {
        // What is held rests on nothing that is free: that rests on it.
        if (hopForEver(body, other, time) || (!isBodyFree && isFree(other, time)))
            continue;
        question.supports.push_back(placed(histories, other, time, changed));
        question.supportMobility.push_back(impactBody(other, time, question.supports.back().state));
    }
    return restOf(question, world_.resolution[body], names_);
}

// --- what rests -----------------------------------------------------------------------------

bool RestingBodies::isFooting(std::size_t a, std::size_t partA, std::size_t b,
                              std::size_t partB) const {
    const auto holds = [this](std::size_t body, std::size_t part, std::size_t support,
                              std::size_t supportPart) {
        const auto found = resting_.find(body);
        return found != resting_.end() &&
               std::ranges::any_of(found->second.rest.footings, [&](const Footing& footing) {
                   return footing.support == support && footing.bodyPart == part &&
                          footing.supportPart == supportPart;
               });
    };
    return holds(a, partA, b, partB) || holds(b, partB, a, partA) ||
           contacts_.areIn(a, partA, b, partB);
}

bool RestingBodies::hasFooting(std::size_t a, std::size_t b) const {
    const auto holds = [this](std::size_t body, std::size_t support) {
        const auto found = resting_.find(body);
        return found != resting_.end() &&
               std::ranges::any_of(found->second.rest.footings, [&](const Footing& footing) {
                   return footing.support == support;
               });
    };
    return holds(a, b) || holds(b, a) || contacts_.areIn(a, b);
}

std::map<std::size_t, std::vector<std::size_t>> RestingBodies::supports() const {
    std::map<std::size_t, std::vector<std::size_t>> supports;
    for (const auto& [body, watch] : resting_)
        for (const Footing& footing : watch.rest.footings)
            if (auto& known = supports[body];
                std::ranges::find(known, footing.support) == known.end())
                known.push_back(footing.support);
    contacts_.addSupports(supports);
    return supports;
}

void RestingBodies::set(std::size_t body, double time, const Rest& rest) {
    if (rest.footings.empty()) {
        forget(body);
        return;
    }
    Watch watch{.rest = rest, .from = time, .seenUntil = time, .ends = infinity, .change = {}};
    std::set<std::size_t> concerned{body};
    for (const Footing& footing : rest.footings)
        if (!world_.records[footing.support].isFixed)
            concerned.insert(footing.support);
    for (const std::size_t b : concerned)
        watch.ends = std::min(watch.ends, nextPhase(b, time));
    resting_.insert_or_assign(body, std::move(watch));
}

void RestingBodies::lookAgain(std::span<const std::size_t> bodies, double time) {
    for (auto& [body, watch] : resting_) {
        const bool concerned =
            std::ranges::count(bodies, body) > 0 ||
            std::ranges::any_of(watch.rest.footings, [&](const Footing& footing) {
                return std::ranges::count(bodies, footing.support) > 0;
            });
        if (!concerned)
            continue;
        watch.seenUntil = std::min(watch.seenUntil, std::max(time, watch.from));
        watch.change.reset();
    }
}

// --- until when -----------------------------------------------------------------------------

bool RestingBodies::agrees(const Histories& histories, std::size_t body, double time,
                           std::span<const std::size_t> partners, const Watch& watch) const {
    const Rest now = restAt(histories, body, time, partners);
    return now.state == Rest::State::bearing && now.bearsLike(watch.rest);
}

// Ends of the solver's steps, each cut in four, and the times of the looks at the forces.
std::vector<double> RestingBodies::timesOf(const Histories& histories, std::size_t body,
                                           double from, double until) const {
    std::vector<double> times;
    const std::size_t first = world_.records[body].firstUnknown;
    const bool isConstant =
        free_.contains(body) && free_.at(body).isConstant && !isCarried(resting_.at(body));
    const double factor = isConstant ? sparse : 1;
    double looked = from + factor * strideAfter(from - world_.start);
    while (looked < until) {
        times.push_back(looked);
        looked += factor * strideAfter(looked - world_.start);
    }
    for (const std::size_t unknown : {physics::dx, physics::dy, physics::dz, physics::w1}) {
        double t = from;
        while (t < until) {
            const double end = std::min(histories.piece(first + unknown, t).until, until);
            if (!(end > t))
                break;
            for (const double part : {0.25, 0.5, 0.75, 1.0})
                times.push_back(part < 1 ? t + part * (end - t) : end);
            t = end;
        }
    }
    times.push_back(std::nextafter(until, from)); // before what begins there
    times.push_back(until);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

namespace {

// The first time at which `holds`, which does at `yes` and did not at `no`. Times are halved
// between powers of 2, not between these two: where rounding decides, close by, the same times are
// asked whatever was looked at before, so that who else is in the scene changes no bit.
// LIMIT: looks lie elsewhere when others meet (look() goes as far as is known): what changes twice
// between two looks may be seen in one scene and not in another.
template <typename Holds> double firstFrom(double no, double yes, const Holds& holds) {
    double high = std::exp2(1 + std::ilogb(std::max({1.0, std::abs(no), std::abs(yes)})));
    double low = -high;
    while (true) {
        const double middle = low + (high - low) / 2;
        if (!(middle > low && middle < high))
            return high;
        (middle >= yes || (middle > no && holds(middle)) ? high : low) = middle;
    }
}

} // namespace

bool RestingBodies::isCarried(const Watch& watch) const {
    return std::ranges::any_of(watch.rest.footings, [this](const Footing& footing) {
        return !world_.records[footing.support].isFixed;
    });
}

void RestingBodies::look(const Histories& histories, std::size_t body, double until,
                         std::span<const std::size_t> partners, Watch& watch) const {
    const double end = std::min(until, watch.ends);
    double good = watch.seenUntil;
    Acceleration last =
        freeAcceleration(histories, body, good, stateOf(world_.records[body], histories, good));
    const double radius = world_.records[body].radius;
    std::vector<double> beyond;
    for (const Footing& f : watch.rest.footings)
        if (world_.moving[body].isBall() &&
            isStandingFace(world_.moving[f.support], world_.records[f.support], f))
            addTurnsBeyond({.part = world_.moving[f.support].shape().parts[f.supportPart],
                            .record = world_.records[f.support],
                            .footing = f},
                           {.histories = histories, .first = world_.records[body].firstUnknown},
                           {good, end}, beyond);
    std::vector<double> times = timesOf(histories, body, watch.seenUntil, end);
    times.insert(times.end(), beyond.begin(), beyond.end());
    std::ranges::sort(times);
    const bool carried = isCarried(watch); // what carries it pushes otherwise at each look
    std::size_t skipped = 0;
    for (const double t : times) {
        if (t <= watch.seenUntil)
            continue; // an event there is past
        const BodyState state = stateOf(world_.records[body], histories, t);
        const Acceleration now = freeAcceleration(histories, body, t, state);
        const double change =
            (now.linear - last.linear).norm() + (now.angular - last.angular).norm() * radius;
        const double scale = last.linear.norm() + last.angular.norm() * radius;
        const bool isBeforeEnd = t >= std::nextafter(end, watch.seenUntil);
        if (change <= notableChange * scale && !carried && !isBeforeEnd && ++skipped % 16 != 0 &&
            std::ranges::find(beyond, t) == beyond.end())
            continue;
        last = now;
        if (agrees(histories, body, t, partners, watch)) {
            good = t;
            continue;
        }
        watch.change = firstFrom(
            good, t, [&](double at) { return !agrees(histories, body, at, partners, watch); });
        return;
    }
    watch.seenUntil = end;
    if (end >= watch.ends)
        watch.change = watch.ends;
}

std::optional<RestingBodies::Change> RestingBodies::firstChange(const Histories& histories,
                                                                double until, double known,
                                                                const Neighbours& neighbours) {
    std::optional<Change> first;
    for (auto& [body, watch] : resting_) {
        if (!watch.change && watch.seenUntil < until)
            look(histories, body, std::max(until, std::min(known, neighbours.windowEnd(body))),
                 neighbours.partners(body), watch);
        if (watch.change && *watch.change <= until && (!first || *watch.change < first->time))
            first = Change{.time = *watch.change, .body = body};
    }
    return first;
}

// --- by which equations ---------------------------------------------------------------------

void RestingBodies::write(const Histories& histories, std::size_t body, double time,
                          const BodyState& state, const Rest& rest,
                          expression::EquationSet& equations, solution::Changes& changes) const {
    const physics::BodyMotion& motion = world_.equations.bodies[body];
    std::vector<double> values;
    for (std::size_t i = 0; i < equations.unknowns.size(); ++i)
        values.push_back(histories.value(i, time));
    const bool isMoved = rest.correction.norm() > 1e-13 * world_.records[body].radius;
    const bool isTurned = !rest.footings.empty() && rest.turn.norm() > 1e-13;
    BodyState corrected = state;
    if (isMoved)
        corrected.position += rest.correction;
    if (isTurned)
        corrected.attitude = turnedBy(state.attitude, rest.turn);
    auto own = unknownsOf(motion, corrected);
    std::ranges::copy(own, values.begin() + static_cast<std::ptrdiff_t>(motion.firstUnknown));

    physics::GapExpressions gaps(equations, world_.equations, body, time);
    std::vector<physics::GapConstraint> constraints;
    for (const Footing& footing : rest.footings)
        constraints.insert(constraints.end(), footing.constraints.begin(),
                           footing.constraints.end());
    const auto rows = gaps.rowsAt(constraints, values);
    const physics::Held held = heldOf(body, time);
    std::vector<physics::GapConstraint> kept;
    std::vector<physics::GapRow> keptRows;
    for (const std::size_t i : physics::independentOf(motion, held, rows)) {
        kept.push_back(constraints[i]);
        keptRows.push_back(rows[i]);
    }
    const physics::VelocityChange change = physics::changeToRates(motion, held, keptRows);
    const physics::ConstrainedRates rates = gaps.constrained(kept);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        own[physics::dx + i] += change.linear[axis];
        own[physics::w1 + i] += change.angular[axis];
        if (isMoved && !held.position[i])
            changes.jumps.push_back({motion.unknown(physics::x) + i, own[physics::x + i]});
    }
    for (std::size_t i = physics::qw; isTurned && i < physics::w1; ++i)
        changes.jumps.push_back({motion.firstUnknown + i, own[i]});
    const auto give = [&](physics::BodyUnknown first, const physics::NodeVector& derivative,
                          const std::array<bool, 3>& isHeld) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (isHeld[i])
                continue;
            const std::size_t unknown = motion.unknown(first) + i;
            expression::Phase phase;
            phase.from = time;
            phase.derivative = derivative[i];
            std::vector<expression::Phase> later = world_.equations.set.unknowns[unknown].phases;
            std::erase_if(later, [time](const expression::Phase& p) { return p.from <= time; });
            changes.equations.push_back({unknown, phase, later});
            changes.jumps.push_back({unknown, own[first + i]});
        }
    };
    give(physics::dx, rates.acceleration, held.position);
    give(physics::w1, rates.spinRate, {held.attitude, held.attitude, held.attitude});
}

} // namespace simulation
