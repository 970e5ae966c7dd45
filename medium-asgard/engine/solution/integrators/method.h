// An integrator: it tries one step at a time, proposes the length of the next, and gives the step
// just accepted as polynomials.
//
//     if (!method.begin(t, y)) ...                 the right-hand side is not finite at the start
//     h = method.firstStep(limit)
//     loop
//         attempt = method.attempt(h)
//         accepted:  method.dense(columns)         polynomials of s = (t - t0)/h for every unknown
//                    method.state()                values at t0 + h
//                    method.proceed(y)             go on from there with y: state(), perhaps
//                                                  normalised
//         otherwise: nothing has changed; try attempt.next
//
// A method owns its error controller: `next` is its proposal. With `fixed` it proposes nothing and
// accepts every step that it can compute.
#pragma once

#include "dense/polynomial.h"
#include "integrators/error_control.h"
#include "integrators/system.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace solution {

struct Attempt {
    enum class Outcome {
        accepted,
        errorTooLarge,
        notFinite,    // the right-hand side, or the state
        notConverged, // the implicit equations
    };
    Outcome outcome = Outcome::accepted;
    double next = 0;
};

struct MethodCounts {
    std::size_t evaluations = 0, jacobians = 0, factorisations = 0;
    std::size_t iterations = 0; // of Newton, each with its solves

    MethodCounts& operator+=(const MethodCounts& other) {
        evaluations += other.evaluations;
        jacobians += other.jacobians;
        factorisations += other.factorisations;
        iterations += other.iterations;
        return *this;
    }
};

class Method {
public:
    Method(System& system, ErrorControl& control, bool fixed)
        : system_(system), control_(control), fixed_(fixed) {}
    virtual ~Method() = default;
    Method(const Method&) = delete;
    Method& operator=(const Method&) = delete;

    [[nodiscard]] virtual const char* name() const = 0;
    [[nodiscard]] virtual std::size_t order() const = 0;
    [[nodiscard]] virtual bool implicit() const = 0;

    [[nodiscard]] virtual bool begin(double t, std::span<const double> y) = 0;
    // A first step from the size of the derivatives at the start, at most `limit`.
    [[nodiscard]] double firstStep(double limit);
    [[nodiscard]] virtual Attempt attempt(double h) = 0;
    [[nodiscard]] std::span<const double> state() const { return end_; }
    // The derivative at the start of the next step.
    [[nodiscard]] std::span<const double> slope() const { return slope_; }
    virtual void dense(std::span<Coefficients> columns) = 0;
    [[nodiscard]] virtual bool proceed(std::span<const double> y) = 0;

    // Of the last accepted step: h |lambda| over the largest that the method takes stably; 0 for
    // methods without such a limit. Explicit methods estimate |lambda| from their last stages.
    [[nodiscard]] virtual double stabilityUsed() const { return 0; }
    // The largest h |lambda| that the method takes stably, on the negative real axis.
    [[nodiscard]] virtual double stabilityLimit() const {
        return std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] const MethodCounts& counts() const { return counts_; }

protected:
    bool rates(double t, std::span<const double> y, std::span<double> out) {
        ++counts_.evaluations;
        return system_.rates(t, y, out);
    }

    System& system_;
    ErrorControl& control_;
    bool fixed_;
    MethodCounts counts_;
    double t_ = 0, h_ = 0;            // of the step being tried
    std::vector<double> start_, end_; // its values
    std::vector<double> slope_;       // derivative at the start
};

} // namespace solution
