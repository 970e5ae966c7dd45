// What authors read when a scene is wrong: golden texts.
//
// golden/diagnostics.txt holds scenes ("=== " and one line, after a first line that they share) and
// what reading each says. REBASELINE=1 writes what is said now; look at the difference.
#include "script/reader.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace script {
namespace {

constexpr const char* goldenFile = SOURCE_DIR "/medium-asgard/script/golden/diagnostics.txt";
constexpr const char* firstLine = "shape_set s -desc {-sub {-sphere 1}}; body b s\n";

std::vector<std::string> blocks(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("=== "))
            all.emplace_back();
        if (!all.empty())
            all.back() += line + "\n";
    }
    return all;
}

std::string firstDifference(const std::string& golden, const std::string& now) {
    const std::vector<std::string> expected = blocks(golden);
    const std::vector<std::string> found = blocks(now);
    for (std::size_t i = 0; i < expected.size() && i < found.size(); ++i)
        if (expected[i] != found[i])
            return "expected:\n" + expected[i] + "found:\n" + found[i];
    return expected.size() == found.size() ? "" : "not as many scenes";
}

TEST(Diagnostics, AreAsTheGoldenFileSays) {
    std::ifstream file(goldenFile);
    std::stringstream golden;
    golden << file.rdbuf();
    std::string now;
    int scenes = 0;
    Reader reader;
    for (std::string line; std::getline(golden, line);) {
        if (!line.starts_with("=== "))
            continue;
        ++scenes;
        now += line + "\n";
        const std::string text = firstLine + line.substr(4) + "\n";
        for (const scene::Diagnostic& diagnostic : reader.read(text).diagnostics)
            now += scene::formatted(diagnostic, "scene.al", text) + "\n";
    }
    EXPECT_GE(scenes, 100);
    if (std::getenv("REBASELINE"))
        std::ofstream(goldenFile) << now;
    else
        EXPECT_EQ(firstDifference(golden.str(), now), "");
}

// The contract's example.
TEST(Diagnostics, NameTheOptionThatNothingFollows) {
    const std::string text = "\n\n\n\n\n\n\n\n\n\n"
                             "shape_set box -desc {-sub {-sphere 1}}\n"
                             "body b1 box -init_pos\n";
    Reader reader;
    const ReadResult result = reader.read(text);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].line, 12);
    EXPECT_EQ(result.diagnostics[0].column, 13);
    EXPECT_EQ(result.diagnostics[0].message,
              "-init_pos of body \"b1\" wants three numbers, and nothing follows it");
}

} // namespace
} // namespace script
