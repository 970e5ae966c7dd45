#include "layout/pages.h"

#include "layout/measure.h"
#include "layout/typeface.h"

#include <algorithm>
#include <deque>

namespace layout {

namespace {

constexpr double rulePoints = 0.5;
constexpr double noteGapPoints = 8;

// Strips that must stand on one page.
struct Chunk {
    std::size_t first = 0, last = 0; // inclusive
    bool mayFloat = false;
};

std::vector<Chunk> chunked(const std::vector<Strip>& strips) {
    std::vector<Chunk> chunks;
    for (std::size_t i = 0; i < strips.size(); ++i) {
        if (i == 0 || !strips[i - 1].keepWithNext || strips[i].breakBefore)
            chunks.push_back({i, i, strips[i].mayFloat});
        chunks.back().last = i;
    }
    return chunks;
}

class Filler {
public:
    Filler(const document::Model& model, const Objects& objects) : model_(model) {
        const document::PageStyle& page = model.page;
        pages_.size = {fromPoints(page.width), fromPoints(page.height)};
        pages_.paper = colorOf(page.background);
        left_ = fromPoints(page.marginLeft);
        top_ = fromPoints(page.marginTop);
        bottom_ = pages_.size.height() - fromPoints(page.marginBottom);
        width_ =
            std::max(pages_.size.width() - left_ - fromPoints(page.marginRight), fromPoints(50));
        const double captionRoom = fromPoints(80);
        const StripBuilder builder{model, objects, width_,
                                   std::max(bottom_ - top_ - captionRoom, fromPoints(50))};
        strips_ = builder.strips(model.blocks);
        for (const document::Footnote& note : model.footnotes)
            notes_.push_back(stacked(builder.strips(note.blocks)));
        insets_ = boxInsets();
        newPage();
    }

    Pages fill() {
        for (const Chunk& chunk : chunked(strips_))
            placeOrFloat(chunk);
        while (!floats_.empty()) {
            newPage();
            placeFloats();
        }
        finishPage();
        addHeaders();
        return std::move(pages_);
    }

private:
    struct Inset {
        double before = 0, after = 0;
    };

    // The paddings that boxes put above their first blocks and below their last ones. They are part
    // of the space between blocks already; they count by themselves at the top of a page.
    std::vector<Inset> boxInsets() const {
        std::vector<Inset> insets(model_.blocks.size());
        for (const document::Box& box : model_.boxes)
            if (box.last < insets.size()) {
                insets[box.first].before += fromPoints(box.padding);
                insets[box.last].after += fromPoints(box.padding);
            }
        return insets;
    }

    bool firstOfBlock(std::size_t strip) const {
        return strip == 0 || strips_[strip - 1].block != strips_[strip].block;
    }
    bool lastOfBlock(std::size_t strip) const {
        return strip + 1 == strips_.size() || strips_[strip + 1].block != strips_[strip].block;
    }
    double gapBefore(std::size_t s) const {
        if (y_ == top_)
            return firstOfBlock(s) ? insets_[strips_[s].block].before : 0;
        return std::max(after_, strips_[s].before);
    }

    double notesHeight(const std::vector<std::size_t>& notes) const {
        double height = 0;
        for (std::size_t note : notes)
            if (note < notes_.size())
                height += notes_[note].height;
        return height;
    }

    double heightOf(const Chunk& chunk) const {
        double height = gapBefore(chunk.first);
        for (std::size_t s = chunk.first; s <= chunk.last; ++s) {
            if (s > chunk.first)
                height += std::max(strips_[s - 1].after, strips_[s].before);
            height += strips_[s].height + notesHeight(strips_[s].footnotes);
            if (!strips_[s].footnotes.empty() && pageNotes_.empty())
                height += fromPoints(noteGapPoints);
        }
        return height;
    }

    double roomBelow() const {
        const double gap = pageNotes_.empty() ? 0 : fromPoints(noteGapPoints);
        return bottom_ - y_ - notesHeight(pageNotes_) - gap;
    }

    void placeOrFloat(const Chunk& chunk) {
        if (strips_[chunk.first].breakBefore && y_ > top_) {
            newPage();
            placeFloats();
        }
        if (heightOf(chunk) > roomBelow() && y_ > top_) {
            if (chunk.mayFloat) {
                floats_.push_back(chunk);
                return;
            }
            newPage();
            placeFloats();
            if (heightOf(chunk) > roomBelow() && y_ > top_)
                newPage();
        } else if (chunk.mayFloat && !floats_.empty()) {
            floats_.push_back(chunk); // figures keep their order
            return;
        }
        place(chunk);
    }

    void placeFloats() {
        while (!floats_.empty() && (y_ == top_ || heightOf(floats_.front()) <= roomBelow())) {
            const Chunk chunk = floats_.front();
            floats_.pop_front();
            place(chunk);
        }
    }

    void place(const Chunk& chunk) {
        for (std::size_t s = chunk.first; s <= chunk.last; ++s) {
            const Strip& strip = strips_[s];
            const double needed = gapBefore(s) + strip.height + notesHeight(strip.footnotes);
            if (needed > roomBelow() && y_ > top_)
                newPage();
            y_ += gapBefore(s);
            note(s);
            for (const Piece& piece : strip.pieces)
                put(moved(piece, {left_, y_}));
            placed_.push_back({s, y_, y_ + strip.height});
            y_ += strip.height;
            after_ = strip.after;
            pageNotes_.insert(pageNotes_.end(), strip.footnotes.begin(), strip.footnotes.end());
        }
    }

    // What refers to places: the outline and the anchors.
    void note(std::size_t s) {
        if (!firstOfBlock(s))
            return;
        const document::Block& block = model_.blocks[strips_[s].block];
        const std::size_t page = pages_.pages.size() - 1;
        for (const std::string& anchor : block.anchors)
            pages_.anchors[anchor] = {page, y_};
        if (block.headingLevel > 0) {
            QString text = QString::fromStdString(block.marker);
            for (const document::Run& run : block.runs)
                if (run.kind == document::RunKind::text)
                    text += (text.isEmpty() || text.endsWith(' ') || &run != &block.runs.front()
                                 ? QString()
                                 : QStringLiteral(" ")) +
                            QString::fromStdString(run.text);
            pages_.outline.push_back({text, block.headingLevel, page, y_});
        }
    }

    void put(const Piece& piece) {
        if (const auto* placed = std::get_if<SubdocumentPiece>(&piece))
            pages_.subdocuments.push_back(
                {placed->subdocument, pages_.pages.size() - 1, placed->rect});
        pages_.pages.back().pieces.push_back(piece);
    }

    void newPage() {
        if (!pages_.pages.empty())
            finishPage();
        pages_.pages.emplace_back();
        y_ = top_;
        after_ = 0;
    }

    // Boxes lie behind what is in them; footnotes stand at the bottom.
    void finishPage() {
        std::vector<Piece> behind;
        for (const document::Box& box : model_.boxes)
            addBox(box, behind);
        auto& pieces = pages_.pages.back().pieces;
        pieces.insert(pieces.begin(), behind.begin(), behind.end());
        addNotes();
        placed_.clear();
        pageNotes_.clear();
    }

    void addBox(const document::Box& box, std::vector<Piece>& behind) const {
        double from = 1e300, to = -1e300;
        bool first = false, last = false;
        for (const Placed& placed : placed_) {
            const std::size_t block = strips_[placed.strip].block;
            if (block < box.first || block > box.last)
                continue;
            from = std::min(from, placed.top);
            to = std::max(to, placed.bottom);
            first |= block == box.first && firstOfBlock(placed.strip);
            last |= block == box.last && lastOfBlock(placed.strip);
        }
        if (from > to)
            return;
        FramePiece frame;
        frame.background = box.background;
        frame.border = box.border;
        frame.border.top &= first; // a box that goes on is open where the page ends
        frame.border.bottom &= last;
        frame.rect = QRectF(QPointF(left_ + fromPoints(box.indentLeft),
                                    from - within(box, box.first, &Inset::before)),
                            QPointF(left_ + width_ - fromPoints(box.indentRight),
                                    to + within(box, box.last, &Inset::after)));
        behind.push_back(frame);
    }

    // The paddings of `box` and of the boxes in it at that block.
    double within(const document::Box& box, std::size_t block, double Inset::*side) const {
        double sum = 0;
        bool inside = false;
        for (const document::Box& other : model_.boxes) {
            inside |= &other == &box;
            if (inside && (side == &Inset::before ? other.first : other.last) == block &&
                other.first >= box.first && other.last <= box.last)
                sum += fromPoints(other.padding);
        }
        return sum;
    }

    void addNotes() {
        if (pageNotes_.empty())
            return;
        double y = bottom_ - notesHeight(pageNotes_);
        const double ruleTop = y - fromPoints(noteGapPoints / 2);
        put(FramePiece{{left_, ruleTop, width_ / 4, fromPoints(rulePoints)},
                       document::Color{150, 150, 150},
                       {}});
        for (std::size_t note : pageNotes_) {
            if (note >= notes_.size())
                continue;
            for (const Piece& piece : notes_[note].pieces)
                put(moved(piece, {left_, y}));
            y += notes_[note].height;
        }
    }

    // --- headers and footers

    void addHeaders() {
        const document::PageStyle& style = model_.page;
        const std::array<std::pair<const std::string*, document::Align>, 3> header{
            {{&style.headerLeft, document::Align::left},
             {&style.headerCenter, document::Align::center},
             {&style.headerRight, document::Align::right}}};
        const std::array<std::pair<const std::string*, document::Align>, 3> footer{
            {{&style.footerLeft, document::Align::left},
             {&style.footerCenter, document::Align::center},
             {&style.footerRight, document::Align::right}}};
        const double height = fromPoints(style.headerStyle.size * 1.2);
        for (std::size_t page = 0; page < pages_.pages.size(); ++page) {
            if (page > 0 || style.headerOnFirstPage)
                for (const auto& [text, align] : header)
                    addLine(page, *text, align, top_ / 2 - height / 2);
            for (const auto& [text, align] : footer)
                addLine(page, *text, align,
                        bottom_ + (pages_.size.height() - bottom_) / 2 - height / 2);
        }
    }

    void addLine(std::size_t page, const std::string& pattern, document::Align align, double y) {
        if (pattern.empty())
            return;
        QString text = QString::fromStdString(pattern);
        text.replace("{page}", QString::number(page + 1));
        text.replace("{pages}", QString::number(pages_.pages.size()));
        text.replace("{title}", QString::fromStdString(model_.title));
        document::Model model;
        model.textStyles = {model_.page.headerStyle};
        document::Block block;
        block.style.align = align;
        document::Run run;
        run.text = text.toStdString();
        block.runs.push_back(run);
        const auto paragraph = std::make_shared<const Paragraph>(model, block, width_, Objects{});
        if (!paragraph->lines().empty())
            pages_.pages[page].pieces.push_back(TextPiece{paragraph, 0, {left_, y}});
    }

    struct Placed {
        std::size_t strip = 0;
        double top = 0, bottom = 0;
    };

    const document::Model& model_;
    Pages pages_;
    double left_ = 0, top_ = 0, bottom_ = 0, width_ = 0;
    std::vector<Strip> strips_;
    std::vector<Stack> notes_;
    std::vector<Inset> insets_;
    std::deque<Chunk> floats_;
    double y_ = 0, after_ = 0;
    std::vector<Placed> placed_; // on the page that is being filled
    std::vector<std::size_t> pageNotes_;
};

} // namespace

Pages layOut(const document::Model& model, const Objects& objects) {
    return Filler(model, objects).fill();
}

const document::Run* runAt(const Page& page, QPointF point) {
    for (const Piece& piece : page.pieces) {
        const auto* text = std::get_if<TextPiece>(&piece);
        if (!text)
            continue;
        const double height = text->paragraph->lines()[static_cast<std::size_t>(text->line)].height;
        if (point.y() >= text->at.y() && point.y() < text->at.y() + height)
            if (const auto* run = text->paragraph->runAt(text->line, point.x() - text->at.x()))
                return run;
    }
    return nullptr;
}

std::string printed(const Pages& pages) {
    QString result;
    const auto line = [&](const char* kind, QRectF rect, const QString& text) {
        rect = {rect.topLeft() / twipsPerPoint, rect.size() / twipsPerPoint};
        result += QStringLiteral("  %1 %2,%3 %4x%5 %6\n")
                      .arg(QLatin1String(kind))
                      .arg(qRound(rect.x()))
                      .arg(qRound(rect.y()))
                      .arg(qRound(rect.width()))
                      .arg(qRound(rect.height()))
                      .arg(text.trimmed());
    };
    for (std::size_t i = 0; i < pages.pages.size(); ++i) {
        result += QStringLiteral("page %1\n").arg(i + 1);
        for (const Piece& piece : pages.pages[i].pieces) {
            if (const auto* text = std::get_if<TextPiece>(&piece)) {
                const auto& of = text->paragraph->lines()[static_cast<std::size_t>(text->line)];
                line("text", {text->at, QSizeF(text->paragraph->naturalWidth(), of.height)},
                     text->paragraph->textOfLine(text->line));
            } else if (const auto* placed = std::get_if<SubdocumentPiece>(&piece)) {
                line("subdocument", placed->rect, QString::number(placed->subdocument));
            } else if (const auto* frame = std::get_if<FramePiece>(&piece)) {
                line("frame", frame->rect, {});
            } else if (const auto* image = std::get_if<ImagePiece>(&piece)) {
                line("image", image->rect, image->alternative);
            }
        }
    }
    return result.toStdString();
}

} // namespace layout
