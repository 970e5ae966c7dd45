#include "geometry/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace geometry {

namespace {

// a + b = sum + error, exactly (Knuth).
void twoSum(double a, double b, double& sum, double& error) {
    sum = a + b;
    const double virtualB = sum - a;
    error = (a - (sum - virtualB)) + (b - virtualB);
}

// A sum of doubles of growing size that do not overlap: the exact value of a polynomial in doubles.
// A difference has 2 terms, a product of two differences 8, a minor 16, times a difference 64;
// three of these make the determinant.
class Expansion {
public:
    void add(double term) {
        double carry = term;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            double error = 0;
            twoSum(carry, terms_[i], carry, error);
            if (error != 0)
                terms_[kept++] = error;
        }
        count_ = kept;
        if (carry != 0)
            terms_[count_++] = carry;
    }
    void addProduct(const Expansion& a, const Expansion& b, double sign) {
        for (std::size_t i = 0; i < a.count_; ++i)
            for (std::size_t j = 0; j < b.count_; ++j) {
                const double high = a.terms_[i] * b.terms_[j];
                add(sign * std::fma(a.terms_[i], b.terms_[j], -high));
                add(sign * high);
            }
    }
    [[nodiscard]] int sign() const {
        if (count_ == 0)
            return 0;
        return terms_[count_ - 1] > 0 ? 1 : -1;
    }

private:
    std::array<double, 192> terms_;
    std::size_t count_ = 0;
};

Expansion difference(double a, double b) {
    Expansion e;
    e.add(a);
    e.add(-b);
    return e;
}

int exactOrientation(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
    std::array<std::array<Expansion, 3>, 3> m;
    for (int k = 0; k < 3; ++k) {
        const auto column = static_cast<std::size_t>(k);
        m[0][column] = difference(b[k], a[k]);
        m[1][column] = difference(c[k], a[k]);
        m[2][column] = difference(d[k], a[k]);
    }
    Expansion determinant;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, n = (k + 2) % 3;
        Expansion minor;
        minor.addProduct(m[1][l], m[2][n], 1);
        minor.addProduct(m[1][n], m[2][l], -1);
        determinant.addProduct(m[0][k], minor, 1);
    }
    return determinant.sign();
}

} // namespace

int orientation(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
    const Vector u = b - a, v = c - a, w = d - a;
    const Vector vw = v.cross(w);
    const double determinant = u.dot(vw);
    // Shewchuk's bound for the same formula: (7 + 56 eps) eps times the sum of the magnitudes.
    const Vector magnitude(std::abs(v.y() * w.z()) + std::abs(v.z() * w.y()),
                           std::abs(v.z() * w.x()) + std::abs(v.x() * w.z()),
                           std::abs(v.x() * w.y()) + std::abs(v.y() * w.x()));
    const double bound = 8 * 0x1p-53 * u.cwiseAbs().dot(magnitude);
    if (std::abs(determinant) > bound)
        return determinant > 0 ? 1 : -1;
    return exactOrientation(a, b, c, d);
}

std::vector<Vector> toGrid(const std::vector<Vector>& points) {
    double largest = 0;
    for (const Vector& p : points)
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    int exponent = 0;
    (void)std::frexp(largest, &exponent);
    std::vector<Vector> result(points);
    for (Vector& p : result)
        for (int k = 0; k < 3; ++k)
            p[k] = std::ldexp(std::nearbyint(std::ldexp(p[k], 60 - exponent)), -60);
    return result;
}

} // namespace geometry
