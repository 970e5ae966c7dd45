// The pictures of the scenes that come with the programs show what moves in them.
#include "batch/input.h"
#include "framing/extent.h"
#include "framing/view.h"
#include "simulation/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace batch {
namespace {

using Box = Eigen::AlignedBox2d;

const render::Size size{480, 360}; // of a figure, and as narrow as a picture is that cuts nothing

// Bodies that are hit and fly away, by the sample's file.
const std::map<std::string, std::set<std::string>> fliesOff = {
    {"pend.al", {"b3"}}, {"seven-steps.al", {"cube1"}}, {"trebuchet.al", {"stone"}}};

std::vector<std::string> samples() {
    std::vector<std::string> files;
    const std::filesystem::path source = SOURCE_DIR;
    for (const auto& folder : {source / "samples", source / "medium-asgard/samples",
                               source / "medium-asgard/samples/mechanics"})
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == ".al")
                files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

// The place at which a ball is seen, in pixels.
Box seen(const render::Camera& camera, const render::Ball& ball) {
    const render::Vector inView =
        camera.scale * (camera.rotation * (ball.center - camera.center)) + camera.position;
    const double radius = ball.radius * camera.scale * render::enlargement(camera, inView.z()) *
                          render::pixelsPerUnit(size);
    const Eigen::Vector2d middle = render::toPixels(camera, size, ball.center);
    return {middle.array() - radius, middle.array() + radius};
}

Box seen(const scene::Scene& scene, const simulation::MotionPointer& motion, std::size_t body,
         double time, const render::Camera& camera) {
    Box all;
    for (const render::Ball& ball : render::outlineOf(scene, scene.bodies[body]))
        all.extend(seen(camera, {motion->shapePose(body, time).toWorld(ball.center), ball.radius}));
    return all;
}

TEST(Samples, NoBodyLeavesItsPictureAndNoneIsSmall) {
    const Box picture(Eigen::Vector2d::Zero(), Eigen::Vector2d(size.width, size.height));
    script::Reader reader;
    const std::vector<std::string> files = samples();
    ASSERT_GT(files.size(), 50U);
    for (const std::string& file : files) {
        const std::string name = std::filesystem::path(file).filename();
        const SceneText read = std::get<SceneText>(readScene(reader, file));
        const scene::Scene& scene = read.reading.scene;
        const simulation::MotionPointer motion = simulation::simulate(scene).motion;
        ASSERT_TRUE(motion) << file;
        ASSERT_EQ(motion->computed(), motion->finish()) << file;
        const render::SceneView view(scene, motion, {}, size);
        const auto away = fliesOff.find(name);
        std::set<std::string> gone;
        Box used; // of the picture, by what moves, in the course of time
        for (int i = 0; i <= 4; ++i) {
            const double time = motion->start() + i * (motion->finish() - motion->start()) / 4;
            for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
                if (scene.bodies[body].fixed)
                    continue;
                const Box box = seen(scene, motion, body, time, view.at(time));
                const bool inside = picture.contains(box);
                if (away != fliesOff.end() && away->second.contains(scene.bodies[body].name)) {
                    if (!inside)
                        gone.insert(scene.bodies[body].name);
                    continue;
                }
                used.extend(box);
                EXPECT_TRUE(inside)
                    << file << ": " << scene.bodies[body].name << " at " << time
                    << " s: " << box.min().transpose() << " to " << box.max().transpose();
            }
        }
        EXPECT_EQ(gone, away == fliesOff.end() ? std::set<std::string>() : away->second) << file;
        EXPECT_GT((used.sizes().array() / picture.sizes().array()).maxCoeff(), 0.2) << file;
    }
}

} // namespace
} // namespace batch
