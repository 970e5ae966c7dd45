// Neither the first nor the last line of a paragraph stands alone on a page, in documents made at
// random.
#include "layout/pages.h"
#include "paragraphs/measure.h"
#include "paragraphs/model_testing.h"

#include <gmock/gmock.h>

#include <map>
#include <random>
#include <set>

namespace layout {
namespace {

class WidowsTest : public ::testing::Test {
protected:
    WidowsTest() {
        const auto styles = std::make_shared<schemas::TextStyles>();
        styles->numberOf({});
        model_.textStyles = styles;
        model_.page.width = 260;
        model_.page.marginLeft = model_.page.marginRight = 20;
        model_.page.marginTop = model_.page.marginBottom = 30;
        objects_.subdocumentSize = [](document::SubdocumentId id) {
            return paragraphs::fromPixels({100.0, 20.0 * static_cast<double>(id)});
        };
    }
    unsigned below(unsigned n) { return random_() % n; }
    std::string words(unsigned most) {
        std::string text;
        for (unsigned i = 0, n = 1 + below(most); i < n; ++i)
            text += std::string(1 + below(9), static_cast<char>('a' + below(26))) + " ";
        return text;
    }
    std::shared_ptr<const model::Block> someBlock() {
        switch (below(12)) {
        case 0: {
            paragraphs::NewBlock heading = paragraphs::paragraph(words(12));
            heading->style.keepWithNext = true;
            heading->style.spaceBefore = 14;
            return heading;
        }
        case 1:
            return paragraphs::picture(1 + below(9));
        case 2:
            return paragraphs::noted(words(60), "*", words(20));
        case 3:
            return paragraphs::tableOf(std::vector<model::Row>(1 + below(9), model::Row(2)));
        default: {
            paragraphs::NewBlock block = paragraphs::paragraph(words(90));
            block->style.spaceBefore = below(2) == 0 ? 0 : 5;
            return block;
        }
        }
    }

    model::Model model_;
    paragraphs::Objects objects_;
    std::mt19937 random_{17};
};

TEST_F(WidowsTest, NoLineOfAParagraphStandsAloneOnAPage) {
    std::size_t divided = 0;
    for (int round = 0; round < 200; ++round) {
        model_.page.height = 200 + below(200);
        model_.blocks.clear();
        for (int i = 0; i < 60; ++i)
            model_.blocks.push_back(someBlock());
        const Pages laid = layOut(std::make_shared<model::Model>(model_), objects_);
        // The lines of each paragraph, page by page.
        std::map<const paragraphs::Paragraph*, std::map<std::size_t, std::set<int>>> lines;
        for (std::size_t page = 0; page < laid.pages.size(); ++page)
            for (const Piece& piece : laid.pages[page]->pieces)
                if (const auto* text = std::get_if<TextPiece>(&piece); text && !text->isOfNote)
                    lines[text->paragraph.get()][page].insert(text->line);
        for (const auto& [paragraph, pages] : lines) {
            divided += pages.size() > 1 ? 1 : 0;
            int next = 0;
            for (const auto& [page, some] : pages)
                for (const int line : some)
                    EXPECT_EQ(line, next++) << "round " << round << ", page " << page + 1;
            const auto toldIf = [&, one = paragraph](const std::set<int>& some) {
                EXPECT_TRUE(pages.size() == 1 || some.size() > 1)
                    << "round " << round << ": " << one->textOfLine(*some.begin()).toStdString();
            };
            toldIf(pages.begin()->second);
            toldIf(pages.rbegin()->second);
        }
    }
    EXPECT_GT(divided, 1000u);
}

} // namespace
} // namespace layout
