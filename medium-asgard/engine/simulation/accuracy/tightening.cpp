#include "accuracy/tightening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace simulation {
namespace {

// Constants of the search, measured on all reference scenes (docs/numerics/measurements.md).
constexpr double tightening = 1.0 / 8;     // between the first two runs
constexpr double enough = 0.625;           // of the accuracy: the estimate that is accepted
constexpr double aim = 0.15;               // and what is aimed at when it is not
constexpr double proofCaution = 1.25;      // what a run at an eighth of the tolerance errs by
constexpr double loosening = 4;            // of a run that proves one at the tolerance of rounding
constexpr double roundingCaution = 1.5;    // what the tighter of the two errs by
constexpr double leastDoubted = 0.01;      // of the accuracy: what chance hides more behind
constexpr double amplified = 20;           // times early errors: faster than the square of time
constexpr double rougher = 512;            // of a third run, when the first two are equal
constexpr double leastStep = 1e-3;         // of tolerances from run to run, and of errors
constexpr double mostStep = 0.25;          // of tolerances, where a run was not enough
constexpr double caution = 2.5, lag = 0.9; // errors fall a little less than tolerances do
constexpr double plausible = 0.03;         // larger differences say nothing of how errors behave
constexpr double nearby = 3, far = 100;    // times the accuracy: differences that can be trusted
// Orders that two pairs of runs can show, where errors follow tolerances; what is measured outside
// counts as the nearest that is believed, and is not trusted.
constexpr double orderly = 0.1; // the largest difference that shows an order
constexpr double leastOrder = 0.7, mostOrder = 1.45, leastBelieved = 0.5, mostBelieved = 1.5;
constexpr double closer = 0.5; // of the difference before: what comes closer
constexpr double later = 1.02; // than wrong runs parted before: what comes closer, too
// Pairs of runs that come no closer, before tightening is given up: where they differ by little
// more than the accuracy, and rounding is too far off to be why, errors may yet begin to fall.
constexpr int patience = 2, morePatience = 5;
constexpr double farAboveRounding = 1e4; // a tolerance
// What rounding does in a step, as a tolerance: where errors of the reference scenes stop falling.
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double roundingUnits = 64, leastUnits = 4;
constexpr double landing = 1.01; // what is no farther from the last tolerance is there

// Coordinates have more digits after the point the nearer they are to the origin.
double coarseness(const IslandError& difference) {
    return std::max(1.0, difference.size > 0 ? difference.far / difference.size : 1.0);
}

} // namespace

Tightening::Tightening(double accuracy, std::size_t bodies)
    : accuracy_(accuracy), loose_(bodies, firstTolerance(accuracy)),
      tight_(bodies, tightening * firstTolerance(accuracy)), bodies_(bodies) {}

Tightening::Outlook Tightening::outlook(std::size_t b, const IslandError& difference,
                                        double rounding) const {
    const Body& body = bodies_[b];
    const double error = difference.largest;
    Outlook outlook{.order = 1, .gain = 1, .estimate = 1, .isMeasured = false};
    if (error > 0 && error < body.before && body.before < orderly && loose_[b] < body.looser) {
        outlook.order = std::log(error / body.before) / std::log(loose_[b] / body.looser);
        outlook.isMeasured = outlook.order > leastOrder && outlook.order < mostOrder;
        outlook.order = std::clamp(outlook.order, leastBelieved, mostBelieved);
    }
    const double ratio = std::max(tight_[b], rounding) / std::max(loose_[b], rounding);
    outlook.gain = std::max(std::pow(ratio, lag * outlook.order), leastStep);
    if (error == 0 && body.before > 0) // equal runs, by rounding: those before say more
        outlook.estimate = std::min(body.before, 1.0);
    else if (std::isfinite(error))
        outlook.estimate =
            caution * outlook.gain * error + leastUnits * epsilon * coarseness(difference);
    return outlook;
}

bool Tightening::isKept(const IslandError& difference, const Outlook& outlook) const {
    const double trusted = (outlook.isMeasured ? far : nearby) * accuracy_;
    return outlook.estimate <= enough * accuracy_ &&
           difference.largest <= std::min(trusted, plausible);
}

// `factor`: of the difference, what the tighter run is off at each time.
void Tightening::settle(std::size_t b, const IslandError& difference, double estimate,
                        double factor, BodyError& error) {
    bodies_[b].isSettled = true;
    error = {.estimate = estimate,
             .predictableUntil = estimate > accuracy_ ? difference.beyondFrom(accuracy_ / factor)
                                                      : solution::infinity};
}

// What the runs that were compared leave open. Motion that amplifies errors makes a number of them,
// along the one direction that grows fastest, and two runs may agree by chance, however wrong they
// both are.
Tightening::Proof Tightening::proofFor(std::size_t b, const IslandError& difference,
                                       double rounding) const {
    const double error = difference.largest;
    const bool mayBeChance = error > leastDoubted * accuracy_;
    const bool isAmplified = mayBeChance && error > amplified * difference.early;
    const bool hasFewSteps = difference.steps <= fewSteps && error > 0;
    if ((isAmplified || hasFewSteps) && tightening * tight_[b] > rounding)
        return Proof::tighter;
    const bool isAtRounding = tight_[b] <= landing * rounding;
    return isAtRounding && mayBeChance ? Proof::looser : Proof::none;
}

// The next tolerance of a body; its last one when it is settled.
double Tightening::next(std::size_t b, const IslandError& difference, BodyError& known) {
    Body& body = bodies_[b];
    const double error = difference.largest, tight = tight_[b];
    if (tight == loose_[b] && body.isSettled) // the same run again, for others
        return tight;
    const double rounding = roundingUnits * epsilon * coarseness(difference);
    const Outlook ahead = outlook(b, difference, rounding);
    const double growth = caution * ahead.gain; // from the difference to the tighter run's error
    // Two wrong runs may differ as much as a wrong and a right one do: then they part later.
    const bool isWrong = !(error <= plausible);
    const double beyond = difference.beyondFrom(accuracy_);
    const bool isNoCloser = body.before >= 0 && !(error < closer * body.before) &&
                            !(isWrong && beyond > later * body.beyondBefore);
    const double unsettled = std::max(ahead.estimate, std::min(error, 1.0));
    const bool mayYetFall = error <= far * accuracy_ && tight > farAboveRounding * rounding;
    body.failures += isNoCloser ? 1 : 0;
    body.size = difference.size;
    body.before = error;
    body.beyondBefore = beyond;
    body.looser = loose_[b];
    body.isSettled = false;
    body.proof = Proof::none;
    if (isKept(difference, ahead))
        settle(b, difference, ahead.estimate, growth, known);
    else if (body.failures >= (mayYetFall ? morePatience : patience))
        settle(b, difference, unsettled, 1, known);
    else if (tight <= rounding)
        settle(b, difference, isWrong ? unsettled : ahead.estimate, growth, known);
    if (body.isSettled) {
        if (known.estimate <= accuracy_)
            body.proof = proofFor(b, difference, rounding);
        return tight;
    }
    const double left = error * ahead.gain; // the error of the tighter run
    const double wanted =
        tight * std::clamp(std::isfinite(left) ? aim * accuracy_ / left : 0, leastStep, mostStep);
    // Where motion becomes unpredictable is best seen by two runs that are both as good as can be.
    const double last = rounding / tightening;
    return isWrong && tight > landing * last ? std::max(wanted, last) : std::max(wanted, rounding);
}

void Tightening::leaveExact(const Run& run) {
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (!run.isIntegrated[b]) {
            tight_[b] = loose_[b];
            bodies_[b].isSettled = true;
        }
    share(run.island);
}

std::vector<bool> Tightening::runsAgain() const {
    std::vector<bool> again(bodies_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        again[b] = tight_[b] != loose_[b] || !bodies_[b].isSettled;
    return again;
}

// A body at rest has the same motion at all tolerances: a rougher run would tell nothing.
bool Tightening::isEqual(std::size_t b, const IslandError& difference) const {
    return difference.largest == 0 && difference.moves && difference.size > 0 &&
           tight_[b] != loose_[b] && !bodies_[b].isSettled && bodies_[b].before < 0;
}

bool Tightening::needsRougher(const std::vector<IslandError>& differences) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (isEqual(b, differences[b]))
            return true;
    return false;
}

void Tightening::roughen(const std::vector<IslandError>& differences) {
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (isEqual(b, differences[b]))
            loose_[b] = std::max(rougher * loose_[b],
                                 rougher * roundingUnits * epsilon * coarseness(differences[b]));
}

void Tightening::judge(const std::vector<IslandError>& differences,
                       const std::vector<std::size_t>& island, std::vector<BodyError>& errors) {
    std::vector<double> wanted(bodies_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        wanted[b] = next(b, differences[b], errors[b]);
    loose_ = std::exchange(tight_, wanted);
    share(island);
}

// Bodies of one island go by the tightest of them.
void Tightening::share(const std::vector<std::size_t>& island) {
    std::vector<double> least(bodies_.size(), solution::infinity);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        least[island[b]] = std::min(least[island[b]], tight_[b]);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        tight_[b] = least[island[b]];
}

void Tightening::doubt(std::size_t body) {
    const bool canBeTighter = tightening * tight_[body] > roundingUnits * epsilon;
    if (canBeTighter && bodies_[body].isSettled && bodies_[body].proof == Proof::none)
        bodies_[body].proof = Proof::tighter;
}

std::vector<double> Tightening::sizes() const {
    std::vector<double> sizes;
    for (const Body& body : bodies_)
        sizes.push_back(body.size);
    return sizes;
}

std::vector<bool> Tightening::unproven() const {
    std::vector<bool> bodies;
    for (const Body& body : bodies_)
        bodies.push_back(body.proof != Proof::none);
    return bodies;
}

std::vector<double> Tightening::proof() const {
    std::vector<double> tolerances = tight_;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (bodies_[b].proof != Proof::none)
            tolerances[b] *= bodies_[b].proof == Proof::tighter ? tightening : loosening;
    return tolerances;
}

std::optional<std::vector<double>> Tightening::tighter() const {
    std::vector<double> tolerances = tight_;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const bool isExact = bodies_[b].isSettled && bodies_[b].before < 0;
        if (bodies_[b].isSettled && !isExact)
            return std::nullopt;
        if (!isExact)
            tolerances[b] *= tightening;
    }
    return tolerances;
}

void Tightening::prove(const std::vector<IslandError>& differences,
                       std::vector<BodyError>& errors) {
    const std::vector<double> proven = proof();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const Proof kind = std::exchange(bodies_[b].proof, Proof::none);
        const IslandError& difference = differences[b];
        if (kind == Proof::looser)
            proveByLooser(b, difference, errors[b]);
        if (kind != Proof::tighter)
            continue;
        const double estimate =
            proofCaution * difference.largest + leastUnits * epsilon * coarseness(difference);
        bodies_[b].isSettled = estimate <= accuracy_;
        if (bodies_[b].isSettled)
            errors[b].estimate = estimate;
        else
            tight_[b] = proven[b];
    }
}

// The run at tight() is as good as can be: what it errs by is all that can be said.
void Tightening::proveByLooser(std::size_t b, const IslandError& difference, BodyError& error) {
    const double estimate = roundingCaution * std::min(difference.largest, 1.0);
    if (estimate > error.estimate)
        settle(b, difference, estimate, roundingCaution, error);
}

std::vector<bool> Tightening::unsettled() const {
    std::vector<bool> open;
    for (const Body& body : bodies_)
        open.push_back(!body.isSettled);
    return open;
}

bool Tightening::goesOn() const { return !std::ranges::all_of(bodies_, &Body::isSettled); }

} // namespace simulation
