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

// The same for any number, eight at a time, and the rest.
inline void weightedBlocks(std::span<const Term> terms, const double* slopes, std::size_t stride,
                           double* out) {
    std::size_t i = 0;
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
[[nodiscard]] inline bool takesFour() {
    static const bool takes = __builtin_cpu_supports("avx") != 0;
    return takes;
}
#endif

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
        weightedBlocks(terms, slopes, stride, out);
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
        return weightedBlocks(terms, slopes, stride, out);
    }
}

} // namespace solution
