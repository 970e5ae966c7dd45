// Who is in which lane, and what a lane knows of it; the arithmetic is alike_steps.cpp.
#include "batches/alike_steps.h"

#include <algorithm>
#include <utility>

namespace solution {

bool AlikeSteps::areOf(const Tableau& tableau) {
    return !tableau.error.empty() && !tableau.dense.empty() &&
           tableau.a.size() > tableau.stages + 1 && tableau.stabilityLimit > 0;
}

AlikeSteps::AlikeSteps(const ExplicitRungeKutta& method, const ErrorControl& control,
                       expression::Function function)
    : tableau_(method.tableau_), function_(std::move(function)), size_(method.size_),
      constants_(function_.tape().inputs() - 1 - size_), unpaired_(method.unpaired_) {
    const auto integrals = method.system_.integrals();
    integrals_.assign(integrals.begin(), integrals.end());
    for (const UnknownScale& scale : control.scales_)
        kinds_.push_back(scale.kind);
    const auto take = [this](std::size_t& first, std::size_t count) {
        first = rows_.all;
        rows_.all += count;
    };
    take(rows_.in, function_.tape().inputs());
    for (std::size_t* const row :
         {&rows_.start, &rows_.end, &rows_.slope, &rows_.lost, &rows_.lostNext, &rows_.stiffAt,
          &rows_.before, &rows_.beforeSlope, &rows_.weights, &rows_.low, &rows_.high, &rows_.newLow,
          &rows_.newHigh, &rows_.length})
        take(*row, size_);
    take(rows_.slopes, (tableau_.stages + 1) * size_);
    take(rows_.columns, maximumCoefficients * size_);
    take(rows_.corrections, 3 * size_);
    for (std::size_t* const row :
         {&rows_.time, &rows_.step, &rows_.beforeStep, &rows_.tolerance, &rows_.leastExtent,
          &rows_.extent, &rows_.speed, &rows_.other, &rows_.rounding, &rows_.error,
          &rows_.stability, &rows_.accepted})
        take(*row, 1);
    data_.assign(lanes * rows_.all, 0.0);
}

bool AlikeSteps::takes(const ExplicitRungeKutta& method, const ErrorControl& control) const {
    return &method.tableau_ == &tableau_ && method.size_ == size_ && !method.fixed_ &&
           std::ranges::equal(control.scales_, kinds_, {}, &UnknownScale::kind);
}

void AlikeSteps::enter(std::size_t lane, ExplicitRungeKutta& method, ErrorControl& control,
                       std::span<const double> constants) {
    methods_[lane] = &method;
    controls_[lane] = &control;
    for (std::size_t c = 0; c < constants_; ++c)
        at(rows_.in + 1 + size_ + c, lane) = constants[c];
    for (std::size_t n = 0; n < size_; ++n) {
        at(rows_.start + n, lane) = method.start_[n];
        at(rows_.end + n, lane) = method.end_[n];
        at(rows_.slope + n, lane) = method.slope_[n];
        at(rows_.lost + n, lane) = method.lost_.start[n];
        at(rows_.before + n, lane) = method.before_.state[n];
        at(rows_.beforeSlope + n, lane) = method.before_.slope[n];
        at(rows_.low + n, lane) = control.seen_[n].low;
        at(rows_.high + n, lane) = control.seen_[n].high;
        at(rows_.weights + n, lane) = control.weights_[n];
        at(rows_.length + n, lane) = control.scales_[n].lengthPerUnit;
    }
    at(rows_.time, lane) = method.t_;
    at(rows_.step, lane) = method.h_;
    at(rows_.beforeStep, lane) = method.before_.step;
    at(rows_.tolerance, lane) = control.tolerance_;
    at(rows_.leastExtent, lane) = control.leastExtent_;
    at(rows_.extent, lane) = control.extent_;
    at(rows_.speed, lane) = control.speed_;
    at(rows_.other, lane) = control.other_;
    at(rows_.rounding, lane) = control.rounding_;
}

// What a step leads from and to, as the method alone has it.
void AlikeSteps::giveBack(std::size_t lane) {
    ExplicitRungeKutta& method = *methods_[lane];
    method.t_ = at(rows_.time, lane);
    method.before_.step = at(rows_.beforeStep, lane);
    for (std::size_t n = 0; n < size_; ++n) {
        method.start_[n] = at(rows_.start + n, lane);
        method.end_[n] = at(rows_.end + n, lane);
        method.slope_[n] = at(rows_.slope + n, lane);
        method.before_.state[n] = at(rows_.before + n, lane);
        method.before_.slope[n] = at(rows_.beforeSlope + n, lane);
        controls_[lane]->weights_[n] = at(rows_.weights + n, lane);
    }
}

void AlikeSteps::leave(std::size_t lane) {
    giveBack(lane);
    ExplicitRungeKutta& method = *methods_[lane];
    ErrorControl& control = *controls_[lane];
    for (std::size_t n = 0; n < size_; ++n) {
        method.lost_.start[n] = at(rows_.lost + n, lane);
        control.seen_[n] = {at(rows_.low + n, lane), at(rows_.high + n, lane)};
    }
    method.h_ = control.step_ = at(rows_.step, lane);
    control.extent_ = at(rows_.extent, lane);
    control.speed_ = at(rows_.speed, lane);
    control.other_ = at(rows_.other, lane);
    control.rounding_ = at(rows_.rounding, lane);
    methods_[lane] = nullptr;
}

void AlikeSteps::evaluate(std::size_t stage) {
    for (std::size_t first = 0; first < data_.size(); first += block * rows_.all) {
        const std::span<double> rows = std::span(data_).subspan(first, block * rows_.all);
        function_.evaluateLanes(rows.subspan(block * rows_.in, block * (1 + size_ + constants_)),
                                rows.subspan(block * (rows_.slopes + stage * size_), block * size_),
                                scratch_);
    }
}

Attempt AlikeSteps::judge(std::size_t lane) {
    ExplicitRungeKutta& method = *methods_[lane];
    method.counts_.evaluations += tableau_.stages;
    method.h_ = at(rows_.step, lane);
    const Attempt attempt = method.judge(at(rows_.error, lane));
    if (attempt.outcome == Attempt::Outcome::accepted)
        method.stabilityUsed_ = at(rows_.stability, lane);
    return attempt;
}

// With stages of its own between the ends, if need be.
void AlikeSteps::denseAlone(std::size_t lane) {
    giveBack(lane);
    ExplicitRungeKutta& method = *methods_[lane];
    for (std::size_t i = 0; i < (tableau_.stages + 1) * size_; ++i)
        method.k_[i] = at(rows_.slopes + i, lane);
    own_[lane].resize(size_);
    method.dense(own_[lane]);
}

void AlikeSteps::columns(std::size_t lane, std::span<Coefficients> columns) const {
    if (alone_ & of(lane)) {
        std::ranges::copy(own_[lane], columns.begin());
        return;
    }
    for (std::size_t n = 0; n < size_; ++n)
        for (std::size_t k = 0; k < maximumCoefficients; ++k)
            columns[n][k] = at(rows_.columns + maximumCoefficients * n + k, lane);
}

double AlikeSteps::crossing(std::size_t lane) const {
    const double extent = at(rows_.extent, lane), speed = at(rows_.speed, lane);
    return extent > 0 && speed > 0 ? extent / speed : infinity;
}

double AlikeSteps::state(std::size_t lane, std::size_t n) const {
    return at(rows_.start + n, lane);
}

} // namespace solution
