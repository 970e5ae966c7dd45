// Steps of an explicit method by alike systems side by side: the same equations with constants of
// their own, each with its own time, step and error control.
//
// A lane is one system. All of a step's arithmetic is done for all lanes at once (lanes.h): stages,
// sums, evaluations (expression/function.h), scales, error, stiffness, the polynomial between the
// ends. Each lane takes its own decisions. A step that is not ordinary, since something in it has
// no finite value or grows without bound, changes nothing in its lane: the system makes it again
// alone, and says what there is to say. So bits and counts are those of stepping alone.
//
//     enter(lane, ...)            what method and control know is now known here
//     ordinary = attempt(h)       a step of its own length by each lane
//     judge(lane)                 as Method::attempt() answers, of ordinary ones
//     dense(accepted)             columns(lane) of those
//     proceed(accepted)
//     leave(lane)                 method and control know all that happened
#pragma once

#include "expression/function.h"
#include "integrators/explicit_runge_kutta.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace solution {

class AlikeSteps {
public:
    static constexpr std::size_t lanes = 8;
    using Lanes = std::uint32_t; // a bit for each
    [[nodiscard]] static Lanes of(std::size_t lane) { return Lanes{1} << lane; }
    // This processor has them.
    [[nodiscard]] static bool areThere();
    // The method has what is needed: an estimate of its error, and polynomials by its ends.
    [[nodiscard]] static bool areOf(const Tableau& tableau);

    // For systems like this one, whose rates `function` gives from time, states and constants.
    AlikeSteps(const ExplicitRungeKutta& method, const ErrorControl& control,
               expression::Function function);
    // Alike but for numbers.
    [[nodiscard]] bool takes(const ExplicitRungeKutta& method, const ErrorControl& control) const;

    void enter(std::size_t lane, ExplicitRungeKutta& method, ErrorControl& control,
               std::span<const double> constants);
    void leave(std::size_t lane);
    // The lane has a system in it, or what is there does not count.
    [[nodiscard]] bool isTaken(std::size_t lane) const { return methods_[lane] != nullptr; }

    [[nodiscard]] Lanes attempt(std::span<const double, lanes> h);
    [[nodiscard]] Attempt judge(std::size_t lane);
    void dense(Lanes accepted);
    void columns(std::size_t lane, std::span<Coefficients> columns) const;
    void proceed(Lanes accepted);

    // After an accepted step, as ErrorControl::crossing().
    [[nodiscard]] double crossing(std::size_t lane) const;
    [[nodiscard]] double state(std::size_t lane, std::size_t n) const;

    // Where the rows of each quantity begin, eight numbers to a row.
    struct Rows {
        std::size_t in = 0; // time, states, constants
        std::size_t start = 0, end = 0, slope = 0, lost = 0, lostNext = 0, stiffAt = 0;
        std::size_t before = 0, beforeSlope = 0, slopes = 0; // slopes: of all stages
        std::size_t weights = 0, low = 0, high = 0, newLow = 0, newHigh = 0, length = 0;
        std::size_t columns = 0, corrections = 0; // of each state maximumCoefficients; three
        std::size_t time = 0, step = 0, beforeStep = 0, tolerance = 0, leastExtent = 0;
        std::size_t extent = 0, speed = 0, other = 0, rounding = 0;
        std::size_t error = 0, stability = 0, accepted = 0;
        std::size_t all = 0;
    };

private:
    [[nodiscard]] double& at(std::size_t row, std::size_t lane) {
        return data_[(lane / block) * block * rows_.all + block * row + lane % block];
    }
    [[nodiscard]] double at(std::size_t row, std::size_t lane) const {
        return data_[(lane / block) * block * rows_.all + block * row + lane % block];
    }
    void evaluate(std::size_t stage);
    void giveBack(std::size_t lane);
    void denseAlone(std::size_t lane);

    static constexpr std::size_t block = 4; // that lie side by side
    const Tableau& tableau_;
    expression::Function function_;
    expression::Function::Scratch scratch_;
    std::size_t size_, constants_;
    std::vector<std::pair<std::size_t, std::size_t>> integrals_;
    std::vector<std::size_t> unpaired_;
    std::vector<UnknownScale::Kind> kinds_;
    Rows rows_;
    std::vector<double> data_;
    std::array<ExplicitRungeKutta*, lanes> methods_{};
    std::array<ErrorControl*, lanes> controls_{};
    Lanes alone_ = 0; // of the last step, whose polynomials the method itself made
    std::array<std::vector<Coefficients>, lanes> own_;
};

} // namespace solution
