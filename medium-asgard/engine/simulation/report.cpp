#include "simulation/report.h"

#include "simulation/place_at.h"

#include <algorithm>

namespace simulation {
namespace {

bool joins(const scene::Link& link, const std::string& body) {
    const auto* other = std::get_if<scene::BodyEnd>(&link.second);
    return link.first.body == body || (other && other->body == body);
}

const scene::Source* sourceOf(const scene::Scene& scene, const Stop::Culprit& culprit) {
    std::size_t left = culprit.nth;
    for (const scene::Link& link : scene.links)
        if (culprit.isLink && joins(link, culprit.body) && left-- == 0)
            return &link.source;
    for (const scene::Force& force : scene.forces)
        if (!culprit.isLink && force.body == culprit.body && left-- == 0)
            return &force.source;
    return nullptr;
}

// The first body whose name a sentence quotes.
const scene::Body* namedIn(const scene::Scene& scene, const std::string& sentence) {
    std::size_t from = sentence.find('"');
    while (from != std::string::npos) {
        const std::size_t to = sentence.find('"', from + 1);
        if (to == std::string::npos)
            return nullptr;
        if (const scene::Body* body =
                scene::findBody(scene, sentence.substr(from + 1, to - from - 1)))
            return body;
        from = to;
    }
    return nullptr;
}

scene::Diagnostic placed(const scene::Scene& scene, scene::Severity severity,
                         const std::string& sentence) {
    scene::Diagnostic said;
    said.severity = severity;
    said.message = sentence;
    if (const scene::Body* body = namedIn(scene, sentence))
        placeAt(body->source, "", said);
    else if (scene.simulator.source)
        for (const char* option : {"-finish", "-accuracy"})
            if (sentence.find(option + 1) != std::string::npos)
                placeAt(*scene.simulator.source, option, said);
    return said;
}

scene::Diagnostic stopAt(const scene::Scene& scene, std::size_t body, const Stop& stop) {
    scene::Diagnostic said;
    said.message = stop.sentence;
    const scene::Source* blamed = stop.culprit ? sourceOf(scene, *stop.culprit) : nullptr;
    if (blamed)
        placeAt(*blamed, stop.culprit->option, said);
    else if (const scene::Body* named = namedIn(scene, stop.sentence))
        placeAt(named->source, "", said);
    else
        placeAt(scene.bodies[body].source, "", said);
    return said;
}

} // namespace

// At a value that the text holds, else at the command.
void placeAt(const scene::Source& source, const std::string& option, scene::Diagnostic& said) {
    if (source.line <= 0)
        return;
    said.range = source.command;
    said.line = said.endLine = source.line;
    said.column = source.column;
    said.endColumn = source.column + 1;
    const auto argument = std::ranges::find(source.arguments, option, &scene::Argument::option);
    if (!option.empty() && argument != source.arguments.end() && argument->word.known())
        said.range = argument->word;
}

std::vector<scene::Diagnostic> reportOf(const scene::Scene& scene, const Motion& motion) {
    std::vector<scene::Diagnostic> report;
    for (const std::string& note : motion.notes())
        report.push_back(placed(scene, scene::Severity::warning, note));
    std::vector<std::string> said;
    for (std::size_t body = 0; body < std::min(motion.bodies(), scene.bodies.size()); ++body) {
        const auto stop = motion.stop(body);
        if (!stop || std::ranges::find(said, stop->sentence) != said.end())
            continue;
        said.push_back(stop->sentence);
        report.push_back(stopAt(scene, body, *stop));
    }
    return report;
}

scene::Diagnostic faultOf(const scene::Scene& scene, const std::string& sentence) {
    return placed(scene, scene::Severity::error, sentence);
}

} // namespace simulation
