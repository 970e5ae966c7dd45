// The accuracy that is asked for is met by measuring it: the scene is solved at two tolerances, the
// difference is the error of the looser run, and what differs by too much is solved again more
// tightly, island by island, so that bodies that never meet do not change each other's numbers.
#include "simulation/accuracy.h"
#include "simulation/cpu_seconds.h"
#include "simulation/impact_order.h"
#include "simulation/solved.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulation {
namespace {

// Constants of the search, measured on all reference scenes (docs/numerics.md, "Work per
// accuracy").
constexpr double firstTolerance = 0.06; // of the accuracy: what one step may err in the first run
constexpr double loosest = 1e-3;        // and at most this
constexpr double tightening = 1.0 / 8;  // between two runs that are compared
constexpr double tightest = 1e-15;
constexpr double loosening = 512; // of a third run, when the first two are equal
constexpr double enough = 0.5;    // of the accuracy: the looser run's error that is accepted
constexpr double aim = 0.15;      // and what is aimed at when it is not
constexpr double caution = 2;     // errors fall a little less than tolerances do
constexpr int patience = 2; // pairs of runs that come no closer, before tightening is given up

void addWork(const Run& run, Solved& solved) {
    solved.near.insert(run.candidates.begin(), run.candidates.end());
    Statistics& sum = solved.result.statistics;
    sum.steps += run.statistics.steps;
    sum.rejectedSteps += run.statistics.rejectedSteps;
    sum.unconvergedSteps += run.statistics.unconvergedSteps;
    sum.discardedSteps += run.statistics.discardedSteps;
    sum.evaluations += run.statistics.evaluations;
    sum.equationEvaluations += run.statistics.equationEvaluations;
    sum.factorisations += run.statistics.factorisations;
    sum.pairTests += run.pairTests;
    sum.secondsSettingUp += run.secondsSettingUp;
}

void describe(const Problem& problem, const Run& run, Result& result) {
    Statistics& sum = result.statistics;
    if (problem.options.explain)
        result.explanation = explanationOf(problem, run);
    sum.collisions = run.impacts.size();
    sum.components = run.statistics.components;
    sum.largestComponent = run.statistics.largestComponent;
    sum.historyBytes = run.statistics.historyBytes;
    sum.reached = run.reached;
    sum.secondsMoving = run.secondsMoving;
    for (const auto& component : run.statistics.componentList)
        sum.componentList.push_back({.unknowns = component.unknowns.size(),
                                     .model = component.model,
                                     .method = component.method,
                                     .steps = component.steps,
                                     .evaluations = component.evaluations});
}

// In all of its phases, not only in the one that is in force at the end.
bool isExact(const Run& run) { return run.statistics.integratedSteps == 0; }

// What is known of a pair of runs.
struct Verdict {
    std::vector<double> next; // tolerances for another run
    bool again = false;       // something is worth another run
};

// What was compared so far.
struct Comparison {
    std::vector<IslandError> errors, before; // of the last two pairs of runs
    std::vector<IslandError> rough;          // of a still looser run, where the first two are equal
    std::vector<double> looser, loose, tight; // tolerances of the last three runs
    std::vector<int> failures;                // to come closer, by body
    std::vector<BodyError> known;             // of the tightest run, by body
};

// How the error follows the tolerance: as measured by two pairs of runs, or proportionally.
double orderOf(std::size_t b, const Comparison& c) {
    if (c.before.empty())
        return 1;
    const double error = c.errors[b].largest, before = c.before[b].largest;
    if (!(error > 0 && error < before && before < 0.1) || c.loose[b] == c.looser[b])
        return 1;
    return std::clamp(std::log(error / before) / std::log(c.loose[b] / c.looser[b]), 0.5, 1.5);
}

Verdict judge(const Problem& problem, Comparison& c) {
    Verdict verdict{.next = c.tight};
    const double accuracy = problem.accuracy();
    for (std::size_t b = 0; b < c.errors.size(); ++b) {
        if (c.tight[b] == c.loose[b]) // the same run again, for others: nothing new
            continue;
        const double error = c.errors[b].largest;
        // Equal runs: tolerances below the rounding of positions. The pair before says more.
        const std::vector<IslandError>& last = c.before.empty() ? c.rough : c.before;
        if (error == 0 && !last.empty()) {
            c.known[b] = {.estimate = std::min(last[b].largest, 1.0),
                          .predictableUntil = last[b].beyondFrom};
            continue;
        }
        const double gain = std::max(std::pow(c.tight[b] / c.loose[b], orderOf(b, c)), 1e-3);
        c.known[b] = {.estimate = std::isfinite(error) ? caution * gain * error : 1,
                      .predictableUntil = solution::infinity};
        if (error <= enough * accuracy)
            continue;
        // Tightening that does not help any more: rounding, or motion that amplifies it. Two wrong
        // runs may differ as much as a wrong and a right one do.
        if (!c.before.empty() && !(error < 0.5 * c.before[b].largest))
            ++c.failures[b];
        if (c.failures[b] < patience && c.tight[b] > tightest) {
            verdict.again = true;
            const double wanted = c.tight[b] * std::clamp(aim * accuracy / error, 1e-3, 1.0);
            verdict.next[b] = std::max(tightest, std::min(wanted, c.tight[b] * tightening));
        } else {
            c.known[b].estimate = std::max(c.known[b].estimate, error);
            c.known[b].predictableUntil = c.errors[b].beyondFrom;
        }
    }
    return verdict;
}

// Somewhere two runs at different tolerances are equal. What is done about it is of no consequence
// elsewhere.
bool anyAreEqual(const Comparison& c) {
    for (std::size_t b = 0; b < c.errors.size(); ++b)
        if (c.errors[b].largest == 0 && c.tight[b] != c.loose[b])
            return true;
    return false;
}

// Bodies of one island go by the tightest of them.
void shareWithinIslands(const std::vector<std::size_t>& island, std::vector<double>& tolerances) {
    std::vector<double> least(tolerances.size(), solution::infinity);
    for (std::size_t b = 0; b < island.size(); ++b)
        least[island[b]] = std::min(least[island[b]], tolerances[b]);
    for (std::size_t b = 0; b < island.size(); ++b)
        tolerances[b] = least[island[b]];
}

// A body that was never integrated has the same motion at any tolerance, but for how expressions
// that hold it are fitted: it keeps the first.
void leaveExact(const Run& run, const std::vector<double>& loose, std::vector<double>& tight) {
    for (std::size_t b = 0; b < tight.size(); ++b)
        if (!run.isIntegrated[b])
            tight[b] = loose[b];
}

// Takes the run as the answer.
void deliver(const Problem& problem, Run run, Solved& solved) {
    Result& result = solved.result;
    putInOrder(run.impacts, [&](std::size_t b) { return (*problem.bodies)[b].isFixed; });
    std::ranges::sort(run.notes);
    describe(problem, run, result);
    if (solved.isEstimated) {
        double estimate = 0, until = solution::infinity;
        for (const BodyError& error : solved.errors) {
            estimate = std::max(estimate, error.estimate);
            until = std::min(until, error.predictableUntil);
        }
        result.statistics.errorEstimate = estimate;
        if (std::isfinite(until))
            result.statistics.predictableUntil = until;
    }
    result.motion = run.motion(problem, result.cancelled || run.cancelled,
                               result.statistics.errorEstimate, result.statistics.predictableUntil);
    result.cancelled = result.cancelled || run.cancelled;
    solved.run = std::move(run);
}

// Another method than the engine's choice is taken as it is: one run.
Solved solvePlainly(const Problem& problem, const Observer& observer) {
    const std::vector<double> tolerances(problem.bodies->size(), problem.accuracy());
    Solved solved;
    Run run = runAt(problem, tolerances, observer);
    addWork(run, solved);
    deliver(problem, std::move(run), solved);
    return solved;
}

Solved solveToAccuracy(const Problem& problem, const Observer& observer) {
    Solved solved;
    const double accuracy = problem.accuracy();
    const double first = std::min(firstTolerance * accuracy, loosest);
    Comparison compared;
    compared.loose.assign(problem.bodies->size(), first);
    compared.tight.assign(problem.bodies->size(), first * tightening);
    compared.failures.assign(problem.bodies->size(), 0);
    compared.known.resize(problem.bodies->size());
    Observer silent{.cancelled = observer.cancelled, .progress = {}};
    Run before = runAt(problem, compared.loose, observer);
    addWork(before, solved);
    if (before.cancelled || isExact(before)) {
        solved.isEstimated = !before.cancelled;
        solved.errors = compared.known;
        deliver(problem, std::move(before), solved);
        return solved;
    }
    if (observer.progress)
        observer.progress(before.motion(problem, true, {}, {}));
    leaveExact(before, compared.loose, compared.tight);
    shareWithinIslands(before.island, compared.tight);
    while (true) {
        Run run = runAt(problem, compared.tight, silent);
        addWork(run, solved);
        if (run.cancelled) {
            solved.result.cancelled = true;
            deliver(problem, std::move(before), solved);
            return solved;
        }
        compared.errors = compareRuns(problem, before, run, accuracy);
        if (compared.before.empty() && anyAreEqual(compared)) {
            std::vector<double> looser = compared.loose;
            for (double& tolerance : looser)
                tolerance *= loosening;
            const Run rough = runAt(problem, looser, silent);
            addWork(rough, solved);
            compared.rough = compareRuns(problem, rough, run, accuracy);
        }
        const Verdict verdict = judge(problem, compared);
        if (!verdict.again) {
            solved.isEstimated = true;
            solved.errors = compared.known;
            deliver(problem, std::move(run), solved);
            return solved;
        }
        compared.looser = std::exchange(compared.loose, compared.tight);
        compared.tight = verdict.next;
        shareWithinIslands(run.island, compared.tight);
        compared.before = std::move(compared.errors);
        before = std::move(run);
    }
}

} // namespace

Solved solve(const Problem& problem, const Observer& observer) {
    const double begin = cpuSeconds();
    Solved solved = problem.scene.simulator.method == "auto" && !problem.options.fixedStep
                        ? solveToAccuracy(problem, observer)
                        : solvePlainly(problem, observer);
    solved.result.statistics.predictableUntil = solved.result.motion->predictableUntil();
    solved.result.statistics.secondsSolving = cpuSeconds() - begin;
    return solved;
}

Result simulate(const scene::Scene& scene, const Options& options, const Observer& observer) {
    const double begin = cpuSeconds();
    auto problem = problemOf(scene, options);
    if (auto* refusal = std::get_if<std::vector<std::string>>(&problem)) {
        Result result;
        result.refusal = std::move(*refusal);
        return result;
    }
    const double posing = cpuSeconds() - begin;
    Result result = solve(*std::get<std::shared_ptr<const Problem>>(problem), observer).result;
    result.statistics.seconds = posing + result.statistics.secondsSolving;
    result.statistics.secondsSettingUp += posing;
    return result;
}

} // namespace simulation
