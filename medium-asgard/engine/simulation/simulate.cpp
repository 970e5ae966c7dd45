// The accuracy that is asked for is met by measuring it: the scene is solved at two tolerances, the
// difference is the error of the looser run, and what differs by too much is solved again more
// tightly, island by island, so that bodies that never meet do not change each other's numbers.
#include "simulation/accuracy.h"
#include "simulation/run.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace simulation {
namespace {

constexpr double firstTolerance = 1e-2; // of the accuracy: what one step may err in the first run
constexpr double tightening = 1.0 / 32; // between two runs that are compared
constexpr double tightest = 1e-15;
constexpr double enough = 0.5; // of the accuracy: the looser run's error that is accepted

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void addWork(const Run& run, Statistics& sum) {
    sum.steps += run.statistics.steps;
    sum.rejectedSteps += run.statistics.rejectedSteps;
    sum.discardedSteps += run.statistics.discardedSteps;
    sum.evaluations += run.statistics.evaluations;
    sum.equationEvaluations += run.statistics.equationEvaluations;
    sum.factorisations += run.statistics.factorisations;
    sum.pairTests += run.pairTests;
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
    for (const auto& component : run.statistics.componentList)
        sum.componentList.push_back({.unknowns = component.unknowns.size(),
                                     .model = component.model,
                                     .method = component.method,
                                     .steps = component.steps,
                                     .evaluations = component.evaluations});
}

bool isExact(const Run& run) {
    return std::ranges::all_of(run.statistics.componentList,
                               [](const auto& c) { return c.model == "closed-form"; });
}

// What is known of a pair of runs.
struct Verdict {
    std::vector<double> next; // tolerances for another run
    bool again = false;       // something is worth another run
    double estimate = 0;      // of the tighter run
    double predictableUntil = solution::infinity;
};

Verdict judge(const Problem& problem, const std::vector<IslandError>& errors,
              const std::vector<IslandError>& errorsBefore, const std::vector<double>& loose,
              const std::vector<double>& tight) {
    Verdict verdict{.next = tight};
    const double accuracy = problem.accuracy();
    for (std::size_t b = 0; b < errors.size(); ++b) {
        const double error = errors[b].largest;
        const double gain = std::max(tight[b] / loose[b], 1e-3);
        verdict.estimate = std::max(verdict.estimate, std::isfinite(error) ? error * gain : 1);
        if (error <= enough * accuracy)
            continue;
        // Tightening that does not help any more: rounding, or motion that amplifies it.
        const bool helps = errorsBefore.empty() || error < 0.5 * errorsBefore[b].largest;
        if (helps && tight[b] > tightest) {
            verdict.again = true;
            const double wanted = tight[b] * std::clamp(0.1 * accuracy / error, 1e-3, 1.0);
            verdict.next[b] = std::max(tightest, std::min(wanted, tight[b] * tightening));
        } else {
            verdict.estimate = std::max(verdict.estimate, error);
            verdict.predictableUntil = std::min(verdict.predictableUntil, errors[b].beyondFrom);
        }
    }
    // Bodies of one island go by the tightest of them.
    return verdict;
}

void shareWithinIslands(const std::vector<std::size_t>& island, std::vector<double>& tolerances) {
    std::vector<double> least(tolerances.size(), solution::infinity);
    for (std::size_t b = 0; b < island.size(); ++b)
        least[island[b]] = std::min(least[island[b]], tolerances[b]);
    for (std::size_t b = 0; b < island.size(); ++b)
        tolerances[b] = least[island[b]];
}

// Another method than the engine's choice is taken as it is: one run.
Result simulatePlainly(const Problem& problem, const Observer& observer) {
    const std::vector<double> tolerances(problem.bodies->size(), problem.accuracy());
    const Run run = runAt(problem, tolerances, observer);
    Result result;
    addWork(run, result.statistics);
    describe(problem, run, result);
    result.cancelled = run.cancelled;
    result.motion = run.motion(problem, run.cancelled, {}, {});
    return result;
}

Result simulateToAccuracy(const Problem& problem, const Observer& observer) {
    Result result;
    const double accuracy = problem.accuracy();
    std::vector<double> loose(problem.bodies->size(), firstTolerance * accuracy);
    std::vector<double> tight(loose.size(), firstTolerance * accuracy * tightening);
    Observer silent{.cancelled = observer.cancelled, .progress = {}};
    Run before = runAt(problem, loose, observer);
    addWork(before, result.statistics);
    if (before.cancelled || isExact(before)) {
        describe(problem, before, result);
        result.cancelled = before.cancelled;
        if (!before.cancelled)
            result.statistics.errorEstimate = 0;
        result.motion =
            before.motion(problem, before.cancelled, result.statistics.errorEstimate, {});
        return result;
    }
    if (observer.progress)
        observer.progress(before.motion(problem, true, {}, {}));
    std::vector<IslandError> errorsBefore;
    while (true) {
        Run run = runAt(problem, tight, silent);
        addWork(run, result.statistics);
        if (run.cancelled) {
            describe(problem, before, result);
            result.cancelled = true;
            result.motion = before.motion(problem, true, {}, {});
            return result;
        }
        const auto errors = compareRuns(problem, before, run, accuracy);
        Verdict verdict = judge(problem, errors, errorsBefore, loose, tight);
        if (!verdict.again) {
            describe(problem, run, result);
            result.statistics.errorEstimate = verdict.estimate;
            if (std::isfinite(verdict.predictableUntil))
                result.statistics.predictableUntil = verdict.predictableUntil;
            result.motion = run.motion(problem, false, result.statistics.errorEstimate,
                                       result.statistics.predictableUntil);
            return result;
        }
        shareWithinIslands(run.island, verdict.next);
        loose = tight;
        tight = verdict.next;
        errorsBefore = errors;
        before = std::move(run);
    }
}

} // namespace

Result simulate(const scene::Scene& scene, const Options& options, const Observer& observer) {
    const double begin = cpuSeconds();
    auto problem = problemOf(scene, options);
    if (auto* refusal = std::get_if<std::vector<std::string>>(&problem)) {
        Result result;
        result.refusal = std::move(*refusal);
        return result;
    }
    const auto& posed = *std::get<std::shared_ptr<const Problem>>(problem);
    Result result = posed.scene.simulator.method == "auto" && !options.fixedStep
                        ? simulateToAccuracy(posed, observer)
                        : simulatePlainly(posed, observer);
    result.statistics.predictableUntil = result.motion->predictableUntil();
    result.statistics.seconds = cpuSeconds() - begin;
    return result;
}

} // namespace simulation
