// How do the steps of one component become pieces of its history?
//
// A step gives polynomials of the states. Unknowns that follow from states, the held ones, get
// polynomials of degree 8 through values at nine points; a step on which one of these does not fit
// is kept in halves. A velocity that is the derivative of its place to the last bit is not kept.
// Of multipliers the mode is kept, as a number: a reader solves for them.
#pragma once

#include "dense/histories.h"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace solution {

// Polynomials of (t - origin)/scale, one for each state, which hold from `origin` to `until`.
struct StateCurves {
    std::span<const Coefficients> columns;
    double origin = 0, scale = 1, until = 0;

    void at(double t, std::span<double> y) const {
        for (std::size_t i = 0; i < columns.size(); ++i)
            y[i] = evaluate(columns[i], (t - origin) / scale);
    }
};

// The values of held unknowns, as far as a writer asks for them.
class HeldValues {
public:
    virtual ~HeldValues() = default;
    // False: one of them is not finite.
    [[nodiscard]] virtual bool valuesAt(double t, std::span<const double> y,
                                        std::span<double> out) = 0;
    // Times in the curves' interval at which they may have the middle of a narrow peak.
    [[nodiscard]] virtual std::vector<double> peaksOn(const StateCurves& curves) = 0;
};

class PieceWriter {
public:
    explicit PieceWriter(std::size_t unknowns)
        : history_(std::make_shared<History>(unknowns)), unknowns_(unknowns) {}

    [[nodiscard]] const std::shared_ptr<History>& history() const { return history_; }

    // Places of states and of held unknowns among the unknowns; pairs (x, v) of states with x' = v.
    void takeLayout(std::span<const std::size_t> states, std::span<const std::size_t> held,
                    std::span<const std::pair<std::size_t, std::size_t>> integrals);
    // Unknowns that are constant from the next piece on.
    void hold(std::span<const std::size_t> unknowns, std::span<const double> values);
    // The next piece begins at an event: values or derivatives may jump there.
    void beginAnew() { isFresh_ = true; }

    // A step from the curves' origin. An anchor on which the component stood goes. Held values err
    // by at most `allowed` of what they span, where halving the step makes that possible.
    void append(const StateCurves& states, HeldValues& values, double allowed);
    // The same with polynomials of the held values too.
    void append(const StateCurves& states, std::span<const Coefficients> held);
    // Where the component stands before its first step: values and rates of all unknowns, in turn.
    void standAt(double t, std::span<const double> valuesAndRates);
    // One piece as it stands, as of an unknown that goes on for ever.
    void append(const History::Step& step, std::span<const double> row);

    // Polynomials of held values over the whole interval, of (t - origin)/(until - origin). False:
    // they err by more than `allowed` of what they span, and by more than what rounding, of the
    // time too, makes of their formulas.
    [[nodiscard]] static bool fit(const StateCurves& states, HeldValues& values, double allowed,
                                  std::span<Coefficients> held);

private:
    void appendPart(const StateCurves& states, HeldValues& values, double allowed, int depth);
    void appendRow(const StateCurves& states, std::span<const Coefficients> held);
    [[nodiscard]] std::uint8_t lengthOf(std::span<const std::size_t> columns,
                                        std::size_t least) const;
    [[nodiscard]] bool tellVelocities(double scale) const;

    std::shared_ptr<History> history_;
    std::size_t unknowns_;
    std::vector<std::size_t> states_, held_; // places of their columns
    History::Pairs pairs_;                   // columns of places and of their velocities
    // Columns: places of pairs; those in no pair; all.
    std::vector<std::size_t> places_, others_, all_;
    std::vector<const Coefficients*> kept_; // of the row that is written, by column
    std::vector<Coefficients> constants_;
    std::vector<std::size_t> constant_; // their places
    bool isFresh_ = true;
};

} // namespace solution
