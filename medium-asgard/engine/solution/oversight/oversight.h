// May a step be believed? One question, asked of each step that a method has made.
//
// Three things speak against a step: its polynomials cross a switching surface that the rates lead
// away from; they differ at a watched time from the rates (watched_times.h); or something peaks
// within it that its stages need not have seen (peak_centres.h).
#pragma once

#include "dense/piece_writer.h"
#include "integrators/error_control.h"
#include "modes/component_equations.h"
#include "oversight/watched_times.h"

#include <functional>
#include <optional>
#include <vector>

namespace solution {

// Times in (curves.origin, curves.until) at which there may be the middle of a peak, however
// narrow.
[[nodiscard]] std::vector<double> centresOf(ComponentEquations& equations,
                                            const ComponentModel::PeakFunctions& peaks,
                                            const StateCurves& curves);

// A step that a method made: its polynomials end at curves.origin + curves.scale.
struct ReviewedStep {
    StateCurves curves;                    // up to the switch that ends it, if there is one
    const std::optional<Violation>& found; // that switch
    bool passesAtOnce;                     // it is passed where the step begins, which goes then
    bool isImplicit;
    double shortest; // no step is shorter here
};

class Oversight {
public:
    struct How {
        double start, tolerance;
        bool isWatched; // else only switches are reviewed
        bool isFixed;   // steps have one length: nothing is reviewed
    };
    explicit Oversight(const How& how);

    // The motion begins anew, after an event.
    void begin() { suspect_ = -infinity; }
    // That the next step may be, by what is watched.
    [[nodiscard]] double longest(double t, const ComponentEquations& equations,
                                 bool isImplicit) const;
    // Of what may peak, errors of speeds count at least over the time between watched times.
    void prepare(double t, const ComponentEquations& equations, bool isImplicit,
                 ErrorControl& control) const;

    // A time at which shorter steps are to look closer; none: the step is believed.
    [[nodiscard]] std::optional<double> verdict(const ReviewedStep& step,
                                                ComponentEquations& equations,
                                                ErrorControl& control, std::size_t& evaluations);
    // It was believed by another check.
    void believe() { invented_ = 0; }

    // Of held values, whose polynomials are compared there.
    [[nodiscard]] std::vector<double> centresIn(ComponentEquations& equations,
                                                const StateCurves& curves) const;

private:
    [[nodiscard]] bool hasCentres(const ComponentEquations& equations) const;
    [[nodiscard]] bool isInvented(const ReviewedStep& step, ComponentEquations& equations);
    [[nodiscard]] std::optional<double> overlooked(const ReviewedStep& step,
                                                   ComponentEquations& equations,
                                                   const ErrorControl& control,
                                                   std::size_t& evaluations) const;

    How how_;
    WatchedTimes watched_;
    double longestPart_;         // of what is watched, that an explicit step may be
    double suspect_ = -infinity; // a watched time that a step passed over
    int invented_ = 0;           // switches in a row that were not believed
};

} // namespace solution
