#include "processes/allowance.h"

#include <gtest/gtest.h>

namespace media {
namespace {

using Clock = Allowance::Clock;
using Message = ipc::Decoded<ipc::ToHost>;

const Clock::time_point start = Clock::now();
Clock::time_point after(double seconds) {
    return start +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

// How many of them, one each `every` seconds, are not yet a flood; at most `most`.
int spent(const Message& message, std::size_t bytes, double every, int most) {
    Allowance allowance;
    for (int count = 0; count < most; ++count)
        if (!allowance.spend(message, bytes, after(count * every)))
            return count;
    return most;
}

Message told(ipc::ToHost call) { return ipc::Told<ipc::ToHost>{std::move(call)}; }
Message menus(std::size_t entries) {
    return told(ipc::MenuChanged{std::vector<ipc::MenuEntry>(entries)});
}

TEST(Allowance, MessagesAtOnceAndPerSecond) {
    const Message small = told(ipc::PresentationResized{});
    EXPECT_EQ(spent(small, 60, 0, 1'000'000), 20'000);
    EXPECT_EQ(spent(small, 60, 1 / 4'900.0, 100'000), 100'000); // a little less than is allowed
    EXPECT_LT(spent(small, 60, 1 / 6'000.0, 200'000), 200'000); // a little more
    EXPECT_EQ(spent(ipc::Ignored{}, 60, 0, 1'000'000), 20'000);
}

TEST(Allowance, EntriesOfListsAreCounted) {
    EXPECT_EQ(spent(menus(1000), 1, 0, 1000), 19);
    EXPECT_LT(spent(menus(1000), 1, 0.1, 1000), 1000); // read at once, and yet a flood
    EXPECT_EQ(spent(menus(20), 1, 1 / 60.0, 10'000), 10'000);
    const Message faults = told(ipc::Diagnostics{1, std::vector<ipc::DiagnosticItem>(177)});
    EXPECT_EQ(spent(faults, 60'000, 0.1, 1000), 1000); // a faulty text that is being typed
}

TEST(Allowance, BytesAreCountedButThoseOfFramesAndAnswers) {
    constexpr std::size_t large = 4 << 20;
    EXPECT_EQ(spent(menus(0), large, 0, 100), 8);
    EXPECT_EQ(spent(told(ipc::RenditionFrame{}), large, 1 / 60.0, 10'000), 10'000);
    EXPECT_EQ(spent(ipc::Answered{}, large, 0, 100'000), 100'000);
}

} // namespace
} // namespace media
