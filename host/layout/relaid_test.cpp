// Pages that follow changes of their model are those of a layout from nothing, and cost what has
// changed.
#include "layout/pages.h"
#include "paragraphs/measure.h"
#include "paragraphs/model_testing.h"
#include "places/find.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace layout {

using paragraphs::NewBlock;
using paragraphs::noted;
using paragraphs::Objects;
using paragraphs::Paragraph;
using paragraphs::paragraph;
using paragraphs::picture;
using paragraphs::tableOf;
using places::findText;
using places::Found;

namespace {

using model::Block;
using model::Blocks;

// All that views read of pages.
std::string everything(const Pages& pages) {
    std::string result = printed(pages);
    for (const PlacedSubdocument& placed : pages.subdocuments())
        result += "subdocument " + std::to_string(placed.subdocument) + " on " +
                  std::to_string(placed.page) + " at " + std::to_string(placed.rect.y()) + "\n";
    for (const OutlineEntry& entry : pages.outline())
        result += "heading " + entry.heading.text.toStdString() + " on " +
                  std::to_string(entry.page) + " at " + std::to_string(entry.heading.top) + "\n";
    for (const auto& page : pages.pages)
        for (const auto& [name, top] : page->anchors)
            result += "anchor " + name + " at " + std::to_string(top) + "\n";
    return result;
}

class RelaidTest : public ::testing::Test {
protected:
    RelaidTest() {
        const auto styles = std::make_shared<schemas::TextStyles>();
        styles->numberOf({});
        model_.textStyles = styles;
        model_.page.width = 260; // some lines to a page, so that there are many of these
        model_.page.height = 300;
        model_.page.marginLeft = model_.page.marginRight = 20;
        model_.page.marginTop = model_.page.marginBottom = 30;
        model_.page.footerCenter = "{page} / {pages}";
        objects_.subdocumentSize = [this](document::SubdocumentId id) { return sizes_[id]; };
        objects_.imageSize = [this](const std::string& source) {
            return QSize(200, 20 * static_cast<int>(source.size()));
        };
    }
    ModelPointer model() const { return std::make_shared<model::Model>(model_); }
    unsigned below(unsigned n) { return random_() % n; }

    std::string words(unsigned most) {
        std::string text;
        for (unsigned i = 0, n = 1 + below(most); i < n; ++i)
            text +=
                (i == 0 ? "" : " ") + std::string(1 + below(9), static_cast<char>('a' + below(26)));
        return text;
    }

    NewBlock someText() {
        NewBlock block = paragraph(words(below(3) == 0 ? 80 : 12));
        switch (below(12)) {
        case 0:
            block->headingLevel = 1;
            block->style.keepWithNext = true;
            block->style.spaceBefore = 12;
            block->anchors = {"h" + std::to_string(below(1000))};
            break;
        case 1:
            block->style.pageBreakBefore = below(3) == 0;
            break;
        case 2:
        case 3:
            block = noted(words(20), "*", words(below(6) == 0 ? 400 : 12));
            break;
        case 4:
            addInline(*block);
            break;
        case 5:
            block->marker = "1.";
            block->style.indentLeft = 20;
            block->style.markerWidth = below(2) == 0 ? 15 : 0;
            break;
        case 6:
            block->style.keepTogether = true;
            break;
        default:
            break;
        }
        block->style.spaceBefore += below(3) == 0 ? 6 : 0;
        return block;
    }

    void addInline(Block& block) {
        model::Run& run = block.runs.emplace_back();
        if (below(3) == 0) {
            run.kind = model::RunKind::image;
            run.picture = std::make_shared<model::Picture>(
                model::Picture{.source = std::string(1 + below(9), 'i')});
        } else {
            run.kind = model::RunKind::subdocument;
            run.subdocument = 1 + below(20);
        }
        block.runs.emplace_back().text = " " + words(10);
    }

    NewBlock someTable() {
        std::vector<model::Row> rows(1 + below(5), model::Row(1 + below(3)));
        const bool isTall = below(4) == 0;
        for (model::Row& row : rows)
            for (model::Cell& cell : row) {
                cell.style.border.width = 1;
                cell.blocks.push_back(paragraph(words(isTall ? 150 : 6)));
                if (below(6) == 0)
                    cell.blocks.push_back(picture(1 + below(20)));
                if (below(8) == 0)
                    cell.blocks.push_back(noted(words(3), "+", words(9)));
            }
        return tableOf(std::move(rows));
    }

    NewBlock someContents() {
        auto block = std::make_shared<Block>();
        block->kind = model::BlockKind::contents;
        block->runs.emplace_back().text = "nothing";
        for (unsigned i = 0, n = below(12); i < n; ++i) {
            NewBlock entry = paragraph(words(below(4) == 0 ? 40 : 5));
            entry->runs.front().target = "#h" + std::to_string(below(1000));
            entry->style.indentLeft = 10 * below(3);
            block->entries.push_back(entry);
        }
        return block;
    }

    std::shared_ptr<const Block> someBlock() {
        switch (below(15)) {
        case 14:
            return someContents();
        case 0:
            return someTable();
        case 1: {
            NewBlock block = picture(1 + below(20));
            block->style.keepWithNext = below(4) != 0;
            block->style.mayFloat = below(4) != 0;
            return block;
        }
        case 2: {
            auto block = std::make_shared<Block>();
            block->kind = model::BlockKind::image;
            block->picture.source = std::string(1 + below(9), 'i');
            block->style.keepWithNext = below(2) == 0;
            block->style.mayFloat = below(2) == 0;
            return block;
        }
        case 3: {
            auto block = std::make_shared<Block>();
            block->kind = below(2) == 0 ? model::BlockKind::pageBreak : model::BlockKind::rule;
            return block;
        }
        default:
            return someText();
        }
    }

    // Boxes follow the blocks in them, as in a model that is made anew.
    void shiftBoxes(std::size_t from, std::size_t removed, std::size_t added) {
        std::erase_if(model_.boxes, [&](model::Box& box) {
            const auto moved = [&](std::size_t at, std::size_t inside) {
                return at < from ? at : at < from + removed ? inside : at - removed + added;
            };
            const std::size_t last = box.last + 1;
            box.first = moved(box.first, from + added);
            const std::size_t end = last <= from             ? last
                                    : last <= from + removed ? from
                                                             : last - removed + added;
            box.last = end - 1;
            return end <= box.first || end == 0;
        });
    }
    void replace(std::size_t from, std::size_t removed, const Blocks& by) {
        shiftBoxes(from, removed, by.size());
        const auto at = model_.blocks.begin() + static_cast<std::ptrdiff_t>(from);
        model_.blocks.insert(model_.blocks.erase(at, at + static_cast<std::ptrdiff_t>(removed)),
                             by.begin(), by.end());
    }

    // A box over some blocks that cross no other's border.
    void addBox() {
        model::Box box;
        box.first = below(static_cast<unsigned>(model_.blocks.size()));
        box.last = std::min(box.first + below(30), model_.blocks.size() - 1);
        box.padding = 4;
        box.border.width = 1 + below(2);
        for (const model::Box& other : model_.boxes) {
            const bool apart = other.last < box.first || other.first > box.last;
            const bool inside = other.first < box.first && other.last > box.last;
            if (!apart && !inside)
                return;
        }
        model_.boxes.push_back(box);
        std::ranges::stable_sort(model_.boxes, {}, &model::Box::first);
    }

    void changeOne() {
        const std::size_t count = model_.blocks.size(), at = below(static_cast<unsigned>(count));
        switch (below(9)) {
        case 0: { // inserted
            Blocks some;
            for (unsigned i = 0, n = 1 + below(4); i < n; ++i)
                some.push_back(someBlock());
            return replace(at, 0, some);
        }
        case 1: // removed
            return replace(at, std::min<std::size_t>(1 + below(4), count - at - (at == 0)), {});
        case 2: { // split, as by Enter
            if (model_.blocks[at]->runs.empty())
                return;
            auto first = std::make_shared<Block>(*model_.blocks[at]), second = first;
            second = std::make_shared<Block>(*first);
            std::string& text = first->runs.front().text;
            second->runs.front().text = text.substr(text.size() / 2);
            text.resize(text.size() / 2);
            return replace(at, 1, {first, second});
        }
        case 3:
            model_.blocks[at] = someBlock();
            return;
        case 4: // an object grows
            sizes_[1 + below(20)] = QSizeF(400 + 100 * below(30), 400 + 100 * below(50));
            return;
        case 5:
            if (model_.boxes.empty() || below(2) == 0)
                return addBox();
            model_.boxes.erase(model_.boxes.begin() +
                               below(static_cast<unsigned>(model_.boxes.size())));
            return;
        case 6: { // some are moved
            const std::size_t n = std::min<std::size_t>(1 + below(20), count - at);
            const Blocks some(model_.blocks.begin() + static_cast<std::ptrdiff_t>(at),
                              model_.blocks.begin() + static_cast<std::ptrdiff_t>(at + n));
            if (n == count)
                return;
            replace(at, n, {});
            return replace(below(static_cast<unsigned>(model_.blocks.size())), 0, some);
        }
        default: { // a letter
            auto block = std::make_shared<Block>(*model_.blocks[at]);
            if (!block->runs.empty())
                block->runs.front().text += static_cast<char>('a' + below(26));
            model_.blocks[at] = block;
        }
        }
    }

    void begin(unsigned blocks) {
        for (document::SubdocumentId id = 1; id <= 20; ++id)
            sizes_[id] = QSizeF(400 + 100 * below(30), 400 + 100 * below(20));
        for (unsigned i = 0; i < blocks; ++i)
            model_.blocks.push_back(someBlock());
        for (unsigned i = 0; i < 6; ++i)
            addBox();
    }

    model::Model model_;
    Objects objects_;
    std::map<document::SubdocumentId, QSizeF> sizes_;
    std::mt19937 random_{1};
};

TEST_F(RelaidTest, PagesThatFollowRandomChangesAreThoseFromNothing) {
    std::size_t filled = 0, all = 0;
    for (unsigned seed = 1; seed <= 30; ++seed) {
        random_.seed(seed);
        model_.blocks.clear();
        model_.boxes.clear();
        begin(10 + below(50));
        Pages pages = layOut(model(), objects_);
        for (int edit = 0; edit < 40; ++edit) {
            for (unsigned i = 0, n = 1 + (below(5) == 0 ? below(5) : 0); i < n; ++i)
                changeOne();
            pages = relaid(pages, model(), objects_);
            ASSERT_EQ(everything(pages), everything(layOut(model(), objects_)))
                << "seed " << seed << ", edit " << edit;
            filled += pages.work.pages;
            all += pages.pages.size();
        }
    }
    EXPECT_LT(filled, all / 2);
    RecordProperty("filled", static_cast<int>(filled));
    RecordProperty("all", static_cast<int>(all));
}

// Cells that are the same blocks as before are neither measured nor broken into lines again.
TEST_F(RelaidTest, ALetterInALongTableCostsItsCell) {
    random_.seed(5);
    std::vector<model::Row> rows(200, model::Row(3));
    for (model::Row& row : rows)
        for (model::Cell& cell : row)
            cell.blocks.push_back(paragraph(words(8)));
    model_.blocks = {tableOf(rows)};
    Pages pages = layOut(model(), objects_);
    EXPECT_GE(pages.work.paragraphs, 600u);
    rows[100][1].blocks = {paragraph("a a")};
    model_.blocks = {tableOf(rows)};
    pages = relaid(pages, model(), objects_);
    EXPECT_EQ(pages.work.paragraphs, 1u);
    EXPECT_LE(pages.work.letters, 20u);
    EXPECT_EQ(everything(pages), everything(layOut(model(), objects_)));
}

// Some thousand paragraphs on 957 pages, in chapters of ten pages.
class LongTest : public RelaidTest {
protected:
    LongTest() {
        for (int i = 0; pages_.pages.size() < 957; i += 300) {
            for (int k = 0; k < 300; ++k) {
                NewBlock block = paragraph(words(30));
                block->style.pageBreakBefore = (i + k) % 50 == 0;
                model_.blocks.push_back(block);
            }
            pages_ = relaid(pages_, model(), objects_);
        }
    }
    std::size_t blockOnPage(std::size_t page) const {
        const auto& piece = std::get<TextPiece>(pages_.pages[page]->pieces[5]);
        const auto at = std::ranges::find(model_.blocks, piece.paragraph->block());
        return static_cast<std::size_t>(at - model_.blocks.begin());
    }
    void change(std::size_t block, const std::string& to) {
        auto changed = std::make_shared<Block>(*model_.blocks[block]);
        changed->runs.front().text = to;
        model_.blocks[block] = changed;
    }
    void follow() { pages_ = relaid(pages_, model(), objects_); }

    Pages pages_;
};

TEST_F(LongTest, AChangeOnPage500CostsItsOwnParagraphAndSomePages) {
    const std::size_t block = blockOnPage(500);
    const Pages before = pages_;
    change(block, model_.blocks[block]->runs.front().text + "x"); // a letter
    follow();
    EXPECT_EQ(pages_.work.paragraphs, 1u);
    EXPECT_LE(pages_.work.pages, 3u);
    EXPECT_EQ(pages_.pages[900], before.pages[900]);

    change(block, model_.blocks[block]->runs.front().text + " " + std::string(150, 'y')); // lines
    follow();
    EXPECT_EQ(pages_.work.paragraphs, 1u);
    EXPECT_LE(pages_.work.pages, 15u); // up to the next chapter
    EXPECT_EQ(pages_.pages.back(), before.pages.back());

    replace(block, 0, {paragraph("new")}); // Enter
    follow();
    EXPECT_EQ(pages_.work.paragraphs, 1u);
    EXPECT_LE(pages_.work.pages, 15u);
    EXPECT_EQ(pages_.pages.back(), before.pages.back());

    for (const std::size_t at : {blockOnPage(200), blockOnPage(700)}) // two at once
        change(at, model_.blocks[at]->runs.front().text + "x");
    follow();
    EXPECT_EQ(pages_.work.paragraphs, 2u);
    EXPECT_LE(pages_.work.pages, 6u);

    follow(); // nothing
    EXPECT_EQ(pages_.work.pages, 0u);
}

// The pages kept of a long document are those that were asked for last.
TEST_F(LongTest, LettersOfFewPagesAreKept) {
    EXPECT_LE(Paragraph::lettersKept(), Paragraph::mostKept);
    const std::string once = printed(pages_);
    EXPECT_LE(Paragraph::lettersKept(), Paragraph::mostKept);
    EXPECT_EQ(printed(pages_), once);

    // A word that is found has a place in its line once that is asked for.
    const std::size_t layouts = Paragraph::layoutsMade();
    std::vector<Found> found = findText(pages_, "a");
    EXPECT_GT(found.size(), 1000u);
    EXPECT_EQ(Paragraph::layoutsMade(), layouts);
    EXPECT_GT(found.front().parts.front().rect().width(), 0);
    EXPECT_EQ(Paragraph::layoutsMade(), layouts + 1);

    found.clear();
    pages_ = {};
    EXPECT_EQ(Paragraph::lettersKept(), 0u);
}

} // namespace
} // namespace layout
