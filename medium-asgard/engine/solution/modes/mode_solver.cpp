// Which side of each surface holds; see mode_solver.h. Coincident switches, switch intersections
// and motion that is held are in mode_solver_intersections.cpp.
#include "modes/mode_solver.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace solution {

using expression::Decision;

// The side to take when a state starts exactly on a surface. While the guard is constant there is
// none: what lies on the surface holds, also where it makes no difference yet.
void ModeSolver::settleOn(std::size_t surface) {
    std::vector<double> above(field_.size()), below(above), on(above);
    mode_.setSide(surface, Mode::onSurface);
    field_.outputs(on);
    if (f_.guardRate(surface, on).still)
        return;
    mode_.setSide(surface, +1);
    field_.outputs(above);
    mode_.setSide(surface, -1);
    field_.outputs(below);
    mode_.setSide(surface, Mode::onSurface);
    const auto signOf = [this, surface](std::span<const double> field) {
        const GuardSlope slope = f_.guardRate(surface, field);
        return slope.rate > slope.noise ? 1 : slope.rate < -slope.noise ? -1 : 0;
    };
    const int up = signOf(above), down = signOf(below);
    if (up < 0 && down > 0)
        mode_.sliding.push_back(surface);
    else if (up > 0 && down >= 0)
        mode_.setSide(surface, +1);
    else if (down < 0 && up <= 0)
        mode_.setSide(surface, -1);
    else if (up > 0 && down < 0) // both lead away: the value on the surface itself decides
        mode_.setSide(surface, signOf(on));
    else if (up < 0 || (up == 0 && above == on))
        mode_.setSide(surface, up < 0 ? -1 : +1);
    else if (down > 0 || below == on)
        mode_.setSide(surface, down > 0 ? +1 : -1);
}

void ModeSolver::decide(double t, std::span<double> y) {
    mode_.release();
    standing_.clear();
    if (model_.surfaces().empty()) {
        decideContacts(t, y);
        guards_.refresh();
        return;
    }
    f_.fill(t, y);
    f_.decide(mode_.decisions);
    std::vector<std::size_t> touching;
    for (std::size_t s = 0; s < model_.surfaces().size(); ++s) {
        const Surface::Member& member = model_.surfaces()[s].members[0];
        const Decision taken = mode_.decisions[member.decision];
        if (model_.surfaces()[s].whole || taken == expression::noBranch)
            continue;
        mode_.sides[s] = static_cast<int>(taken) * member.orientation;
        if (mode_.sides[s] == Mode::onSurface)
            touching.push_back(s);
    }
    for (const std::size_t s : touching)
        settleOn(s);
    if (!touching.empty()) {
        follow({}); // what was decided by values on surfaces that are left at once
        const std::vector<double> touched(mode_.sides.size());
        while (leaveWhereJumped(touched))
            follow({});
    }
    if (!settleWeights(t, y))
        mode_.sliding.clear();
    project(t, y);
    decideContacts(t, y);
    guards_.refresh();
}

// Directions that have none push nothing as yet.
void ModeSolver::decideContacts(double t, std::span<double> y) {
    if (!model_.directions().ranges.empty()) {
        mode_.sticking = field_.directionsAtRest(t, y);
        std::ranges::fill(f_.units(), 0);
    }
    active_.decide(t, y);
    mode_.sticking.clear();
}

// On its side or, at its root, moving there: a guard that has switches of its own may have been put
// right by theirs.
bool ModeSolver::isRight(std::size_t surface) {
    const std::vector<double> now = field_.here();
    f_.evaluateGuards();
    const GuardSlope slope = f_.guardRate(surface, now);
    const double g = mode_.sides[surface] * f_.guard(surface);
    return g > slope.near || (g >= -slope.near && slope.rate * mode_.sides[surface] > slope.noise);
}

// The integer that floor or ceil takes next, on the branches of what its argument reads. What rests
// on a whole number stays on its side of it.
Decision ModeSolver::wholeBranch(std::size_t surface, std::span<const double> rates) {
    const GuardSlope slope = f_.guardRate(surface, rates);
    const double nearest = std::round(slope.value);
    const bool ceiling = model_.surfaces()[surface].ceiling;
    double whole = ceiling ? std::ceil(slope.value) : std::floor(slope.value);
    if (std::abs(slope.value - nearest) <= slope.near) {
        const bool leaves = ceiling ? slope.rate > slope.noise : slope.rate < -slope.noise;
        const double beside = nearest + (ceiling ? 1 : -1);
        const Decision taken = mode_.decisions[model_.surfaces()[surface].members[0].decision];
        const bool rests = !slope.still && std::abs(slope.rate) <= slope.noise;
        whole = leaves || (rests && static_cast<double>(taken) == beside) ? beside : nearest;
    }
    constexpr double largest = 9e18;
    return std::abs(whole) < largest ? static_cast<Decision>(whole) : expression::noBranch;
}

void ModeSolver::pass(const Watch& watch, Passing how, Passed& passed) {
    const std::size_t s = watch.surface;
    if (watch.kind == Watch::Kind::side && model_.readsMultipliers(s)) { // there is no sliding
        mode_.setSide(s,
                      f_.guard(s) > 0 && mode_.sides[s] == Mode::onSurface ? 1 : -mode_.sides[s]);
        passed.settled.push_back(s);
    } else if (how == Passing::leaves) { // whatever else falls later falls again
        if (ahead_[s] == Mode::onSurface)
            return;
        mode_.setSide(s, ahead_[s]);
        passed.settled.push_back(s);
    } else if (watch.kind != Watch::Kind::side) {
        mode_.sliding.erase(std::remove(mode_.sliding.begin(), mode_.sliding.end(), s),
                            mode_.sliding.end());
        mode_.setSide(s, watch.kind == Watch::Kind::least ? -1 : +1);
        if (model_.surfaces()[s].whole)
            passed.settled.push_back(s);
        for (const Mode::Coincident& other : mode_.coincident[s])
            passed.settled.push_back(other.surface);
    } else if (how == Passing::across) {
        passAcross(s, passed);
    } else if (model_.surfaces()[s].whole) {
        if (passWhole(s, how == Passing::stays) && passed.isAlone)
            passed.settled.push_back(s);
    } else {
        mode_.setSide(s, Mode::onSurface);
        standing_.push_back(s);
    }
}

// With all that switches there. Of several at different places the later ones are passed only where
// the first have not put them right.
void ModeSolver::passAcross(std::size_t surface, Passed& passed) {
    if (std::ranges::find(passed.joined, surface) != passed.joined.end())
        return;
    const bool isWhole = model_.surfaces()[surface].whole;
    if (isWhole && !takeLevel(surface)) {
        if (passWhole(surface, false) && passed.isAlone)
            passed.settled.push_back(surface);
        return;
    }
    if (!isWhole && !passed.surfaces.empty() && isRight(surface))
        return;
    field_.find();
    const double g = f_.distance(surface);
    join(surface);
    if (mode_.sides[surface] == Mode::onSurface)
        passed.stood.push_back(surface);
    mode_.setSide(surface, mode_.sides[surface] == Mode::onSurface ? (g > 0) - (g < 0)
                                                                   : -mode_.sides[surface]);
    passed.surfaces.push_back(surface);
    for (const Mode::Coincident& other : mode_.coincident[surface]) {
        passed.joined.push_back(other.surface);
        passed.settled.push_back(other.surface);
    }
    if (isWhole && passed.isAlone)
        passed.settled.push_back(surface);
}

// To and fro without end: where both branches move it the same way, rounding alone passes it, and
// either branch will do until it is farther from the whole number. True: where values and rates say
// that nothing is to be passed, the branch beside was taken.
bool ModeSolver::passWhole(std::size_t surface, bool insist) {
    const std::vector<double> now = field_.here();
    const GuardSlope slope = f_.guardRate(surface, now);
    const bool ceiling = model_.surfaces()[surface].ceiling;
    const Decision next = wholeBranch(surface, now);
    Decision& taken = mode_.decisions[model_.surfaces()[surface].members[0].decision];
    const double middle = static_cast<double>(taken) + (ceiling ? -0.5 : 0.5);
    const Decision beside = taken + (slope.value > middle ? 1 : -1);
    const bool isForced = next == taken && !slope.still;
    taken = next != taken ? next : beside;
    mode_.isGrazed[surface] = 0;
    if (!insist)
        return isForced;
    const std::vector<double> behind = field_.here();
    const double rate = f_.guardRate(surface, behind).rate;
    mode_.isGrazed[surface] = rate == slope.rate || rate * slope.rate > 0 ? 1 : 0;
    return isForced;
}

// Guards that jumped when other surfaces were passed: their sides follow their values. One that is
// constant now, like floor(t) - 3, may stay at 0 for a while; there what lies on the surface holds.
void ModeSolver::follow(const Passed& passed) {
    const auto in = [](const std::vector<std::size_t>& list, std::size_t s) {
        return std::find(list.begin(), list.end(), s) != list.end();
    };
    const auto isSettled = [&](std::size_t s) {
        return in(passed.settled, s) || (mode_.sides[s] == Mode::onSurface && in(standing_, s));
    };
    for (std::size_t round = 0; round < model_.surfaces().size(); ++round) {
        bool changed = false;
        const std::vector<double> now = field_.here();
        for (std::size_t s = 0; s < model_.surfaces().size() && !changed; ++s)
            if (!in(mode_.sliding, s) && !mode_.isCoincident(s) && !isSettled(s))
                changed = follow(s, now, in(passed.surfaces, s));
        if (!changed)
            return;
    }
}

// True: its branch is another now.
bool ModeSolver::follow(std::size_t surface, std::span<const double> rates, bool passed) {
    Decision& decision = mode_.decisions[model_.surfaces()[surface].members[0].decision];
    const Decision before = decision;
    const GuardSlope slope = f_.guardRate(surface, rates);
    if (model_.surfaces()[surface].whole) {
        if (!passed && before != expression::noBranch)
            decision = wholeBranch(surface, rates);
        return decision != before;
    }
    f_.evaluateGuards();
    const double g = f_.guard(surface);
    if (before == expression::noBranch || (passed && !slope.still))
        return false;
    if (g == 0 && (slope.still || mode_.sides[surface] == Mode::onSurface))
        settleOn(surface);
    else if ((g * mode_.sides[surface] < 0 || mode_.sides[surface] == Mode::onSurface) &&
             std::abs(g) > slope.near)
        mode_.setSide(surface, g > 0 ? 1 : -1);
    return decision != before;
}

// On which side of those surfaces on which it was held is the motion at the violation's time?
bool ModeSolver::looksAhead(const Violation& violation, double t, std::span<const double> y) {
    f_.fill(t, y);
    f_.evaluateGuards();
    ahead_.assign(model_.surfaces().size(), Mode::onSurface);
    bool any = false;
    for (const std::size_t k : violation.watches) {
        if (k >= guards_.watches().size())
            continue;
        const auto [kind, s] = guards_.watches()[k];
        if (kind != Watch::Kind::side || model_.surfaces()[s].whole ||
            mode_.sides[s] != Mode::onSurface)
            continue;
        const double g = f_.guard(s);
        ahead_[s] = (g > 0) - (g < 0);
        any = any || ahead_[s] != Mode::onSurface;
    }
    return any;
}

// Behind the surface the field leads back to it. What does it do in front of it? Where it leads
// back too the motion only touched the surface, and nothing could slide there. Where nothing moves
// it there, what passed was an error of polynomials, and it rests.
ModeSolver::Front ModeSolver::front(std::size_t surface) {
    const int side = mode_.sides[surface];
    mode_.setSide(surface, -side);
    const std::vector<double> before = field_.here();
    const GuardSlope slope = f_.guardRate(surface, before);
    mode_.setSide(surface, side);
    if (!slope.still && std::abs(slope.rate) <= slope.noise)
        return Front::rests;
    return slope.rate * side <= 0 ? Front::leadsAway : Front::leadsHere;
}

// Does the field behind each passed surface lead away from it?
void ModeSolver::slideWhereLedBack(const Passed& passed) {
    const std::vector<double> behind = field_.here();
    f_.evaluateGuards();
    std::vector<std::size_t> back;
    for (const std::size_t s : passed.surfaces) {
        mode_.wasPassed[s] = 1;
        const GuardSlope slope = f_.guardRate(s, behind);
        mode_.setGrazed(s, !slope.still && std::abs(slope.rate) <= slope.noise);
        if (mode_.isOnSide(s) && slope.rate * mode_.sides[s] < -slope.noise &&
            std::abs(f_.distance(s)) <= slope.near)
            back.push_back(s);
    }
    std::vector<Front> fronts;
    std::ranges::transform(back, std::back_inserter(fronts),
                           [this](std::size_t s) { return front(s); });
    for (std::size_t k = 0; k < back.size(); ++k) {
        const std::size_t s = back[k];
        if (fronts[k] != Front::leadsAway) {
            mode_.sliding.push_back(s);
            mode_.setGrazed(s, fronts[k] == Front::rests);
        } else if (std::ranges::find(passed.stood, s) == passed.stood.end()) {
            mode_.setSide(s, -mode_.sides[s]);
        }
    }
}

ModeSolver::Crossing ModeSolver::cross(const Violation& violation, double t, std::span<double> y,
                                       Passing how) {
    if (const auto fallen = guards_.activeOf(violation); !fallen.empty()) {
        f_.fill(t, y);
        const std::vector<double> rates = field_.here();
        const bool isDone = active_.cross(fallen, t, y, rates);
        guards_.refresh();
        return isDone ? Crossing::done : Crossing::impossible;
    }
    if (std::ranges::any_of(violation.watches,
                            [this](std::size_t k) { return k >= guards_.watches().size(); })) {
        const bool isDone = stick_.leave(guards_.directionsOf(violation), t, y);
        guards_.refresh();
        return isDone ? Crossing::done : Crossing::impossible;
    }
    f_.fill(t, y);
    if (t != standingAt_)
        standing_.clear();
    standingAt_ = t;
    if (how == Passing::solved && solveCorner()) {
        project(t, y);
        stick_.releaseWhereJumped(t, y);
        guards_.refresh();
        return Crossing::done;
    }
    Passed passed{.isAlone = violation.watches.size() == 1};
    const Late late = how == Passing::across ? lateness(violation) : Late{};
    const std::vector<double> before = distancesOfSliding();
    for (const std::size_t k : violation.watches)
        pass(guards_.watches()[k], how, passed);
    follow(passed);
    while (leaveWhereJumped(before))
        follow(passed);
    slideWhereLedBack(passed);
    const std::vector<std::size_t> slid = mode_.sliding;
    if (!settleWeights(t, y)) { // beside the surface a side may have no value, as a root's
        mode_.sliding = slid;
        project(t, y);
        if (!settleWeights(t, y) && !solveCorner())
            return Crossing::impossible;
    }
    makeUp(late, t, y);
    project(t, y);
    stick_.releaseWhereJumped(t, y);
    guards_.refresh();
    return Crossing::done;
}

// A switch is passed at the first double beyond it: always late, by half of the resolution of time
// in the middle. What swings about a switch gains by that each time, and its error grows like the
// square of the time, unless the time that it was late is made up for.
ModeSolver::Late ModeSolver::lateness(const Violation& violation) {
    const Watch& watch = guards_.watches()[violation.watches[0]];
    if (violation.watches.size() != 1 || watch.kind != Watch::Kind::side || !mode_.sliding.empty())
        return {};
    Late late{.seconds = 0, .rates = field_.here()};
    const GuardSlope slope = f_.guardRate(watch.surface, late.rates);
    const bool isWhole = model_.surfaces()[watch.surface].whole;
    const double off = isWhole ? slope.value - std::round(slope.value) : slope.value;
    const double seconds = off / slope.rate;
    if (std::abs(seconds) <= 2 * std::numeric_limits<double>::epsilon() * std::abs(f_.in()[0]))
        late.seconds = seconds;
    return late;
}

void ModeSolver::makeUp(const Late& late, double t, std::span<double> y) {
    if (late.seconds == 0 || !mode_.sliding.empty())
        return;
    f_.fill(t, y);
    const std::vector<double> now = field_.here();
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double made = late.seconds * (now[i] - late.rates[i]);
        if (std::isfinite(made)) // a branch may have no rate beyond its end
            y[i] += made;
    }
}

} // namespace solution
