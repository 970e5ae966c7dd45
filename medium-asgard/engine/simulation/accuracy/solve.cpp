// The accuracy that is asked for is met by measuring it: the scene is solved at two tolerances, the
// difference is the error of the looser run, and what differs by too much is solved again more
// tightly, island by island, so that bodies that never meet do not change each other's numbers.
#include "accuracy/solve.h"

#include "accuracy/accuracy.h"
#include "accuracy/close_impacts.h"
#include "accuracy/restarts.h"
#include "accuracy/tightening.h"
#include "motion/impact_order.h"
#include "run/cpu_seconds.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace simulation {
namespace {

WorkCounts workOf(const solution::Statistics& counted) {
    return {.steps = counted.steps,
            .rejectedSteps = counted.rejectedSteps,
            .discardedSteps = counted.discardedSteps,
            .unconvergedSteps = counted.unconvergedSteps,
            .evaluations = counted.evaluations,
            .equationEvaluations = counted.equationEvaluations,
            .factorisations = counted.factorisations};
}

void addWork(const Run& run, Solved& solved) {
    std::vector<std::pair<std::size_t, std::size_t>> near;
    std::ranges::set_union(solved.near, run.candidates, std::back_inserter(near));
    solved.near = std::move(near);
    Statistics& sum = solved.result.statistics;
    sum += workOf(run.statistics);
    sum -= workOf(run.before);
    sum.pairTests += run.pairTests;
    sum.secondsSettingUp += run.secondsSettingUp;
    solved.keptBytes = std::max(solved.keptBytes, run.statistics.keptBytes);
    solved.isFull = solved.isFull || std::ranges::any_of(run.histories->stops(), [](const auto& s) {
                        return s.reason == solution::Stop::Reason::tooMuchKept;
                    });
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

// Takes the run as the answer.
void deliver(const Problem& problem, Run run, Solved& solved) {
    Result& result = solved.result;
    putInOrder(run.impacts, [&](std::size_t b) { return (*problem.bodies)[b].isFixed; });
    std::ranges::sort(run.notes);
    describe(problem, run, result);
    std::optional<BodyError> worst;
    if (solved.isEstimated)
        worst = std::accumulate(solved.errors.begin(), solved.errors.end(), BodyError{}, worse);
    result.motion = run.motion(problem, result.cancelled || run.cancelled, worst);
    result.statistics.errorEstimate = result.motion->errorEstimate();
    result.cancelled = result.cancelled || run.cancelled;
    solved.run = std::move(run);
}

// Another method than the engine's choice is taken as it is: one run.
Solved solvePlainly(const Problem& problem, const Observer& observer, RunSource& runs) {
    const std::vector<double> tolerances(problem.bodies->size(), problem.accuracy());
    Solved solved;
    Run run = *runs.next(problem, {.tolerances = tolerances}, observer);
    addWork(run, solved);
    deliver(problem, std::move(run), solved);
    return solved;
}

// Islands in which something hits something, by their least body: impacts amplify what rounding
// does.
struct Amplifying {
    // Nothing is integrated: rounding is all that is off.
    std::vector<bool> alone;
    // Something is, but not all that is hit: runs at two tolerances may meet at the same bits and
    // be equal, and say nothing of what rounding does.
    std::vector<bool> beside;
};

Amplifying amplifying(const Problem& problem, const Run& run) {
    // A hit makes a deviation some hundred times as large at most.
    constexpr std::size_t leastImpacts = 6;
    const std::size_t bodies = run.island.size();
    Amplifying islands{std::vector<bool>(bodies), std::vector<bool>(bodies)};
    std::vector<std::size_t> impacts(bodies);
    for (const Impact& impact : run.impacts)
        for (const std::size_t body : {impact.first, impact.second})
            if (!(*problem.bodies)[body].isFixed) {
                const std::size_t island = run.island[body];
                islands.alone[island] = true;
                ++impacts[island];
                if (!run.isIntegrated[body])
                    islands.beside[island] = true;
            }
    std::vector<bool> isMixed(bodies);
    for (std::size_t b = 0; b < bodies; ++b)
        if (run.isIntegrated[b])
            isMixed[run.island[b]] = true;
    for (std::size_t b = 0; b < bodies; ++b) {
        islands.beside[b] = islands.beside[b] && isMixed[b] && impacts[b] >= leastImpacts;
        islands.alone[b] = islands.alone[b] && !isMixed[b];
    }
    return islands;
}

// By body, unless it is cancelled meanwhile.
std::vector<IslandError> differencesOf(const Problem& problem, const Run& first, const Run& second,
                                       const Observer& silent, Solved& solved) {
    std::vector<IslandError> differences;
    solved.result.cancelled = second.cancelled;
    if (!second.cancelled)
        differences = compareRuns(problem, first, second, problem.accuracy(), silent.cancelled);
    solved.result.cancelled = solved.result.cancelled || (silent.cancelled && silent.cancelled());
    return differences;
}

// What rounding does, by body, where impacts amplify it. Written into the errors where nothing is
// integrated; answered where something is, and rounding alone takes the motion beyond the accuracy.
std::vector<std::optional<BodyError>> judgeRounding(const Problem& problem, const Run& run,
                                                    const Observer& silent,
                                                    const std::vector<double>& tolerances,
                                                    RunSource& runs, Solved& solved,
                                                    std::vector<double>& sizes) {
    std::vector<std::optional<BodyError>> beside(solved.errors.size());
    const Amplifying islands = amplifying(problem, run);
    const auto concerns = [&](std::size_t b) {
        return islands.alone[run.island[b]] || islands.beside[run.island[b]];
    };
    if (std::ranges::find(islands.alone, true) == islands.alone.end() &&
        std::ranges::find(islands.beside, true) == islands.beside.end())
        return beside;
    std::vector<bool> concerned;
    for (std::size_t b = 0; b < solved.errors.size(); ++b)
        concerned.push_back(concerns(b));
    const auto nudged = runs.next(problem,
                                  {.kind = RunSource::Kind::nudged,
                                   .tolerances = tolerances,
                                   .concerned = std::move(concerned)},
                                  silent);
    if (!nudged)
        return beside;
    addWork(*nudged, solved);
    const auto differences = differencesOf(problem, run, *nudged, silent, solved);
    for (std::size_t b = 0; b < solved.errors.size() && !solved.result.cancelled; ++b) {
        const BodyError error{.estimate = std::min(differences[b].largest, 1.0),
                              .predictableUntil = differences[b].beyondFrom(problem.accuracy())};
        sizes[b] = differences[b].size;
        if (islands.alone[run.island[b]])
            solved.errors[b] = error;
        else if (concerns(b) && std::isfinite(error.predictableUntil))
            beside[b] = error;
    }
    return beside;
}

// A body that comes to rest makes no more hops, in none of the runs that are compared: where they
// are left out for being too low to be found, these runs agree. So their height is a part of the
// error. `sizes`: by body, of its island.
void addLostHops(const Problem& problem, const Run& run, const std::vector<double>& sizes,
                 std::vector<BodyError>& errors) {
    std::vector<BodyError> lost(errors.size());
    for (const LostHop& hop : run.lostHops) {
        const std::size_t island = run.island[hop.body];
        const double size = sizes[hop.body];
        if (!(size > 0))
            continue;
        BodyError& error = lost[island];
        error.lostHops = std::max(error.lostHops, std::min(hop.height / size, 1.0));
        if (hop.height > problem.accuracy() * size)
            error.predictableUntil = std::min(error.predictableUntil, hop.time);
    }
    for (std::size_t b = 0; b < errors.size(); ++b) {
        const BodyError& error = lost[run.island[b]];
        errors[b].estimate += error.lostHops;
        errors[b].lostHops = error.lostHops;
        errors[b].predictableUntil = std::min(errors[b].predictableUntil, error.predictableUntil);
    }
}

// The larger of the two.
void takeRounding(const std::vector<std::optional<BodyError>>& rounding,
                  std::vector<BodyError>& errors) {
    for (std::size_t b = 0; b < rounding.size(); ++b)
        if (rounding[b])
            errors[b] = {.estimate = std::max(errors[b].estimate, rounding[b]->estimate),
                         .predictableUntil =
                             std::min(errors[b].predictableUntil, rounding[b]->predictableUntil)};
}

// Runs that are equal, by rounding, say nothing. One that is rougher than `loose` does.
void compareRougher(const Problem& problem, const Run& loose, const Run& run,
                    const Observer& silent, Tightening& search,
                    std::vector<IslandError>& differences, RunSource& runs, Solved& solved) {
    const std::vector<double> before = search.loose();
    search.roughen(differences);
    std::vector<bool> concerned;
    for (std::size_t b = 0; b < before.size(); ++b)
        concerned.push_back(search.loose()[b] != before[b]);
    const auto rough = runs.next(problem,
                                 {.kind = RunSource::Kind::rougher,
                                  .tolerances = search.loose(),
                                  .concerned = concerned,
                                  .base = RunSource::Base{loose, concerned}},
                                 silent);
    if (!rough)
        return;
    addWork(*rough, solved);
    const auto rougher = differencesOf(problem, *rough, run, silent, solved);
    for (std::size_t b = 0; b < differences.size() && !solved.result.cancelled; ++b)
        if (concerned[b])
            differences[b] = rougher[b];
}

// A run that proved another wrong.
struct Proof {
    Run run;
    std::vector<double> tolerances;
};

// Runs that hit something mostly want a proof.
bool hits(const Run& run) { return !run.impacts.empty() || !run.contacts.entries().empty(); }

// The tolerances of the second run, if all that is not fixed is integrated.
std::vector<double> tighterOf(const Problem& problem, const Tightening& search) {
    std::vector<double> tolerances = search.tight();
    for (std::size_t b = 0; b < tolerances.size(); ++b)
        if ((*problem.bodies)[b].isFixed)
            tolerances[b] = search.loose()[b];
    return tolerances;
}

// Compares runs until the search ends. `proof` is the first of them if it has the tolerances that
// are next. False: the search was cancelled, or such a run was not made before.
bool tighten(const Problem& problem, const Observer& silent, Tightening& search, RunSource& runs,
             std::optional<Proof> proof, Run& run, Solved& solved) {
    const bool isExplained = problem.options.explain; // what is taken brings no equations with it
    while (search.goesOn() && !solved.result.cancelled) {
        std::optional<Run> tight;
        if (proof && !isExplained && proof->tolerances == search.tight()) {
            tight = std::move(proof->run);
        } else {
            RunSource::Wanted wanted{.tolerances = search.tight(), .concerned = search.unsettled()};
            if (!isExplained)
                wanted.base.emplace(RunSource::Base{run, search.runsAgain()});
            if (const auto next = search.tighter();
                next && !runs.expects(search.tight()) && hits(run))
                runs.expect(problem, *next);
            tight = runs.next(problem, wanted, silent);
            if (tight)
                addWork(*tight, solved);
        }
        proof.reset();
        if (!tight)
            return false;
        auto differences = differencesOf(problem, run, *tight, silent, solved);
        if (!solved.result.cancelled && search.needsRougher(differences))
            compareRougher(problem, run, *tight, silent, search, differences, runs, solved);
        if (solved.result.cancelled)
            return false;
        search.judge(differences, tight->island, solved.errors);
        run = std::move(*tight);
    }
    return !solved.result.cancelled;
}

// What the errors may have put in another order is looked at once more, and so is what restarts too
// often for them to follow tolerances.
void doubtImpacts(const Problem& problem, const Run& run, Tightening& search,
                  const Solved& solved) {
    const auto close = hasCloseImpacts(problem, run, solved.errors, search.sizes());
    const auto often = restartsOften(problem, run, solved.errors);
    for (std::size_t b = 0; b < close.size(); ++b)
        if ((close[b] || often[b]) && run.isIntegrated[b] &&
            solved.errors[b].estimate <= problem.accuracy())
            search.doubt(b);
}

// One run more measures the errors that are open. Answers with it if the search goes on from it.
std::optional<Proof> prove(const Problem& problem, const Run& run, const Observer& silent,
                           Tightening& search, RunSource& runs, Solved& solved) {
    doubtImpacts(problem, run, search, solved);
    const std::vector<bool> unproven = search.unproven();
    if (std::ranges::find(unproven, true) == unproven.end())
        return std::nullopt;
    const std::vector<double> tolerances = search.proof();
    auto proof = runs.next(problem,
                           {.kind = RunSource::Kind::proving,
                            .tolerances = tolerances,
                            .concerned = unproven,
                            .base = RunSource::Base{run, unproven}},
                           silent);
    if (!proof)
        return std::nullopt;
    addWork(*proof, solved);
    const auto differences = differencesOf(problem, run, *proof, silent, solved);
    if (solved.result.cancelled)
        return std::nullopt;
    search.prove(differences, solved.errors);
    if (!search.goesOn())
        return std::nullopt;
    return Proof{std::move(*proof), tolerances};
}

// Runs that differ from where the motion stops on, or a little before, say what the stop says:
// until then the accuracy is kept.
void endWithStops(const Problem& problem, const Run& run, std::vector<BodyError>& errors) {
    constexpr double lastPart = 0.01;
    for (const auto& [body, stop] : run.stops) {
        BodyError& error = errors[body];
        const double near = stop.time - lastPart * (stop.time - problem.start());
        if (std::isfinite(error.predictableUntil) && error.predictableUntil >= near)
            error = {.estimate = std::min(error.estimate, problem.accuracy()),
                     .predictableUntil = solution::infinity};
    }
}

// Of the island with the largest error that was estimated by comparing.
std::optional<double> sizeOfWorst(const std::vector<BodyError>& errors,
                                  const std::vector<double>& sizes) {
    double worst = -1;
    std::optional<double> size;
    for (std::size_t b = 0; b < errors.size(); ++b)
        if (sizes[b] > 0 && errors[b].estimate > worst) {
            worst = errors[b].estimate;
            size = sizes[b];
        }
    return size;
}

Solved solveToAccuracy(const Problem& problem, const Observer& observer, RunSource& runs) {
    Solved solved;
    Tightening search(problem.accuracy(), problem.bodies->size());
    const auto cancelled = [&] {
        runs.beginExpected();
        return observer.cancelled && observer.cancelled();
    };
    const Observer silent{.cancelled = cancelled, .progress = {}, .working = observer.working};
    runs.expect(problem, tighterOf(problem, search));
    Run run = *runs.next(
        problem, {.tolerances = search.loose()},
        {.cancelled = cancelled, .progress = observer.progress, .working = observer.working});
    addWork(run, solved);
    if (run.cancelled) {
        deliver(problem, std::move(run), solved);
        return solved;
    }
    solved.errors.resize(problem.bodies->size());
    std::vector<double> sizes(solved.errors.size());
    const auto rounding = judgeRounding(problem, run, silent, search.loose(), runs, solved, sizes);
    if (observer.progress && !isExact(run))
        observer.progress(run.motion(problem, true));
    search.leaveExact(run);
    std::optional<Proof> proof;
    while (tighten(problem, silent, search, runs, std::exchange(proof, std::nullopt), run, solved))
        if (!(proof = prove(problem, run, silent, search, runs, solved)))
            break;
    solved.isEstimated = !solved.result.cancelled;
    takeRounding(rounding, solved.errors);
    endWithStops(problem, run, solved.errors);
    const std::vector<double> compared = search.sizes();
    for (std::size_t b = 0; b < sizes.size(); ++b)
        sizes[b] = std::max(sizes[b], compared[b]);
    addLostHops(problem, run, sizes, solved.errors);
    solved.result.statistics.movingSize = sizeOfWorst(solved.errors, sizes);
    deliver(problem, std::move(run), solved);
    return solved;
}

} // namespace

Solved solve(const Problem& problem, const Observer& observer, RunSource& runs) {
    struct Expecting { // ends with the search
        RunSource& runs;
        ~Expecting() { runs.expectNothing(); }
    };
    const double begin = cpuSeconds();
    runs.begin(problem.bodies->size());
    const Expecting expecting{runs};
    Solved solved = problem.scene.simulator.method == "auto" && !problem.options.fixedStep
                        ? solveToAccuracy(problem, observer, runs)
                        : solvePlainly(problem, observer, runs);
    solved.result.statistics.predictableUntil = solved.result.motion->predictableUntil();
    solved.result.statistics.secondsSolving = cpuSeconds() - begin;
    return solved;
}

} // namespace simulation
