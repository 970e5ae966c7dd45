#include "batch/soft_links.h"

#include "motion/known_span.h"
#include "run/quantities.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace batch {
namespace {

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.15g", value);
    return text;
}

std::string listOf(const scene::Vector& v) {
    return "{" + number(v.x()) + " " + number(v.y()) + " " + number(v.z()) + "}";
}

using Place = std::array<std::string, 3>; // expressions

Place placeOf(const scene::BodyEnd& end) {
    if (!end.offset)
        return {end.body + ".x", end.body + ".y", end.body + ".z"};
    const scene::Vector& o = *end.offset;
    const std::string at = "(" + number(o.x()) + "," + number(o.y()) + "," + number(o.z()) + ")";
    return {end.body + ".px" + at, end.body + ".py" + at, end.body + ".pz" + at};
}

Place placeOf(const scene::PointEnd& end) { return end.coordinates; }

Place placeOf(const scene::TrajectoryEnd& end) {
    return {end.trajectory + ".x", end.trajectory + ".y", end.trajectory + ".z"};
}

std::string lengthOf(const scene::Link& link) {
    const Place first = placeOf(link.first);
    const Place second = std::visit([](const auto& end) { return placeOf(end); }, link.second);
    std::string text = "hypot(";
    for (std::size_t i = 0; i < 3; ++i)
        text += (i > 0 ? ",(" : "(") + first[i] + ")-(" + second[i] + ")";
    return text + ")";
}

// The joint that holds the two together; none for a point that moves.
std::string jointFor(const scene::Link& link) {
    std::string text = "joint NAME -type ball -body1 " + link.first.body;
    if (link.first.offset)
        text += " -offset1 " + listOf(*link.first.offset);
    if (const auto* second = std::get_if<scene::BodyEnd>(&link.second))
        text += " -body2 " + second->body;
    return text;
}

} // namespace

std::string softLinkLine(const scene::Scene& scene, const simulation::MotionPointer& motion,
                         double allowed) {
    constexpr int samples = 400;
    std::vector<const scene::Link*> links;
    std::vector<std::string> lengths;
    for (const scene::Link& link : scene.links)
        if (!link.spring && !link.release) {
            links.push_back(&link);
            lengths.push_back(lengthOf(link));
        }
    if (links.empty())
        return "";
    std::vector<std::string> faults;
    const simulation::Quantities stretch(scene, {}, motion, lengths, faults);
    const double start = motion->start(), span = simulation::knownSpan(*motion).computed - start;
    const std::vector<double> first = stretch.at(start);
    std::vector<double> most(links.size(), 0);
    for (int i = 1; i <= samples; ++i) {
        const std::vector<double> now = stretch.at(start + span * i / samples);
        for (std::size_t k = 0; k < links.size(); ++k)
            if (first[k] <= allowed / 10) // and NaN never
                most[k] = std::max(most[k], now[k] - first[k]);
    }
    const auto worst = std::ranges::max_element(most);
    if (!(*worst > allowed))
        return "";
    const scene::Link& link = *links[static_cast<std::size_t>(worst - most.begin())];
    const auto* second = std::get_if<scene::BodyEnd>(&link.second);
    char by[40];
    std::snprintf(by, sizeof by, "%.2g", *worst);
    return "the link of " + std::string(second ? "bodies \"" : "body \"") + link.first.body + "\"" +
           (second ? " and \"" + second->body + "\"" : "") + " (line " +
           std::to_string(link.source.line) + ") stretched by " + by +
           " m; if it is meant as a hinge, a joint does not stretch: " + jointFor(link);
}

} // namespace batch
