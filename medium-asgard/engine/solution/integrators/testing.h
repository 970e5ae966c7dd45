// Systems written as C++ functions, and a bare loop around a method, for tests.
#pragma once

#include "integrators/methods.h"

#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace solution::testing {

// The Jacobian is dense and by central differences.
class FunctionSystem final : public System {
public:
    using Function = std::function<void(double t, std::span<const double> y, std::span<double> f)>;
    FunctionSystem(std::size_t size, Function function)
        : size_(size), function_(std::move(function)) {
        for (std::size_t column = 0; column <= size; ++column)
            pattern_.columnStarts.push_back(static_cast<int>(column * size));
        for (std::size_t k = 0; k < size * size; ++k)
            pattern_.rows.push_back(static_cast<int>(k % size));
    }
    std::vector<std::pair<std::size_t, std::size_t>> positions; // (x, v)

    std::size_t size() const override { return size_; }
    bool rates(double t, std::span<const double> y, std::span<double> f) override {
        function_(t, y, f);
        for (const double x : f)
            if (!std::isfinite(x))
                return false;
        return true;
    }
    const Pattern& jacobianPattern() override { return pattern_; }
    bool jacobian(double t, std::span<const double> y, std::span<double> entries) override {
        std::vector<double> at(y.begin(), y.end()), low(size_), high(size_);
        for (std::size_t column = 0; column < size_; ++column) {
            const double step = 1e-6 * std::max(1e-5, std::abs(y[column]));
            at[column] = y[column] + step;
            function_(t, at, high);
            at[column] = y[column] - step;
            function_(t, at, low);
            at[column] = y[column];
            for (std::size_t row = 0; row < size_; ++row)
                entries[column * size_ + row] = (high[row] - low[row]) / (2 * step);
        }
        return true;
    }
    std::span<const std::pair<std::size_t, std::size_t>> integrals() const override {
        return positions;
    }
    std::span<const std::size_t> configuration() const override {
        configuration_.clear();
        for (const auto& [x, v] : positions)
            configuration_.push_back(x);
        return configuration_;
    }

private:
    std::size_t size_;
    Function function_;
    Pattern pattern_;
    mutable std::vector<std::size_t> configuration_;
};

struct Run {
    std::vector<double> end;
    std::size_t steps = 0, rejected = 0;
    MethodCounts counts;
    double worstDense = 0; // against `exact`, at nine points of every step
};

using Exact = std::function<std::vector<double>(double t)>;

// From 0 to `finish` exactly; with fixed steps of `fixedStep` when that is not 0.
inline Run run(const std::string& name, FunctionSystem& system, std::vector<double> y,
               double finish, double tolerance, double fixedStep = 0, const Exact& exact = {},
               std::vector<UnknownScale> scales = {}) {
    scales.resize(y.size());
    ErrorControl control(scales, tolerance);
    const auto method = makeMethod(name, system, control, fixedStep > 0);
    control.observe(y);
    if (!method->begin(0, y))
        throw std::runtime_error("not finite at the start");
    Run result;
    double t = 0, h = fixedStep > 0 ? fixedStep : method->firstStep(finish);
    std::vector<Coefficients> columns(y.size());
    while (t < finish) {
        const bool last = t + h >= finish * (1 - 1e-12);
        const double length = last ? finish - t : h;
        const Attempt attempt = method->attempt(length);
        h = attempt.next;
        if (attempt.outcome != Attempt::Outcome::accepted) {
            if (++result.rejected > 100000)
                throw std::runtime_error("too many rejected steps");
            continue;
        }
        ++result.steps;
        method->dense(columns);
        if (exact)
            for (int k = 0; k <= 8; ++k) {
                const auto truth = exact(t + k / 8.0 * length);
                for (std::size_t n = 0; n < y.size(); ++n)
                    result.worstDense = std::max(
                        result.worstDense, std::abs(evaluate(columns[n], k / 8.0) - truth[n]));
            }
        y.assign(method->state().begin(), method->state().end());
        control.observe(y);
        t = last ? finish : t + length;
        if (!method->proceed(y))
            throw std::runtime_error("not finite");
    }
    result.end = y;
    result.counts = method->counts();
    return result;
}

} // namespace solution::testing
