#include "charts/study_chart.h"

#include <charconv>

namespace charts {

namespace {

// The shortest text that reads back as the same number.
std::string text(double value) {
    char buffer[40];
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

std::string textOf(const std::optional<double>& value) { return value ? text(*value) : ""; }

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
    case simulation::Status::notFinite:
        return "not finite";
    case simulation::Status::notReached:
        break;
    }
    return "accuracy not reached";
}

WorkPoint pointOf(const simulation::StudyRow& row) {
    return {.seconds = row.seconds,
            .error = row.error,
            .failure = row.status == simulation::Status::notReached && !row.error
                           ? "ended early"
                           : inWords(row.status),
            .minor = row.status == simulation::Status::notReached && row.error.has_value(),
            .fixedStep = row.step.has_value(),
            .chosen = row.isAuto};
}

} // namespace

WorkPrecision chartOf(const std::string& name, const simulation::StudyPlan& plan,
                      const simulation::StudyResult& result) {
    WorkPrecision chart;
    chart.title = "Methods on " + name;
    chart.subtitle = plan.reference ? "error against the reference given"
                                    : "error against a run at " + text(result.referenceAccuracy);
    chart.chosen = "what auto takes";
    chart.chosenName = result.autoTakes;
    chart.subtitle += "; each run stopped after " + text(plan.limit) + " s";
    for (const std::string& method : plan.methods) {
        WorkSeries& series = chart.series.emplace_back();
        series.name = method;
        for (const simulation::StudyRow& row : result.rows)
            if (row.method == method)
                series.points.push_back(pointOf(row));
    }
    return chart;
}

std::string tableOf(const simulation::StudyResult& result) {
    std::string table = "method,accuracy,step,error,seconds,steps,evaluations,status,auto\n";
    for (const simulation::StudyRow& row : result.rows)
        table += row.method + ',' + textOf(row.accuracy) + ',' + textOf(row.step) + ',' +
                 textOf(row.error) + ',' + text(row.seconds) + ',' + std::to_string(row.steps) +
                 ',' + std::to_string(row.evaluations) + ',' + nameOf(row.status) +
                 (row.isAuto ? ",1\n" : ",0\n");
    return table;
}

} // namespace charts
