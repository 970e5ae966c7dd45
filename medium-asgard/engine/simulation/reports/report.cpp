#include "reports/report.h"

#include "reports/place_at.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <string_view>
#include <unordered_map>

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

using Names = std::unordered_map<std::string_view, std::size_t>;

Names namesOf(const scene::Scene& scene) {
    Names names;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
        names.emplace(scene.bodies[body].name, body);
    return names;
}

// The bodies whose names a sentence quotes, in its order.
std::vector<std::size_t> namedIn(const Names& names, std::string_view sentence) {
    std::vector<std::size_t> named;
    std::size_t from = sentence.find('"');
    while (from != std::string_view::npos) {
        const std::size_t to = sentence.find('"', from + 1);
        if (to == std::string_view::npos)
            return named;
        const auto body = names.find(sentence.substr(from + 1, to - from - 1));
        if (body != names.end())
            named.push_back(body->second);
        from = body == names.end() ? to : sentence.find('"', to + 1);
    }
    return named;
}

template <typename Element>
const scene::Source* sourceIn(const std::vector<Element>& all, const std::string& word,
                              const std::string& sentence) {
    for (const Element& element : all)
        if (sentence.find(word + " \"" + element.name + "\":") != std::string::npos)
            return &element.source;
    return nullptr;
}

// The joint, gear or rope that a sentence is about: joint "pin": ..., -speed of joint "pin": ...
const scene::Source* conditionIn(const scene::Scene& scene, const std::string& sentence) {
    if (const auto* joint = sourceIn(scene.joints, "joint", sentence))
        return joint;
    if (const auto* gear = sourceIn(scene.gears, "gear", sentence))
        return gear;
    return sourceIn(scene.ropes, "rope", sentence);
}

scene::Diagnostic placed(const scene::Scene& scene, const Names& names, scene::Severity severity,
                         const std::string& sentence) {
    scene::Diagnostic said;
    said.severity = severity;
    said.message = sentence;
    if (const scene::Source* element = conditionIn(scene, sentence))
        placeAt(*element, sentence.starts_with('-') ? sentence.substr(0, sentence.find(' ')) : "",
                said);
    else if (const auto named = namedIn(names, sentence); !named.empty())
        placeAt(scene.bodies[named[0]].source, "", said);
    else if (scene.simulator.source)
        for (const char* option : {"-finish", "-accuracy"})
            if (sentence.find(option + 1) != std::string::npos)
                placeAt(*scene.simulator.source, option, said);
    return said;
}

scene::Diagnostic stopAt(const scene::Scene& scene, const Names& names, std::size_t body,
                         const Stop& stop) {
    scene::Diagnostic said;
    said.message = stop.sentence;
    said.time = stop.time;
    const scene::Source* blamed = stop.culprit ? sourceOf(scene, *stop.culprit) : nullptr;
    if (blamed)
        placeAt(*blamed, stop.culprit->option, said);
    else if (const auto named = namedIn(names, stop.sentence); !named.empty())
        placeAt(scene.bodies[named[0]].source, "", said);
    else
        placeAt(scene.bodies[body].source, "", said);
    return said;
}

// Bodies that stop for one reason, and those that stop since these did: one fault.
struct Fault {
    std::size_t body; // the first of them
    Stop stop;
    std::string reason; // without the names of bodies
    std::vector<std::size_t> alike, following;
};

// The sentence without times and the names of bodies.
std::string reasonOf(const scene::Scene& scene, const Names& names, const Stop& stop) {
    std::string reason =
        stop.sentence.substr(std::min(stop.sentence.find(": "), stop.sentence.size()));
    for (const std::size_t body : namedIn(names, reason)) {
        const std::string name = '"' + scene.bodies[body].name + '"';
        reason.replace(reason.find(name), name.size(), "*");
    }
    return reason;
}

// By body that stopped: who stopped before, of those that it met; itself: it met none.
std::vector<std::size_t> causesOf(const Names& names, const Motion& motion) {
    std::vector<std::size_t> causes(motion.bodies());
    for (std::size_t body = 0; body < causes.size(); ++body) {
        causes[body] = body;
        const auto stop = motion.stop(body);
        if (!stop || stop->sentence.find("whose motion stopped") == std::string::npos)
            continue;
        for (const std::size_t other : namedIn(names, stop->sentence))
            if (const auto ended = motion.stop(other);
                other != body && ended && ended->time <= stop->time)
                causes[body] = other;
    }
    for (std::size_t& cause : causes)
        for (std::size_t steps = 0; steps < causes.size() && causes[cause] != cause; ++steps)
            cause = causes[cause];
    return causes;
}

std::string listOf(const scene::Scene& scene, const std::vector<std::size_t>& bodies) {
    constexpr std::size_t most = 5;
    const std::size_t told = bodies.size() > most ? most - 1 : bodies.size();
    std::string list;
    for (std::size_t i = 0; i < told; ++i)
        list += (i == 0 ? "\"" : ", \"") + scene.bodies[bodies[i]].name + "\"";
    if (told < bodies.size())
        list += " and " + std::to_string(bodies.size() - told) + " others";
    return list;
}

// " The same stops 3 more bodies: ..., the last at t = 2."
std::string alsoStopped(const scene::Scene& scene, const Motion& motion, const std::string& what,
                        const std::vector<std::size_t>& bodies) {
    if (bodies.empty())
        return "";
    double last = 0;
    for (const std::size_t body : bodies)
        last = std::max(last, motion.stop(body)->time);
    char when[40];
    std::snprintf(when, sizeof when, "%.6g", last);
    return " " + what + " " + std::to_string(bodies.size()) +
           (bodies.size() == 1 ? " more body: " : " more bodies: ") + listOf(scene, bodies) +
           (bodies.size() == 1 ? ", at t = " : ", the last at t = ") + when + ".";
}

std::vector<Fault> faultsOf(const scene::Scene& scene, const Names& names, const Motion& motion) {
    std::vector<Fault> faults;
    const std::vector<std::size_t> causes = causesOf(names, motion);
    std::map<std::size_t, std::size_t> faultOfBody;
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        const auto stop = motion.stop(body);
        if (!stop || causes[body] != body)
            continue;
        const std::string reason = reasonOf(scene, names, *stop);
        const auto known = std::ranges::find_if(faults, [&](const Fault& fault) {
            return fault.reason == reason && fault.stop.culprit == stop->culprit;
        });
        faultOfBody[body] = static_cast<std::size_t>(known - faults.begin());
        if (known == faults.end())
            faults.push_back({body, *stop, reason, {}, {}});
        else if (stop->sentence != known->stop.sentence)
            known->alike.push_back(body);
    }
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
        if (const auto fault = faultOfBody.find(causes[body]);
            causes[body] != body && fault != faultOfBody.end())
            faults[fault->second].following.push_back(body);
    return faults;
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
    const Names names = namesOf(scene);
    for (const std::string& note : motion.notes())
        report.push_back(placed(scene, names, scene::Severity::warning, note));
    if (motion.bodies() != scene.bodies.size()) // of another version of the scene
        return report;
    for (const Fault& fault : faultsOf(scene, names, motion)) {
        Stop stop = fault.stop;
        stop.sentence +=
            alsoStopped(scene, motion, "The same stops", fault.alike) +
            alsoStopped(scene, motion, "A meeting with a stopped body stops", fault.following);
        report.push_back(stopAt(scene, names, fault.body, stop));
    }
    return report;
}

scene::Diagnostic faultOf(const scene::Scene& scene, const std::string& sentence) {
    return placed(scene, namesOf(scene), scene::Severity::error, sentence);
}

} // namespace simulation
