// Texts are the place of one ball, "faulty" makes no scene; the test lets its motion end.
#include "computing/follower.h"
#include "computing/stale_motion.h"

#include <gtest/gtest.h>

#include <thread>

namespace computing {
namespace {

using std::chrono::milliseconds;

scene::Scene ballAt(double x, const std::string& name = "b") {
    scene::Scene scene;
    scene.simulator.finish = 2;
    scene.shapeSets.push_back({"ball", {scene::Part{}}, {}, {}});
    scene::Body& body = scene.bodies.emplace_back();
    body.name = name;
    body.shape = "ball";
    body.initialPosition.x() = x;
    return scene;
}

class FollowerTest : public testing::Test {
protected:
    Tools tools() {
        Tools tools;
        tools.read = [this](const std::string& text, const ParameterValues& values) {
            ++readings;
            script::ReadResult result;
            result.usable = text != "faulty" && !values.contains("unknown");
            if (result.usable)
                result.scene = ballAt(std::stod(text), text == "7" ? "other" : "b");
            else
                result.diagnostics.push_back(
                    {scene::Severity::error, {}, 1, 1, 1, 2, "faulty", ""});
            return result;
        };
        tools.cancelReading = [] {};
        tools.simulate = [this](const ScenePointer& scene, const auto& options,
                                const simulation::Observer& observer) {
            ++motions;
            auto result = simulation::simulate(*scene, options);
            const std::vector<char> taken(takes, 'x');
            while (held && !observer.cancelled()) {
                if (publishes.exchange(false))
                    observer.progress(result.motion);
                std::this_thread::sleep_for(milliseconds(1));
            }
            result.cancelled = held && observer.cancelled();
            return result;
        };
        return tools;
    }
    Changes update() {
        const Changes now = follower.update(moment);
        all.ended = all.ended || now.ended;
        return now;
    }
    template <class F> void until(F condition) {
        const auto end = Clock::now() + std::chrono::seconds(60);
        while (!condition()) {
            ASSERT_LT(Clock::now(), end) << "waited too long";
            std::this_thread::sleep_for(milliseconds(1));
            update();
        }
    }
    void settle() {
        until([this] { return follower.work() == Work::none; });
    }
    double x(double time = 0) { return follower.shown().motion->at(0, time).position.x(); }

    std::atomic<int> readings = 0, motions = 0;
    std::atomic<bool> held = false, publishes = false;
    std::atomic<std::size_t> takes = 0; // bytes, while it is held
    Instant moment = Clock::now();
    Changes all;
    Follower follower{tools(), [] {}};
};

TEST_F(FollowerTest, ATextIsReadAndComputedOnce) {
    EXPECT_TRUE(follower.isCurrent());
    follower.follow("1", {}, moment);
    EXPECT_EQ(follower.work(), Work::reading);
    EXPECT_FALSE(follower.isCurrent());
    settle();
    EXPECT_TRUE(follower.isCurrent());
    EXPECT_FALSE(follower.motionIsStale());
    EXPECT_EQ(x(1), 1);
    EXPECT_EQ(readings, 1);
    EXPECT_EQ(motions, 1);
    follower.follow("faulty", {}, moment);
    settle();
    EXPECT_TRUE(follower.isFaulty());
    EXPECT_EQ(x(1), 1); // the last good one
    EXPECT_EQ(follower.diagnostics().size(), 1U);
    EXPECT_EQ(motions, 1);
}

// As by an undo.
TEST_F(FollowerTest, ATextThatComesBackHasTheMotionThatItHad) {
    for (const char* text : {"1", "2"}) {
        follower.follow(text, {}, moment);
        settle();
    }
    const auto second = follower.shown().motion;
    for (const double back : {1.0, 2.0, 1.0}) {
        follower.follow(std::to_string(static_cast<int>(back)), {}, moment);
        settle();
        EXPECT_EQ(x(1), back);
    }
    EXPECT_EQ(motions, 2);
    follower.follow("2", {}, moment);
    settle();
    EXPECT_EQ(follower.shown().motion, second);
    EXPECT_EQ(follower.statistics()->steps, 0U);
    follower.follow("1", {.parameters = {{"h", 2.0}}}, moment); // another motion
    settle();
    EXPECT_EQ(motions, 3);
    follower.follow("1", {.asked = true}, moment); // by who wants it computed
    settle();
    EXPECT_EQ(motions, 4);
}

// However long the drag or the way of a slider was.
TEST_F(FollowerTest, AfterAGestureTheTextBeforeItHasItsMotion) {
    follower.follow("1", {}, moment);
    settle();
    for (int i = 10; i < 20 + static_cast<int>(FormerMotions::mostTexts); ++i) {
        follower.follow(std::to_string(i), {.gesture = true}, moment);
        settle();
    }
    const std::string last = std::to_string(19 + FormerMotions::mostTexts);
    follower.follow(last, {}, moment); // it is let go
    settle();
    const int before = motions;
    follower.follow("1", {}, moment);
    settle();
    follower.follow(last, {}, moment);
    settle();
    EXPECT_EQ(motions, before);
    follower.follow("15", {}, moment); // a step of the gesture
    settle();
    EXPECT_EQ(motions, before + 1);
}

TEST_F(FollowerTest, ATextThatComesBackHasItsMotionUnasked) {
    follower.setLive(Live::never);
    for (const char* text : {"1", "2"}) {
        follower.follow(text, {.asked = true}, moment);
        settle();
    }
    follower.follow("3", {}, moment);
    settle();
    EXPECT_TRUE(follower.motionIsStale());
    follower.follow("1", {}, moment);
    settle();
    EXPECT_FALSE(follower.motionIsStale());
    EXPECT_EQ(x(1), 1);
    EXPECT_EQ(motions, 2);
}

TEST(FormerMotions, LongTextsAndManyBodiesCount) {
    const auto result = simulation::simulate(ballAt(1), {});
    const auto kept = [&](std::size_t length, std::size_t bodies) {
        FormerMotions former;
        std::size_t count = 0;
        for (int i = 0; i < 60; ++i)
            former.add(std::string(length, 'x') + std::to_string(i), {}, result, bodies);
        for (int i = 0; i < 60; ++i)
            count += former.of(std::string(length, 'x') + std::to_string(i), {}) ? 1 : 0;
        return count;
    };
    EXPECT_EQ(kept(10, 1), FormerMotions::mostTexts);
    EXPECT_EQ(kept(std::size_t{8} << 20, 1), 24U);
    EXPECT_LT(kept(10, 500), 9U);
}

TEST_F(FollowerTest, WithPatienceASceneIsShownWithItsMotionOnly) {
    follower.setSeen(1);
    follower.follow("1", {.patience = milliseconds(250)}, moment);
    settle();
    const Shown before = follower.shown();
    held = true;
    follower.follow("2", {.patience = milliseconds(250)}, moment);
    until([this] { return motions == 2; });
    moment += milliseconds(200);
    update();
    EXPECT_EQ(follower.shown().scene, before.scene);
    EXPECT_EQ(follower.newestScene()->bodies[0].initialPosition.x(), 2);
    publishes = true; // its motion reaches the time that is looked at
    until([&] { return follower.shown().scene != before.scene; });
    EXPECT_FALSE(follower.motionIsStale());
    EXPECT_EQ(x(1), 2);
    EXPECT_EQ(follower.work(), Work::simulating);
}

TEST_F(FollowerTest, ADraggedSceneIsShownAtOnceAndItsMotionFollows) {
    follower.follow("1", {}, moment);
    settle();
    held = true;
    follower.follow("2", {.gesture = true}, moment);
    until([this] { return motions == 2; });
    update(); // it is read
    moment += quick;
    update();
    EXPECT_TRUE(follower.isCurrent());
    EXPECT_TRUE(follower.motionIsStale());
    EXPECT_EQ(x(0), 2);                              // as the scene says
    EXPECT_EQ(x(1), 1);                              // where it was
    follower.follow("7", {.gesture = true}, moment); // another body: nothing is known of it
    until([this] { return follower.shown().scene->bodies[0].name == "other" || readings == 3; });
    held = false;
    settle();
    EXPECT_FALSE(follower.motionIsStale());
    EXPECT_EQ(x(1), 7);
}

TEST_F(FollowerTest, WhatIsCancelledKeepsTheMotionThatThereIs) {
    held = true;
    follower.follow("1", {}, moment);
    until([this] { return motions == 1; });
    follower.cancel();
    settle();
    EXPECT_TRUE(follower.isCancelled());
    EXPECT_TRUE(all.ended);
    ASSERT_TRUE(follower.shown().motion);
    EXPECT_EQ(x(1), 1);
    follower.follow("2", {}, moment); // a new one is worked for
    held = false;
    settle();
    EXPECT_FALSE(follower.isCancelled());
    EXPECT_EQ(x(1), 2);
}

TEST_F(FollowerTest, AnEditIsComputedAfterAnotherWasCancelled) {
    held = true;
    for (int i = 1; i < 4; ++i) {
        follower.follow(std::to_string(i), {}, moment);
        until([&] { return motions == i; });
        follower.cancel();
        settle();
    }
    held = false;
    follower.follow("4", {}, moment);
    settle();
    EXPECT_FALSE(follower.motionIsStale());
    EXPECT_EQ(x(1), 4);
}

// Its motion so far is shown, and the fault says why there is no more.
TEST_F(FollowerTest, AMotionThatTakesTooMuchMemoryEnds) {
    held = true;
    takes = std::size_t{64} << 20;
    follower.setMostBytes(std::size_t{16} << 20);
    follower.follow("1", {}, moment);
    settle();
    EXPECT_FALSE(follower.isCancelled());
    EXPECT_FALSE(follower.motionIsStale());
    EXPECT_EQ(x(1), 1);
    ASSERT_EQ(follower.diagnostics().size(), 1U);
    EXPECT_NE(follower.diagnostics()[0].message.find("16 MB"), std::string::npos);
}

TEST_F(FollowerTest, ValuesOfParametersThatAreNoMoreAreLeftOut) {
    follower.follow("1", {.parameters = {{"unknown", 5}}}, moment);
    settle();
    EXPECT_FALSE(follower.isFaulty());
    EXPECT_EQ(x(1), 1);
}

// A motion that is known to that time so far.
class Partly final : public simulation::Motion {
public:
    Partly(simulation::MotionPointer of, double computed)
        : of_(std::move(of)), computed_(computed) {}
    double start() const override { return of_->start(); }
    double finish() const override { return of_->finish(); }
    double computed() const override { return computed_; }
    bool draft() const override { return true; }
    std::size_t bodies() const override { return of_->bodies(); }
    simulation::BodyState at(std::size_t body, double time) const override {
        return of_->at(body, time);
    }
    std::optional<simulation::Stop> stop(std::size_t body) const override {
        return of_->stop(body);
    }
    geometry::Vector centroid(std::size_t body) const override { return of_->centroid(body); }
    double mass(std::size_t body) const override { return of_->mass(body); }
    const std::vector<simulation::Impact>& impacts() const override { return of_->impacts(); }
    std::vector<double> jumps(std::size_t body) const override { return of_->jumps(body); }
    std::optional<double> errorEstimate() const override { return std::nullopt; }
    std::optional<double> predictableUntil() const override { return std::nullopt; }
    const std::vector<std::string>& notes() const override { return of_->notes(); }

private:
    simulation::MotionPointer of_;
    double computed_;
};

// The moment of a throw is the new start: what was thrown stands where the hand let it go.
TEST(StaleMotion, BeginsAtALaterStartOfItsScene) {
    const scene::Scene before = ballAt(1);
    auto now = std::make_shared<scene::Scene>(ballAt(3));
    now->simulator.start = 0.5;
    const auto motion = simulation::simulate(before, {}).motion;
    const auto stale = staleMotion(before, motion, now);
    ASSERT_TRUE(stale);
    EXPECT_EQ(stale->start(), 0.5);
    EXPECT_EQ(stale->at(0, 0.5).position.x(), 3);
    EXPECT_EQ(stale->at(0, 0.6).position.x(), 1);
    const auto jumps = stale->jumps(0); // no line leads from there to where it was
    ASSERT_EQ(jumps.size(), 1U);
    EXPECT_GT(jumps.front(), 0.5);
    EXPECT_LT(jumps.front(), 0.5 + 1e-9);
    EXPECT_TRUE(
        staleMotion(before, motion, std::make_shared<scene::Scene>(before))->jumps(0).empty());
    now->simulator.start = 3; // later than all that is known
    EXPECT_EQ(staleMotion(before, motion, now)->start(), 0);
    now->simulator.start = 1.5; // the old motion is known to 1 s so far
    EXPECT_EQ(staleMotion(before, std::make_shared<Partly>(motion, 1), now)->start(), 0);
}

} // namespace
} // namespace computing
