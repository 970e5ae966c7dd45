// Texts in, scenes out, through the processes that evaluate them.
#include "script/reader.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace script {
namespace {

std::string fileText(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string messages(const ReadResult& result, const std::string& text) {
    std::string all;
    for (const scene::Diagnostic& diagnostic : result.diagnostics)
        all += scene::formatted(diagnostic, "scene.al", text) + "\n";
    return all;
}

std::vector<std::filesystem::path> scenesIn(const std::string& folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".al")
            paths.push_back(entry.path());
    return paths;
}

Reader& reader() {
    static Reader shared;
    return shared;
}

TEST(Reader, ReadsEveryReferenceSceneAndSample) {
    std::size_t read = 0;
    for (const std::string folder : {SOURCE_DIR "/tests/reference", SOURCE_DIR "/samples"})
        for (const auto& path : scenesIn(folder)) {
            const std::string text = fileText(path);
            const ReadResult result = reader().read(text);
            EXPECT_TRUE(result.usable) << path;
            EXPECT_EQ(messages(result, text), "") << path;
            EXPECT_FALSE(result.scene.bodies.empty()) << path;
            ++read;
        }
    EXPECT_GE(read, 66u);
}

// Figure 4.6 of the dissertation, its scanning errors repaired and nothing else.
TEST(Reader, ReadsTheDissertationsPendulum) {
    const ReadResult result = reader().read(fileText(SOURCE_DIR "/samples/pend.al"));
    ASSERT_TRUE(result.usable);
    const scene::Scene& scene = result.scene;
    EXPECT_EQ(scene.simulator.finish, 5);
    EXPECT_EQ(scene.simulator.firstStep, 0.1);
    ASSERT_EQ(scene.shapeSets.size(), 3u);
    const auto& rod = std::get<scene::HullShape>(scene.shapeSets[2].parts[0].shape);
    EXPECT_EQ(rod.points.size(), 24u); // six faces of four corners
    EXPECT_EQ(rod.points[0], scene::Vector(-5, -0.55, -0.55));
    ASSERT_EQ(scene.bodies.size(), 3u);
    EXPECT_EQ(scene.bodies[1].articulatedBody, "b");
    EXPECT_EQ(scene.bodies[2].initialVelocity, scene::Vector(-3, 0, 0));
    ASSERT_EQ(scene.links.size(), 2u);
    EXPECT_EQ(scene.links[0].tightness, 5000);
    EXPECT_EQ(std::get<scene::ComponentForce>(scene.forces[0].kind).components[1], "-10 * b1.mass");
}

TEST(Reader, GivesParametersToTheScript) {
    const std::string text = "parameter n -value 3 -min 1 -max 9\n"
                             "shape_set s -desc {-sub {-sphere 1}}\n"
                             "for {set i 0} {$i < $n} {incr i} {body b$i s}\n";
    EXPECT_EQ(reader().read(text).scene.bodies.size(), 3u);
    const ReadResult given = reader().read(text, {{"n", 5}});
    EXPECT_EQ(given.scene.bodies.size(), 5u);
    EXPECT_EQ(given.scene.parameters[0].value, 5);
    EXPECT_FALSE(reader().read(text, {{"n", 10}}).usable);
    EXPECT_THAT(messages(reader().read(text, {{"m", 1}}), text),
                testing::HasSubstr("the scene has no parameter \"m\""));
}

TEST(Reader, DividesAWholeOverrideOfAFractionAsAFraction) {
    const std::string text = "parameter g -value 9.5\n"
                             "shape_set s -desc {-sub {-sphere 1}}\n"
                             "body b s -mass [expr {$g / 2}]\n";
    EXPECT_EQ(reader().read(text, {{"g", 5}}).scene.bodies[0].mass, 2.5);
}

TEST(Reader, IsCancelledFromAnotherThread) {
    std::jthread other([](const std::stop_token& cancelled) { // before it begins in vain
        while (!cancelled.stop_requested()) {
            reader().cancel();
            std::this_thread::yield();
        }
    });
    const ReadResult result = reader().read("while 1 {}");
    other.request_stop();
    other.join();
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].message, "reading was cancelled");
    EXPECT_TRUE(reader().read("").usable); // and goes on
}

TEST(Reader, CancellingNothingDoesNothing) {
    reader().cancel();
    EXPECT_TRUE(reader().read("").usable);
}

} // namespace
} // namespace script
