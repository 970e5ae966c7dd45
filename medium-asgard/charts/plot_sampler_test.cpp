// The plots of a scene, sampled beside the thread that wishes for them.
#include "charts/plot_sampler.h"

#include <gmock/gmock.h>

#include <future>

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

TEST(PlotSampler, AnotherSceneIsNotWaitedFor) {
    Gate gate;
    const auto first = sceneWithPlots(1), second = sceneWithPlots(2);
    PlotSampler sampler(gate.done());
    sampler.sample({first, simulation::simulate(*first).motion, 1});
    sampler.sample({second, nullptr, 2});
    sampler.sample({second, simulation::simulate(*second).motion, 3});
    gate.opened.set_value();
    gate.awaitWish(3);
    EXPECT_EQ(gate.came.back().second.size(), 2u);
}

} // namespace
} // namespace charts
