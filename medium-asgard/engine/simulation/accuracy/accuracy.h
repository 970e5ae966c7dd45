// How far apart are two runs of one scene? The measure of the accuracy that is promised.
//
// Position error of a body at a time: the largest of the distance of the centres of mass, (angle
// between the attitudes) x (radius of the body), and how far the attitudes move each point of a
// joint outside the body apart: a motion that is shown stands on its joints, and an arm turns
// errors of attitudes into errors of places.
// It is scaled by the size of what moves together (an island), which is never larger than the
// scene: the longest edge of the box that holds the island's bodies, bounding spheres included,
// over the motion. Each edge is that of the whole motion, within steps too, but for some hundredths
// of it. LIMIT: where a joint slides, its point is that of the start.
#pragma once

#include "run/run.h"

#include <utility>
#include <vector>

namespace simulation {

struct IslandError {
    double size = 0;
    double far = 0;        // the largest distance from the origin along an axis
    double largest = 0;    // scaled
    double early = 0;      // the largest in the first quarter of the time
    std::size_t steps = 0; // of the second run, the most that one of its components has
    // How it grows, where it exceeds what compareRuns() was told: times, and the largest scaled
    // error up to then.
    std::vector<std::pair<double, double>> growth;
    bool moves = true; // some body of it, in either run

    // The first time at which the scaled error exceeds `limit`; infinity: never.
    [[nodiscard]] double beyondFrom(double limit) const;
};

// By body: the error of its island (bodies of one island share it). Compared at the steps of the
// second run, at their ends and middles in turn, as far as both are known; of a body that stops,
// without the last hundredth; where integration ends in one run a hundredth before it does in the
// other, if at all, they are the whole size apart from there on. The growth of errors is told of
// islands where the largest exceeds `limit`. Nothing is said of what the second run took
// from the first.
// `cancelled` is asked once in `comparisonsPerPoll` places that are compared, or oftener. When it
// is cancelled meanwhile the answer says nothing.
inline constexpr std::size_t comparisonsPerPoll = 1024;
[[nodiscard]] std::vector<IslandError> compareRuns(const Problem& problem, const Run& first,
                                                   const Run& second, double limit,
                                                   const std::function<bool()>& cancelled = {});

// A motion at some times, sampled from another one or read from a table: what any motion can be
// compared with. Where a table says nothing of a body or of its attitude, neither is compared.
struct Trace {
    struct Place {
        Vector position = Vector::Zero();
        std::optional<Quaternion> attitude;
    };
    std::vector<double> times;
    std::vector<std::vector<std::optional<Place>>> places; // by time, then by body
};
[[nodiscard]] Trace traceOf(const Motion& motion, std::size_t times);

// The scaled error of a motion against a trace, as the accuracy is: the largest over islands, each
// by its own size in the trace. Infinity where the motion is not known.
[[nodiscard]] double scaledError(const Problem& problem, const std::vector<std::size_t>& island,
                                 const Trace& truth, const Motion& motion);

} // namespace simulation
