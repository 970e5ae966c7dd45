// The plots of a scene, sampled beside the thread that wishes for them.
#include "charts/plot_sampler.h"

#include <gmock/gmock.h>

#include <future>
#include <semaphore>

namespace charts {
namespace {

std::shared_ptr<const scene::Scene> sceneWithPlots(std::size_t count) {
    auto scene = std::make_shared<scene::Scene>();
    scene->simulator.finish = 2;
    scene::ShapeSet set;
    set.name = "round";
    set.parts.resize(1);
    set.parts[0].shape = scene::SphereShape{0.5};
    scene->shapeSets = {set};
    scene::Body ball;
    ball.name = "b";
    ball.shape = "round";
    scene->bodies = {ball};
    for (std::size_t i = 0; i < count; ++i) {
        scene::Plot plot;
        plot.name = "p" + std::to_string(i);
        plot.values = {std::to_string(i) + "*t", "b.x"};
        scene->plots.push_back(plot);
    }
    return scene;
}

// The plots that come, and a thread that goes on when the test lets it.
struct Gate {
    std::promise<void> opened;
    std::shared_future<void> open = opened.get_future().share();
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<std::pair<unsigned, std::vector<Plot>>> came;

    PlotSampler::Done done() {
        return [this](const PlotSampler::Wish& wish, std::vector<Plot> plots) {
            open.wait();
            const std::lock_guard lock(mutex);
            came.emplace_back(wish.number, std::move(plots));
            changed.notify_all();
        };
    }
    void awaitWish(unsigned number) {
        std::unique_lock lock(mutex);
        const auto isThere = [&] { return !came.empty() && came.back().first == number; };
        ASSERT_TRUE(changed.wait_for(lock, std::chrono::seconds(60), isThere));
    }
};

TEST(PlotSampler, WorksBesideWhoeverWishes) {
    Gate gate;
    const auto scene = sceneWithPlots(25);
    const auto motion = simulation::simulate(*scene).motion;
    PlotSampler sampler(gate.done(), 20);
    sampler.sample({scene, motion, 1});
    sampler.sample({scene, motion, 2}); // both return, whatever the thread does
    gate.opened.set_value();
    gate.awaitWish(2);
    const std::vector<Plot>& plots = gate.came.back().second;
    ASSERT_EQ(plots.size(), 20u);
    EXPECT_EQ(plots[3].curves[0].values.back(), 6);
    EXPECT_EQ(sampler.built(), 1u); // for all plots, of both wishes
}

// Its sampling begins, and goes on when the test lets it. It has no state to read.
class HeldMotion final : public simulation::Motion {
public:
    double start() const override {
        begun_.release();
        held_.acquire();
        return 0;
    }
    double finish() const override { return 1; }
    double computed() const override { return 1; }
    bool draft() const override { return false; }
    std::size_t bodies() const override { return 1; }
    simulation::BodyState at(std::size_t, double) const override { return {}; }
    std::optional<simulation::Stop> stop(std::size_t) const override { return std::nullopt; }
    simulation::Vector centroid(std::size_t) const override { return simulation::Vector::Zero(); }
    double mass(std::size_t) const override { return 1; }
    const std::vector<simulation::Impact>& impacts() const override { return impacts_; }
    std::vector<double> jumps(std::size_t) const override { return {}; }
    std::optional<double> errorEstimate() const override { return std::nullopt; }
    std::optional<double> predictableUntil() const override { return std::nullopt; }
    const std::vector<std::string>& notes() const override { return notes_; }

    void awaitBegin() const { begun_.acquire(); }
    void goOn() const { held_.release(); }

private:
    mutable std::binary_semaphore begun_{0}, held_{0};
    std::vector<simulation::Impact> impacts_;
    std::vector<std::string> notes_;
};

// Scenes follow one another faster than they are sampled, as under a slider that is dragged: each
// is wished for while the one before is being sampled.
class OvertakenSampler : public ::testing::Test {
protected:
    static constexpr unsigned count = 5;

    OvertakenSampler() {
        gate_.opened.set_value();
        for (unsigned i = 0; i < count; ++i) {
            scenes_.push_back(sceneWithPlots(1));
            motions_.push_back(std::make_shared<HeldMotion>());
        }
    }
    void wish(unsigned number) { sampler_.sample({scenes_[number], motions_[number], number}); }
    // Each but the last is overtaken by the next one; the last comes to its end.
    std::vector<unsigned> shownOf(unsigned wishes) {
        wish(0);
        for (unsigned i = 0; i < wishes; ++i) {
            motions_[i]->awaitBegin();
            if (i + 1 < wishes)
                wish(i + 1);
            motions_[i]->goOn();
        }
        gate_.awaitWish(wishes - 1);
        std::vector<unsigned> shown;
        for (const auto& [number, plots] : gate_.came)
            shown.push_back(number);
        return shown;
    }

private:
    Gate gate_;
    std::vector<std::shared_ptr<const scene::Scene>> scenes_;
    std::vector<std::shared_ptr<HeldMotion>> motions_;
    PlotSampler sampler_{gate_.done()};
};

TEST_F(OvertakenSampler, AnotherSceneIsNotWaitedFor) {
    EXPECT_THAT(shownOf(2), ::testing::ElementsAre(1u));
}

TEST_F(OvertakenSampler, EverySecondSceneIsShownHoweverFastTheyCome) {
    EXPECT_THAT(shownOf(5), ::testing::ElementsAre(1u, 3u, 4u));
}

} // namespace
} // namespace charts
