#include "screen/numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <unistd.h>

namespace screen {
namespace {

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

std::string printedHalf() {
    std::array<char, 20> text{};
    std::snprintf(text.data(), text.size(), "%g", 0.5);
    return text.data();
}

TEST(Numbers, OnlyTheyAreNotTheUsers) {
    setenv("LC_ALL", "de_DE.UTF-8", 1);
    setenv("LC_NUMERIC", "fr_FR.UTF-8", 1);
    keepNumbersC();
    EXPECT_EQ(variable("LC_ALL"), "");
    EXPECT_EQ(variable("LC_NUMERIC"), "C");
    EXPECT_EQ(variable("LC_TIME"), "de_DE.UTF-8");
    EXPECT_EQ(variable("LANG"), "de_DE.UTF-8");
}

// With a locale of decimal commas, made here where the system can make one.
TEST(Numbers, HavePointsUnderALocaleOfCommas) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("commas-" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    const std::string make = "localedef -f UTF-8 -i de_DE " + (folder / "de_DE.UTF-8").string();
    const bool isMade = std::system((make + " >/dev/null 2>&1").c_str()) == 0;
    setenv("LOCPATH", folder.c_str(), 1);
    setenv("LC_ALL", "de_DE.UTF-8", 1);
    if (isMade) {
        ASSERT_NE(std::setlocale(LC_ALL, ""), nullptr);
        EXPECT_EQ(printedHalf(), "0,5");
    }
    keepNumbersC();
    std::setlocale(LC_ALL, ""); // as Qt does when it starts
    EXPECT_EQ(printedHalf(), "0.5");
    if (isMade) {
        EXPECT_STREQ(std::setlocale(LC_TIME, nullptr), "de_DE.UTF-8");
    }
    unsetenv("LOCPATH");
    std::filesystem::remove_all(folder);
    if (!isMade)
        GTEST_SKIP() << "no locale of commas could be made: localedef has no de_DE here";
}

} // namespace
} // namespace screen
