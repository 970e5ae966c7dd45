// Rows of a text on a page; the pictures themselves are looked at.
#include "charts/text_page.h"

#include <gtest/gtest.h>

namespace {

using charts::TextPage;

TEST(TextPage, HasARowForEachLineAndMoreForWideOnes) {
    EXPECT_EQ(TextPage("a\n\nb\n", {}, 300).rows(), 3U);
    EXPECT_EQ(TextPage("", {}, 300).rows(), 0U);
    const TextPage wide(std::string(100, 'x'), {}, 300);
    EXPECT_EQ(wide.rows(), 3U); // some 42 letters each
    EXPECT_EQ(TextPage("\xC3\xA4\xC3\xA4", {}, 300).rows(), 1U);
}

TEST(TextPage, NoPageBeginsBehindTheLastFullOne) {
    std::string text;
    for (int i = 0; i < 30; ++i)
        text += "line\n";
    const TextPage page(text, {}, 300);
    EXPECT_EQ(page.top(0, page.height()), 0U);
    EXPECT_EQ(page.top(7, page.height()), 0U);
    EXPECT_EQ(page.top(7, page.height() / 2), 7U);
    EXPECT_LT(page.top(1000, page.height() / 2), 20U);
}

TEST(TextPage, ShowsItsLinesItsFaultsAndWhatIsLeft) {
    const auto picture = [](std::string_view text, const std::set<std::size_t>& faulty,
                            double height) {
        charts::Canvas canvas(200, 60, 1);
        TextPage(text, faulty, 200).draw(canvas, height);
        return canvas.pixels().colors;
    };
    const auto plain = picture("a\nb\nc\nd", {}, 60);
    EXPECT_NE(plain, picture("a\nb\nc\ne", {}, 40));
    EXPECT_NE(plain, picture("a\nb\nc\nd", {2}, 60));
    EXPECT_NE(plain, picture("a\nb\nc\nd", {}, 40)); // "2 more lines"
    // Bytes that no letter has are signs, and what follows is shown all the same.
    EXPECT_NE(picture("\xFF\na", {}, 60), picture("\xFF\nb", {}, 60));
    EXPECT_NE(picture("\001\na", {}, 60), picture("\001\nb", {}, 60));
}

} // namespace
