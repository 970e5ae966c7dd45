#include "integrators/method_choice.h"

#include <algorithm>

namespace solution {

namespace {

constexpr double memory = 0.9; // weight of what was before, per step
constexpr double bound = 0.8, suspicious = 0.1;
constexpr std::size_t trialSteps = 12, warmUp = 4;
constexpr double worthIt = 1.3;
constexpr double implicitStep = 10, shortTime = 1.0 / 250;
constexpr std::size_t unlikely = 500;
constexpr std::size_t asMuch = 320;   // steps cost more than a trial
constexpr double explicitLimit = 6.1; // of dop853 on the real axis
constexpr std::size_t spectralInterval = 16;

// An implicit step may be short beside the motion.
bool isLikely(double h, double crossing) { return implicitStep * h < shortTime * crossing; }

} // namespace

MethodChoice MethodChoice::restarted() const {
    MethodChoice result;
    result.implicit_ = implicit_ && !trial_;
    result.evidence_ = evidence_;
    result.tried_ = tried_;
    return result;
}

double MethodChoice::costOf(const Method& method) const {
    const MethodCounts& c = method.counts();
    return static_cast<double>(c.evaluations + 8 * c.jacobians + 60 * c.factorisations +
                               12 * c.iterations);
}

void MethodChoice::change(bool implicit) {
    if (!implicit)
        evidence_ *= 2;
    implicit_ = implicit;
    trial_ = implicit;
    tried_ = true;
    steps_ = 0;
    stability_ = before_ = progress_ = cost_ = 0;
}

bool MethodChoice::changesAfter(const Method& method, double h, double crossing, double known) {
    ++steps_;
    const double cost = costOf(method);
    const double forget = trial_ ? 1 : memory;
    progress_ = forget * progress_ + h;
    cost_ = forget * cost_ + cost - before_;
    before_ = cost;
    if (trial_ && steps_ == warmUp)
        progress_ = cost_ = 0;
    if (!implicit_) {
        const double used = std::max(method.stabilityUsed(), h * known / method.stabilityLimit());
        stability_ = memory * stability_ + (1 - memory) * used;
        const bool isShort = isLikely(h, crossing);
        const std::size_t enough = isShort || tried_ ? evidence_ : std::max(evidence_, unlikely);
        const bool stiff =
            stability_ > bound && steps_ >= (isShort ? std::min(enough, asMuch) : enough);
        const bool perhaps = stability_ > suspicious && steps_ >= 4 * enough;
        if (!stiff && !perhaps)
            return false;
        explicitRate_ = progress_ / cost_;
        change(true);
        return true;
    }
    if (!trial_ || steps_ < trialSteps)
        return false;
    trial_ = false;
    if (progress_ / cost_ >= worthIt * explicitRate_)
        return false;
    change(false);
    return true;
}

bool MethodChoice::wantsSpectralRadius() const {
    return implicit_ && !trial_ && steps_ > 0 && steps_ % spectralInterval == 0;
}

bool MethodChoice::changesFor(double spectralRadius, double h) {
    constexpr double worthwhile = 6;
    const double used = h * spectralRadius / explicitLimit;
    stability_ = stability_ == 0 ? used : 0.5 * (stability_ + used);
    if (steps_ < 2 * spectralInterval || stability_ >= worthwhile)
        return false;
    change(false);
    return true;
}

} // namespace solution
