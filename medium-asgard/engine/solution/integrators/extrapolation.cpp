#include "integrators/extrapolation.h"

#include <array>

namespace solution {

namespace {

constexpr std::array<std::size_t, 4> parts = {2, 6, 10, 14};
constexpr std::size_t stages = 1 + 1 + 5 + 9 + 13;

using Weights = std::vector<double>; // of the slopes k; times h

void add(Weights& to, double factor, const Weights& from) {
    for (std::size_t i = 0; i < from.size(); ++i)
        to[i] += factor * from[i];
}

// The stage at which column j's point i is evaluated: point 0 is the step's start for all.
std::size_t stageOf(std::size_t column, std::size_t point) {
    std::size_t first = 1;
    for (std::size_t j = 0; j < column; ++j)
        first += parts[j] - 1;
    return point == 0 ? 0 : first + point - 1;
}

// z_1 = y + h f_0 / n,  z_{i+1} = z_{i-1} + 2 h f_i / n
std::vector<Weights> pointsOf(std::size_t column) {
    const double n = static_cast<double>(parts[column]);
    std::vector<Weights> z(parts[column] + 1, Weights(stages, 0.0));
    z[1][0] = 1 / n;
    for (std::size_t i = 1; i < parts[column]; ++i) {
        z[i + 1] = z[i - 1];
        z[i + 1][stageOf(column, i)] += 2 / n;
    }
    return z;
}

// The value at no step length of the polynomial in 1/n^2 through columns first, ..., last.
Weights extrapolate(const std::array<Weights, 4>& columns, std::size_t first, std::size_t last) {
    Weights result(stages, 0.0);
    for (std::size_t j = first; j <= last; ++j) {
        double factor = 1;
        for (std::size_t i = first; i <= last; ++i)
            if (i != j) {
                const double ni = static_cast<double>(parts[i] * parts[i]);
                const double nj = static_cast<double>(parts[j] * parts[j]);
                factor *= nj / (nj - ni);
            }
        add(result, factor, columns[j]);
    }
    return result;
}

Weights slope(std::size_t stage) {
    Weights w(stages + 1, 0.0);
    w[stage] = 1;
    return w;
}

// The polynomial of degree 7 in r = s - 1/2 with given value, first three derivatives in the
// middle, and values and slopes at both ends; all over y at the start. Powers 4 to 7 from the ends:
// even and odd parts are separate.
std::vector<Weights> denseOf(const std::array<Weights, 4>& middle, const Weights& end) {
    std::vector<Weights> r(8, Weights(stages + 1, 0.0));
    for (std::size_t power = 0; power < 4; ++power)
        add(r[power], power == 2 ? 0.5 : power == 3 ? 1.0 / 6 : 1, middle[power]);
    Weights even(stages + 1, 0.0), odd = even, evenSlope = even, oddSlope = even;
    add(even, 0.5, end); // of the values 0 and `end`
    add(odd, 0.5, end);
    for (const double sign : {-1.0, 1.0}) { // slopes at both ends
        add(oddSlope, 0.5, slope(sign < 0 ? 0 : stages));
        add(evenSlope, 0.5 * sign, slope(sign < 0 ? 0 : stages));
    }
    add(even, -1, r[0]);
    add(even, -1.0 / 4, r[2]);
    add(evenSlope, -1, r[2]);
    add(odd, -1.0 / 2, r[1]);
    add(odd, -1.0 / 8, r[3]);
    add(oddSlope, -1, r[1]);
    add(oddSlope, -3.0 / 4, r[3]);
    // a/16 + b/64 = even, a/2 + 3b/16 = evenSlope, and the same with r more for the odd.
    add(r[4], 48, even);
    add(r[4], -4, evenSlope);
    add(r[6], -128, even);
    add(r[6], 16, evenSlope);
    add(r[5], 112, odd);
    add(r[5], -8, oddSlope);
    add(r[7], -320, odd);
    add(r[7], 32, oddSlope);
    return r;
}

// From powers of s - 1/2 to powers of s; by stage, power 0 (which is zero) left out.
std::vector<std::vector<double>> byStage(const std::vector<Weights>& r) {
    std::vector<std::vector<double>> dense;
    for (std::size_t stage = 0; stage <= stages; ++stage) {
        std::vector<double> p(8, 0.0);
        for (std::size_t power = 8; power-- > 0;) { // Horner: p = p (s - 1/2) + r
            for (std::size_t k = 8; k-- > 1;)
                p[k] = p[k - 1] - 0.5 * p[k];
            p[0] = -0.5 * p[0] + r[power][stage];
        }
        dense.emplace_back(p.begin() + 1, p.end());
    }
    return dense;
}

} // namespace

Tableau makeExtrapolation() {
    Tableau t{.name = "gbs", .order = 8, .stages = stages};
    t.a.assign(1, {});
    t.c.assign(1, 0);
    std::array<Weights, 4> ends, values, second, third, first;
    for (std::size_t j = 0; j < parts.size(); ++j) {
        const std::vector<Weights> z = pointsOf(j);
        const std::size_t middle = parts[j] / 2;
        const double n = static_cast<double>(parts[j]);
        for (std::size_t i = 1; i < parts[j]; ++i) {
            t.a.emplace_back(z[i].begin(),
                             z[i].begin() + static_cast<std::ptrdiff_t>(stageOf(j, i)));
            t.c.push_back(static_cast<double>(i) / n);
        }
        ends[j] = z.back();
        values[j] = z[middle];
        first[j] = second[j] = third[j] = Weights(stages, 0.0);
        first[j][stageOf(j, middle)] = 1;
        if (j == 0) // differences begin with the second column
            continue;
        second[j][stageOf(j, middle + 1)] = n / 2;
        second[j][stageOf(j, middle - 1)] = -n / 2;
        third[j][stageOf(j, middle + 2)] = third[j][stageOf(j, middle - 2)] = n * n / 4;
        third[j][stageOf(j, middle)] = -n * n / 2;
    }
    const Weights end = extrapolate(ends, 0, 3), rough = extrapolate(ends, 1, 3);
    t.a.push_back(end);
    t.c.push_back(1);
    t.error = Weights(stages, 0.0);
    add(t.error, 1, end);
    add(t.error, -1, rough);
    t.dense = byStage(denseOf({extrapolate(values, 0, 3), extrapolate(first, 0, 3),
                               extrapolate(second, 1, 3), extrapolate(third, 1, 3)},
                              end));
    return t;
}

} // namespace solution
