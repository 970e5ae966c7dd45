#include "accuracy/close_impacts.h"

#include <cmath>
#include <limits>

namespace simulation {
namespace {

constexpr double few = 4;          // errors
constexpr double samePlace = 1e-3; // of the body's radius

// The last hit of a body that could matter.
struct Hit {
    double time = -std::numeric_limits<double>::infinity();
    std::size_t by = 0;
    Vector point = Vector::Zero();
};

} // namespace

std::vector<bool> hasCloseImpacts(const Problem& problem, const Run& run,
                                  const std::vector<BodyError>& errors,
                                  const std::vector<double>& sizes) {
    const std::size_t bodies = errors.size();
    std::vector<bool> isClose(bodies), islands(bodies);
    std::vector<Hit> last(bodies);
    for (const Impact& impact : run.impacts) {
        for (const auto& [body, by] :
             {std::pair(impact.first, impact.second), {impact.second, impact.first}}) {
            const BodyRecord& record = (*problem.bodies)[body];
            if (record.isFixed || !run.isIntegrated[body])
                continue;
            const double size = sizes[body], speed = impact.impulse / record.mass;
            if (speed * (problem.finish() - impact.time) < problem.accuracy() * size)
                continue;
            Hit& before = last[body];
            const double apart = impact.time - before.time;
            const bool isOther =
                by != before.by || (impact.point - before.point).norm() > samePlace * record.radius;
            if (isOther && apart > 0 && apart * speed < few * errors[body].estimate * size)
                islands[run.island[body]] = true;
            before = {.time = impact.time, .by = by, .point = impact.point};
        }
    }
    for (std::size_t b = 0; b < bodies; ++b)
        isClose[b] = islands[run.island[b]];
    return isClose;
}

} // namespace simulation
