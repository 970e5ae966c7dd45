// Charts that are shown while those of another scene are being sampled.
#include "service/sheets.h"
#include "service/testing.h"

#include <gtest/gtest.h>

#include <poll.h>

namespace service {
namespace {

// Texts: how many plots the pushed ball has.
Tools countedPlots() {
    Tools tools;
    tools.read = [](const std::string& text, const ParameterValues&) {
        script::ReadResult result;
        result.scene = pushedBallScene(2);
        result.scene.plots.resize(std::stoul(text));
        for (scene::Plot& plot : result.scene.plots)
            plot.values = {"b.x"};
        result.usable = true;
        return result;
    };
    tools.cancelReading = [] {};
    tools.simulate = [](const ScenePointer& scene, const auto& options, const auto& observer) {
        return simulation::simulate(*scene, options, observer);
    };
    return tools;
}

class SheetsTest : public ::testing::Test {
protected:
    template <class F> void until(F condition) {
        const Instant end = Clock::now() + std::chrono::seconds(60);
        while (!condition()) {
            ASSERT_LT(Clock::now(), end) << "waited too long";
            pollfd news{of_.descriptor(), POLLIN, 0};
            poll(&news, 1, 5);
            of_.update(Clock::now());
        }
    }
    void load(const std::string& text) {
        of_.load(text, ++revision_, Clock::now());
        until([&] { return !of_.computing() && of_.upToDate(); });
    }
    std::vector<std::byte> drawn() {
        constexpr int side = 400;
        std::vector<std::byte> pixels(4 * side * side);
        render::Image image;
        image.size = {side, side};
        image.stride = 4 * side;
        image.pixels = pixels;
        sheets_.draw(Presentation::chart, sheets_.lookOf(Presentation::chart, 0, 0), 1, image);
        return pixels;
    }
    bool isSampled() { return sheets_.upToDate(Presentation::chart); }

private:
    Subdocument of_{countedPlots()};
    Sheets sheets_{of_};
    ipc::Integer revision_ = 0;
};

TEST_F(SheetsTest, ChartsOfTheSceneBeforeStayAsTheyAreUntilTheNextOnesAreThere) {
    for (const char* next : {"30", "3", "0"}) {
        load("25");
        until([&] { return isSampled(); });
        const auto before = drawn();
        load(next);
        EXPECT_TRUE(drawn() == before) << next;
        until([&] { return isSampled(); });
        EXPECT_FALSE(drawn() == before) << next;
    }
}

} // namespace
} // namespace service
