#include "strips/cells.h"

#include "paragraphs/measure.h"
#include "strips/number_columns.h"

#include <algorithm>

namespace layout {

using paragraphs::fromPoints;

Cells::Cells(const Surroundings& in, const model::Block& table, const Columns& columns,
             std::size_t band, double left)
    : pageHeight_(in.pageHeight) {
    const std::size_t first = columns.bands[band];
    for (std::size_t r = first; r < columns.bands[band + 1]; ++r) {
        double x = left;
        std::size_t column = 0;
        for (const document::GridCell& place : columns.grid.row(r)) {
            for (; column < place.column; ++column)
                x += columns.widths[column];
            double width = 0;
            for (; column <= place.lastColumn(); ++column)
                width += columns.widths[column];
            const model::Cell& cell = table.rows[r][place.number];
            const double padding = fromPoints(cell.style.padding);
            Surroundings inside = in;
            inside.width = std::max(width - 2 * padding, 1.0);
            const auto& point = columns.points[place.column];
            const bool stands = point && place.span.columns == 1;
            cells_.push_back({.x = x,
                              .width = width,
                              .padding = padding,
                              .shift = stands ? shiftToPoint(inside, cell, *point) : 0,
                              .first = r - first,
                              .last = place.lastRow() - first,
                              .style = &cell.style,
                              .flow = Flow(inside, cell.blocks)});
            x += width;
        }
        starts_.push_back(cells_.size());
    }
}

// The first strip of a part has no space above it.
double Cells::gapBefore(const Strip& strip, const std::deque<Strip>& all, std::size_t index) {
    return index == 0 ? 0 : std::max(all[index - 1].after, strip.before);
}

// False: more is to be done for it.
bool Cells::makeReady(Cell& cell) const {
    while (!cell.ended && (cell.ready.empty() || cell.height + 2 * cell.padding <= pageHeight_)) {
        Strip strip;
        const Made made = cell.flow.next(strip);
        if (made == Made::pause)
            return false;
        cell.ended = made == Made::end;
        if (cell.ended)
            break;
        // A row in this one that is taller than a page is taken in parts with it.
        const double height = strip.cells ? pageHeight_ : strip.height;
        cell.ready.push_back(std::move(strip));
        cell.height += gapBefore(cell.ready.back(), cell.ready, cell.ready.size() - 1) + height;
    }
    return true;
}

bool Cells::prepare() {
    if (prepared_ < cells_.size() && makeReady(cells_[prepared_]))
        ++prepared_;
    return prepared_ >= cells_.size();
}

// Those that stand in the row, and before them some that ended above it.
std::span<Cells::Cell> Cells::reaching(std::size_t row) {
    const std::size_t first = starts_[row + 1 - std::min(row + 1, document::mostSpanned)];
    return std::span(cells_).subspan(first, starts_[row + 1] - first);
}

bool Cells::fitsOnPage() {
    std::vector<double> heights(rows(), 0);
    double all = 0;
    for (std::size_t row = 0; row < rows(); ++row) {
        for (const Cell& cell : reaching(row)) {
            if (cell.last != row)
                continue;
            const bool divided = std::any_of(cell.ready.begin(), cell.ready.end(),
                                             [](const Strip& strip) { return bool(strip.cells); });
            if (!cell.ended || divided)
                return false;
            double rest = cell.height + 2 * cell.padding;
            for (std::size_t above = cell.first; above < row; ++above)
                rest -= heights[above];
            heights[row] = std::max(heights[row], rest);
        }
        all += heights[row];
    }
    return all <= pageHeight_;
}

// Strips of a cell go on where those of this part end, down to the height `to` of the part.
void Cells::takeFrom(Cell& cell, double to, bool forced, Strip& part) {
    const auto put = [&](const Strip& strip, double top) {
        for (const Piece& piece : strip.pieces)
            part.pieces.push_back(
                moved(piece, {cell.x + cell.padding + cell.shift, cell.top + cell.padding + top}));
        part.footnotes.insert(part.footnotes.end(), strip.footnotes.begin(), strip.footnotes.end());
    };
    const double room = to - cell.top - 2 * cell.padding;
    while (!cell.ready.empty()) {
        Strip& next = cell.ready.front();
        const double top = cell.any ? cell.taken + std::max(cell.after, next.before) : cell.taken;
        if (next.cells) {
            const Strip inner = next.cells->take(room - top, forced && !cell.any);
            put(inner, top);
            cell.taken = inner.height > 0 ? top + inner.height : cell.taken;
            cell.any = cell.any || inner.height > 0;
            if (!next.cells->isTaken())
                break;
        } else if (top + next.height <= room || (forced && !cell.any)) {
            put(next, top);
            cell.taken = top + next.height;
            cell.any = true;
        } else {
            break;
        }
        cell.after = next.after;
        cell.ready.pop_front();
    }
}

// The material of the next part.
void Cells::refill(Cell& cell) const {
    cell.height = 0;
    for (std::size_t i = 0; i < cell.ready.size(); ++i)
        cell.height += gapBefore(cell.ready[i], cell.ready, i) +
                       (cell.ready[i].cells ? pageHeight_ : cell.ready[i].height);
    while (!makeReady(cell))
        continue;
}

// How high the row is in this part; nothing: none of it fits. A cell that reaches further down than
// the row fills it as far as it goes.
std::optional<double> Cells::takeRow(double top, double room, bool forced, Strip& part) {
    double bottom = top;
    bool any = forced, isWhole = true;
    for (Cell& cell : reaching(row_)) {
        if (cell.first == row_)
            cell.top = top;
        if (cell.last != row_)
            continue;
        const double before = cell.taken;
        takeFrom(cell, room, forced, part);
        refill(cell);
        any = any || cell.taken > before;
        isWhole = isWhole && cell.ended && cell.ready.empty();
        bottom = std::max(bottom, cell.top + cell.taken + 2 * cell.padding);
    }
    if (!any && !(isWhole && bottom <= room))
        return std::nullopt;
    for (Cell& cell : reaching(row_))
        if (cell.last > row_) {
            takeFrom(cell, bottom, false, part);
            refill(cell);
        }
    row_ += isWhole ? 1 : 0;
    return bottom - top;
}

Strip Cells::take(double room, bool forced) {
    Strip part;
    const std::size_t from = row_;
    if (row_ < rows())
        for (Cell& cell : reaching(row_)) {
            cell.top = cell.taken = cell.after = 0;
            cell.any = false;
        }
    std::vector<double> tops{0}; // of the rows of this part, and where the last one ends
    for (bool goesOn = true; goesOn && row_ < rows();) {
        const std::size_t row = row_;
        const std::optional<double> height =
            takeRow(part.height, room, forced && row == from, part);
        if (!height)
            break;
        part.height += *height;
        tops.push_back(part.height);
        goesOn = row_ > row;
    }
    if (tops.size() > 1)
        addFrames(from, tops, part);
    return part;
}

// A cell that goes on is open where the page ends.
void Cells::addFrames(std::size_t from, const std::vector<double>& tops, Strip& part) {
    const std::size_t end = from + tops.size() - 1; // behind the last row of the part
    const std::size_t first = starts_[from + 1 - std::min(from + 1, document::mostSpanned)];
    std::vector<Piece> frames;
    for (Cell& cell : std::span(cells_).subspan(first, starts_[end] - first)) {
        if (cell.last < from)
            continue;
        const bool isFirst = !std::exchange(cell.begun, true);
        if (!cell.style->background && cell.style->border.width <= 0)
            continue;
        const double top = tops[std::max(cell.first, from) - from];
        const double bottom = tops[std::min(cell.last + 1, end) - from];
        FramePiece frame{
            {cell.x, top, cell.width, bottom - top}, cell.style->background, cell.style->border};
        frame.border.top &= isFirst;
        frame.border.bottom &= cell.last < row_;
        frames.emplace_back(frame);
    }
    part.pieces.insert(part.pieces.begin(), frames.begin(), frames.end());
}

} // namespace layout
