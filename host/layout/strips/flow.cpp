#include "strips/flow.h"

#include "paragraphs/measure.h"
#include "strips/cells.h"

#include <algorithm>
#include <numeric>

namespace layout {

using paragraphs::BlockPointer;
using paragraphs::fitted;
using paragraphs::fromPoints;
using paragraphs::InlineObject;
using paragraphs::NoteMark;
using paragraphs::Paragraph;

namespace {

template <class... Ts> struct Overloaded : Ts... { using Ts::operator()...; };
template <class... Ts> Overloaded(Ts...) -> Overloaded<Ts...>; // clang 14 needs it

ImagePiece pieceOf(const model::Picture& picture, const QRectF& rect, sgml::NodeId element,
                   schemas::Align align) {
    const std::string& named = picture.alternative.empty() ? picture.source : picture.alternative;
    return {picture.source, rect, QString::fromStdString(named), element, align};
}

} // namespace

Piece moved(Piece piece, QPointF by) {
    std::visit(Overloaded{[&](TextPiece& text) { text.at += by; },
                          [&](auto& other) { other.rect.translate(by); }},
               piece);
    return piece;
}

Flow::Flow(const Surroundings& in, const model::Blocks& blocks) : in_(in), blocks_(blocks) {}

Flow::~Flow() = default;
Flow::Flow(Flow&&) noexcept = default;

void Flow::seek(Place place) {
    countText();
    block_ = place.block;
    made_ = place.strip;
    breakNext_ = false;
    paragraph_.reset();
    table_.reset();
    entry_ = {};
}

double Flow::left(const BlockPointer& block) const { return fromPoints(block->style.indentLeft); }

double Flow::room(const BlockPointer& block) const {
    return std::max(in_.width - left(block) - fromPoints(block->style.indentRight), fromPoints(20));
}

double Flow::aligned(const BlockPointer& block, double itsWidth) const {
    const double spare = std::max(0.0, room(block) - itsWidth);
    switch (block->style.align) {
    case schemas::Align::center:
        return left(block) + spare / 2;
    case schemas::Align::right:
        return left(block) + spare;
    default:
        return left(block);
    }
}

Made Flow::next(Strip& strip) {
    while (block_ < blocks_.size()) {
        const BlockPointer& block = blocks_[block_];
        bool last = true;
        const Made made = inBlock(block, strip, last);
        if (made == Made::strip)
            finish(block, strip, last);
        if (made != Made::end && (made == Made::pause || !last))
            return made;
        breakNext_ =
            made == Made::end && (breakNext_ || block->kind == model::BlockKind::pageBreak);
        leaveBlock();
        if (made == Made::strip)
            return made;
    }
    return Made::end;
}

void Flow::leaveBlock() {
    countText();
    ++block_;
    made_ = 0;
    paragraph_.reset();
    table_.reset();
    entry_ = {};
}

// The next strip of a block, `last` when there is none behind it; Made::end: the block has none.
Made Flow::inBlock(const BlockPointer& block, Strip& strip, bool& last) {
    using model::BlockKind;
    switch (block->kind) {
    case BlockKind::text:
    case BlockKind::verbatim:
    case BlockKind::chart:
    case BlockKind::formula:
        return text(block, strip, last);
    case BlockKind::table:
        return table(block, strip, last);
    case BlockKind::contents:
        return block->entries.empty() ? text(block, strip, last) : contents(block, strip, last);
    case BlockKind::subdocument:
        subdocument(block, strip);
        return Made::strip;
    case BlockKind::image:
        image(block, strip);
        return Made::strip;
    case BlockKind::rule:
        rule(block, strip);
        return Made::strip;
    case BlockKind::pageBreak:
        break;
    }
    return Made::end;
}

void Flow::finish(const BlockPointer& block, Strip& strip, bool last) {
    ++in_.work.strips;
    strip.block = block_;
    strip.firstOfBlock = made_ == 0;
    strip.lastOfBlock = last;
    if (strip.firstOfBlock) {
        strip.before = fromPoints(block->style.spaceBefore);
        strip.breakBefore = breakNext_ || block->style.pageBreakBefore;
    }
    if (last)
        strip.after = fromPoints(block->style.spaceAfter);
    if (last ? block->style.keepWithNext : block->style.keepTogether)
        strip.keepWithNext = true;
    ++made_;
}

// --- text --------------------------------------------------------------------------------------

void Flow::beginText(const BlockPointer& block) {
    const bool markerInFront = !block->marker.empty() && block->style.markerWidth <= 0 &&
                               block->kind != model::BlockKind::formula;
    const auto part = markerInFront ? Stock::Part::withMarker : Stock::Part::text;
    paragraph_ = in_.stock.paragraph(block, room(block), part, [&] {
        return std::make_unique<Paragraph>(in_.stock.materials(), block, room(block),
                                           markerInFront);
    });
    lettersBefore_ = paragraph_->lettersShaped();
}

void Flow::countText() {
    if (!paragraph_ || paragraph_->lettersShaped() == lettersBefore_)
        return;
    in_.work.letters += paragraph_->lettersShaped() - lettersBefore_;
    lettersBefore_ = paragraph_->lettersShaped();
    ++in_.work.paragraphs;
}

Made Flow::text(const BlockPointer& block, Strip& strip, bool& last) {
    if (!paragraph_)
        beginText(block);
    const std::size_t i = made_;
    if (!paragraph_->makeLine(i))
        return Made::end;
    last = !paragraph_->makeLine(i + 1);
    const int index = static_cast<int>(i);
    strip.height = paragraph_->lines()[i].height;
    for (const NoteMark& mark : paragraph_->notesOf(index))
        strip.footnotes.push_back(mark.note);
    strip.pieces.emplace_back(TextPiece{paragraph_, index, {left(block), 0}});
    for (const InlineObject& object : paragraph_->objectsOf(index)) {
        const model::Run& run = block->runs[object.run];
        const QRectF rect = paragraph_->objectRect(index, object).translated(left(block), 0);
        if (run.picture)
            strip.pieces.emplace_back(
                pieceOf(*run.picture, rect, run.element, schemas::Align::left));
        else if (!object.formula) // the paragraph paints formulas
            strip.pieces.emplace_back(SubdocumentPiece{run.subdocument, rect});
    }
    // Neither the first nor the last line of a paragraph stands alone.
    const bool ragged = block->kind == model::BlockKind::verbatim;
    strip.keepWithNextLine = !ragged && !last && (i == 0 || !paragraph_->makeLine(i + 2));
    strip.keepWithNext = strip.keepWithNextLine;
    // A display stays with the sentence before it.
    const auto isDisplay = [](const BlockPointer& one) {
        return one->kind == model::BlockKind::formula;
    };
    if (last && !isDisplay(block) && block_ + 1 < blocks_.size() && isDisplay(blocks_[block_ + 1]))
        strip.keepWithNext = true;
    const bool isNumbered = isDisplay(block);
    if (i == 0 && !block->marker.empty() && (isNumbered || block->style.markerWidth > 0))
        addMarker(block, strip, paragraph_->lines()[i].baseline);
    return Made::strip;
}

void Flow::addMarker(const BlockPointer& block, Strip& strip, double lineBaseline) const {
    // A formula's number stands on its right.
    const bool isNumber = block->kind == model::BlockKind::formula;
    const double column = isNumber ? room(block) : fromPoints(block->style.markerWidth);
    const auto make = [&] {
        // It keeps the block, by which it is known, alive.
        struct Marker {
            BlockPointer of;
            model::Block block;
        };
        const auto marker = std::make_shared<Marker>();
        marker->of = block;
        marker->block.style.align = isNumber ? schemas::Align::right : block->style.markerAlign;
        marker->block.style.lineHeight = block->style.lineHeight;
        model::Run run;
        run.text = block->marker;
        run.style = block->markerStyle;
        marker->block.runs.push_back(run);
        return std::make_unique<Paragraph>(in_.stock.materials(),
                                           BlockPointer(marker, &marker->block), column);
    };
    const auto paragraph = in_.stock.paragraph(block, column, Stock::Part::marker, make);
    if (!paragraph->makeLine(0))
        return;
    const double down = lineBaseline - paragraph->lines().front().baseline;
    const double x = isNumber ? left(block) : left(block) - column;
    strip.pieces.emplace_back(TextPiece{paragraph, 0, {x, down}});
}

// --- contents ----------------------------------------------------------------------------------

// A strip for each line of each entry. The number stands in a column of its own.
Made Flow::contents(const BlockPointer& block, Strip& strip, bool& last) {
    const schemas::TextStyle& style = in_.stock.materials()->looks.style(block->textStyle);
    const double column = fromPoints(style.size * 2.2);
    const auto indentOf = [](const BlockPointer& entry) {
        return fromPoints(entry->style.indentLeft);
    };
    const auto begin = [&](const BlockPointer& entry) {
        const double width = std::max(room(block) - indentOf(entry) - column, fromPoints(40));
        entry_.paragraph = in_.stock.paragraph(entry, width, Stock::Part::text, [&] {
            return std::make_unique<Paragraph>(in_.stock.materials(), entry, width);
        });
    };
    for (;;) { // only after seek() more than once
        if (entry_.index == block->entries.size())
            return Made::end;
        if (!entry_.paragraph)
            begin(block->entries[entry_.index]);
        if (!entry_.paragraph->makeLine(entry_.line)) {
            entry_ = {.index = entry_.index + 1, .made = entry_.made};
            continue;
        }
        if (entry_.made == made_)
            break;
        ++entry_.line;
        ++entry_.made;
    }
    const BlockPointer& entry = block->entries[entry_.index];
    const double x = left(block) + indentOf(entry);
    const int line = static_cast<int>(entry_.line);
    const Paragraph::Line& letters = entry_.paragraph->lines()[entry_.line];
    strip.height = letters.height;
    strip.pieces.emplace_back(TextPiece{entry_.paragraph, line, {x, 0}});
    const bool endsEntry = !entry_.paragraph->makeLine(entry_.line + 1);
    if (endsEntry) {
        const double end =
            x + entry_.paragraph->leftOf(line, entry_.paragraph->rangeOfLine(line).second);
        const double right = left(block) + room(block);
        strip.pieces.emplace_back(PageNumberPiece{entry->runs.front().target.substr(1),
                                                  style,
                                                  {end, 0, right - end, letters.height},
                                                  letters.baseline});
        last = entry_.index + 1 == block->entries.size();
    } else {
        last = false;
        strip.keepWithNext = true;
    }
    ++entry_.line;
    ++entry_.made;
    return Made::strip;
}

// --- pictures and rules ------------------------------------------------------------------------

void Flow::subdocument(const BlockPointer& block, Strip& strip) const {
    const QSizeF size =
        fitted(in_.stock.sizes().subdocument(block->subdocument), room(block), in_.pictureHeight);
    strip.height = size.height();
    strip.mayFloat = block->style.mayFloat && block->style.keepWithNext;
    strip.pieces.emplace_back(SubdocumentPiece{
        block->subdocument, {QPointF(aligned(block, size.width()), 0), size}, block->style.align});
}

void Flow::image(const BlockPointer& block, Strip& strip) const {
    const QSizeF size =
        fitted(in_.stock.sizes().picture(block->picture), room(block), in_.pictureHeight);
    strip.height = size.height();
    strip.mayFloat = block->style.mayFloat && block->style.keepWithNext;
    strip.pieces.emplace_back(pieceOf(block->picture,
                                      {QPointF(aligned(block, size.width()), 0), size},
                                      block->element, block->style.align));
}

void Flow::rule(const BlockPointer& block, Strip& strip) const {
    const double thickness = fromPoints(std::max(block->style.border.width, 0.25));
    schemas::Border none;
    strip.height = thickness;
    strip.pieces.emplace_back(
        FramePiece{{left(block), 0, room(block), thickness}, block->style.border.color, none});
}

} // namespace layout
