#include "simulation/run.h"

#include "scene/shape_of.h"
#include "simulation/cpu_seconds.h"
#include "simulation/nudge.h"
#include "solution/partition.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace simulation {
namespace {

using physics::bodyUnknowns;

// Which body each unknown belongs to: bodies have their unknowns in a row.
std::vector<std::size_t> ownersOf(const Problem& problem) {
    std::vector<std::size_t> owners(problem.equations.set.unknowns.size());
    for (std::size_t b = 0; b < problem.bodies->size(); ++b)
        if (const BodyRecord& body = (*problem.bodies)[b]; !body.isFixed)
            std::fill_n(owners.begin() + static_cast<std::ptrdiff_t>(body.firstUnknown),
                        bodyUnknowns, b);
    return owners;
}

std::string timeText(double time) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", time);
    return text;
}

std::string sentenceOf(const Problem& problem, const solution::Histories& histories,
                       const std::vector<std::size_t>& owners, const solution::Stop& stop) {
    std::string reason = stop.sentence;
    if (stop.reason == solution::Stop::Reason::notFinite) {
        std::vector<std::size_t> bodies;
        for (const std::size_t unknown : stop.unknowns)
            bodies.push_back(owners[unknown]);
        // The motion ends at the last time that is finite: what is not, is so just after.
        for (const double part : {0.0, 1e-12, 1e-9, 1e-6}) {
            const double after = part * std::max(1.0, std::abs(stop.time));
            const double before = std::max(problem.start(), stop.time - after);
            std::vector<double> state;
            for (std::size_t i = 0; i < histories.unknowns(); ++i) {
                const double value = 2 * histories.value(i, stop.time) - histories.value(i, before);
                // Of what is not solved any value will do.
                state.push_back(std::isnan(value) ? problem.equations.set.unknowns[i].initial
                                                  : value);
            }
            const std::string named =
                problem.equations.whatIsNotFinite(problem.scene, state, stop.time + after, bodies);
            if (!named.empty()) {
                reason = named;
                break;
            }
        }
    }
    return "Stopped at t = " + timeText(stop.time) + " s: " + reason + ".";
}

std::map<std::size_t, Stop> stopsOf(const Problem& problem, const solution::Histories& histories) {
    std::map<std::size_t, Stop> stops;
    if (histories.stops().empty())
        return stops;
    const std::vector<std::size_t> owners = ownersOf(problem);
    for (const solution::Stop& stop : histories.stops())
        for (const std::size_t unknown : stop.unknowns) {
            const std::size_t body = owners[unknown];
            const auto place = stops.find(body);
            if (place == stops.end() || stop.time < place->second.time)
                stops[body] = {.time = stop.time,
                               .sentence = sentenceOf(problem, histories, owners, stop)};
        }
    return stops;
}

struct Groups { // union-find
    std::vector<std::size_t> parent;
    explicit Groups(std::vector<std::size_t> parents) : parent(std::move(parents)) {}
    std::size_t root(std::size_t i) {
        while (parent[i] != i)
            i = parent[i] = parent[parent[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        parent[std::max(a, b)] = std::min(a, b);
    }
};

solution::Options solverOptions(const Problem& problem, const std::vector<double>& tolerances,
                                const Observer& observer) {
    solution::Options options;
    options.start = problem.start();
    options.method = problem.scene.simulator.method;
    options.fixedStep = problem.options.fixedStep;
    options.firstStep = problem.scene.simulator.firstStep;
    options.whole = problem.options.whole;
    options.eventDriven = problem.options.eventDriven;
    options.threads = static_cast<std::size_t>(std::max(problem.options.threads, 0));
    options.cancelled = observer.cancelled;
    options.asked = problem.asked;
    for (std::size_t b = 0; b < tolerances.size(); ++b)
        if (!(*problem.bodies)[b].isFixed) {
            options.tolerances.insert(options.tolerances.end(), bodyUnknowns, tolerances[b]);
            options.extents.insert(options.extents.end(), bodyUnknowns,
                                   2 * (*problem.bodies)[b].radius);
        }
    return options;
}

void applyOptions(scene::Scene& scene, const Options& options, std::vector<std::string>& faults) {
    if (options.accuracy)
        scene.simulator.accuracy = *options.accuracy;
    if (options.finish)
        scene.simulator.finish = *options.finish;
    if (!options.method.empty())
        scene.simulator.method = options.method;
    const auto& methods = solution::methodNames();
    if (scene.simulator.method != "auto" &&
        std::ranges::find(methods, scene.simulator.method) == methods.end()) {
        std::string known = "auto";
        for (const std::string& name : methods)
            known += ", " + name;
        faults.push_back("There is no method \"" + scene.simulator.method +
                         "\" (methods here: " + known + ").");
    }
    if (scene.simulator.finish < scene.simulator.start)
        faults.push_back("The motion would finish before it starts.");
    for (const auto& [name, value] : options.parameters) {
        const auto parameter = std::ranges::find(scene.parameters, name, &scene::Parameter::name);
        if (parameter == scene.parameters.end())
            faults.push_back("The scene has no parameter \"" + name + "\".");
        else
            parameter->value = value;
    }
}

std::vector<std::size_t> readersOf(const Problem& problem) {
    std::vector<std::size_t> alone(problem.bodies->size());
    std::iota(alone.begin(), alone.end(), std::size_t{0});
    Groups groups(std::move(alone));
    const auto reads = solution::readsOf(problem.equations.set, problem.start());
    const std::vector<std::size_t> owner = ownersOf(problem);
    for (std::size_t i = 0; i < reads.size(); ++i)
        for (const std::size_t read : reads[i])
            groups.join(owner[i], owner[read]);
    for (std::size_t b = 0; b < groups.parent.size(); ++b)
        groups.parent[b] = groups.root(b);
    return std::move(groups.parent);
}

// Places and velocities are always of interest: they tell what the motion's errors are.
std::optional<std::vector<std::size_t>> askedOf(const Problem& problem) {
    if (!problem.options.only || problem.collides())
        return std::nullopt;
    std::vector<std::size_t> asked = unknownsRead(problem.scene, *problem.options.only);
    for (const BodyRecord& body : *problem.bodies)
        for (std::size_t i = 0; !body.isFixed && i < physics::qw; ++i)
            asked.push_back(body.firstUnknown + i);
    return asked;
}

struct Cancelled {}; // thrown while a problem is posed

std::variant<std::shared_ptr<const Problem>, std::vector<std::string>>
posed(const scene::Scene& original, const Options& options,
      const std::function<void()>& meanwhile) {
    std::vector<std::string> faults;
    scene::Scene scene = original;
    applyOptions(scene, options, faults);
    std::vector<geometry::Shape> shapes;
    for (const scene::Body& body : scene.bodies) {
        if (shapes.size() % 16 == 15)
            meanwhile();
        const scene::ShapeSet* set = scene::findShapeSet(scene, body.shape);
        auto shape = set ? scene::shapeOf(*set)
                         : std::variant<geometry::Shape, std::string>("there is none");
        if (const auto* why = std::get_if<std::string>(&shape))
            faults.push_back("Body \"" + body.name + "\" has no shape: " + *why + ".");
        else
            shapes.push_back(std::get<geometry::Shape>(std::move(shape)));
    }
    if (!faults.empty())
        return faults;
    physics::EquationsOfMotion equations(scene, meanwhile);
    if (!equations.faults.empty())
        return equations.faults;
    auto bodies = std::make_shared<const std::vector<BodyRecord>>(recordsOf(equations));
    auto problem = std::make_shared<Problem>(Problem{.scene = std::move(scene),
                                                     .equations = std::move(equations),
                                                     .shapes = std::move(shapes),
                                                     .bodies = std::move(bodies),
                                                     .options = options,
                                                     .prepared = nullptr,
                                                     .readers = {},
                                                     .asked = {}});
    problem->asked = askedOf(*problem);
    // The set is a part of the problem, which owns what was prepared of it.
    const std::shared_ptr<const expression::EquationSet> set(std::shared_ptr<const void>(),
                                                             &problem->equations.set);
    problem->prepared = std::make_shared<const solution::PreparedEquations>(
        set, solution::preparationFor(solverOptions(*problem, {}, {})), meanwhile);
    problem->readers = readersOf(*problem);
    return problem;
}

} // namespace

std::vector<std::size_t> islandsOf(const Problem& problem, const std::vector<Impact>& impacts) {
    Groups groups(problem.readers);
    for (const Impact& impact : impacts)
        if (!(*problem.bodies)[impact.first].isFixed && !(*problem.bodies)[impact.second].isFixed)
            groups.join(impact.first, impact.second);
    std::vector<std::size_t> island(problem.bodies->size());
    for (std::size_t b = 0; b < island.size(); ++b)
        island[b] = groups.root(b);
    return island;
}

bool Problem::collides() const { return scene.simulator.collisions && bodies->size() > 1; }

std::variant<std::shared_ptr<const Problem>, std::vector<std::string>>
problemOf(const scene::Scene& original, const Options& options, const Observer& observer) {
    try {
        return posed(original, options, [&observer] {
            if (observer.cancelled && observer.cancelled())
                throw Cancelled{};
        });
    } catch (const Cancelled&) {
        return std::vector<std::string>();
    }
}

std::string shortfallOf(double accuracy, double estimate, std::optional<double> predictableUntil) {
    constexpr double lost = 0.03; // of the size
    char text[200];
    if (predictableUntil && estimate > lost)
        std::snprintf(text, sizeof text,
                      "From t = %.4g s on the motion is not predictable to %.1g of its size, since "
                      "it amplifies even rounding beyond that.",
                      *predictableUntil, accuracy);
    else
        std::snprintf(text, sizeof text,
                      "An accuracy of %.1g is not reached: rounding, and what the motion makes of "
                      "it, leave an error of about %.1g of its size.",
                      accuracy, estimate);
    return text;
}

MotionPointer Run::motion(const Problem& problem, bool draft, std::optional<double> errorEstimate,
                          std::optional<double> predictableUntil) const {
    std::vector<ComputedMotion::Place> places(problem.bodies->size());
    for (std::size_t b = 0; b < places.size(); ++b)
        places[b] = {.part = 0, .body = b};
    std::vector<std::string> told = notes;
    if (errorEstimate && *errorEstimate > problem.accuracy())
        told.push_back(shortfallOf(problem.accuracy(), *errorEstimate, predictableUntil));
    return std::make_shared<ComputedMotion>(
        ComputedMotion::Contents{.start = problem.start(),
                                 .finish = problem.finish(),
                                 .draft = draft,
                                 .parts = {{problem.bodies, histories}},
                                 .places = std::move(places),
                                 .stops = stops,
                                 .impacts = impacts,
                                 .notes = std::move(told),
                                 .errorEstimate = errorEstimate,
                                 .predictableUntil = predictableUntil});
}

namespace {

Run runWith(const Problem& problem, solution::Options options, const Observer& observer,
            Rounding rounding) {
    const double begin = cpuSeconds();
    // A hop that is lower than this moves nothing by more than the accuracy allows. The nudged run
    // follows lower ones, to show what they do.
    const double hop = rounding == Rounding::nudged ? 1e-4 : 1e-3;
    const RestLimits limits{.gap = std::clamp(1e-2 * problem.accuracy(), 1e-8, 1e-6),
                            .hopHeight = hop * problem.accuracy()};
    std::optional<CollisionSource> collisions;
    if (problem.collides())
        collisions.emplace(problem.scene, problem.equations, problem.shapes, problem.start(),
                           problem.finish(), limits, observer.cancelled);
    const solution::Solver* current = nullptr;
    double published = problem.start();
    const auto collect = [&](const solution::Solver& solver) {
        Run run;
        run.histories = solver.snapshot();
        run.stops = stopsOf(problem, *run.histories);
        if (collisions) {
            run.impacts = collisions->impacts();
            run.notes = collisions->notes();
            run.pairTests = collisions->pairTests();
        }
        return run;
    };
    if (observer.progress)
        options.progress = [&](double known) {
            // A little soon, so that something moves at once; then a tenth more each time, as what
            // is collected grows.
            const double span = problem.finish() - problem.start();
            const double more = std::clamp((known - problem.start()) / 10, span / 2000, span / 50);
            if (current && known >= published + more) {
                published = known;
                observer.progress(collect(*current).motion(problem, true, {}, {}));
            }
        };
    solution::EventSource* source = collisions ? &*collisions : nullptr;
    std::optional<NudgedSource> nudgedSource;
    if (rounding == Rounding::nudged) {
        options.initial = nudgedStart(problem.equations.set);
        if (source)
            source = &nudgedSource.emplace(*source);
    }
    solution::Solver solver(problem.prepared, options, source);
    current = &solver;
    const double ready = cpuSeconds();
    const solution::Advance advance = solver.advanceTo(problem.finish());
    Run run = collect(solver);
    run.secondsSettingUp = ready - begin;
    run.secondsMoving = cpuSeconds() - ready;
    run.statistics = solver.statistics();
    run.reached = advance.reached;
    run.cancelled = advance.cancelled;
    run.isDisturbed = advance.disturbed;
    if (problem.options.explain)
        run.equations = std::make_shared<const expression::EquationSet>(solver.equations());
    run.island = islandsOf(problem, run.impacts);
    run.isIntegrated.assign(problem.bodies->size(), false);
    const std::vector<std::size_t> owners = ownersOf(problem);
    for (const std::size_t unknown : run.statistics.integrated)
        run.isIntegrated[owners[unknown]] = true;
    if (collisions)
        run.candidates = collisions->candidates();
    return run;
}

// Islands in which nothing was hit, nothing stopped and nothing is to be solved again.
std::vector<bool> takenFrom(const Problem& problem, const Run& before,
                            const std::vector<bool>& again) {
    const std::size_t bodies = problem.bodies->size();
    std::vector<bool> islands(bodies, true);
    for (const Impact& impact : before.impacts)
        for (const std::size_t body : {impact.first, impact.second})
            islands[before.island[body]] = false;
    for (const auto& [body, stop] : before.stops)
        islands[before.island[body]] = false;
    for (std::size_t b = 0; b < bodies; ++b)
        if (again[b])
            islands[before.island[b]] = false;
    std::vector<bool> taken(bodies);
    for (std::size_t b = 0; b < bodies; ++b)
        taken[b] = islands[before.island[b]] && !(*problem.bodies)[b].isFixed;
    return taken;
}

std::shared_ptr<const solution::TakenMotion> motionOf(const Problem& problem, const Run& before,
                                                      const std::vector<bool>& taken) {
    auto motion = std::make_shared<solution::TakenMotion>();
    motion->histories = before.histories;
    motion->components = before.statistics.componentList;
    for (const std::size_t owner : ownersOf(problem))
        motion->unknowns.push_back(taken[owner]);
    return motion;
}

// What the motion that was taken has cost: its part of all evaluations then.
double secondsOf(const Run& before, const solution::TakenMotion& taken) {
    double all = 1, part = 0;
    for (const auto& component : before.statistics.componentList) {
        const auto evaluations = static_cast<double>(component.evaluations);
        all += evaluations;
        part += taken.unknowns[component.unknowns[0]] ? evaluations : 0;
    }
    return before.secondsMoving * part / all;
}

} // namespace

Run runAt(const Problem& problem, const std::vector<double>& tolerances, const Observer& observer,
          Rounding rounding) {
    return runWith(problem, solverOptions(problem, tolerances, observer), observer, rounding);
}

Run runAgain(const Problem& problem, const std::vector<double>& tolerances,
             const Observer& observer, const Run& before, const std::vector<bool>& again) {
    const std::vector<bool> taken = takenFrom(problem, before, again);
    solution::Options options = solverOptions(problem, tolerances, observer);
    if (std::ranges::find(taken, true) != taken.end()) {
        options.taken = motionOf(problem, before, taken);
        Run run = runWith(problem, options, observer, Rounding::asItIs);
        if (!run.isDisturbed) {
            run.secondsMoving += secondsOf(before, *options.taken);
            run.isTaken = taken;
            return run;
        }
        options.taken = nullptr;
    }
    return runWith(problem, options, observer, Rounding::asItIs);
}

} // namespace simulation
