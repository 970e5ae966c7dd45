#include "modes/active_set.h"

#include "complementarity/solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace solution {

using complementarity::State;

namespace {

constexpr double slow = 1e-8;     // of the velocities: a contact neither approaches nor parts
constexpr double noLength = 1e-4; // of a resolution, which is 1e-9 of a size

double shortest(double t) { return 1e-12 * std::max(1e-6, std::abs(t)); }

} // namespace

ActiveSet::ActiveSet(ModelFunctions& functions, Multipliers& multipliers, Mode& mode)
    : f_(functions), multipliers_(multipliers), mode_(mode) {
    const auto& laws = functions.bound()->laws;
    for (std::size_t row = 0; row < laws.size(); ++row)
        if (laws[row].isBounded()) {
            bounded_.push_back(row);
            hasContacts_ = hasContacts_ || isContact(row);
        }
    opened_.assign(laws.size(), 0);
    jammed_.assign(laws.size(), 0);
    mode.discs.clear();
    for (const BoundModel::Disc& disc : discs())
        mode.discs.push_back({.slip = {leastOf(disc), 0, 0}});
}

bool ActiveSet::isStop(std::size_t row) const { return law(row).isStop; }

bool ActiveSet::slips() const {
    for (std::size_t disc = 0; disc < discs().size(); ++disc)
        if (multipliers_.friction().slips(disc))
            return true;
    return false;
}

// --------------------------------------------------------------------------------------- watches

void ActiveSet::refresh() {
    watches_.clear();
    for (const std::size_t row : bounded_)
        if (!isGone(row) && !law(row).disc)
            watchRow(row);
    for (std::size_t disc = 0; disc < discs().size(); ++disc)
        watchDisc(disc);
    const auto held = std::ranges::find_if(
        bounded_, [this](std::size_t row) { return isContact(row) && holds(row); });
    if (held != bounded_.end())
        watches_.push_back({*held, Kind::unsolved});
}

void ActiveSet::watchRow(std::size_t row) {
    const BoundModel::Law& of = law(row);
    const auto [first, last] = multipliers_.confines(row);
    for (std::uint32_t k = first; k < last; ++k) // one by one, since the least of them has kinks
        watches_.push_back({row, Kind::invalid, k});
    if (mode_.kept[row] == State::inside) {
        if (of.low > -complementarity::unbounded)
            watches_.push_back({row, Kind::least});
        if (of.high < complementarity::unbounded)
            watches_.push_back({row, Kind::most});
    } else if (of.isStop) {
        watches_.push_back({row, Kind::gap});
        if (isContact(row))
            watches_.push_back({row, Kind::parted});
    } else {
        watches_.push_back({row, mode_.kept[row] == State::low ? Kind::forward : Kind::backward});
    }
}

// Without a normal force there is nothing to watch.
void ActiveSet::watchDisc(std::size_t disc) {
    const BoundModel::Disc& of = discs()[disc];
    const bool isPressed = std::ranges::any_of(
        of.normals, [this](std::size_t row) { return mode_.kept[row] == State::inside; });
    if (isPressed && !isGone(of.rows[0]))
        watches_.push_back({disc, multipliers_.friction().slips(disc) ? Kind::turn : Kind::cone});
}

std::size_t ActiveSet::rowOf(std::size_t watch) const {
    const auto [row, kind, confine] = watches_[watch];
    const bool isOfDisc = kind == Kind::cone || kind == Kind::turn;
    return isOfDisc ? discs()[row].rows[0] : row;
}

void ActiveSet::watch(std::span<double> values) {
    if (watches_.empty())
        return;
    multipliers_.evaluateGaps();
    largest_ = 0;
    if (hasContacts_)
        for (const double m : multipliers_.values())
            largest_ = std::max(largest_, std::abs(m));
    for (std::size_t k = 0; k < watches_.size(); ++k) {
        const bool isKnown = multipliers_.areFound() || !readsForces(k);
        values[k] = isKnown || watches_[k].kind == Kind::unsolved ? valueOf(watches_[k]) : 1;
    }
}

bool ActiveSet::readsForces(std::size_t watch) const {
    const Kind kind = watches_[watch].kind;
    return kind == Kind::least || kind == Kind::most || kind == Kind::cone ||
           kind == Kind::unsolved;
}

bool ActiveSet::isOfPlaces(std::size_t watch) const {
    const auto [row, kind, confine] = watches_[watch];
    return kind == Kind::invalid || (kind == Kind::gap && isContact(row));
}

bool ActiveSet::isOffPlace(std::size_t watch) {
    constexpr double ofResolution = 0.1;
    return std::abs(watchOfPlaces(watch)) > ofResolution * law(watches_[watch].row).resolution;
}

bool ActiveSet::grazes(std::size_t watch) {
    const auto [row, kind, confine] = watches_[watch];
    if (kind != Kind::gap)
        return false;
    multipliers_.evaluateGaps();
    const double gap = multipliers_.gap(row), resolution = law(row).resolution;
    if (!(gap > -resolution && multipliers_.rate(row) > rateOf * resolution))
        return false;
    opened_[row] = std::min(opened_[row], 2 * gap);
    return true;
}

double ActiveSet::watchOfPlaces(std::size_t watch) {
    multipliers_.evaluateGaps();
    return valueOf(watches_[watch]);
}

namespace {

// A value that is 0 but for rounding is constant: one that trembles about 0 ends nothing.
double beyond(double none, double value) { return value >= -none ? std::max(value, none) : value; }

} // namespace

double ActiveSet::beyondRounding(double force) const { return beyond(noForce * largest_, force); }

double ActiveSet::valueOf(const Watch& watch) const {
    const auto [row, kind, confine] = watch;
    switch (kind) {
    case Kind::cone:
        return beyondRounding(multipliers_.friction().leewayOf(row, multipliers_.values()));
    case Kind::unsolved:
        return multipliers_.areFound() ? 1 : -1;
    case Kind::turn: // others may hold it at rest, but for rounding
        return multipliers_.friction().aheadOf(row);
    case Kind::gap:
        return multipliers_.gap(row) - opened_[row] +
               (isContact(row) ? rateOf * law(row).resolution : 0) +
               (mode_.touches[row] != 0 ? law(row).resolution : 0);
    case Kind::parted:
        return *law(row).leaving - multipliers_.gap(row);
    case Kind::invalid:
        return beyond(noLength * law(row).resolution, multipliers_.confine(confine));
    case Kind::least:
        return beyondRounding(multipliers_.values()[row] - law(row).low);
    case Kind::most:
        return law(row).high - multipliers_.values()[row];
    case Kind::forward: // others may hold its rate at 0, but for rounding
        return rateOf * law(row).resolution + multipliers_.rate(row);
    case Kind::backward:
        return rateOf * law(row).resolution - multipliers_.rate(row);
    }
    return 0;
}

// ------------------------------------------------------------------------------- the next set

// Stops and brakes are open while the conditions without bounds make velocities consistent.
void ActiveSet::decide(double t, std::span<double> y) {
    if (bounded_.empty())
        return;
    std::ranges::fill(mode_.touches, 0);
    for (const std::size_t row : bounded_)
        if (!isGone(row))
            mode_.kept[row] = State::low;
    multipliers_.project(t, y);
    beginEvent(t);
    ahead_ = 0;
    slowest_ = slowestOf(y, 0);
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    double fastest = 0;
    for (std::size_t row = 0; row < mode_.kept.size(); ++row)
        fastest = std::max(fastest, std::abs(multipliers_.rate(row)));
    const double none = slow * multipliers_.fastest(y);
    std::vector<std::size_t> hit, closed;
    for (const std::size_t row : bounded_) {
        const bool touches =
            isStop(row) && !isGone(row) && multipliers_.gap(row) <= law(row).resolution;
        const bool approaches = multipliers_.rate(row) < -atRest * fastest;
        if (touches && isContact(row) && multipliers_.rate(row) <= none)
            closed.push_back(row); // its source has made it: it neither approaches nor parts
        else if (touches && approaches)
            hit.push_back(row);
    }
    if (!hit.empty())
        blow(hit, t, y);
    slip(fastest, t, y);
    std::vector<std::size_t> landing; // the blow of their source has left them so
    for (const std::size_t row : closed)
        if (multipliers_.rate(row) < -none)
            landing.push_back(row);
    if (!landing.empty())
        (void)endDriven(landing, none, t, y);
    closed.insert(closed.end(), hit.begin(), hit.end());
    if (!settle(closed, fastest, t, y))
        (void)endJam(closed, t, y, std::vector<double>(y.size(), 0));
    else
        closeLow(closed, none, fastest, t, y);
    noteOpened(std::vector<State>(mode_.kept.size(), State::inside), t, y);
    refresh();
}

// A jam is one of its instant, however many events that has.
void ActiveSet::beginEvent(double t) {
    if (t != lastCross_)
        std::ranges::fill(jammed_, 0);
    lastCross_ = t;
}

// An overlap by rounding, or by what an impact left, closes no stop again.
void ActiveSet::noteOpened(std::span<const State> before, double t, std::span<const double> y) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    for (const std::size_t row : bounded_)
        if (isStop(row) && mode_.kept[row] == State::low && before[row] != State::low)
            opened_[row] = std::min(0.0, multipliers_.gap(row));
}

// At the bound itself the laws have both answers; a little ahead, along the rates that led there,
// they have one. If that little was too little, it is more the next time.
bool ActiveSet::cross(std::span<const std::size_t> watches, double t, std::span<double> y,
                      std::span<const double> rates) {
    constexpr double part = 1e-6, more = 100; // of the time since the last event
    ahead_ = t > lastCross_ ? part * (t - lastCross_) : std::max(more * ahead_, shortest(t));
    f_.fill(t, y);
    (void)solve();
    const bool isKnown = multipliers_.areFound();
    slowest_ = slowestOf(y, isKnown ? multipliers_.weight() : 0);
    multipliers_.evaluateGaps();
    for (std::size_t disc = 0; disc < discs().size() && isKnown; ++disc)
        setCentre(disc, multipliers_.friction().centreOf(disc, multipliers_.values()));
    const double elapsed = t - lastCross_;
    beginEvent(t);
    const Mode before = mode_;
    std::vector<std::size_t> fallen(watches.begin(), watches.end());
    addClosing(fallen, t);
    auto [candidates, hit, stopped, isUnsolved] = endBy(fallen, elapsed);
    land(fallen, t, y);
    const std::vector<double> moving(y.begin(), y.end());
    const Mode ended = mode_;
    const double slowest = slowest_;
    std::vector<SlowSlip> slow = slowSlips(stopped);
    bool isDone = settleWith(hit, candidates, stopped, t, y, rates);
    while ((!isDone || !stopped.empty()) && stopNext(slow, stopped, slowest, isDone, t, y)) {
        std::ranges::copy(moving, y.begin());
        mode_ = ended;
        slowest_ = slowest;
        isDone = settleWith(hit, candidates, stopped, t, y, rates);
    }
    if (isDone && isUnsolved)
        isDone = hasForces(t, y);
    // No forces hold the slips that were slow: they go on.
    if (!isDone && slow_.part > 0 && !stopped.empty()) {
        std::ranges::copy(moving, y.begin());
        mode_ = before;
        lastCross_ = t - elapsed;
        const Slow limits = std::exchange(slow_, {});
        const bool isOn = cross(watches, t, y, rates);
        slow_ = limits;
        return isOn;
    }
    if (!isDone) {
        std::ranges::copy(moving, y.begin());
        mode_ = ended;
        isDone = endJam(candidates, t, y, rates);
    }
    multipliers_.project(t, y);
    if (isDone && hit.empty() && slips() && !hasForces(t, y))
        settleAgain(candidates, t, y, rates);
    noteOpened(before.kept, t, y);
    refresh();
    return isDone;
}

ActiveSet::Ended ActiveSet::endBy(std::span<const std::size_t> fallen, double elapsed) {
    Ended ended;
    for (const std::size_t k : fallen) {
        const auto [row, kind, confine] = watches_[k];
        const bool isEnded = kind == Kind::parted || kind == Kind::invalid ||
                             (kind == Kind::gap && isContact(row) && !hasFallenLow(row));
        if (isEnded)
            mode_.kept[row] = Mode::gone;
        else if (kind == Kind::unsolved)
            ended.isUnsolved = true;
        else if (kind == Kind::turn && hasStopped(row, elapsed))
            ended.stopped.push_back(row);
        else if (kind == Kind::cone)
            ended.candidates.push_back(discs()[row].rows[0]);
        else if (kind == Kind::turn)
            setSlip(row);
        else
            ended.candidates.push_back(row);
        if (kind == Kind::gap && !isContact(row))
            ended.hit.push_back(row);
    }
    if (ended.isUnsolved)
        for (const SlowSlip& slip : slowSlips(ended.stopped))
            ended.stopped.push_back(slip.disc);
    return ended;
}

// The next set, where `hit` takes a blow, `stopped` has come to rest, and `candidates` may hold.
bool ActiveSet::settleWith(std::vector<std::size_t> hit, std::vector<std::size_t> candidates,
                           std::span<const std::size_t> stopped, double t, std::span<double> y,
                           std::span<const double> rates) {
    for (const std::size_t disc : stopped)
        candidates.push_back(discs()[disc].rows[0]);
    halt(stopped, t, y);
    if (hit.empty()) {
        std::vector<double> beyond(y.begin(), y.end());
        for (std::size_t i = 0; i < beyond.size(); ++i)
            beyond[i] += ahead_ * rates[i];
        return settle(candidates, 0, t + ahead_, beyond);
    }
    addTouching(hit);
    double fastest = 0;
    for (const std::size_t row : hit)
        fastest = std::max(fastest, std::abs(multipliers_.rate(row)));
    blow(hit, t, y);
    slip(fastest, t, y);
    return settle(candidates, fastest, t, y);
}

complementarity::Laws ActiveSet::lawsOf(std::span<const std::size_t> rows,
                                        std::span<const std::size_t> shut) const {
    complementarity::Laws laws;
    for (const std::size_t row : rows)
        if (law(row).isBounded() && !isIn(shut, row))
            complementarity::addUnilateral(laws);
        else
            complementarity::addEquality(laws);
    return laws;
}

bool ActiveSet::touches(std::size_t row) const {
    return isStop(row) && !isContact(row) && mode_.kept[row] != State::inside &&
           multipliers_.gap(row) <= law(row).resolution;
}

// Stops that close at one instant, but for rounding, take one blow: one after another they would
// share it otherwise, and drive each other into hops.
void ActiveSet::addTouching(std::vector<std::size_t>& hit) const {
    for (const std::size_t row : bounded_)
        if (touches(row) && multipliers_.rate(row) < 0 && !isIn(hit, row))
            hit.push_back(row);
}

// Contacts that close at one instant, but for rounding, close together, too: the wheels of a car on
// both sides of it.
void ActiveSet::addClosing(std::vector<std::size_t>& fallen, double t) const {
    const auto closes = [&](std::size_t watch) {
        return watches_[watch].kind == Kind::gap && isContact(watches_[watch].row);
    };
    if (std::ranges::none_of(fallen, closes))
        return;
    for (std::size_t k = 0; k < watches_.size(); ++k) {
        if (!closes(k) || isIn(fallen, k))
            continue;
        const std::size_t row = watches_[k].row;
        const double rate = multipliers_.rate(row), none = noLength * law(row).resolution;
        if (rate < 0 && valueOf(watches_[k]) <= none - rate * shortest(t))
            fallen.push_back(k);
    }
}

// A stop whose rebound would be lower than its resolution takes the blow without one, and a stop
// that touches and would be in such a hop is closed.
void ActiveSet::blow(std::span<const std::size_t> hit, double t, std::span<double> y) {
    std::vector<double> restitutions(mode_.kept.size(), 0);
    for (const std::size_t row : hit)
        restitutions[row] = law(row).restitution;
    const std::vector<double> before(y.begin(), y.end());
    give(hit, {}, restitutions, t, y);
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    bool isAnyLow = false;
    for (const std::size_t row : hit)
        if (const double rate = multipliers_.rate(row);
            restitutions[row] > 0 && rate > 0 && isLow(row, rate)) {
            restitutions[row] = 0;
            isAnyLow = true;
        }
    const std::vector<std::size_t> shut = drivenLow(hit, restitutions);
    if (!isAnyLow && shut.empty())
        return;
    std::ranges::copy(before, y.begin());
    give(hit, shut, restitutions, t, y);
}

// With the stops that were hit closed: these decide how soon the others come back.
std::vector<std::size_t> ActiveSet::drivenLow(std::span<const std::size_t> hit,
                                              std::span<const double> restitutions) {
    std::vector<std::size_t> driven, low;
    for (const std::size_t row : bounded_)
        if (touches(row) && multipliers_.rate(row) > rateOf * law(row).resolution)
            driven.push_back(row);
    if (driven.empty())
        return low;
    const std::vector<State> before = mode_.kept;
    for (const std::size_t row : hit)
        if (restitutions[row] == 0 && !isIn(driven, row))
            mode_.kept[row] = State::inside;
    for (const std::size_t row : driven)
        if (isLow(row, multipliers_.rate(row)))
            low.push_back(row);
    mode_.kept = before;
    return low;
}

void ActiveSet::setDisc(std::size_t disc, State state) {
    for (const std::size_t row : discs()[disc].rows)
        if (!isGone(row))
            mode_.kept[row] = state;
}

void ActiveSet::setSlip(std::size_t disc, const DiscFriction::InDisc& direction, double speed) {
    setDisc(disc, State::low);
    const double length = direction.norm(), least = leastOf(discs()[disc]);
    Eigen::Map<Eigen::Vector3d> slip(mode_.discs[disc].slip.data());
    if (length > 0) {
        slip.setZero();
        slip.head(direction.size()) = direction / length;
    }
    const bool isSlow = direction.size() > 1 && speed < slowest_;
    slip *= (isSlow ? std::max(slowest_, least) : least) / slip.norm();
}

void ActiveSet::setSlip(std::size_t disc) {
    const DiscFriction::InDisc slip = multipliers_.friction().slipOf(disc);
    setSlip(disc, slip, slip.norm());
}

void ActiveSet::setCentre(std::size_t disc, const DiscFriction::Centre& centre) {
    mode_.discs[disc].centre = {};
    std::ranges::copy(centre, mode_.discs[disc].centre.begin());
    mode_.discs[disc].last = mode_.discs[disc].centre;
}

// Brakes, motors and friction do not hold against a blow: they slip the way that it gives.
void ActiveSet::slip(double fastest, double t, std::span<const double> y) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    for (const std::size_t row : bounded_)
        if (const double rate = multipliers_.rate(row);
            !isStop(row) && !isGone(row) && !law(row).disc)
            mode_.kept[row] = std::abs(rate) <= atRest * fastest ? State::inside
                              : rate > 0                         ? State::low
                                                                 : State::high;
    for (std::size_t disc = 0; disc < discs().size(); ++disc)
        setSlip(disc);
}

// It fell from a height that is none: it closes without a blow. A blow would drive what slides in
// the same island into a hop of its own, without end.
bool ActiveSet::hasFallenLow(std::size_t row) const {
    const double rate = multipliers_.rate(row), second = multipliers_.secondRate(row);
    const double sunk = multipliers_.gap(row) - opened_[row]; // since it touched: no height
    return hopOf(rate, second) + std::min(sunk, 0.0) < std::max(law(row).hop, law(row).resolution);
}

// With nothing that holds it, it would come back from that height.
bool ActiveSet::isLow(std::size_t row, double rate) {
    (void)solve();
    const double second = multipliers_.secondRate(row);
    return hopOf(rate, second) < law(row).resolution;
}

// Newton's law: of what approaches the rate afterwards is -e times that before, or more. Of `shut`
// it is 0.
void ActiveSet::give(std::span<const std::size_t> hit, std::span<const std::size_t> shut,
                     std::span<const double> restitutions, double t, std::span<double> y) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < mode_.kept.size(); ++row) {
        const bool isHeld = mode_.kept[row] == State::inside &&
                            (!law(row).isBounded() ? law(row).isOnSecondRates : isStop(row));
        if (isHeld || isIn(hit, row) || isIn(shut, row))
            rows.push_back(row);
    }
    const auto [a, none] = multipliers_.systemOf(rows);
    Eigen::VectorXd b(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double rate = multipliers_.rate(rows[i]);
        const bool isHit = isIn(hit, rows[i]) && rate < 0;
        b[static_cast<Eigen::Index>(i)] = isHit ? (1 + restitutions[rows[i]]) * rate : rate;
    }
    const auto answer = complementarity::solve(a, b, lawsOf(rows, shut));
    if (answer)
        multipliers_.push(rows, answer->forces, y);
}

// Its direction has turned by a right angle: it rests, if it is slow beside what its deceleration
// has taken away since the last event, or would take away on a short way; else it slips on another
// way.
bool ActiveSet::hasStopped(std::size_t disc, double elapsed) {
    constexpr double ofLost = 1e-6;
    const double second = secondOf(disc);
    const double none = std::max({leastOf(discs()[disc]), ofLost * second * elapsed,
                                  std::sqrt(slow_.way * second), slowest_});
    return multipliers_.friction().slipOf(disc).norm() <= none;
}

double ActiveSet::secondOf(std::size_t disc) const {
    double second = 0;
    for (const std::size_t row : discs()[disc].rows)
        second = std::max(second, std::abs(multipliers_.secondRate(row)));
    return second;
}

double ActiveSet::slowestOf(std::span<const double> y, double weight) const {
    return std::max(slow_.part * multipliers_.fastest(y), fallenSlow(weight));
}

double ActiveSet::fallenSlow(double weight) const {
    return slow_.part * std::sqrt(slow_.extent * weight);
}

// Of those that have not stopped.
std::vector<ActiveSet::SlowSlip> ActiveSet::slowSlips(std::span<const std::size_t> stopped) const {
    std::vector<SlowSlip> slow;
    for (std::size_t disc = 0; disc < discs().size(); ++disc)
        if (multipliers_.friction().slips(disc) && !isIn(stopped, disc))
            if (const double speed = multipliers_.friction().slipOf(disc).norm(); speed < slowest_)
                slow.push_back({disc, speed});
    return slow;
}

// Slow slips whose speed changes by as much as they have almost at once, now that these have
// stopped, stop with them: one after another, each would turn the others back. A slow slip that
// something fast drags along goes on: of dominoes that lean on each other, each slides a hundredth
// as fast as the next. Where no forces hold what has stopped, all slow slips stop with it.
bool ActiveSet::stopNext(std::vector<SlowSlip>& slow, std::vector<std::size_t>& stopped,
                         double slowest, bool isDone, double t, std::span<const double> y) {
    constexpr double soon = 1e3; // times as late as what the largest load brakes
    if (slow.empty())
        return false;
    f_.fill(t, y);
    const bool isKnown = solve() && isDone;
    multipliers_.evaluateGaps();
    const double weight = multipliers_.weight();
    const auto stops = [&](const SlowSlip& slip) {
        return !isKnown || slip.speed * weight <= soon * slowest * secondOf(slip.disc);
    };
    const std::size_t before = stopped.size();
    for (const SlowSlip& slip : slow)
        if (stops(slip))
            stopped.push_back(slip.disc);
    std::erase_if(slow, [&](const SlowSlip& slip) { return isIn(stopped, slip.disc); });
    return stopped.size() > before;
}

// By the least change of velocities.
void ActiveSet::halt(std::span<const std::size_t> discs, double t, std::span<double> y) {
    if (discs.empty())
        return;
    const std::vector<State> before = mode_.kept;
    for (const std::size_t disc : discs)
        setDisc(disc, State::inside);
    multipliers_.project(t, y);
    mode_.kept = before;
    f_.fill(t, y);
    multipliers_.evaluateGaps();
}

} // namespace solution
