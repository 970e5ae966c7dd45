#include "study/study.h"

#include "integrators/methods.h"
#include "run/cpu_seconds.h"
#include "study/failures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace simulation {
namespace {

constexpr std::size_t referenceTimes = 400;
constexpr double referenceAccuracies[] = {1e-12, 1e-10, 1e-8};
constexpr double referencePatience = 10; // times the limit of a run
constexpr double visible = 1e-6;         // of the largest velocity
constexpr double constantEnergy = 1e-6, drifted = 1e-2;
constexpr double promise = 10;    // times the accuracy asked
constexpr double farAway = 1000;  // times as far as anything is
constexpr double worthless = 0.1; // of the size: an error in the first digit

class Study {
public:
    Study(const scene::Scene& scene, const Options& options, const StudyPlan& plan)
        : scene_(scene), options_(options), plan_(plan) {}

    StudyResult result();

private:
    [[nodiscard]] bool prepare(StudyResult& result);
    [[nodiscard]] bool cancelled() const { return plan_.cancelled && plan_.cancelled(); }
    [[nodiscard]] Result runFor(double seconds, const Options& options) const;
    void add(StudyResult& result, const StudyRow& row) const;
    [[nodiscard]] StudyRow row(const std::string& method, std::optional<double> accuracy,
                               std::optional<double> step) const;
    [[nodiscard]] bool hasLeft(const ComputedMotion& motion) const;
    void judge(const Options& options, const Result& run, StudyRow& row) const;
    void markAuto(StudyResult& result) const;

    const scene::Scene& scene_;
    const Options& options_;
    const StudyPlan& plan_;
    std::shared_ptr<const Problem> problem_;
    MotionPointer reference_;
    Trace truth_;
    std::vector<std::size_t> island_;
    bool energyIsKept_ = false;
};

Result Study::runFor(double seconds, const Options& options) const {
    const double end = cpuSeconds() + seconds;
    const auto enough = [this, end] { return cpuSeconds() > end || cancelled(); };
    return simulate(scene_, options, Observer{.cancelled = enough, .progress = {}});
}

void Study::add(StudyResult& result, const StudyRow& row) const {
    if (cancelled()) // it was not measured to its end
        return;
    result.rows.push_back(row);
    if (plan_.progress)
        plan_.progress(result);
}

bool Study::prepare(StudyResult& result) {
    Options options = options_;
    options.method = "auto";
    auto problem = problemOf(scene_, options);
    if (auto* refusal = std::get_if<std::vector<std::string>>(&problem)) {
        result.refusal = std::move(*refusal);
        return false;
    }
    problem_ = std::get<std::shared_ptr<Problem>>(problem);
    for (const double accuracy : referenceAccuracies) {
        if (cancelled())
            return false;
        options.accuracy = accuracy;
        Result run = runFor(referencePatience * plan_.limit, options);
        if (!run.motion || (run.cancelled && accuracy != std::end(referenceAccuracies)[-1]))
            continue;
        if (run.cancelled || run.motion->computed() < run.motion->finish()) {
            char text[200];
            std::snprintf(
                text, sizeof text,
                "The motion that the others are compared with was not finished in %g s of "
                "processor time; a longer --limit (it gets %g of them) or a shorter "
                "motion may help.",
                referencePatience * plan_.limit, referencePatience);
            result.refusal.emplace_back(text);
            return false;
        }
        result.referenceAccuracy = accuracy;
        reference_ = run.motion;
        break;
    }
    truth_ = plan_.reference ? *plan_.reference : traceOf(*reference_, referenceTimes);
    island_ = islandsOf(*problem_, Impacts(reference_->impacts()));
    const auto energy = energyCourse(scene_, options, reference_, *problem_->bodies);
    energyIsKept_ = energy && energy->range < constantEnergy;
    return true;
}

// Short runs are made three times: the first has to fetch everything from memory.
StudyRow Study::row(const std::string& method, std::optional<double> accuracy,
                    std::optional<double> step) const {
    constexpr double isShort = 0.05;
    Options options = options_;
    options.method = method;
    options.fixedStep = step;
    if (accuracy)
        options.accuracy = accuracy;
    StudyRow row{.method = method, .accuracy = accuracy, .step = step};
    const Result run = runFor(plan_.limit, options);
    row.seconds = run.statistics.secondsSolving;
    for (int again = 0; again < 2 && row.seconds < isShort; ++again)
        row.seconds = std::min(row.seconds, runFor(plan_.limit, options).statistics.secondsSolving);
    row.steps = run.statistics.steps;
    row.evaluations = run.statistics.evaluations;
    judge(options, run, row);
    return row;
}

// Far from where anything is: what grows without bound is slow to search for collisions, too.
bool Study::hasLeft(const ComputedMotion& motion) const {
    double largest = 0;
    for (std::size_t i = 0; i < truth_.times.size(); ++i)
        for (std::size_t b = 0; b < island_.size(); ++b)
            if (const auto& place = truth_.places[i][b])
                largest = std::max({largest, place->position.cwiseAbs().maxCoeff(),
                                    (*problem_->bodies)[b].radius});
    const solution::Histories& histories = motion.histories();
    for (std::size_t b = 0; b < island_.size(); ++b)
        for (std::size_t axis = 0; axis < 3 && !(*problem_->bodies)[b].isFixed; ++axis) {
            const std::size_t unknown = (*problem_->bodies)[b].firstUnknown + axis;
            const double until = std::min(histories.reached(unknown), motion.finish());
            if (!(std::abs(histories.value(unknown, until)) <= farAway * largest))
                return true;
        }
    return false;
}

void Study::judge(const Options& options, const Result& run, StudyRow& row) const {
    using Reason = solution::Stop::Reason;
    const auto motion = std::dynamic_pointer_cast<const ComputedMotion>(run.motion);
    if (!motion || run.cancelled) {
        row.status = motion && hasLeft(*motion) ? Status::unstable
                     : run.cancelled            ? Status::tooSlow
                                                : Status::notReached;
        return;
    }
    const auto stops = motion->histories().stops();
    const auto stoppedBy = [&](Reason reason) {
        return std::ranges::any_of(stops, [&](const auto& s) { return s.reason == reason; });
    };
    const double error = scaledError(*problem_, island_, truth_, *motion);
    if (std::isfinite(error))
        row.error = error;
    // At the edge of stability, where control keeps an explicit method, fast parts go to and fro
    // within what was asked.
    const bool isAtTheEdge = row.accuracy && run.statistics.factorisations == 0;
    const bool refused = run.statistics.unconvergedSteps > run.statistics.steps;
    const auto& truth = dynamic_cast<const ComputedMotion&>(*reference_).histories().stops();
    const bool isScenes = std::ranges::any_of(
        truth, [](const auto& stop) { return stop.reason == Reason::notFinite; });
    if (stoppedBy(Reason::notFinite) && isScenes)
        row.status = Status::notFinite;
    else if (stoppedBy(Reason::overflow) || stoppedBy(Reason::notFinite))
        row.status = Status::unstable;
    else if (stoppedBy(Reason::notConverged) || refused)
        row.status = Status::newton;
    else if (!stops.empty() || !row.error)
        row.status = Status::notReached;
    else if (error > 1)
        row.status = Status::unstable;
    else if (!isAtTheEdge && rings(*motion, *reference_, *problem_->bodies,
                                   std::max(visible, promise * row.accuracy.value_or(0))))
        row.status = Status::ringing;
    else if (const auto energy = energyCourse(scene_, options, run.motion, *problem_->bodies);
             energyIsKept_ && energy && std::abs(energy->drift) > drifted)
        row.status = Status::drift;
    else if (error > (row.accuracy ? promise * *row.accuracy : worthless))
        row.status = Status::notReached;
}

// At the accuracy in the study that is nearest to the scene's: the row of `auto`, or, when that is
// not among the methods, the one of the method that most of its steps are made with.
void Study::markAuto(StudyResult& result) const {
    StudyRow* nearest = nullptr;
    const auto consider = [&](const std::string& method) {
        const auto distance = [&](const StudyRow& row) {
            return std::abs(std::log(*row.accuracy / problem_->accuracy()));
        };
        for (StudyRow& row : result.rows)
            if (row.method == method && row.accuracy &&
                (!nearest || distance(row) < distance(*nearest)))
                nearest = &row;
    };
    Options options = options_;
    options.method = "auto";
    consider("auto");
    if (nearest)
        options.accuracy = nearest->accuracy;
    std::map<std::string, std::size_t> steps;
    for (const ComponentStatistics& c : runFor(plan_.limit, options).statistics.componentList)
        if (c.model == "closed-form")
            steps.try_emplace("closed form", 0);
        else
            steps[c.method] += c.steps;
    std::vector<std::pair<std::size_t, std::string>> order;
    order.reserve(steps.size());
    for (const auto& [method, count] : steps)
        order.emplace_back(count, method);
    std::ranges::stable_sort(order, std::greater<>(), [](const auto& o) { return o.first; });
    for (const auto& [count, method] : order)
        result.autoTakes += (result.autoTakes.empty() ? "" : ", ") + method;
    if (!nearest && !order.empty())
        consider(order[0].second);
    if (nearest)
        nearest->isAuto = true;
}

StudyResult Study::result() {
    StudyResult result;
    if (!prepare(result))
        return result;
    for (const std::string& method : plan_.methods) {
        for (const double accuracy : plan_.accuracies)
            if (!cancelled())
                add(result, row(method, accuracy, std::nullopt));
        for (const double step : plan_.steps)
            if (method != "auto" && !cancelled())
                add(result, row(method, std::nullopt, step));
    }
    if (!cancelled())
        markAuto(result);
    return result;
}

} // namespace

const char* nameOf(Status status) {
    switch (status) {
    case Status::ok:
        return "ok";
    case Status::unstable:
        return "unstable";
    case Status::ringing:
        return "ringing";
    case Status::drift:
        return "drift";
    case Status::newton:
        return "newton";
    case Status::tooSlow:
        return "too_slow";
    case Status::notFinite:
        return "not_finite";
    case Status::notReached:
        break;
    }
    return "not_reached";
}

std::vector<std::string> studyMethods() {
    std::vector<std::string> names = {"auto"};
    for (const std::string& method : solution::methodNames())
        names.push_back(method);
    return names;
}

StudyPlan usualPlan(const scene::Scene& scene) {
    StudyPlan plan;
    plan.methods = studyMethods();
    plan.accuracies = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
    const double span = scene.simulator.finish - scene.simulator.start;
    for (const double parts : {1e2, 4e2, 1.6e3, 6.4e3, 2.56e4})
        plan.steps.push_back(span / parts);
    return plan;
}

StudyResult study(const scene::Scene& scene, const Options& options, const StudyPlan& plan) {
    return Study(scene, options, plan).result();
}

} // namespace simulation
