#include "batch/command.h"
#include "batch/input.h"
#include "batch/output.h"
#include "batch/reference_table.h"

#include "charts/canvas.h"
#include "charts/work_precision.h"
#include "simulation/study.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace batch {
namespace {

int refuse(const Refusal& refusal) {
    const bool line = refusal.message.ends_with('\n');
    std::fprintf(stderr, line ? "%s" : "asgard: %s\n", refusal.message.c_str());
    return refusal.exitCode;
}

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
    simulation::StudyPlan plan;
    plan.limit = arguments.limit;
    auto methods = methodsOf(arguments);
    if (const auto* refusal = std::get_if<Refusal>(&methods))
        return *refusal;
    plan.methods = std::move(std::get<std::vector<std::string>>(methods));
    plan.accuracies = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
    const double span = scene.simulator.finish - scene.simulator.start;
    for (const double parts : {1e2, 4e2, 1.6e3, 6.4e3, 2.56e4})
        plan.steps.push_back(span / parts);
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

// The shortest text that reads back as the same number.
std::string text(double value) {
    char buffer[40];
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

std::string textOf(const std::optional<double>& value) { return value ? text(*value) : ""; }

bool writeRows(std::FILE* file, const std::vector<simulation::StudyRow>& rows) {
    bool good =
        std::fputs("method,accuracy,step,error,seconds,steps,evaluations,status,auto\n", file) >= 0;
    for (const simulation::StudyRow& row : rows)
        good = good && std::fprintf(file, "%s,%s,%s,%s,%s,%zu,%zu,%s,%d\n", row.method.c_str(),
                                    textOf(row.accuracy).c_str(), textOf(row.step).c_str(),
                                    textOf(row.error).c_str(), text(row.seconds).c_str(), row.steps,
                                    row.evaluations, simulation::nameOf(row.status),
                                    row.isAuto ? 1 : 0) >= 0;
    return good;
}

std::string inWords(simulation::Status status) {
    switch (status) {
    case simulation::Status::ok:
        return "";
    case simulation::Status::unstable:
        return "unstable";
    case simulation::Status::ringing:
        return "rings";
    case simulation::Status::drift:
        return "drifts";
    case simulation::Status::newton:
        return "Newton fails";
    case simulation::Status::tooSlow:
        return "too slow";
    case simulation::Status::notReached:
        break;
    }
    return "accuracy not reached";
}

charts::WorkPrecision chartOf(const std::string& scene, const simulation::StudyPlan& plan,
                              const simulation::StudyResult& result) {
    charts::WorkPrecision chart;
    const std::size_t slash = scene.find_last_of('/');
    chart.title = "Methods on " + (slash == std::string::npos ? scene : scene.substr(slash + 1));
    chart.subtitle = plan.reference ? "error against the reference given"
                                    : "error against a run at " + text(result.referenceAccuracy);
    chart.subtitle += "; each run stopped after " + text(plan.limit) + " s";
    for (const std::string& method : plan.methods) {
        charts::WorkSeries& series = chart.series.emplace_back();
        series.name = method;
        for (const simulation::StudyRow& row : result.rows)
            if (row.method == method)
                series.points.push_back(
                    {.seconds = row.seconds,
                     .error = row.error,
                     .failure = inWords(row.status),
                     .minor = row.status == simulation::Status::notReached && row.error.has_value(),
                     .fixedStep = row.step.has_value(),
                     .chosen = row.isAuto});
    }
    return chart;
}

int compute(const SceneText& scene, const StudyArguments& arguments,
            const simulation::Options& options, const simulation::StudyPlan& plan) {
    const simulation::StudyResult result = simulation::study(scene.reading.scene, options, plan);
    if (!result.refusal.empty()) {
        std::string all;
        for (const std::string& sentence : result.refusal)
            all += scene.file + ": error: " + sentence + "\n";
        return refuse({failure, all});
    }
    Output output(arguments.csv);
    if (!output.good() || !output.finish(writeRows(output.stream(), result.rows)))
        return failure;
    if (!arguments.output)
        return success;
    const std::string why = charts::draw(chartOf(scene.file, plan, result), *arguments.output);
    return why.empty() ? success : refuse({failure, *arguments.output + ": " + why});
}

} // namespace

int studyCommand(script::Reader& reader, const StudyArguments& arguments) {
    if (!(arguments.limit > 0) || !std::isfinite(arguments.limit))
        return refuse({wrongUsage, "--limit wants a positive number"});
    if (arguments.output && !charts::Canvas::knows(*arguments.output))
        return refuse({wrongUsage, "--output wants a name that ends with .svg, .png or .pdf"});
    const auto parameters = settings(arguments.set);
    if (const auto* refusal = std::get_if<Refusal>(&parameters))
        return refuse(*refusal);
    const auto& values = std::get<std::map<std::string, double>>(parameters);
    const auto read = readScene(reader, arguments.scene, values);
    if (const auto* refusal = std::get_if<Refusal>(&read))
        return refuse(*refusal);
    const auto& scene = std::get<SceneText>(read);
    if (const auto refusal = unusable(scene))
        return refuse(*refusal);
    if (const auto refusal = outOfBounds(scene.reading.scene, values))
        return refuse(*refusal);
    const auto plan = planOf(arguments, scene.reading.scene);
    if (const auto* refusal = std::get_if<Refusal>(&plan))
        return refuse(*refusal);
    simulation::Options options;
    options.parameters = values;
    return compute(scene, arguments, options, std::get<simulation::StudyPlan>(plan));
}

} // namespace batch
