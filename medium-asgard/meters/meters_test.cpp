#include "meters/meters.h"

#include "framing/test_scenes.h"

#include <gmock/gmock.h>

#include <cmath>

namespace meters {
namespace {

using testing::ElementsAre;

scene::Plot beside(std::vector<std::string> values, std::vector<std::string> labels = {}) {
    scene::Plot plot;
    plot.values = std::move(values);
    plot.labels = std::move(labels);
    plot.beside = true;
    return plot;
}

scene::Scene twoBalls() {
    scene::Scene scene;
    scene::ShapeSet set;
    set.name = "round";
    set.parts.resize(1);
    set.parts[0].shape = scene::SphereShape{0.5};
    scene.shapeSets = {set};
    scene.bodies.resize(2);
    for (scene::Body& body : scene.bodies)
        body.shape = "round";
    scene.bodies[0].name = "a";
    scene.bodies[1].name = "b";
    scene.joints.emplace_back().name = "pin";
    return scene;
}

TEST(Meters, EachValueStandsAtTheFirstThingThatItNames) {
    scene::Scene scene = twoBalls();
    scene.plots = {beside({"2*b.x - a.x", "pin.q", "t"}, {"Way"}), beside({"a.y"})};
    scene.plots.emplace_back().values = {"a.z"}; // a chart alone
    const auto all = metersOf(scene);
    ASSERT_EQ(all.size(), 3U);
    using editing::Element, editing::Kind;
    EXPECT_EQ(all[0], (Meter{0, 0, Element{Kind::body, 1}, "Way"}));
    EXPECT_EQ(all[1], (Meter{0, 1, Element{Kind::joint, 0}, "pin.q"}));
    EXPECT_EQ(all[2], (Meter{1, 0, Element{Kind::body, 0}, "a.y"}));
    scene.plots.assign(100, beside({"a.x"}));
    EXPECT_EQ(metersOf(scene).size(), most);
}

TEST(Meters, TheirWordsHaveThreeDigitsAndTheUnit) {
    const Meter meter{0, 0, {}, "Speed"};
    charts::Plot plot;
    plot.times = {0, 1, 2};
    plot.curves = {{"", {0, 100, 200.4}, {}, {}, "m/s"}};
    EXPECT_EQ(wordsOf(meter, &plot, 0.25), "Speed 25 m/s");
    EXPECT_EQ(wordsOf(meter, &plot, 2), "Speed 200 m/s");
    EXPECT_EQ(wordsOf(meter, &plot, 3), "Speed –");
    EXPECT_EQ(wordsOf(meter, nullptr, 0), "Speed …");
    plot.curves[0].values[0] = -1e-9; // of 100: noise
    EXPECT_EQ(wordsOf(meter, &plot, 0), "Speed 0 m/s");
    plot.curves[0].values[0] = std::nan("");
    EXPECT_EQ(wordsOf(meter, &plot, 0), "Speed –");
}

TEST(Meters, ValuesAreThoseOfAnAlikePlotOfAnOlderScene) {
    auto older = std::make_shared<scene::Scene>(twoBalls());
    older->plots = {beside({"a.x"}), beside({"b.x"})};
    Sampled sampled{older, {{.title = "first"}, {.title = "second"}}};
    ASSERT_NE(sampled.of(beside({"b.x"})), nullptr);
    EXPECT_EQ(sampled.of(beside({"b.x"}))->title, "second");
    EXPECT_EQ(sampled.of(beside({"b.y"})), nullptr);
    EXPECT_EQ(Sampled().of(beside({"b.x"})), nullptr);
}

TEST(Meters, ThoseOfOneThingStandBelowEachOtherInThePicture) {
    const editing::Element first{editing::Kind::body, 0}, second{editing::Kind::body, 1};
    const Eigen::Vector2d size(40, 10), picture(200, 100);
    const auto boxes = boxesFor({{first, {{50, 20}, 10}, size},
                                 {second, {{195, 95}, 10}, size},
                                 {first, {{50, 20}, 10}, size},
                                 {first, {{50, 20}, 10}, size, {30, 40}}},
                                picture);
    const auto at = [&](std::size_t i) {
        return std::pair(boxes[i].rect.min().x(), boxes[i].rect.min().y());
    };
    EXPECT_EQ(at(0), std::pair(67.0, 27.0));
    EXPECT_EQ(at(1), std::pair(138.0, 90.0)); // all of it is seen, and its body
    EXPECT_EQ(at(2), std::pair(67.0, 37.0));
    EXPECT_EQ(at(3), std::pair(97.0, 67.0)); // where it was put
}

// A pile of bodies and the joint between them.
TEST(Meters, ThoseOfSeveralThingsAvoidEachOther) {
    std::vector<Wish> wishes;
    for (std::size_t i = 0; i < 4; ++i)
        for (int values = 0; values < 2; ++values)
            wishes.push_back({{editing::Kind::body, i},
                              {{150.0 + 3 * static_cast<double>(i), 100}, 12},
                              {60, 14}});
    wishes.push_back({{editing::Kind::joint, 0}, {{152, 104}, 10}, {60, 14}});
    wishes.push_back({{editing::Kind::joint, 1}, {{152, 104}, 10}, {60, 14}, {4, 4}}); // put there
    const auto boxes = boxesFor(wishes, {300, 200});
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_LE(boxes[i].rect.intersection(boxes[j].rect).sizes().minCoeff(), 0)
                << i << ' ' << j;
}

TEST(Meters, APlaceFollowsTheBody) {
    const scene::Scene scene = twoBalls();
    render::Drawing drawing;
    drawing.scene = &scene;
    drawing.motion = std::make_shared<render::GivenMotion>(
        1, std::vector<render::GivenMotion::Law>(2, [](double t) {
            simulation::BodyState state;
            state.position = {2 * t, 0, 0};
            return state;
        }));
    drawing.camera = {};
    const gestures::Sight sight{drawing.camera, {400, 300}};
    const editing::Element ball{editing::Kind::body, 0};
    const auto before = placeOf(drawing, sight, ball, 2);
    drawing.time = 1;
    const auto after = placeOf(drawing, sight, ball, 2);
    ASSERT_TRUE(before && after);
    EXPECT_NEAR((after->at - sight.pixels({2, 0, 0}) / 2).norm(), 0, 1e-9);
    EXPECT_GT((after->at - before->at).norm(), 1);
    EXPECT_FALSE(placeOf(drawing, sight, {editing::Kind::body, 7}, 2));
}

} // namespace
} // namespace meters
