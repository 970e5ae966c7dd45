// What is asked of a solution, and what is counted of each component's.
#pragma once

#include "dense/histories.h"
#include "equations/prepared_equations.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace solution {

// Counts of work.
struct Work {
    std::size_t steps = 0, rejectedSteps = 0, discardedSteps = 0;
    std::size_t unconvergedSteps = 0; // of the rejected: the implicit equations were not solved
    std::size_t evaluations = 0;      // of right-hand sides of components
    std::size_t factorisations = 0;
    std::size_t switches = 0; // switching events located
    std::size_t jams = 0;     // rows of friction whose slip an impact without a collision ended

    void add(const Work& other) {
        steps += other.steps;
        rejectedSteps += other.rejectedSteps;
        discardedSteps += other.discardedSteps;
        unconvergedSteps += other.unconvergedSteps;
        evaluations += other.evaluations;
        factorisations += other.factorisations;
        switches += other.switches;
        jams += other.jams;
    }
};

struct ComponentStatistics : Work {
    std::vector<std::size_t> unknowns;
    std::string model; // "closed-form" | "quadrature" | "linear" | "explicit" | "implicit"
    std::string
        method; // "exact", "exponential", "dop853", "radau5", ...: the one that it used last
    std::size_t order = 0;
    std::size_t integratedSteps = 0;         // of the steps those that a method made
    double integratedFrom = infinity;        // when the first of these began
    std::string why;                         // why this model and method, one clause
    std::shared_ptr<const BoundModel> bound; // its equations
};

// The motion of some unknowns in an earlier run with the same prepared equations and options,
// without any event: it is not solved again. An unknown that is read by one of these is one of
// them, and the other way round. Their tolerances are the same as in that run.
struct TakenMotion {
    std::shared_ptr<const Histories> histories; // to the finish at least
    std::vector<bool> unknowns;
    std::vector<ComponentStatistics> components; // of that run, all
};

struct Options {
    double start = 0;
    // Largest error of one step: of a position relative to the extent of its component, of any
    // other unknown relative to its own largest value so far. One for all, or one for each unknown
    // (a component takes the smallest of its unknowns').
    double tolerance = 1e-6;
    std::vector<double> tolerances;
    // Lengths that a component's extent is at least, per unknown (say, the diameter of its body);
    // the extent grows with the range of positions it has seen. Empty: none.
    std::vector<double> extents;
    // Values of all unknowns at the start in place of the equations' own, 0 where those are 0.
    std::vector<double> initial;
    // All unknowns that will be read of the histories; unknowns that only others would read are not
    // solved, and are not a number there. None: all.
    std::optional<std::vector<std::size_t>> asked;
    std::string method = "auto"; // or a name of methodNames(): then for all components and states
    std::optional<double> fixedStep;
    std::optional<double> firstStep;
    bool isWatched = true;   // long steps are watched for what they might pass over (oversight/)
    bool whole = false;      // one component of everything
    bool eventDriven = true; // false: run each component to the end before the next
    std::size_t threads = 1; // 0: as many as the machine has cores; the motion is the same
    std::size_t maximumSteps = 20'000'000;    // of one component
    std::size_t maximumEventsAtOnce = 10'000; // of what takes part in them, and met by then
    // That all histories and what the source keeps may take; nothing else depends on it.
    std::size_t mostBytes = std::numeric_limits<std::size_t>::max();
    std::shared_ptr<const TakenMotion> taken; // may be null
    std::function<bool()> cancelled;          // polled between steps, on the thread of advanceTo()
    std::function<void(double known)> progress; // known grew; snapshot() may be called from here
    std::function<void(double time)> working;   // every now and then, as cancelled is polled
};

} // namespace solution
