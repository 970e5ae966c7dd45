#include "collision/polynomial.h"

#include <algorithm>
#include <cmath>

namespace collision {

double Polynomial::value(double s) const {
    double sum = 0;
    for (std::size_t k = count; k-- > 0;)
        sum = sum * s + terms[k];
    return sum;
}

double Polynomial::derivative(double s) const {
    double sum = 0;
    for (std::size_t k = count; k-- > 1;)
        sum = sum * s + static_cast<double>(k) * terms[k];
    return sum;
}

namespace {

using Bernstein = std::array<double, maximumTerms>;

// b_i = sum over k <= i of C(i,k)/C(n,k) a_k, for s scaled to 0..1.
Bernstein toBernstein(const Polynomial& p, double length) {
    const std::size_t n = p.count - 1;
    Bernstein scaled{}, result{};
    double power = 1;
    for (std::size_t k = 0; k <= n; ++k, power *= length)
        scaled[k] = p.terms[k] * power;
    for (std::size_t i = 0; i <= n; ++i) {
        double ratio = 1; // C(i,k)/C(n,k)
        for (std::size_t k = 0; k <= i; ++k) {
            result[i] += ratio * scaled[k];
            ratio *=
                static_cast<double>(i - k) / static_cast<double>(std::max(n - k, std::size_t{1}));
        }
    }
    return result;
}

struct Search {
    const Polynomial& polynomial;
    const std::function<double(double)>& exact;
    double length;

    [[nodiscard]] double value(double s) const { return exact ? exact(s) : polynomial.value(s); }

    // Exactly one change of sign, from positive to negative.
    [[nodiscard]] double refine(double low, double high) const {
        double s = low + (high - low) / 2;
        for (int i = 0; i < 200; ++i) {
            const double v = value(s);
            (v >= 0 ? low : high) = s;
            const double slope = polynomial.derivative(s);
            double next = slope < 0 ? s - v / slope : low;
            if (!(next > low && next < high))
                next = low + (high - low) / 2;
            // Newton creeps towards a root that is nearly double; halving does not.
            if (i > 20 && i % 2)
                next = low + (high - low) / 2;
            if (std::abs(next - s) <= 1e-16 * std::abs(s) || next == low || next == high || v == 0)
                return v == 0 ? s : next;
            s = next;
        }
        return s;
    }

    [[nodiscard]] std::optional<double> first(const Bernstein& b, std::size_t n, double low,
                                              double high, int depth) const {
        int changes = 0;
        int side = 1; // what was before: not negative
        std::size_t i = 0;
        while (i <= n && b[i] == 0)
            ++i;
        if (i > n)
            return std::nullopt;
        if (b[i] < 0)
            return low;
        for (; i <= n; ++i)
            if (b[i] != 0 && (b[i] > 0 ? 1 : -1) != side) {
                side = -side;
                ++changes;
            }
        if (changes == 0)
            return std::nullopt;
        if (changes == 1)
            return refine(low, high);
        if (depth == 0) // a touch within rounding
            return std::nullopt;
        return inHalves(b, n, low, high, depth);
    }

    [[nodiscard]] std::optional<double> inHalves(const Bernstein& b, std::size_t n, double low,
                                                 double high, int depth) const {
        Bernstein left = b, right{};
        for (std::size_t k = 0; k <= n; ++k) { // de Casteljau
            right[n - k] = left[n];
            for (std::size_t i = n; i > k; --i)
                left[i] = (left[i - 1] + left[i]) / 2;
        }
        const double middle = low + (high - low) / 2;
        if (const auto found = first(left, n, low, middle, depth - 1))
            return found;
        return first(right, n, middle, high, depth - 1);
    }
};

} // namespace

std::optional<double> firstDescent(const Polynomial& polynomial, double length,
                                   const std::function<double(double)>& value) {
    const Search search{polynomial, value, length};
    return search.first(toBernstein(polynomial, length), polynomial.count - 1, 0, length, 60);
}

} // namespace collision
