// Steps that are made beside those of other components; see component.h and side_by_side.h.
#include "batches/alike_steps.h"
#include "solution/component.h"

#include <algorithm>

namespace solution {

// Whatever method it has now.
bool Component::mayGoSideBySide() const {
    return AlikeSteps::areThere() && equations_ && equations_->isPlain() &&
           equations_->size() > 0 && !equations_->readsInputs() && !equations_->bound()->canPeak &&
           quaternions_.empty() && !options_.fixedStep;
}

bool Component::mayStride() const {
    const auto* const method = dynamic_cast<const ExplicitRungeKutta*>(method_.get());
    return mayGoSideBySide() && method && AlikeSteps::areOf(method->tableau());
}

ExplicitRungeKutta& Component::stride() const { return static_cast<ExplicitRungeKutta&>(*method_); }

std::optional<double> Component::strideEnd() const {
    if (history_.size() > options_.maximumSteps || isPaceDue())
        return std::nullopt;
    const double wanted = std::max(std::min(proposed_, longest()), shortestStep(time_));
    if (time_ + landingOf(options_) * wanted >= nextPhase_)
        return std::nullopt;
    return time_ + wanted;
}

bool Component::refuseStride(const Attempt& attempt, double h) {
    if (!(attempt.next > shortestStep(time_) && attempt.next < h))
        return false;
    ++counts_.rejectedSteps;
    proposed_ = attempt.next;
    return true;
}

void Component::endStride(const Attempt& attempt, double h) { (void)refuse(attempt, h); }

void Component::takeStride(double h, double to, double next) {
    invented_ = 0;
    switches_.goOn();
    ++counts_.steps;
    ++counts_.integratedSteps;
    counts_.integratedFrom = std::min(counts_.integratedFrom, time_);
    append(columns_, h, to);
    time_ = to;
    proposed_ = next;
}

bool Component::changesAfterStride(double h, double crossing) {
    return mayChange_ && choice_.changesAfter(*method_, h, crossing);
}

void Component::leaveStride(std::span<const double> y) {
    y_.assign(y.begin(), y.end());
    setStates(y);
}

} // namespace solution
