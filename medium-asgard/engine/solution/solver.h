// How the unknowns of an equation set move: partition, schedule, integration, events.
// Dissertation 5.2 to 5.2.5; methods and policies: docs/numerics.md.
//
// The equations are cut into strongly connected components (partition.h). Each has its own time
// points, method and step, and reads others through their dense output. A solver advances the
// components that are furthest behind, in rounds (schedule.h):
//
//     advanceTo(finish):
//         while some component is known for less than `finish`:
//             a round: each of the groups that are furthest behind, on any thread, until all of it
//             has reached the round's end:
//                 component = the one furthest behind whose inputs are known far enough
//                 component.step()                  one accepted step, past the end if it likes,
//                                                   or up to a switch, a phase's end, or its stop
//             if all are known for longer than before:
//                 while the source has an event up to there:
//                     cut what it touches, and transitively what reads that, at the event's time
//                     apply its jumps; its new equations repartition what they change
//
// Semantics of one step of one component, failure policy included:
//
//     boundary = end of the current phases, next event of an input, end of an input that stopped,
//                or eight steps of an input, whichever comes first
//     repeat
//         try h = min(proposed, boundary - t)
//         the branches of all switching expressions are frozen as decided at t
//         right-hand side not finite: h / 4;  Newton fails: h / 2 ;  error > 1: h from the
//         controller h below what doubles resolve at t: the component stops here, and says why
//     first root of a switch's guard on the dense output: cut the step there, decide again
//     renormalise quaternions; restart at events, else continue
//
// Determinism: a component's steps depend on its equations, its tolerance, its inputs' pieces and
// its events, and on nothing else: not on `finish`, the other components, the thread, or the clock.
// The numbers after an event follow from the state at the event alone, however far had been solved.
// Rounds follow from times and steps, so that counts too are the same for any number of threads.
#pragma once

#include "dense/histories.h"
#include "equations/prepared_equations.h"
#include "expression/equations.h"
#include "solution/event_source.h"
#include "solution/statistics.h"
#include "stepping/options.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace solution {

// Every name that Options::method takes, without "auto".
[[nodiscard]] const std::vector<std::string>& methodNames();

// How the equations are prepared for a solver with these options.
[[nodiscard]] Preparation preparationFor(const Options& options);

struct Advance {
    double reached = 0;     // all unknowns that did not stop are known up to here, at most `finish`
    bool cancelled = false; // else all that can be done is done
    bool disturbed = false; // an event touched motion that was taken: solve without it
};

class Solver {
public:
    // `source` may be null; it must outlive the solver.
    Solver(expression::EquationSet equations, Options options, EventSource* source = nullptr);
    // With what preparationFor(options) gave, which runs over the same equations share.
    Solver(std::shared_ptr<const PreparedEquations> prepared, Options options,
           EventSource* source = nullptr);
    ~Solver();
    Solver(Solver&&) noexcept;
    Solver& operator=(Solver&&) noexcept;

    [[nodiscard]] Advance advanceTo(double finish);
    // The motion that was taken, known for longer.
    void takeLonger(std::shared_ptr<const TakenMotion> taken);

    // The motion so far; valid until the next call of advanceTo(). On the solver's thread only.
    [[nodiscard]] const Histories& histories() const;
    // That it holds, histories and all, about.
    [[nodiscard]] std::size_t bytes() const;
    // The same, never to change again.
    [[nodiscard]] std::shared_ptr<const Histories> snapshot() const;

    // Those in force, with all that were before; they never change again.
    [[nodiscard]] std::shared_ptr<const expression::EquationSet> equations() const;
    [[nodiscard]] Statistics statistics() const;

private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace solution
