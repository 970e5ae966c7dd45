#include "run/problem.h"

#include "equations/partition.h"
#include "motion/groups.h"
#include "placing/hops.h"
#include "placing/placing.h"
#include "run/budget.h"
#include "run/quantities.h"
#include "scene/shape_of.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace simulation {
namespace {

using physics::bodyUnknowns;

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
    if (!(std::abs(scene.simulator.finish) <= 1e100))
        faults.push_back("The motion would finish after 1e100: nothing is that long.");
    for (const auto& [name, value] : options.parameters) {
        const auto parameter = std::ranges::find(scene.parameters, name, &scene::Parameter::name);
        if (parameter == scene.parameters.end())
            faults.push_back("The scene has no parameter \"" + name + "\".");
        else
            parameter->value = value;
    }
}

std::vector<std::size_t> readersOf(const Problem& problem) {
    Groups groups(problem.bodies->size());
    const auto reads = solution::readsOf(problem.equations.set, problem.start());
    const std::vector<std::size_t> owner = ownersOf(problem);
    for (std::size_t i = 0; i < reads.size(); ++i)
        for (const std::size_t read : reads[i])
            groups.join(owner[i], owner[read]);
    return groups.roots();
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

// By body.
std::vector<geometry::Shape> shapesOf(const scene::Scene& scene, scene::ShapeReader& reader,
                                      const std::function<void()>& meanwhile,
                                      std::vector<std::string>& faults) {
    const scene::ShapeReader::Made none = "there is none";
    std::vector<geometry::Shape> shapes;
    for (const scene::Body& body : scene.bodies) {
        if (shapes.size() % 16 == 15)
            meanwhile();
        const scene::ShapeSet* set = scene::findShapeSet(scene, body.shape);
        const auto& made = set ? reader.of(*set) : none;
        if (const auto* why = std::get_if<std::string>(&made))
            faults.push_back("Body \"" + body.name + "\" has no shape: " + *why + ".");
        else
            shapes.push_back(std::get<geometry::Shape>(made));
    }
    return shapes;
}

struct Cancelled {}; // thrown while a problem is posed

std::variant<std::shared_ptr<Problem>, std::vector<std::string>>
posed(const scene::Scene& original, const Options& options,
      const std::function<void()>& meanwhile) {
    std::vector<std::string> faults;
    scene::Scene scene = original;
    applyOptions(scene, options, faults);
    scene::ShapeReader reader(meanwhile);
    std::vector<geometry::Shape> shapes = shapesOf(scene, reader, meanwhile, faults);
    if (!faults.empty())
        return faults;
    physics::EquationsOfMotion equations(scene, meanwhile, &reader);
    if (!equations.faults.empty())
        return equations.faults;
    const Touching begun =
        scene.simulator.collisions ? touching(scene, equations, shapes) : Touching();
    if (!begun.moved.empty()) {
        for (const physics::Assembly::Moved& of : begun.moved) {
            scene.bodies[of.body].initialPosition = of.pose.position;
            scene.bodies[of.body].initialAttitude = of.pose.attitude;
        }
        equations = physics::EquationsOfMotion(scene, meanwhile, &reader);
        if (!equations.faults.empty())
            return equations.faults;
        std::ranges::copy(begun.notes, std::back_inserter(equations.notes));
    }
    if (scene.simulator.collisions)
        std::ranges::copy(hopSentences(scene, equations, shapes),
                          std::back_inserter(equations.notes));
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
    // The set is a part of the problem, which owns what was prepared of it; readers of a motion
    // outlive the problem.
    const auto set = solution::ConditionReader::isWanted(problem->equations.set)
                         ? std::make_shared<const expression::EquationSet>(problem->equations.set)
                         : std::shared_ptr<const expression::EquationSet>(
                               std::shared_ptr<const void>(), &problem->equations.set);
    problem->prepared = std::make_shared<const solution::PreparedEquations>(
        set, solution::preparationFor(solverOptions(*problem, {})), meanwhile);
    problem->readers = readersOf(*problem);
    return problem;
}

} // namespace

double firstTolerance(double accuracy) {
    constexpr double part = 0.5, loosest = 1e-3; // measured, as those of tightening.cpp
    return std::min(part * accuracy, loosest);
}

std::vector<std::size_t> ownersOf(const Problem& problem) { return problem.equations.owners; }

solution::Options solverOptions(const Problem& problem, const std::vector<double>& tolerances) {
    solution::Options options;
    options.start = problem.start();
    options.method = problem.scene.simulator.method;
    options.fixedStep = problem.options.fixedStep;
    options.firstStep = problem.scene.simulator.firstStep;
    options.whole = problem.options.whole;
    options.eventDriven = problem.options.eventDriven;
    options.threads = static_cast<std::size_t>(std::max(problem.options.threads, 0));
    options.asked = problem.asked;
    options.mostBytes = mostBytes();
    if (!tolerances.empty())
        for (const std::size_t b : problem.equations.owners) {
            options.tolerances.push_back(tolerances[b]);
            options.extents.push_back(2 * (*problem.bodies)[b].radius);
        }
    return options;
}

bool Problem::collides() const { return scene.simulator.collisions && bodies->size() > 1; }

std::variant<std::shared_ptr<Problem>, std::vector<std::string>>
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

} // namespace simulation
