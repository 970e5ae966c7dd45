// Sums of slopes are the same bits for any number of unknowns, however many are added at once.
#include "dense/weighted_sum.h"

#include <gtest/gtest.h>

#include <random>

using namespace solution;

namespace {

std::vector<double> oneByOne(const Terms& terms, const std::vector<double>& slopes,
                             std::size_t size) {
    std::vector<double> sums(size, 0.0);
    for (std::size_t i = 0; i < size; ++i)
        for (const Term& term : terms)
            sums[i] += term.weight * slopes[term.stage * size + i];
    return sums;
}

template <std::size_t Size>
void check(const Terms& terms, std::mt19937& random, std::size_t stages) {
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<double> slopes(stages * Size), out(Size), any(Size);
    for (double& slope : slopes)
        slope = number(random);
    weightedSumOf<Size>(terms, slopes.data(), Size, out.data());
    weightedSum(terms, slopes.data(), Size, any.data());
    EXPECT_EQ(out, oneByOne(terms, slopes, Size)) << Size;
    EXPECT_EQ(any, out) << Size;
    std::vector<double> advanced(Size);
    const std::vector<double> start(Size, 0.7);
    advanceMany(terms, slopes.data(), Size, start.data(), 0.3, advanced.data());
    for (std::size_t i = 0; i < Size; ++i)
        EXPECT_EQ(advanced[i], start[i] + 0.3 * out[i]) << Size;
}

} // namespace

TEST(WeightedSum, HasTheSameBitsHoweverManyAreAddedAtOnce) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    for (std::size_t stages = 0; stages < 13; ++stages) {
        std::vector<double> weights(stages);
        for (std::size_t i = 0; i < stages; ++i)
            weights[i] = i % 4 == 3 ? 0 : number(random);
        const Terms terms = termsOf(weights);
        EXPECT_EQ(terms.size(), stages - stages / 4);
        [&]<std::size_t... Size>(std::index_sequence<Size...>) {
            (check<Size + 1>(terms, random, stages), ...);
        }
        (std::make_index_sequence<24>());
        check<31>(terms, random, stages);
        check<32>(terms, random, stages);
        check<71>(terms, random, stages);
    }
}
