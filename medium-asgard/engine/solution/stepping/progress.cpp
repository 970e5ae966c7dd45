#include "stepping/progress.h"

namespace solution {

void Progress::normalize() {
    for (const auto& four : quaternions) {
        double square = 0;
        for (const std::size_t place : four)
            square += values[place] * values[place];
        if (square == 1 || !(square > 0) || !std::isfinite(square))
            continue;
        const double length = std::sqrt(square);
        for (const std::size_t place : four)
            values[place] /= length;
    }
}

} // namespace solution
