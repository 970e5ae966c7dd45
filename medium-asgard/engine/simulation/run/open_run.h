// A run that can be taken further: the solver and the source of collisions as they stand.
//
// The numbers of a run do not depend on when it is to end (solution/solver.h, encounter_search.h).
// So a run that goes on from where it stood is the one that was longer from the start, and one that
// went further than is wanted now is the shorter one, but for what lies beyond the finish.
#pragma once

#include "run/run.h"

namespace simulation {

enum class Rounding { asItIs, nudged }; // a nudged run shows what rounding does (nudge.h)

// By body: it moves, and nothing was hit, nothing stopped and nothing is to be solved again in its
// island.
[[nodiscard]] std::vector<bool> untouchedIn(const Problem& problem, const Run& before,
                                            const std::vector<bool>& again);

class OpenRun {
public:
    // tolerances: of one step, relative, by body. `taken`, by body: what it takes from the run
    // before, whose tolerances are the same there; empty: nothing. The problem must outlive it.
    enum class Use { once, again };
    OpenRun(const Problem& problem, std::vector<double> tolerances,
            Rounding rounding = Rounding::asItIs, Use use = Use::again,
            std::vector<bool> taken = {});
    ~OpenRun();

    [[nodiscard]] const std::vector<double>& tolerances() const { return tolerances_; }
    [[nodiscard]] bool takes(std::size_t body) const { return !taken_.empty() && taken_[body]; }
    // False: something happens at the very end, where what comes after counts in a longer run and
    // does not in a shorter one, or something touched what is taken. Then a run from the start
    // tells.
    [[nodiscard]] bool canGoOn(const Run* before) const;
    // To the problem's finish, and no run yet. Of one that takes nothing.
    void solve(const Observer& observer);
    // The run to the problem's finish, solved on if need be. Progress is published as a draft. Its
    // statistics count everything, Run::before what was counted earlier.
    // `before`: the run that something is taken from, to the same finish. When it is disturbed
    // another run must be made that takes nothing.
    [[nodiscard]] Run upToFinish(const Observer& observer, const Run* before);
    [[nodiscard]] std::size_t bytes() const; // of the motion, and of what takes it further

private:
    struct Machinery;
    void makeMachinery(const std::shared_ptr<const solution::TakenMotion>& taken);
    solution::Advance advance(const std::shared_ptr<const solution::TakenMotion>& taken);
    [[nodiscard]] Run collect(double until);
    void publish(double known);

    const Problem& problem_;
    std::vector<double> tolerances_;
    Rounding rounding_;
    Use use_;
    std::vector<bool> taken_;
    Observer observer_; // while it is solved
    std::unique_ptr<Machinery> machinery_;
    double advanced_ = -solution::infinity; // all is solved up to here
    double furthest_ = -solution::infinity; // something beyond that up to here
    double published_ = 0;
    double secondsSettingUp_ = 0, secondsMoving_ = 0; // since the last run was collected
    solution::Statistics counted_;
    std::size_t countedPairTests_ = 0;
};

} // namespace simulation
