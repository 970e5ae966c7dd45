#include "surfaces/contact_resolution.h"

#include <algorithm>
#include <cmath>

namespace simulation {

ContactResolution resolutionFor(const ContactScales& scales) {
    using namespace resolution;
    const double gap = std::clamp(gapPart * scales.accuracy, leastGap, mostGap);
    const double nudged = scales.isNudged ? nudgedPart : 1;
    const double part = scales.tolerance / scales.firstTolerance;
    const double fine = std::clamp(part * part, finest, 1.0) * nudged;
    const double deep = part < fineBesideDepth
                            ? fineBesideDepth * std::pow(part / fineBesideDepth, 0.25)
                            : std::min(part, 1.0);
    return {.gap = std::max(gap * fine, leastGap),
            .beyond = std::min(gap, gapPart * scales.accuracy) * fine,
            .hopHeight = hopPart * scales.accuracy * fine,
            .depth = besideDepth * deep * nudged};
}

} // namespace simulation
