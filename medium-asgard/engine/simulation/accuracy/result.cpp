#include "accuracy/result.h"

namespace simulation {
namespace {

// Every count of the first by that of the second.
template <typename Apply>
void forEachCount(WorkCounts& work, const WorkCounts& other, Apply&& apply) {
    apply(work.steps, other.steps);
    apply(work.rejectedSteps, other.rejectedSteps);
    apply(work.discardedSteps, other.discardedSteps);
    apply(work.unconvergedSteps, other.unconvergedSteps);
    apply(work.evaluations, other.evaluations);
    apply(work.equationEvaluations, other.equationEvaluations);
    apply(work.factorisations, other.factorisations);
    apply(work.pairTests, other.pairTests);
}

} // namespace

WorkCounts& WorkCounts::operator+=(const WorkCounts& more) {
    forEachCount(*this, more, [](std::size_t& count, std::size_t by) { count += by; });
    return *this;
}

WorkCounts& WorkCounts::operator-=(const WorkCounts& less) {
    forEachCount(*this, less, [](std::size_t& count, std::size_t by) { count -= by; });
    return *this;
}

} // namespace simulation
