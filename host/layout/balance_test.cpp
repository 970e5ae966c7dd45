// Pages that are filled alike: the plan, and the pages that follow it.
#include "layout/balance.h"
#include "layout/pages.h"
#include "paragraphs/measure.h"
#include "paragraphs/model_testing.h"

#include <gmock/gmock.h>

#include <random>

namespace layout {
namespace {

using ::testing::ElementsAre;

// Portions of one height, with what a page costs that begins with them.
std::vector<Portion> alike(std::size_t count, std::vector<std::size_t> inList = {}) {
    std::vector<Portion> all(count, {.height = 10});
    for (const std::size_t one : inList)
        all[one].cost = withinListCost;
    return all;
}

TEST(BalanceTest, ARestOfOneLineIsNotLeftToTheLastPage) {
    EXPECT_EQ(secondPage(alike(10), false, 100), 10u);
    EXPECT_EQ(secondPage(alike(11), false, 100), 6u);
    EXPECT_EQ(secondPage(alike(21), false, 100), 7u);
}

TEST(BalanceTest, AShortListStaysTogether) {
    // A paragraph of eight lines, and a list of three of which one would fit.
    std::vector<Portion> all = alike(11, {9, 10});
    for (std::size_t line = 1; line < 8; ++line)
        all[line].cost = withinBlockCost;
    EXPECT_EQ(secondPage(all, false, 90), 8u);
    // A list of more than a page is divided.
    EXPECT_EQ(secondPage(alike(12, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}), false, 80), 6u);
}

TEST(BalanceTest, WhereMoreFollowsThePageIsFilled) {
    EXPECT_EQ(secondPage(alike(11), true, 100), 10u);
}

TEST(BalanceTest, WhatIsTallerThanAPageStandsAlone) {
    std::vector<Portion> all = alike(3);
    all[1].height = 200;
    EXPECT_EQ(secondPage(all, false, 100), 1u);
    EXPECT_EQ(secondPage({{.height = 200}}, false, 100), 1u);
    EXPECT_EQ(secondPage({}, false, 100), 0u);
}

class BalancedPagesTest : public ::testing::Test {
protected:
    BalancedPagesTest() {
        const auto styles = std::make_shared<schemas::TextStyles>();
        styles->numberOf({});
        model_.textStyles = styles;
        model_.page.width = 300;
        model_.page.height = 200;
        model_.page.marginLeft = model_.page.marginRight = 20;
        model_.page.marginTop = model_.page.marginBottom = 20;
        model_.page.balance = true;
    }
    void add(const std::string& text) { model_.blocks.push_back(paragraphs::paragraph(text)); }
    void addLines(int count) {
        for (int i = 0; i < count; ++i)
            add("line " + std::to_string(i));
    }
    [[nodiscard]] Pages laidOut(const Pages& old = {}) const {
        return relaid(old, std::make_shared<const model::Model>(model_), {});
    }
    [[nodiscard]] std::vector<std::size_t> linesOfPages() const {
        std::vector<std::size_t> result;
        for (const auto& page : laidOut().pages)
            result.push_back(page->pieces.size());
        return result;
    }
    model::Model model_;
};

TEST_F(BalancedPagesTest, PagesUpToABreakAreFilledAlike) {
    addLines(40);
    const std::size_t full = [&] {
        model_.page.balance = false;
        const std::size_t most = linesOfPages().front();
        model_.page.balance = true;
        return most;
    }();
    model_.blocks.clear();
    addLines(static_cast<int>(full) + 1);
    const std::size_t half = full / 2 + 1;
    EXPECT_THAT(linesOfPages(), ElementsAre(half, full + 1 - half));
    auto next = paragraphs::paragraph("a chapter");
    next->style.pageBreakBefore = true;
    model_.blocks.push_back(next);
    EXPECT_THAT(linesOfPages(), ElementsAre(half, full + 1 - half, 1));
}

// Pages that are kept were planned with all that is read now.
TEST_F(BalancedPagesTest, PagesAfterAChangeAreThoseOfALayoutFromNothing) {
    std::mt19937 random(7);
    addLines(60);
    for (const std::size_t at : {9u, 30u, 31u}) {
        auto chapter = std::make_shared<model::Block>(*model_.blocks[at]);
        chapter->style.pageBreakBefore = true;
        model_.blocks[at] = chapter;
    }
    Pages pages = laidOut();
    for (int i = 0; i < 200; ++i) {
        const std::size_t at = random() % (model_.blocks.size() + 1);
        const auto place = model_.blocks.begin() + static_cast<std::ptrdiff_t>(at);
        if (random() % 2 == 0 || at == model_.blocks.size())
            model_.blocks.insert(place, paragraphs::paragraph("new"));
        else
            model_.blocks.erase(place);
        pages = laidOut(pages);
        ASSERT_EQ(printed(pages), printed(laidOut())) << i;
    }
}

} // namespace
} // namespace layout
