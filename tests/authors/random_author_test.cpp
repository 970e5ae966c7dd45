#include "authors/random_author.h"

#include <gtest/gtest.h>

namespace authors {

// One percent of the run at length (write_at_length): the same seeds, in pieces of 100 commands.
TEST(Authoring, RandomCommandsKeepDocumentsValid) {
    std::size_t steps = 0, replaced = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        RandomAuthor author(seed);
        ASSERT_EQ(author.write(100), "") << "seed " << seed;
        steps += author.tally().steps;
        replaced += author.tally().replaced;
    }
    EXPECT_GT(steps, 5'000u);         // of 10,000: not most of them are refused
    EXPECT_LT(replaced, steps * 100); // bytes: what was edited, not the document
}

// Whatever a document holds, commands neither crash nor leave what cannot be undone.
TEST(Authoring, RandomCommandsSurviveAnyDocument) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        RandomAuthor author(seed);
        const std::string any = author.anyDocument();
        ASSERT_EQ(author.write(30, any), "") << "seed " << seed;
    }
}

} // namespace authors
