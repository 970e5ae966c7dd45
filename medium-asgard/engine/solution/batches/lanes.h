// Numbers side by side: code for one number works on eight at once.
//
// A Wide has one number in each of its lanes; all operations are of each lane by itself and have
// the bits that they have of one number: no multiply-add, comparisons as std::min and std::max make
// them. Where one number would take a branch, `chosen` takes one of two values that both are there.
//
// Eight lanes are two registers of four, so that one works while the other waits. A file
// with this include compiles for AVX (a pragma around the include) and asks areThere() first.
#pragma once

#include <immintrin.h>

#include <cstddef>

namespace solution::lanes {

inline constexpr std::size_t ofBlock = 4, count = 8;

using Four = __m256d;

#define ASGARD_LANES __attribute__((always_inline)) inline

struct Mask {
    Four a, b;
    // A bit for each lane.
    [[nodiscard]] ASGARD_LANES unsigned bits() const {
        return static_cast<unsigned>(_mm256_movemask_pd(a)) |
               static_cast<unsigned>(_mm256_movemask_pd(b)) << ofBlock;
    }
};

struct Wide {
    Four a, b;
    Wide() = default;
    ASGARD_LANES Wide(Four first, Four second) : a(first), b(second) {}
    ASGARD_LANES Wide(double all) : a(_mm256_set1_pd(all)), b(a) {} // NOLINT: as a number is
    ASGARD_LANES Wide& operator+=(const Wide& y) {
        a += y.a;
        b += y.b;
        return *this;
    }
    ASGARD_LANES Wide& operator-=(const Wide& y) {
        a -= y.a;
        b -= y.b;
        return *this;
    }
};

ASGARD_LANES Wide operator+(const Wide& x, const Wide& y) { return {x.a + y.a, x.b + y.b}; }
ASGARD_LANES Wide operator-(const Wide& x, const Wide& y) { return {x.a - y.a, x.b - y.b}; }
ASGARD_LANES Wide operator*(const Wide& x, const Wide& y) { return {x.a * y.a, x.b * y.b}; }
ASGARD_LANES Wide operator/(const Wide& x, const Wide& y) { return {x.a / y.a, x.b / y.b}; }
ASGARD_LANES Wide operator-(const Wide& x) { return {-x.a, -x.b}; }

ASGARD_LANES Mask operator<(const Wide& x, const Wide& y) {
    return {_mm256_cmp_pd(x.a, y.a, _CMP_LT_OQ), _mm256_cmp_pd(x.b, y.b, _CMP_LT_OQ)};
}
ASGARD_LANES Mask operator<=(const Wide& x, const Wide& y) {
    return {_mm256_cmp_pd(x.a, y.a, _CMP_LE_OQ), _mm256_cmp_pd(x.b, y.b, _CMP_LE_OQ)};
}
ASGARD_LANES Mask operator>(const Wide& x, const Wide& y) { return y < x; }
ASGARD_LANES Mask operator>=(const Wide& x, const Wide& y) { return y <= x; }
ASGARD_LANES Mask operator==(const Wide& x, const Wide& y) {
    return {_mm256_cmp_pd(x.a, y.a, _CMP_EQ_OQ), _mm256_cmp_pd(x.b, y.b, _CMP_EQ_OQ)};
}
ASGARD_LANES Mask operator&(const Mask& x, const Mask& y) {
    return {_mm256_and_pd(x.a, y.a), _mm256_and_pd(x.b, y.b)};
}
ASGARD_LANES Mask operator|(const Mask& x, const Mask& y) {
    return {_mm256_or_pd(x.a, y.a), _mm256_or_pd(x.b, y.b)};
}
ASGARD_LANES Mask operator!(const Mask& x) {
    const Four ones = _mm256_cmp_pd(Four{}, Four{}, _CMP_EQ_OQ);
    return {_mm256_xor_pd(x.a, ones), _mm256_xor_pd(x.b, ones)};
}

ASGARD_LANES Wide chosen(const Mask& mask, const Wide& x, const Wide& y) {
    return {_mm256_blendv_pd(y.a, x.a, mask.a), _mm256_blendv_pd(y.b, x.b, mask.b)};
}
ASGARD_LANES Wide max(const Wide& x, const Wide& y) { return chosen(x < y, y, x); }
ASGARD_LANES Wide min(const Wide& x, const Wide& y) { return chosen(y < x, y, x); }
ASGARD_LANES Wide abs(const Wide& x) {
    const Four sign = _mm256_set1_pd(-0.0);
    return {_mm256_andnot_pd(sign, x.a), _mm256_andnot_pd(sign, x.b)};
}
ASGARD_LANES Wide sqrt(const Wide& x) { return {_mm256_sqrt_pd(x.a), _mm256_sqrt_pd(x.b)}; }

} // namespace solution::lanes
