// Which side of each surface holds; see component_equations.h. What slides on surfaces is in
// component_sliding.cpp.
#include "modes/component_equations.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace solution {

using expression::Decision;
using expression::Node;

void ComponentEquations::setSide(std::size_t surface, int side) {
    setOwnSide(surface, side);
    for (const Mode::Coincident& other : mode_.coincident[surface])
        setOwnSide(other.surface, side * other.orientation);
}

void ComponentEquations::setOwnSide(std::size_t surface, int side) {
    mode_.sides[surface] = side;
    if (model_.surfaces()[surface].whole) { // the branches beside that whole number
        mode_.decisions[model_.surfaces()[surface].members[0].decision] =
            decisionBeside(surface, side);
        return;
    }
    for (const Surface::Member& member : model_.surfaces()[surface].members)
        mode_.decisions[member.decision] = Decision{side} * member.orientation;
}

void ComponentEquations::setGrazed(std::size_t surface, bool isGrazed) {
    mode_.isGrazed[surface] = isGrazed ? 1 : 0;
    for (const Mode::Coincident& other : mode_.coincident[surface])
        mode_.isGrazed[other.surface] = mode_.isGrazed[surface];
}

void ComponentEquations::refreshWatches() {
    watches_.clear();
    const auto slides = [this](std::size_t s) { return mode_.slidesOn(s); };
    for (std::size_t s = 0; s < model_.surfaces().size(); ++s)
        if (!slides(s))
            mode_.coincident[s].clear();
    const bool mayVary = model_.readSurfaces().mayVary();
    const std::vector<bool> read =
        mayVary ? model_.readSurfaces().on(mode_.decisions) : std::vector<bool>();
    for (std::size_t s = 0; s < model_.surfaces().size(); ++s) {
        if (mode_.isCoincident(s))
            continue;
        if (!slides(s)) {
            if (!mayVary || read[s])
                watches_.push_back({Watch::Kind::side, s});
            continue;
        }
        watches_.push_back({Watch::Kind::least, s});
        watches_.push_back({Watch::Kind::most, s});
    }
}

// d g / dt along given rates of the states, at the point given to fill().
ComponentEquations::Slope ComponentEquations::guardRate(std::size_t surface,
                                                        std::span<const double> rates) {
    return slopeOf(model_.gradient(surface).derivatives, rates);
}

ComponentEquations::Slope ComponentEquations::slopeOf(const ComponentModel::Derived& derivatives,
                                                      std::span<const double> rates) {
    const std::size_t variables = model_.variables();
    std::vector<double> partial(variables + 1), change(variables, 1.0);
    evaluate(derivatives, partial);
    std::copy_n(rates.begin(), states().size(), change.begin() + 1);
    inputs_.rates(in_[0], std::span(change).subspan(1 + states().size()));
    Slope slope{0, 0, 0, 0, partial.back(), true};
    for (std::size_t i = 0; i < variables; ++i) {
        if (partial[i] == 0)
            continue;
        slope.still = false;
        slope.rate += partial[i] * change[i];
        slope.noise += 1e-12 * std::abs(partial[i] * change[i]);
        slope.near += 1e-11 * std::abs(partial[i] * in_[i]);
        slope.least += 4 * std::numeric_limits<double>::epsilon() * std::abs(partial[i] * in_[i]);
    }
    slope.near += 1e-12 * std::abs(slope.rate) * std::max(1.0, std::abs(in_[0]));
    return slope;
}

void ComponentEquations::watch(double t, std::span<const double> y, std::span<double> values) {
    fill(t, y);
    const bool isPossible = !sliding() || weigh();
    if (!isPossible)
        std::fill(weights_.begin(), weights_.end(), -1.0); // no longer possible: leave
    for (std::size_t k = 0; k < mode_.sticking.size(); ++k)
        values[watches_.size() + k] = !isPossible ? -1
                                      : mode_.sticking[k] == mode_.leaving
                                          ? leeway()
                                          : -excess(mode_.sticking[k]);
    model_.function().guards(in_, guards_, scratch_, mode_.decisions);
    for (std::size_t k = 0; k < watches_.size(); ++k) {
        const auto [kind, s] = watches_[k];
        const Surface& surface = model_.surfaces()[s];
        const double g = guard(s);
        if (mode_.decisions[surface.members[0].decision] == expression::noBranch) {
            values[k] = 1;
        } else if (kind != Watch::Kind::side) {
            const auto place =
                std::find(mode_.sliding.begin(), mode_.sliding.end(), s) - mode_.sliding.begin();
            const double w = weights_[static_cast<std::size_t>(place)];
            values[k] =
                (kind == Watch::Kind::least ? w : 1 - w) + (mode_.isGrazed[s] ? standing : 0);
        } else if (surface.whole) {
            const auto taken = static_cast<double>(mode_.decisions[surface.members[0].decision]);
            values[k] = g + (mode_.isGrazed[s] ? standing * std::max(1.0, std::abs(taken)) : 0);
        } else if (mode_.sides[s] == Mode::onSurface) {
            values[k] = standing - std::abs(g);
        } else {
            values[k] = mode_.sides[s] * g + (mode_.isGrazed[s] ? standing : 0);
        }
    }
}

// The side to take when a state starts exactly on a surface. While the guard is constant there is
// none: what lies on the surface holds, also where it makes no difference yet.
void ComponentEquations::settleOn(std::size_t surface) {
    std::vector<double> above(out_.size()), below(out_.size()), on(out_.size());
    setSide(surface, Mode::onSurface);
    evaluate(on);
    if (guardRate(surface, on).still)
        return;
    setSide(surface, +1);
    evaluate(above);
    setSide(surface, -1);
    evaluate(below);
    setSide(surface, Mode::onSurface);
    const auto signOf = [this, surface](std::span<const double> field) {
        const Slope slope = guardRate(surface, field);
        return slope.rate > slope.noise ? 1 : slope.rate < -slope.noise ? -1 : 0;
    };
    const int up = signOf(above), down = signOf(below);
    if (up < 0 && down > 0)
        mode_.sliding.push_back(surface);
    else if (up > 0 && down >= 0)
        setSide(surface, +1);
    else if (down < 0 && up <= 0)
        setSide(surface, -1);
    else if (up > 0 && down < 0) // both lead away: the value on the surface itself decides
        setSide(surface, signOf(on));
    else if (up < 0 || (up == 0 && above == on))
        setSide(surface, up < 0 ? -1 : +1);
    else if (down > 0 || below == on)
        setSide(surface, down > 0 ? +1 : -1);
}

void ComponentEquations::decide(double t, std::span<double> y) {
    mode_.release();
    standing_.clear();
    std::ranges::fill(wasPassed_, 0);
    if (model_.surfaces().empty())
        return;
    fill(t, y);
    model_.function().tape().decide(in_, mode_.decisions, guards_, scratch_);
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
    refreshWatches();
}

double ComponentEquations::guard(std::size_t surface) const {
    const Surface::Member& member = model_.surfaces()[surface].members[0];
    return guards_[member.decision] * member.orientation;
}

void ComponentEquations::field() {
    if (!sliding() || !weigh())
        evaluate(out_);
}

// On its side or, at its root, moving there: a guard that has switches of its own may have been put
// right by theirs.
bool ComponentEquations::isRight(std::size_t surface) {
    field();
    const std::vector<double> now = out_;
    model_.function().guards(in_, guards_, scratch_, mode_.decisions);
    const Slope slope = guardRate(surface, now);
    const double g = mode_.sides[surface] * guard(surface);
    return g > slope.near || (g >= -slope.near && slope.rate * mode_.sides[surface] > slope.noise);
}

// The integer that floor or ceil takes next, on the branches of what its argument reads. What rests
// on a whole number stays on its side of it.
Decision ComponentEquations::wholeBranch(std::size_t surface, std::span<const double> rates) {
    const Slope slope = guardRate(surface, rates);
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

void ComponentEquations::pass(const Watch& watch, Passing how, Passed& passed) {
    const std::size_t s = watch.surface;
    if (how == Passing::leaves) { // whatever else falls later falls again
        if (ahead_[s] == Mode::onSurface)
            return;
        setSide(s, ahead_[s]);
        passed.settled.push_back(s);
    } else if (watch.kind != Watch::Kind::side) {
        mode_.sliding.erase(std::remove(mode_.sliding.begin(), mode_.sliding.end(), s),
                            mode_.sliding.end());
        setSide(s, watch.kind == Watch::Kind::least ? -1 : +1);
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
        setSide(s, Mode::onSurface);
        standing_.push_back(s);
    }
}

// With all that switches there. Of several at different places the later ones are passed only where
// the first have not put them right.
void ComponentEquations::passAcross(std::size_t surface, Passed& passed) {
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
    field();
    const double g = distance(surface);
    join(surface);
    if (mode_.sides[surface] == Mode::onSurface)
        passed.stood.push_back(surface);
    setSide(surface,
            mode_.sides[surface] == Mode::onSurface ? (g > 0) - (g < 0) : -mode_.sides[surface]);
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
bool ComponentEquations::passWhole(std::size_t surface, bool insist) {
    field();
    const std::vector<double> now = out_;
    const Slope slope = guardRate(surface, now);
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
    field();
    const std::vector<double> behind = out_;
    const double rate = guardRate(surface, behind).rate;
    mode_.isGrazed[surface] = rate == slope.rate || rate * slope.rate > 0 ? 1 : 0;
    return isForced;
}

// Guards that jumped when other surfaces were passed: their sides follow their values. One that is
// constant now, like floor(t) - 3, may stay at 0 for a while; there what lies on the surface holds.
void ComponentEquations::follow(const Passed& passed) {
    const auto in = [](const std::vector<std::size_t>& list, std::size_t s) {
        return std::find(list.begin(), list.end(), s) != list.end();
    };
    const auto isSettled = [&](std::size_t s) {
        return in(passed.settled, s) || (mode_.sides[s] == Mode::onSurface && in(standing_, s));
    };
    for (std::size_t round = 0; round < model_.surfaces().size(); ++round) {
        bool changed = false;
        field();
        const std::vector<double> now = out_;
        for (std::size_t s = 0; s < model_.surfaces().size() && !changed; ++s)
            if (!in(mode_.sliding, s) && !mode_.isCoincident(s) && !isSettled(s))
                changed = follow(s, now, in(passed.surfaces, s));
        if (!changed)
            return;
    }
}

// True: its branch is another now.
bool ComponentEquations::follow(std::size_t surface, std::span<const double> rates, bool passed) {
    Decision& decision = mode_.decisions[model_.surfaces()[surface].members[0].decision];
    const Decision before = decision;
    const Slope slope = guardRate(surface, rates);
    if (model_.surfaces()[surface].whole) {
        if (!passed && before != expression::noBranch)
            decision = wholeBranch(surface, rates);
        return decision != before;
    }
    model_.function().guards(in_, guards_, scratch_, mode_.decisions);
    const double g = guard(surface);
    if (before == expression::noBranch || (passed && !slope.still))
        return false;
    if (g == 0 && (slope.still || mode_.sides[surface] == Mode::onSurface))
        settleOn(surface);
    else if ((g * mode_.sides[surface] < 0 || mode_.sides[surface] == Mode::onSurface) &&
             std::abs(g) > slope.near)
        setSide(surface, g > 0 ? 1 : -1);
    return decision != before;
}

bool ComponentEquations::leadsInside(const Watch& watch) {
    const Surface& surface = model_.surfaces()[watch.surface];
    if (watch.kind != Watch::Kind::side || surface.whole ||
        mode_.sides[watch.surface] == Mode::onSurface)
        return false;
    const std::vector<double> now = out_;
    const Slope slope = guardRate(watch.surface, now);
    return !slope.still && slope.rate * mode_.sides[watch.surface] > slope.noise;
}

bool ComponentEquations::contradicts(const Violation& violation, double t,
                                     std::span<const double> y) {
    if (unknownsOf(violation).empty()) // what no polynomial of this component is in
        return false;
    fill(t, y);
    field();
    return std::ranges::all_of(violation.watches, [this](std::size_t k) {
        return k < watches_.size() && leadsInside(watches_[k]);
    });
}

bool ComponentEquations::grazesByRounding(const Violation& violation, double t,
                                          std::span<const double> y) {
    if (violation.watches.size() != 1 || violation.watches[0] >= watches_.size())
        return false;
    const Watch& watch = watches_[violation.watches[0]];
    if (mode_.isGrazed[watch.surface] != 0 || wasPassed_[watch.surface] != 0)
        return false;
    fill(t, y);
    field();
    if (!leadsInside(watch))
        return false;
    const std::vector<double> now = out_;
    const Slope slope = guardRate(watch.surface, now);
    if (!(std::abs(slope.value) <= slope.least))
        return false;
    setGrazed(watch.surface, true);
    return true;
}

// On which side of those surfaces on which it was held is the motion at the violation's time?
bool ComponentEquations::looksAhead(const Violation& violation, double t,
                                    std::span<const double> y) {
    fill(t, y);
    model_.function().guards(in_, guards_, scratch_, mode_.decisions);
    ahead_.assign(model_.surfaces().size(), Mode::onSurface);
    bool any = false;
    for (const std::size_t k : violation.watches) {
        if (k >= watches_.size())
            continue;
        const auto [kind, s] = watches_[k];
        if (kind != Watch::Kind::side || model_.surfaces()[s].whole ||
            mode_.sides[s] != Mode::onSurface)
            continue;
        const double g = guard(s);
        ahead_[s] = (g > 0) - (g < 0);
        any = any || ahead_[s] != Mode::onSurface;
    }
    return any;
}

// Behind the surface the field leads back to it. What does it do in front of it? Where it leads
// back too the motion only touched the surface, and nothing could slide there. Where nothing moves
// it there, what passed was an error of polynomials, and it rests.
ComponentEquations::Front ComponentEquations::front(std::size_t surface) {
    const int side = mode_.sides[surface];
    setSide(surface, -side);
    field();
    const std::vector<double> before = out_;
    const Slope slope = guardRate(surface, before);
    setSide(surface, side);
    if (!slope.still && std::abs(slope.rate) <= slope.noise)
        return Front::rests;
    return slope.rate * side <= 0 ? Front::leadsAway : Front::leadsHere;
}

// Does the field behind each passed surface lead away from it?
void ComponentEquations::slideWhereLedBack(const Passed& passed) {
    field();
    const std::vector<double> behind = out_;
    model_.function().guards(in_, guards_, scratch_, mode_.decisions);
    std::vector<std::size_t> back;
    for (const std::size_t s : passed.surfaces) {
        wasPassed_[s] = 1;
        const Slope slope = guardRate(s, behind);
        setGrazed(s, !slope.still && std::abs(slope.rate) <= slope.noise);
        if (isOnSide(s) && slope.rate * mode_.sides[s] < -slope.noise &&
            std::abs(distance(s)) <= slope.near)
            back.push_back(s);
    }
    std::vector<Front> fronts;
    std::ranges::transform(back, std::back_inserter(fronts),
                           [this](std::size_t s) { return front(s); });
    for (std::size_t k = 0; k < back.size(); ++k) {
        const std::size_t s = back[k];
        if (fronts[k] != Front::leadsAway) {
            mode_.sliding.push_back(s);
            setGrazed(s, fronts[k] == Front::rests);
        } else if (std::ranges::find(passed.stood, s) == passed.stood.end()) {
            setSide(s, -mode_.sides[s]);
        }
    }
}

ComponentEquations::Crossing ComponentEquations::cross(const Violation& violation, double t,
                                                       std::span<double> y, Passing how) {
    if (std::ranges::any_of(violation.watches,
                            [this](std::size_t k) { return k >= watches_.size(); }))
        return leaveRest(violation, t, y) ? Crossing::done : Crossing::impossible;
    fill(t, y);
    if (t != standingAt_)
        standing_.clear();
    standingAt_ = t;
    if (how == Passing::solved && solveCorner()) {
        project(t, y);
        releaseWhereJumped(t, y);
        refreshWatches();
        return Crossing::done;
    }
    Passed passed{.isAlone = violation.watches.size() == 1};
    const Late late = how == Passing::across ? lateness(violation) : Late{};
    const std::vector<double> before = distancesOfSliding();
    for (const std::size_t k : violation.watches)
        pass(watches_[k], how, passed);
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
    releaseWhereJumped(t, y);
    refreshWatches();
    return Crossing::done;
}

// A switch is passed at the first double beyond it: always late, by half of the resolution of time
// in the middle. What swings about a switch gains by that each time, and its error grows like the
// square of the time, unless the time that it was late is made up for.
ComponentEquations::Late ComponentEquations::lateness(const Violation& violation) {
    const Watch& watch = watches_[violation.watches[0]];
    if (violation.watches.size() != 1 || watch.kind != Watch::Kind::side || !mode_.sliding.empty())
        return {};
    field();
    Late late{.seconds = 0, .rates = out_};
    const Slope slope = guardRate(watch.surface, late.rates);
    const bool isWhole = model_.surfaces()[watch.surface].whole;
    const double off = isWhole ? slope.value - std::round(slope.value) : slope.value;
    const double seconds = off / slope.rate;
    if (std::abs(seconds) <= 2 * std::numeric_limits<double>::epsilon() * std::abs(in_[0]))
        late.seconds = seconds;
    return late;
}

void ComponentEquations::makeUp(const Late& late, double t, std::span<double> y) {
    if (late.seconds == 0 || !mode_.sliding.empty())
        return;
    fill(t, y);
    field();
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double made = late.seconds * (out_[i] - late.rates[i]);
        if (std::isfinite(made)) // a branch may have no rate beyond its end
            y[i] += made;
    }
}

// Places among the symbols.
std::vector<std::size_t> ComponentEquations::symbolsOf(const Violation& violation) const {
    std::vector<Node> guards;
    guards.reserve(violation.watches.size());
    for (const std::size_t k : violation.watches)
        guards.push_back(k < watches_.size()
                             ? model_.surfaces()[watches_[k].surface].guard
                             : model_.directions().lengths[mode_.sticking[k - watches_.size()]]);
    std::vector<std::size_t> found;
    for (const Node symbol : expression::symbolsOf(graph(), guards))
        if (const auto place = model_.placeOf(symbol); place)
            found.push_back(*place);
    return found;
}

std::vector<std::size_t> ComponentEquations::surfacesOf(const Violation& violation) const {
    std::vector<std::size_t> found;
    for (const std::size_t k : violation.watches)
        if (k < watches_.size())
            found.push_back(watches_[k].surface);
    return found;
}

std::vector<std::size_t> ComponentEquations::unknownsOf(const Violation& violation) const {
    std::vector<std::size_t> found;
    for (const std::size_t place : symbolsOf(violation))
        if (place >= 1 && place <= size())
            found.push_back(states()[place - 1]);
    return found;
}

std::vector<std::size_t> ComponentEquations::inputsOf(const Violation& violation) const {
    std::vector<std::size_t> found;
    for (const std::size_t place : symbolsOf(violation))
        if (place > size() && place < model_.variables())
            found.push_back(inputs_.unknowns()[place - 1 - size()]);
    return found;
}

} // namespace solution
