#include "batch/command.h"
#include "batch/input.h"
#include "batch/output.h"
#include "batch/reference_table.h"
#include "batch/waiting.h"

#include "charts/canvas.h"
#include "charts/study_chart.h"
#include "study/study.h"

#include <algorithm>
#include <cmath>

namespace batch {
namespace {

std::variant<std::vector<double>, Refusal> positiveNumbers(const std::string& list,
                                                           const std::string& option) {
    std::vector<double> numbers;
    if (list.empty()) // none
        return numbers;
    for (const std::string& item : quantitiesIn(list)) {
        const auto number = numberOf(item);
        if (!number || !(*number > 0) || !std::isfinite(*number))
            return Refusal{wrongUsage, option + " wants positive numbers with commas between them"};
        numbers.push_back(*number);
    }
    return numbers;
}

std::variant<std::vector<std::string>, Refusal> methodsOf(const StudyArguments& arguments) {
    const std::vector<std::string> known = simulation::studyMethods();
    if (!arguments.methods)
        return known;
    std::vector<std::string> methods = quantitiesIn(*arguments.methods);
    for (const std::string& method : methods)
        if (std::ranges::find(known, method) == known.end()) {
            std::string names;
            for (const std::string& name : known)
                names += (names.empty() ? "" : ", ") + name;
            return Refusal{failure, "there is no method \"" + method + "\" (" + names + ")"};
        }
    return methods;
}

std::variant<simulation::StudyPlan, Refusal> planOf(const StudyArguments& arguments,
                                                    const scene::Scene& scene) {
    simulation::StudyPlan plan = simulation::usualPlan(scene);
    plan.limit = arguments.limit;
    auto methods = methodsOf(arguments);
    if (const auto* refusal = std::get_if<Refusal>(&methods))
        return *refusal;
    plan.methods = std::move(std::get<std::vector<std::string>>(methods));
    for (const auto& [list, option, numbers] :
         {std::tuple(&arguments.accuracies, "--accuracies", &plan.accuracies),
          std::tuple(&arguments.steps, "--steps", &plan.steps)}) {
        if (!*list)
            continue;
        auto read = positiveNumbers(**list, option);
        if (const auto* refusal = std::get_if<Refusal>(&read))
            return *refusal;
        *numbers = std::move(std::get<std::vector<double>>(read));
    }
    if (arguments.reference) {
        auto trace = referenceIn(*arguments.reference, scene);
        if (const auto* refusal = std::get_if<Refusal>(&trace))
            return *refusal;
        plan.reference = std::move(std::get<simulation::Trace>(trace));
    }
    return plan;
}

// How many runs a plan is, without that of the reference.
std::size_t runsOf(const simulation::StudyPlan& plan) {
    const std::size_t fixed =
        plan.methods.size() - static_cast<std::size_t>(std::ranges::count(plan.methods, "auto"));
    return plan.methods.size() * plan.accuracies.size() + fixed * plan.steps.size();
}

simulation::StudyResult studied(const SceneText& scene, const simulation::Options& options,
                                const simulation::StudyPlan& quiet) {
    Waiting waiting;
    simulation::StudyPlan plan = quiet;
    std::string done = "computing the motion that the others are compared with";
    plan.progress = [&](const simulation::StudyResult& result) {
        done = "measured " + std::to_string(result.rows.size()) + " of " +
               std::to_string(runsOf(plan)) + " runs, " + result.rows.back().method + " last";
        if (waiting.isTime())
            waiting.say(done);
    };
    plan.cancelled = [&] { // asked often, also before the first row
        if (waiting.isTime())
            waiting.say(done);
        return false;
    };
    return simulation::study(scene.reading.scene, options, plan);
}

int compute(const SceneText& scene, const StudyArguments& arguments,
            const simulation::Options& options, const simulation::StudyPlan& plan) {
    const simulation::StudyResult result = studied(scene, options, plan);
    if (!result.refusal.empty())
        return refuse(refusalOf(scene, result.refusal));
    Output output(arguments.csv);
    if (!output.good() || !output.finish(output.write(charts::tableOf(result))))
        return failure;
    if (!arguments.output)
        return success;
    const std::string name = scene.file.substr(scene.file.find_last_of('/') + 1);
    const std::string why = charts::draw(charts::chartOf(name, plan, result), *arguments.output);
    return why.empty() ? success : refuse({failure, *arguments.output + ": " + why});
}

} // namespace

int studyCommand(script::Reader& reader, const StudyArguments& arguments) {
    if (!(arguments.limit > 0) || !std::isfinite(arguments.limit))
        return refuse({wrongUsage, "--limit wants a positive number"});
    if (arguments.output && !charts::Canvas::knows(*arguments.output))
        return refuse({wrongUsage, "--output wants a name that ends with .svg, .png or .pdf"});
    const auto opened = openScene(reader, arguments.scene, arguments.set);
    if (const auto* refusal = std::get_if<Refusal>(&opened))
        return refuse(*refusal);
    const auto& [scene, values] = std::get<OpenScene>(opened);
    const auto plan = planOf(arguments, scene.reading.scene);
    if (const auto* refusal = std::get_if<Refusal>(&plan))
        return refuse(*refusal);
    simulation::Options options;
    options.parameters = values;
    return compute(scene, arguments, options, std::get<simulation::StudyPlan>(plan));
}

} // namespace batch
