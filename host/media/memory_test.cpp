#include "media/scripted_medium.h"

#include "processes/memory.h"

#include <gmock/gmock.h>

#include <unistd.h>

namespace media {
namespace {

using ::testing::HasSubstr;
using testing::scriptedManifest;
using testing::shortLimits;
using testing::waitFor;

constexpr std::size_t mib = 1 << 20;

TEST(Memory, TheLargestGoesWhileAllHoldTooMuch) {
    EXPECT_EQ(tooLarge({}, 0), std::nullopt);
    EXPECT_EQ(tooLarge({3, 4, 3}, 10), std::nullopt);
    EXPECT_EQ(tooLarge({3, 5, 3}, 10), 1u);
    EXPECT_EQ(tooLarge({0, 0, 11}, 10), 2u);
}

TEST(Memory, AnotherOneMayHoldAsMuchAsTheLargest) {
    EXPECT_TRUE(hasRoom({}, 3, 0)); // nothing is known yet
    EXPECT_TRUE(hasRoom({3, 1}, 0, 7));
    EXPECT_FALSE(hasRoom({3, 1}, 0, 6));
    EXPECT_TRUE(hasRoom({3, 1}, 1, 10));
    EXPECT_FALSE(hasRoom({3, 1}, 1, 9));
}

TEST(Memory, IsWhatAProcessHoldsForItself) {
    const std::size_t before = memoryOf(getpid());
    EXPECT_GT(before, mib / 4);
    const std::vector<char> taken(64 * mib, 'x');
    EXPECT_GE(memoryOf(getpid()), before + taken.size() - 4 * mib);
    EXPECT_EQ(memoryOf(-1), 0u);
}

TEST(Memory, AMediumThatTakesTooMuchEndsWithASentenceAndTheOthersLive) {
    PipeThread pipes;
    pipes.setMostMemory(300 * mib);
    TimeLimits limits = shortLimits();
    limits.quiet = limits.hung = 60'000;
    limits.restartsPerMinute = 3; // this one is not started again by itself
    const Manifest manifest = scriptedManifest();
    std::vector<std::unique_ptr<LiveSubdocument>> all;
    for (const char* text : {"behave take 20", "behave take 400", "behave take 30"}) {
        all.push_back(
            std::make_unique<LiveSubdocument>(manifest, programOf(manifest, {}), pipes, limits));
        all.back()->setText(text);
        all.back()->start();
    }
    ASSERT_TRUE(waitFor([&] { return all[1]->condition() == Condition::failed; }));
    EXPECT_THAT(all[1]->reason().toStdString(),
                HasSubstr("all media together held more than 300 MiB of memory, and it held the "
                          "most, "));
    for (const int other : {0, 2}) {
        EXPECT_TRUE(waitFor([&] { return all[other]->hasLoaded(); }));
        EXPECT_EQ(all[other]->condition(), Condition::live);
    }
    EXPECT_EQ(pipes.alive(), 2);
}

} // namespace
} // namespace media
