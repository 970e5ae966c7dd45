#include "strips/flow.h"

#include "paragraphs/measure.h"
#include "strips/cells.h"
#include "strips/number_columns.h"

#include <algorithm>
#include <numeric>

namespace layout {

using paragraphs::BlockPointer;
using paragraphs::fitted;
using paragraphs::fromPoints;
using paragraphs::InlineObject;
using paragraphs::NoteMark;
using paragraphs::Paragraph;
using paragraphs::Widths;
using paragraphs::widthsOf;

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

// --- tables ------------------------------------------------------------------------------------

namespace {

// The width that a block in a cell would like, and the least, of at most so many letters.
Widths widthsIn(const Surroundings& in, Columns& columns, const BlockPointer& pointer,
                double available, std::size_t& letters) {
    Stock& stock = in.stock;
    const model::Block& block = *pointer;
    const auto sizeOf = [&](document::SubdocumentId id) {
        columns.sizes.emplace_back(id, stock.sizes().subdocument(id));
        return columns.sizes.back().second;
    };
    const auto measured = measuredOf(in, pointer, letters);
    columns.cells.push_back(measured);
    letters -= measured->letters;
    Widths widths = measured->widths;
    for (const model::Run& run : block.runs) {
        if (run.kind == model::RunKind::subdocument)
            sizeOf(run.subdocument);
        if (run.picture) // it takes what there is
            widths.least = std::min(widths.least, available / 3);
    }
    const auto isPicture = [](const model::Run& run) { return run.picture != nullptr; };
    if (std::ranges::all_of(block.runs, isPicture))
        widths.natural = std::min(widths.natural, available / 3);
    if (block.kind == model::BlockKind::subdocument)
        widths.natural = widths.least = sizeOf(block.subdocument).width();
    else if (block.kind != model::BlockKind::text)
        widths.natural = std::max(widths.natural, available / 3);
    return widths;
}

// The width that a cell would like, with its padding.
Widths widthsOf(const Surroundings& in, Columns& columns, const model::Cell& cell, double available,
                std::size_t& letters) {
    Widths wanted;
    std::size_t ofCell = Paragraph::segmentLength;
    for (const auto& pointer : cell.blocks) {
        const std::size_t before = ofCell;
        if (before == 0)
            break;
        const Widths widths = widthsIn(in, columns, pointer, available, ofCell);
        letters -= std::min(letters, before - ofCell);
        const double extra = 2 * fromPoints(cell.style.padding) +
                             fromPoints(pointer->style.indentLeft) + fromPoints(0.5);
        wanted.natural = std::max(wanted.natural, widths.natural + extra);
        wanted.least = std::max(wanted.least, widths.least + extra);
        if (widths.number > 0)
            wanted.number = std::max(wanted.number, widths.number + extra);
    }
    return wanted;
}

// Several columns share the width that a cell over them lacks.
void widen(std::vector<Widths>& wanted, const document::GridCell& place, const Widths& cell,
           const std::vector<double>& fixed) {
    double natural = 0, least = 0, free = 0;
    for (std::size_t c = place.column; c <= place.lastColumn(); ++c) {
        natural += wanted[c].natural;
        least += wanted[c].least;
        free += c < fixed.size() && fixed[c] > 0 ? 0 : 1;
    }
    for (std::size_t c = place.column; c <= place.lastColumn(); ++c) {
        if (c < fixed.size() && fixed[c] > 0)
            continue;
        wanted[c].natural += std::max(0.0, cell.natural - natural) / free;
        wanted[c].least += std::max(0.0, cell.least - least) / free;
    }
}

// Of each column. Every column is measured by one of its cells at least.
std::vector<Widths> wantedBy(const Surroundings& in, Columns& columns, double available,
                             std::vector<NumberColumn>& numbers) {
    const model::Block& table = *columns.block;
    std::vector<Widths> wanted(columns.grid.columns());
    std::vector<std::pair<document::GridCell, Widths>> wide;
    std::size_t letters = Flow::lettersForColumns;
    for (std::size_t r = 0; r < table.rows.size(); ++r)
        for (const document::GridCell& place : columns.grid.row(r)) {
            Widths& column = wanted[place.column];
            if (letters == 0 && column.natural > 0)
                continue;
            const model::Cell& read = table.rows[r][place.number];
            const Widths cell = widthsOf(in, columns, read, available, letters);
            if (place.span.columns > 1) {
                wide.emplace_back(place, cell);
            } else {
                const bool isHeader = r < std::max<std::size_t>(table.headerRows, 1);
                numbers[place.column].add(
                    read, read.blocks.size() == 1 ? columns.cells.back().get() : nullptr, isHeader);
                column.natural = std::max(column.natural, cell.natural);
                column.least = std::max(column.least, cell.least);
                column.number = std::max(column.number, cell.number);
            }
        }
    for (std::size_t c = 0; c < std::min(wanted.size(), table.columnWidths.size()); ++c)
        if (const double fixed = fromPoints(table.columnWidths[c]); fixed > 0)
            wanted[c].natural = wanted[c].least = wanted[c].number = fixed;
    for (const auto& [place, cell] : wide)
        widen(wanted, place, cell, table.columnWidths);
    return wanted;
}

// Columns as wide as the author or their widest text wants where there is room; else each gets its
// longest word, and they share what is left by how much more they would like. If not even the
// words have room, each gets its longest number before. LIMIT: numbers that have no room side by
// side are torn.
std::unique_ptr<Columns> columnsOf(const Surroundings& in, const BlockPointer& block,
                                   double available) {
    auto result = std::make_unique<Columns>();
    result->block = block;
    result->grid = model::gridOf(*block);
    for (std::size_t row = 0; row < block->rows.size(); row = result->grid.endOfBand(row))
        result->bands.push_back(row);
    result->bands.push_back(block->rows.size());
    std::vector<NumberColumn> numbers(result->grid.columns());
    std::vector<Widths> wanted = wantedBy(in, *result, available, numbers);
    for (std::size_t c = 0; c < wanted.size(); ++c) {
        const double width = numbers[c].isOne() ? numbers[c].ofCells() : 0;
        for (double* const own : {&wanted[c].natural, &wanted[c].least, &wanted[c].number})
            *own = std::max(*own, width);
    }
    Widths all;
    for (const Widths& column : wanted) {
        all.natural += column.natural;
        all.least += column.least;
        all.number += column.number;
    }
    const auto shareOf = [&](double more, double than) {
        return more > than ? std::clamp((available - than) / (more - than), 0.0, 1.0) : 1.0;
    };
    const double share = shareOf(all.natural, all.least), ofWords = shareOf(all.least, all.number);
    const double squeeze = all.number > available ? available / all.number : 1;
    for (const Widths& column : wanted)
        result->widths.push_back(squeeze *
                                 (column.number + ofWords * (column.least - column.number) +
                                  (ofWords < 1 ? 0 : share * (column.natural - column.least))));
    for (std::size_t c = 0; c < result->widths.size(); ++c)
        result->points.push_back(numbers[c].point(result->widths[c]));
    return result;
}

} // namespace

void Flow::beginTable(const BlockPointer& block) {
    table_ = std::make_unique<Table>();
    table_->columns =
        in_.stock.columns(block, room(block), [&] { return columnsOf(in_, block, room(block)); });
    const auto& widths = table_->columns->widths;
    table_->left = aligned(block, std::accumulate(widths.begin(), widths.end(), 0.0));
    table_->header = headerOf(block);
}

std::shared_ptr<Cells> Flow::cellsOf(const BlockPointer& block, std::size_t band) const {
    return std::make_shared<Cells>(in_, *block, *table_->columns, band, table_->left);
}

// Of a table that says which rows are repeated: what is text in them. LIMIT: a header that is
// higher than a third of a page stands on the first page alone.
std::shared_ptr<const Strip> Flow::headerOf(const BlockPointer& block) const {
    constexpr double most = 1.0 / 3;
    const std::vector<std::size_t>& bands = table_->columns->bands;
    auto header = std::make_shared<Strip>();
    for (std::size_t b = 0; b + 2 < bands.size() && bands[b + 1] <= block->headerRows; ++b) {
        const std::shared_ptr<Cells> cells = cellsOf(block, b);
        while (!cells->prepare())
            continue;
        if (!cells->fitsOnPage())
            return nullptr;
        const Strip row = cells->take(in_.pageHeight, true);
        for (const Piece& piece : row.pieces) {
            if (std::holds_alternative<SubdocumentPiece>(piece))
                continue;
            header->pieces.push_back(moved(piece, {0, header->height}));
            if (auto* text = std::get_if<TextPiece>(&header->pieces.back()))
                text->isRepeated = true;
        }
        header->height += row.height;
    }
    const bool isUseful = header->height > 0 && header->height <= most * in_.pageHeight;
    return isUseful ? header : nullptr;
}

Made Flow::table(const BlockPointer& block, Strip& strip, bool& last) {
    if (!table_)
        beginTable(block);
    const std::vector<std::size_t>& bands = table_->columns->bands;
    const std::size_t band = made_, count = bands.size() - 1;
    if (band >= count)
        return Made::end;
    if (!table_->cells)
        table_->cells = cellsOf(block, band);
    if (!table_->cells->prepare())
        return Made::pause;
    if (table_->cells->fitsOnPage())
        strip = table_->cells->take(in_.pageHeight, true);
    else
        strip.cells = std::move(table_->cells);
    table_->cells.reset();
    strip.columns = table_->columns;
    strip.left = table_->left;
    const bool isHeader = bands[band + 1] <= block->headerRows;
    if (!isHeader)
        strip.header = table_->header;
    last = band + 1 == count;
    // Neither the first nor the last row of a table stands alone, nor its header.
    strip.keepWithNext = !last && (band == 0 || band + 2 == count || isHeader);
    return Made::strip;
}

} // namespace layout
