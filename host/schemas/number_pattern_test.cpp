#include "schemas/number_pattern.h"

#include <gtest/gtest.h>

namespace schemas {

TEST(NumberPattern, LevelsAndWords) {
    struct {
        std::string pattern;
        std::vector<int> path;
        std::string result;
    } cases[] = {{"1.1", {2, 3}, "2.3"},
                 {"1.1", {4}, "4"},
                 {"1.1", {1, 2, 3}, "2.3"},
                 {"Figure 1:", {7}, "Figure 7:"},
                 {"(a)", {28}, "(ab)"},
                 {"I.", {1994}, "MCMXCIV."},
                 {"i", {4}, "iv"},
                 {"Appendix A", {2}, "Appendix B"},
                 {"Section 1.1", {3}, "Section 3"},
                 {"-", {1}, "-"}};
    for (const auto& [pattern, path, result] : cases)
        EXPECT_EQ(numbered(pattern, path), result) << pattern;
    EXPECT_EQ(withoutPunctuation("Figure 1: "), "Figure 1");
    EXPECT_EQ(wordsBefore("Section 1.1"), "Section");
    EXPECT_EQ(withoutWords("Section 1.1"), "1.1");
    EXPECT_EQ(wordsBefore("1.1"), "");
    EXPECT_EQ(withoutWords("none"), "");
}

} // namespace schemas
