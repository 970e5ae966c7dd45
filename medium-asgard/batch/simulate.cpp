#include "batch/accuracy_line.h"
#include "batch/command.h"
#include "batch/input.h"
#include "batch/output.h"
#include "batch/soft_links.h"
#include "batch/statistics.h"
#include "batch/table.h"
#include "batch/waiting.h"
#include "motion/known_span.h"
#include "reports/instants.h"
#include "run/budget.h"
#include "scene/names.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace batch {
namespace {

std::optional<Refusal> wrongNumbers(const SimulateArguments& arguments) {
    const auto positive = [](const std::optional<double>& value) {
        return !value || (std::isfinite(*value) && *value > 0);
    };
    if (!positive(arguments.accuracy))
        return Refusal{wrongUsage, "--accuracy wants a positive number"};
    if (!positive(arguments.fixedStep))
        return Refusal{wrongUsage, "--fixed-step wants a positive number"};
    if (arguments.finish && !(std::abs(*arguments.finish) <= 1e100))
        return Refusal{wrongUsage, "--finish wants a number of at most 1e100"};
    if (arguments.threads && *arguments.threads < 1)
        return Refusal{wrongUsage, "--threads wants at least 1"};
    if (arguments.memory && !(*arguments.memory >= 1 && *arguments.memory <= 1e9))
        return Refusal{wrongUsage, "--memory wants a number of MB, 1 to 1e9"};
    if (arguments.only && !arguments.quantities)
        return Refusal{wrongUsage, "--only wants --quantities"};
    if (arguments.at && arguments.times)
        return Refusal{wrongUsage, "--at and --times exclude each other"};
    return std::nullopt;
}

std::variant<std::vector<double>, Refusal> timesOf(const SimulateArguments& arguments, double start,
                                                   double finish) {
    std::variant<std::vector<double>, Refusal> times = usualTimes(start, finish);
    if (arguments.at)
        times = timesAt(*arguments.at);
    if (arguments.times) {
        const auto content = contentOf(*arguments.times);
        if (const auto* refusal = std::get_if<Refusal>(&content))
            return *refusal;
        times = timesIn(std::get<std::string>(content), *arguments.times);
    }
    if (const auto* list = std::get_if<std::vector<double>>(&times))
        for (const double time : *list)
            if (time < start || time > finish)
                return Refusal{failure, "time " + cell(time) + " lies outside the motion, " +
                                            cell(start) + " to " + cell(finish)};
    return times;
}

simulation::Options optionsOf(const SimulateArguments& arguments,
                              std::map<std::string, double> parameters) {
    simulation::Options options;
    options.accuracy = arguments.accuracy;
    options.finish = arguments.finish;
    options.method = arguments.method;
    options.fixedStep = arguments.fixedStep;
    options.whole = arguments.whole;
    options.eventDriven = !arguments.noEvents;
    options.threads = arguments.threads.value_or(0);
    options.parameters = std::move(parameters);
    if (arguments.only)
        options.only =
            arguments.quantities ? quantitiesIn(*arguments.quantities) : std::vector<std::string>();
    return options;
}

bool writeStatistics(const std::string& file, const scene::Scene& scene,
                     const simulation::Result& result, double secondsReading) {
    Output output(file);
    if (!output.good())
        return false;
    const std::string json =
        statisticsJson(scene, *result.motion, result.statistics, secondsReading);
    return output.finish(output.write(json));
}

bool writeInstants(const std::string& file, const scene::Scene& scene,
                   const simulation::Motion& motion) {
    Output output(file);
    if (!output.good())
        return false;
    std::string text = "time,kind,names,impulse\n";
    for (const simulation::ListedInstant& instant : simulation::instantsOf(scene, motion))
        text += cell(instant.time) + "," + instant.kind + "," + instant.names + "," +
                (instant.impulse ? cell(*instant.impulse) : "") + "\n";
    return output.finish(output.write(text));
}

void tellAccuracy(const SimulateArguments& arguments, const scene::Scene& scene,
                  const simulation::Result& result) {
    const double reached = simulation::knownSpan(*result.motion).computed;
    if (std::ranges::all_of(scene.bodies, &scene::Body::fixed) ||
        (reached == result.motion->start() && result.motion->finish() > reached))
        return; // nothing moves
    const scene::Simulator& simulator = scene.simulator;
    const double accuracy = arguments.accuracy.value_or(simulator.accuracy);
    const std::string line =
        accuracyLine({.start = result.motion->start(),
                      .reached = reached,
                      .accuracy = accuracy,
                      .method = arguments.method.empty() ? simulator.method : arguments.method,
                      .fixedStep = arguments.fixedStep.value_or(0)},
                     result.statistics);
    const double size = result.statistics.movingSize.value_or(0);
    if (const std::string soft = softLinkLine(scene, result.motion, accuracy * size);
        size > 0 && !soft.empty())
        terminal::complain("asgard: " + soft);
    if (!line.empty())
        terminal::complain("asgard: " + line);
}

// The scene is good, the times are good: compute and write.
int compute(const SceneText& scene, const SimulateArguments& arguments,
            const simulation::Options& options, const std::vector<double>& times,
            double secondsReading) {
    const simulation::Result result = simulated(scene.reading.scene, options);
    if (!result.motion)
        return refuse(refusalOf(scene, result.refusal));
    Columns columns{!arguments.only, {}};
    if (arguments.quantities)
        columns.quantities = quantitiesIn(*arguments.quantities);
    std::vector<std::string> faults;
    const simulation::Quantities quantities(scene.reading.scene, options, result.motion,
                                            columns.quantities, faults);
    if (!faults.empty()) {
        Refusal refusal;
        for (const std::string& fault : faults)
            refusal.faults.push_back("asgard: --quantities: " + fault);
        return refuse(refusal);
    }
    const bool stopped = tell(scene, *result.motion);
    tellAccuracy(arguments, scene.reading.scene, result);
    Output output(arguments.csv);
    if (!output.good() || !output.finish(writeTable(output.stream(), scene.reading.scene,
                                                    *result.motion, quantities, columns, times)))
        return failure;
    if (arguments.events && !writeInstants(*arguments.events, scene.reading.scene, *result.motion))
        return failure;
    if (arguments.stats &&
        !writeStatistics(*arguments.stats, scene.reading.scene, result, secondsReading))
        return failure;
    return stopped || result.motion->computed() < result.motion->finish() ? failure : success;
}

} // namespace

int simulateCommand(script::Reader& reader, const SimulateArguments& arguments) {
    if (const auto refusal = wrongNumbers(arguments))
        return refuse(*refusal);
    if (arguments.memory)
        simulation::setMostBytes(static_cast<std::size_t>(*arguments.memory * 1e6));
    const auto begin = std::chrono::steady_clock::now();
    auto opened = openScene(reader, arguments.scene, arguments.set);
    const std::chrono::duration<double> reading = std::chrono::steady_clock::now() - begin;
    if (const auto* refusal = std::get_if<Refusal>(&opened))
        return refuse(*refusal);
    auto& [scene, values] = std::get<OpenScene>(opened);
    if (arguments.quantities)
        scene::countTurns(scene.reading.scene, quantitiesIn(*arguments.quantities));
    const scene::Simulator& simulator = scene.reading.scene.simulator;
    const double finish = arguments.finish.value_or(simulator.finish);
    if (finish < simulator.start)
        return refuse({failure, "the motion would finish at " + cell(finish) +
                                    ", before it starts at " + cell(simulator.start)});
    const auto times = timesOf(arguments, simulator.start, finish);
    if (const auto* refusal = std::get_if<Refusal>(&times))
        return refuse(*refusal);
    return compute(scene, arguments, optionsOf(arguments, values),
                   std::get<std::vector<double>>(times), reading.count());
}

} // namespace batch
