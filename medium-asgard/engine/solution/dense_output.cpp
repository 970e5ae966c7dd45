#include "solution/dense_output.h"

namespace solution {

void lines(std::span<Coefficients> columns, const StepEnds& ends) {
    for (std::size_t n = 0; n < columns.size(); ++n) {
        columns[n] = {};
        columns[n][0] = ends.start[n];
        columns[n][1] = ends.end[n] - ends.start[n];
    }
}

void cubics(std::span<Coefficients> columns, const StepEnds& ends) {
    for (std::size_t n = 0; n < columns.size(); ++n) {
        const double rise = ends.end[n] - ends.start[n];
        const double first = ends.h * ends.startSlope[n], last = ends.h * ends.endSlope[n];
        columns[n] = {ends.start[n], first, 3 * rise - 2 * first - last, first + last - 2 * rise};
    }
}

void integratePositions(std::span<Coefficients> columns,
                        std::span<const std::pair<std::size_t, std::size_t>> pairs,
                        const StepEnds& ends) {
    for (const auto& [x, v] : pairs) {
        Coefficients integral{};
        integral[0] = ends.start[x];
        double sum = ends.start[x];
        for (std::size_t power = 0; power < maximumDegree; ++power) {
            integral[power + 1] = ends.h * columns[v][power] / static_cast<double>(power + 1);
            sum += integral[power + 1];
        }
        const double lack = ends.end[x] - sum;
        integral[2] += 3 * lack;
        integral[3] -= 2 * lack;
        columns[x] = integral;
    }
}

} // namespace solution
