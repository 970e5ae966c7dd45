#include "run/run.h"

#include "motion/groups.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace simulation {

std::vector<std::size_t> islandsOf(const Problem& problem, const Impacts& impacts,
                                   const ContactLog& contacts,
                                   const std::vector<collision::Pair>& blocked) {
    Groups groups(problem.readers);
    const auto join = [&](std::size_t first, std::size_t second) {
        if (!(*problem.bodies)[first].isFixed && !(*problem.bodies)[second].isFixed)
            groups.join(first, second);
    };
    for (const Impact& impact : impacts)
        join(impact.first, impact.second);
    for (const auto& entry : contacts.entries())
        for (const ContactLog::Contact& contact : entry->contacts)
            join(contact.bodies.first, contact.bodies.second);
    for (const auto& [first, second] : blocked)
        groups.join(first, second);
    return groups.roots();
}

BodyError worse(const BodyError& first, const BodyError& second) {
    BodyError error = first.estimate >= second.estimate ? first : second;
    error.predictableUntil = std::min(first.predictableUntil, second.predictableUntil);
    return error;
}

std::string shortfallOf(double accuracy, const BodyError& error) {
    char text[280], from[40] = "";
    const bool hasHorizon = std::isfinite(error.predictableUntil);
    if (hasHorizon && error.estimate > unpredictable) {
        std::snprintf(text, sizeof text,
                      "From t = %.4g on the motion is not predictable to %.3g of its size, since "
                      "it amplifies even rounding beyond that; a looser accuracy is kept for "
                      "longer, a tighter one for less long.",
                      error.predictableUntil, accuracy);
        return text;
    }
    if (hasHorizon)
        std::snprintf(from, sizeof from, " from t = %.4g on", error.predictableUntil);
    const bool isByHops = error.lostHops > error.estimate / 2;
    std::snprintf(text, sizeof text,
                  isByHops
                      ? "An accuracy of %.3g is not reached%s: where bouncing ends, the engine "
                        "leaves out the last hops, up to about %.1g of its size high."
                      : "An accuracy of %.3g is not reached%s: rounding, which the motion "
                        "amplifies, leaves an error of about %.1g of its size.",
                  accuracy, from, isByHops ? error.lostHops : error.estimate);
    return text;
}

ComputedMotion::Part partOf(const Problem& problem, const Run& run) {
    ComputedMotion::Part part{problem.bodies, run.histories};
    if (run.histories && run.equations && solution::ConditionReader::isWanted(*run.equations)) {
        part.equations = run.equations;
        part.contacts = run.contacts;
        part.conditions = std::make_shared<const solution::ConditionReader>(
            run.equations, problem.start(), problem.prepared->how.models, run.histories);
    }
    return part;
}

MotionPointer Run::motion(const Problem& problem, bool draft,
                          const std::optional<BodyError>& error) const {
    std::vector<ComputedMotion::Place> places(problem.bodies->size());
    for (std::size_t b = 0; b < places.size(); ++b)
        places[b] = {.part = 0, .body = b};
    std::vector<std::string> told = notes;
    if (error && error->estimate > problem.accuracy())
        told.push_back(shortfallOf(problem.accuracy(), *error));
    std::optional<double> estimate, until;
    if (error)
        estimate = error->estimate;
    if (error && std::isfinite(error->predictableUntil))
        until = error->predictableUntil;
    return std::make_shared<ComputedMotion>(
        ComputedMotion::Contents{.start = problem.start(),
                                 .finish = problem.finish(),
                                 .draft = draft,
                                 .parts = {partOf(problem, *this)},
                                 .places = std::move(places),
                                 .stops = stops,
                                 .impacts = impacts,
                                 .notes = std::move(told),
                                 .errorEstimate = estimate,
                                 .predictableUntil = until});
}

} // namespace simulation
