// The values of plots with `-beside 1` are in a document's pictures, moving and printed.
#include "lettering/values_beside.h"

#include "ipc/base64.h"
#include "service/session_testing.h"

namespace service {
namespace {

using namespace held;

class ValuesBesideTest : public SessionTest {
protected:
    // The test's pictures have nothing else in them.
    std::vector<std::byte> printed(double time) {
        std::vector<std::byte> pixels;
        ipc::RenditionSnapshot call;
        call.width = 300;
        call.height = 150;
        call.time = time;
        bool isThere = false;
        host.request(std::move(call), [&](ipc::Outcome<ipc::Taken> outcome) {
            isThere = true;
            if (const auto* taken = std::get_if<ipc::Taken>(&outcome))
                pixels = ipc::fromBase64(taken->pixels.value_or("")).value();
        });
        until([&] { return isThere; });
        return pixels;
    }
    static std::ptrdiff_t marks(const std::vector<std::byte>& pixels) {
        return std::ranges::count_if(pixels, [](std::byte one) { return one != std::byte{0}; });
    }
};

TEST_F(ValuesBesideTest, ASnapshotHasThemAtItsTime) {
    load("measured");
    computedTo(10);
    const auto start = printed(0), later = printed(3);
    EXPECT_GT(marks(start), 400);
    EXPECT_GT(marks(later), 400);
    EXPECT_NE(start, later);
    EXPECT_EQ(start, printed(0));
}

TEST_F(ValuesBesideTest, APlotWithoutTheOptionIsAChartAlone) {
    load("charted");
    computedTo(10);
    EXPECT_EQ(marks(printed(0)), 0);
}

TEST_F(ValuesBesideTest, AFrameIsDrawnAgainWhenTheyAreThere) {
    load("measured");
    computedTo(10);
    show();
    const auto last = [&] {
        return frames.empty() ? std::vector<std::byte>()
                              : ipc::fromBase64(frames.back().pixels.value_or("")).value();
    };
    until([&] {
        if (!frames.empty())
            host.notify(ipc::RenditionAck{1, frames.back().serial});
        now += std::chrono::milliseconds(20);
        return marks(last()) > 100;
    });
    const auto count = frames.size();
    for (int i = 0; i < 20; ++i) {
        host.notify(ipc::RenditionAck{1, frames.back().serial});
        now += std::chrono::milliseconds(100);
        exchange();
    }
    EXPECT_LE(frames.size(), count + 2); // then nothing changes
}

} // namespace
} // namespace service
