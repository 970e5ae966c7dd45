// How a table becomes rows: the widths of its columns, and the header that stands again on each
// page.
#include "strips/flow.h"

#include "paragraphs/measure.h"
#include "strips/cells.h"
#include "strips/number_columns.h"

#include <algorithm>
#include <numeric>

namespace layout {

using paragraphs::BlockPointer;
using paragraphs::fromPoints;
using paragraphs::Paragraph;
using paragraphs::Widths;
using paragraphs::widthsOf;

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
