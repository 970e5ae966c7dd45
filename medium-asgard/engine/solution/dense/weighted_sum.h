// Sums of a method's slopes with the weights of a table's row: the arithmetic of a step that is not
// evaluation, so it is done without what is zero and with sums that stay in registers.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace solution {

struct Term {
    std::size_t stage;
    double weight;
};
using Terms = std::vector<Term>;

// Those weights that are not zero.
[[nodiscard]] inline Terms termsOf(std::span<const double> weights) {
    Terms terms;
    for (std::size_t stage = 0; stage < weights.size(); ++stage)
        if (weights[stage] != 0)
            terms.push_back({stage, weights[stage]});
    return terms;
}

// Two numbers that are added and multiplied at once: what every processor has.
using Pair = double __attribute__((vector_size(16)));

[[nodiscard]] inline Pair pairAt(const double* values) {
    Pair pair;
    std::memcpy(&pair, values, sizeof pair);
    return pair;
}
// By value: a sum whose address is taken would go through memory, term by term.
inline void put(double* to, Pair pair) { std::memcpy(to, &pair, sizeof pair); }

template <std::size_t Width, std::size_t... I>
inline void weightedPairs(std::span<const Term> terms, const double* slopes, std::size_t stride,
                          double* out, std::index_sequence<I...>) {
    [[maybe_unused]] Pair sum[Width < 2 ? 1 : Width / 2]; // none, of one number
    ((sum[I] = Pair{}), ...);
    double last = 0;
    for (const Term& term : terms) {
        const double* slope = slopes + term.stage * stride;
        const Pair weight = {term.weight, term.weight};
        ((sum[I] += weight * pairAt(slope + 2 * I)), ...);
        if constexpr (Width % 2 == 1)
            last += term.weight * slope[Width - 1];
    }
    (put(out + 2 * I, sum[I]), ...);
    if constexpr (Width % 2 == 1)
        out[Width - 1] = last;
}

// out[i] = sum of weight * slopes[stage * stride + i] in the order of the terms, for i < Width.
template <std::size_t Width>
inline void weightedBlock(std::span<const Term> terms, const double* slopes, std::size_t stride,
                          double* out) {
    weightedPairs<Width>(terms, slopes, stride, out, std::make_index_sequence<Width / 2>());
}

// The same for any number from the first on, eight at a time, and the rest.
inline void weightedBlocks(std::span<const Term> terms, const double* slopes, std::size_t stride,
                           double* out, std::size_t first = 0) {
    std::size_t i = first;
    for (; i + 8 <= stride; i += 8)
        weightedBlock<8>(terms, slopes + i, stride, out + i);
    if (stride - i >= 4) {
        weightedBlock<4>(terms, slopes + i, stride, out + i);
        i += 4;
    }
    if (stride - i >= 2) {
        weightedBlock<2>(terms, slopes + i, stride, out + i);
        i += 2;
    }
    if (i < stride)
        weightedBlock<1>(terms, slopes + i, stride, out + i);
}

#if defined(__x86_64__)
// Four at once, where the processor has that: the same sums.
using Four = double __attribute__((vector_size(32)));

__attribute__((target("avx"), always_inline)) inline Four fourAt(const double* values) {
    Four four;
    std::memcpy(&four, values, sizeof four);
    return four;
}
__attribute__((target("avx"), always_inline)) inline void put(double* to, Four four) {
    std::memcpy(to, &four, sizeof four);
}

template <std::size_t Width, std::size_t... I>
__attribute__((target("avx"))) inline void weightedFours(std::span<const Term> terms,
                                                         const double* slopes, double* out,
                                                         std::index_sequence<I...>) {
    constexpr std::size_t first = Width / 4 * 4;
    Four sum[Width / 4];
    ((sum[I] = Four{}), ...);
    Pair two = {};
    double last = 0;
    for (const Term& term : terms) {
        const double* slope = slopes + term.stage * Width;
        const Four weight = {term.weight, term.weight, term.weight, term.weight};
        ((sum[I] += weight * fourAt(slope + 4 * I)), ...);
        if constexpr (Width % 4 >= 2)
            two += Pair{term.weight, term.weight} * pairAt(slope + first);
        if constexpr (Width % 2 == 1)
            last += term.weight * slope[Width - 1];
    }
    (put(out + 4 * I, sum[I]), ...);
    if constexpr (Width % 4 >= 2)
        put(out + first, two);
    if constexpr (Width % 2 == 1)
        out[Width - 1] = last;
}

// Values from sums: out = start + h * sum.
struct FromStart {
    const double* start;
    double h;
};

template <std::size_t... I>
__attribute__((target("avx"))) inline void
fourBlock(std::span<const Term> terms, const double* slopes, std::size_t stride,
          const FromStart* from, std::size_t first, double* out, std::index_sequence<I...>) {
    Four sum[sizeof...(I)];
    ((sum[I] = Four{}), ...);
    for (const Term& term : terms) {
        const double* slope = slopes + term.stage * stride + first;
        const Four weight = {term.weight, term.weight, term.weight, term.weight};
        ((sum[I] += weight * fourAt(slope + 4 * I)), ...);
    }
    if (from) {
        const Four h = {from->h, from->h, from->h, from->h};
        ((sum[I] = fourAt(from->start + first + 4 * I) + h * sum[I]), ...);
    }
    (put(out + first + 4 * I, sum[I]), ...);
}
// Of as many as come in fours; how many these are. Without `from` the sums themselves.
__attribute__((target("avx"))) inline std::size_t fourBlocks(std::span<const Term> terms,
                                                             const double* slopes,
                                                             std::size_t stride,
                                                             const FromStart* from, double* out) {
    std::size_t i = 0;
    for (; i + 32 <= stride; i += 32)
        fourBlock(terms, slopes, stride, from, i, out, std::make_index_sequence<8>());
    for (; i + 4 <= stride; i += 4)
        fourBlock(terms, slopes, stride, from, i, out, std::make_index_sequence<1>());
    return i;
}

[[nodiscard]] inline bool takesFour() {
    static const bool takes = __builtin_cpu_supports("avx") != 0;
    return takes;
}
#endif

// Of any number.
inline void weightedMany(std::span<const Term> terms, const double* slopes, std::size_t stride,
                         double* out) {
    std::size_t first = 0;
#if defined(__x86_64__)
    if (takesFour())
        first = fourBlocks(terms, slopes, stride, nullptr, out);
#endif
    weightedBlocks(terms, slopes, stride, out, first);
}

// out = start + h * sum, of any number.
inline void advanceMany(std::span<const Term> terms, const double* slopes, std::size_t stride,
                        const double* start, double h, double* out) {
    std::size_t first = 0;
#if defined(__x86_64__)
    const FromStart from{start, h};
    if (takesFour())
        first = fourBlocks(terms, slopes, stride, &from, out);
#endif
    weightedBlocks(terms, slopes, stride, out, first);
    for (; first < stride; ++first)
        out[first] = start[first] + h * out[first];
}

// Of `Width` unknowns, where the compiler may know how many; 0: of any number.
template <std::size_t Width>
inline void weightedSumOf(std::span<const Term> terms, const double* slopes, std::size_t stride,
                          double* out) {
#if defined(__x86_64__)
    if constexpr (Width >= 6)
        if (takesFour())
            return weightedFours<Width>(terms, slopes, out, std::make_index_sequence<Width / 4>());
#endif
    if constexpr (Width == 0)
        weightedMany(terms, slopes, stride, out);
    else
        weightedBlock<Width>(terms, slopes, Width, out);
}

// out[i] for i < stride.
inline void weightedSum(std::span<const Term> terms, const double* slopes, std::size_t stride,
                        double* out) {
    switch (stride) { // known to the compiler, in small components
    case 1:
        return weightedBlock<1>(terms, slopes, 1, out);
    case 2:
        return weightedBlock<2>(terms, slopes, 2, out);
    case 3:
        return weightedBlock<3>(terms, slopes, 3, out);
    case 4:
        return weightedBlock<4>(terms, slopes, 4, out);
    default:
        return weightedMany(terms, slopes, stride, out);
    }
}

} // namespace solution
