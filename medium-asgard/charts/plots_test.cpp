// Plots of scenes: their curves, and that they are drawn where they belong.
#include "charts/marks.h"
#include "charts/plots.h"

#include <gmock/gmock.h>

#include <cmath>

namespace {

using charts::Plot;

scene::Body& addBody(scene::Scene& scene, const std::string& name, double x) {
    scene::Body& body = scene.bodies.emplace_back();
    body.name = name;
    body.shape = "s";
    body.initialPosition.x() = x;
    return body;
}

scene::Scene threeBodies() {
    scene::Scene scene;
    scene.simulator.finish = 2;
    scene.shapeSets.push_back({"s", {scene::Part{}}, {}, {}});
    addBody(scene, "red", 0).appearance.color = scene::Color{0.8, 0.1, 0.1};
    scene.bodies.back().initialVelocity.x() = 1;
    addBody(scene, "pale", 30).appearance.color = scene::Color{1, 1, 0.6};
    addBody(scene, "grey", 60);
    scene.plots.emplace_back();
    scene.plots[0].name = "p";
    scene.plots[0].values = {"red.x", "red.y", "pale.x", "grey.x", "red.x + pale.x"};
    scene.plots[0].labels = {"way"};
    return scene;
}

bool same(const charts::Color& a, const charts::Color& b) {
    return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue) < 1e-9;
}

TEST(Plots, CurvesHaveTheColourOfTheirBody) {
    const scene::Scene scene = threeBodies();
    const Plot plot = charts::named(scene, scene.plots[0]);
    EXPECT_EQ(plot.title, "p");
    EXPECT_EQ(plot.curves[0].label, "way");
    EXPECT_EQ(plot.curves[1].label, "y of red");
    EXPECT_EQ(plot.curves[4].label, "red.x + pale.x");
    EXPECT_TRUE(same(plot.curves[0].color, {0.8, 0.1, 0.1}));
    EXPECT_TRUE(same(plot.curves[1].color, plot.curves[0].color));
    EXPECT_NE(plot.curves[1].stroke, plot.curves[0].stroke); // told apart all the same
    EXPECT_LT(plot.curves[2].color.green, 0.75);             // seen on white
    EXPECT_TRUE(same(plot.curves[3].color, charts::colorOf(3)));
    EXPECT_TRUE(same(plot.curves[4].color, charts::colorOf(4))); // of two bodies
}

TEST(Plots, SayWhatTheirValuesAre) {
    scene::Scene scene = threeBodies();
    const auto nameOf = [&](std::vector<std::string> values, std::vector<std::string> labels = {}) {
        scene.plots[0].values = std::move(values);
        scene.plots[0].labels = std::move(labels);
        return charts::named(scene, scene.plots[0]).values;
    };
    EXPECT_EQ(nameOf({"red.x"}), "x of red, m");
    EXPECT_EQ(nameOf({"red.dy"}), "velocity along y of red, m/s");
    EXPECT_EQ(nameOf({"red.x"}, {"way"}), "way, m");
    EXPECT_EQ(nameOf({"red.x - 1"}), "m");
    EXPECT_EQ(nameOf({"100*red.x"}, {"cm"}), "cm"); // as the author says
    EXPECT_EQ(nameOf({"red.x", "pale.x"}), "x, m");
    EXPECT_EQ(nameOf({"red.x", "red.y"}), "m");
    EXPECT_EQ(nameOf({"red.x", "red.dx"}), "");
    EXPECT_EQ(nameOf({}), "");
}

TEST(Plots, DrawTheNamesOfTheirAxes) {
    const charts::PlotArea area{0, 0, 300, 200, 0, 2};
    const charts::PlotArea inside = charts::insideOf(area);
    Plot plot{.title = "p", .times = {0, 1, 2}, .curves = {{"c", {0, 1, 0}, {1, 0, 0}}}};
    const auto inkIn = [&](double left, double top, double right, double bottom) {
        charts::Canvas canvas(300, 200, 1);
        charts::draw(canvas, plot, area, 1);
        const charts::Pixels pixels = canvas.pixels();
        int found = 0;
        for (int y = static_cast<int>(top); y < static_cast<int>(bottom); ++y)
            for (int x = static_cast<int>(left); x < static_cast<int>(right); ++x)
                found +=
                    (pixels.colors[static_cast<std::size_t>(y * pixels.width + x)] & 0xff) < 160;
        return found;
    };
    const double below = inside.top + inside.height + 18; // the numbers
    EXPECT_GT(inkIn(inside.left, below, 290, 200), 20);
    EXPECT_EQ(inkIn(0, inside.top, 14, 190), 0);
    plot.values = "x of red, m";
    EXPECT_GT(inkIn(0, inside.top, 14, 190), 20);
    plot.values = "a name that is far too long for an axis of this little height, m";
    const int unit = inkIn(0, inside.top, 14, 190); // it alone
    EXPECT_GT(unit, 2);
    EXPECT_LT(unit, 40);
}

TEST(Plots, HaveTheValuesOfTheMotion) {
    const scene::Scene scene = threeBodies();
    const auto motion = simulation::simulate(scene).motion;
    simulation::ReadableScene readable(scene);
    const auto plot = charts::sampled(readable, scene, scene.plots[0], motion);
    ASSERT_TRUE(plot);
    EXPECT_EQ(plot->times.back(), 2);
    EXPECT_NEAR(plot->curves[0].values.back(), 2, 1e-12);
    EXPECT_NEAR(plot->curves[4].values.back(), 32, 1e-12);
    const charts::Range range = charts::rangeOf(*plot);
    EXPECT_LT(range.low, 0);
    EXPECT_GT(range.high, 60);
    EXPECT_FALSE(charts::sampled(readable, scene, scene.plots[0], motion, [] { return true; }));
    scene::Scene faulty = scene;
    faulty.plots[0].values = {"nobody.x"};
    EXPECT_THAT(charts::sampled(readable, faulty, faulty.plots[0], motion)->fault,
                testing::HasSubstr("nobody"));
}

// In expressions they are radians.
TEST(Plots, AnglesAreInDegrees) {
    scene::Scene scene = threeBodies();
    scene.plots[0].values = {"atan2(red.x + 1, 1)", "red.x"};
    scene.plots[0].labels = {"angle of red"};
    const auto motion = simulation::simulate(scene).motion;
    simulation::ReadableScene readable(scene);
    const auto plot = charts::sampled(readable, scene, scene.plots[0], motion);
    ASSERT_TRUE(plot);
    EXPECT_EQ(plot->curves[0].unit, "°");
    EXPECT_NEAR(plot->curves[0].values.front(), 45, 1e-9);
    EXPECT_EQ(plot->curves[1].unit, "m");
    EXPECT_NEAR(plot->curves[1].values.back(), 2, 1e-12);
    scene.plots[0].values = {"atan2(red.x + 1, 1)"};
    EXPECT_EQ(charts::named(scene, scene.plots[0]).values, "angle of red, °");
}

TEST(Plots, EnormousValuesHaveNoPlaceAndTheOthersStay) {
    const Plot plot{.title = "p",
                    .times = {0, 1, 2},
                    .curves = {{"c", {1.5e308, 1, -1.5e308}, {1, 0, 0}}, {"d", {2, 3, 4}}}};
    const charts::Range range = charts::rangeOf(plot);
    EXPECT_LT(range.high - range.low, 10);
    charts::Canvas canvas(300, 200, 1);
    charts::draw(canvas, plot, {0, 0, 300, 200, 0, 2}, 1);
    charts::draw(canvas, plot, {0, 0, 1, 1, 0, 0}, 0);
    EXPECT_EQ(canvas.pixels().width, 300);
}

TEST(Plots, ACurveIsDrawnAtItsValuesAndTheLineAtTheTime) {
    Plot plot{.title = "p", .times = {0, 1, 2}, .curves = {{"c", {0, 0, 0}, {1, 0, 0}}}};
    const charts::PlotArea area{0, 0, 300, 200, 0, 2};
    const auto columnsWith = [&](double now, auto isIt) {
        charts::Canvas canvas(300, 200, 1);
        charts::draw(canvas, plot, area, now);
        const charts::Pixels pixels = canvas.pixels();
        std::vector<int> found;
        const charts::PlotArea inside = charts::insideOf(area);
        const int y = static_cast<int>(inside.top + inside.height / 2);
        for (int x = 0; x < pixels.width; ++x)
            if (isIt(pixels.colors[static_cast<std::size_t>(y * pixels.width + x)]))
                found.push_back(x);
        return found;
    };
    const auto isRed = [](std::uint32_t color) {
        return (color >> 16 & 0xff) > 180 && (color & 0xff) < 150;
    };
    EXPECT_GT(columnsWith(-1, isRed).size(), 200U); // a value that does not change: in the middle
    // Another time, another picture; a time beyond the ends has no line.
    const auto any = [&](double now) {
        charts::Canvas canvas(300, 200, 1);
        charts::draw(canvas, plot, area, now);
        return canvas.pixels().colors;
    };
    EXPECT_NE(any(0.5), any(1.5));
    EXPECT_EQ(any(-1), any(9));
    const charts::PlotArea inside = charts::insideOf(area);
    EXPECT_EQ(inside.timeAt(inside.left), 0);
    EXPECT_EQ(inside.timeAt(inside.left + inside.width), 2);
    EXPECT_EQ(inside.timeAt(1e6), 2);
}

} // namespace
