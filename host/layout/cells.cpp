#include "layout/cells.h"

#include "layout/measure.h"

#include <algorithm>

namespace layout {

Cells::Cells(const Surroundings& in, const model::Row& row, const std::vector<double>& columns,
             double left)
    : pageHeight_(in.pageHeight) {
    cells_.reserve(row.size());
    double x = left;
    for (std::size_t c = 0; c < row.size(); ++c) {
        const double padding = fromPoints(row[c].style.padding);
        Surroundings inside = in;
        inside.width = std::max(columns[c] - 2 * padding, 1.0);
        cells_.push_back(
            {x, columns[c], padding, &row[c].style, Flow(inside, row[c].blocks), {}, 0, false});
        x += columns[c];
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

bool Cells::fitsOnPage() const {
    return std::all_of(cells_.begin(), cells_.end(), [this](const Cell& cell) {
        const bool divided = std::any_of(cell.ready.begin(), cell.ready.end(),
                                         [](const Strip& strip) { return bool(strip.cells); });
        return cell.ended && !divided && cell.height + 2 * cell.padding <= pageHeight_;
    });
}

bool Cells::isTaken() const {
    return begun_ && std::all_of(cells_.begin(), cells_.end(),
                                 [](const Cell& cell) { return cell.ended && cell.ready.empty(); });
}

// The height that was taken, paddings not counted.
double Cells::takeFrom(Cell& cell, double room, bool forced, Strip& part) {
    double y = 0, after = 0;
    bool any = false;
    const auto put = [&](const Strip& strip, double top) {
        for (const Piece& piece : strip.pieces)
            part.pieces.push_back(moved(piece, {cell.x + cell.padding, cell.padding + top}));
        part.footnotes.insert(part.footnotes.end(), strip.footnotes.begin(), strip.footnotes.end());
    };
    while (!cell.ready.empty()) {
        Strip& next = cell.ready.front();
        const double top = any ? y + std::max(after, next.before) : y;
        if (next.cells) {
            const Strip inner = next.cells->take(room - top, forced && !any);
            put(inner, top);
            y = inner.height > 0 ? top + inner.height : y;
            any = any || inner.height > 0;
            if (!next.cells->isTaken())
                break;
        } else if (top + next.height <= room || (forced && !any)) {
            put(next, top);
            y = top + next.height;
            any = true;
        } else {
            break;
        }
        after = next.after;
        cell.ready.pop_front();
    }
    return y;
}

Strip Cells::take(double room, bool forced) {
    Strip part;
    double height = 0;
    bool any = false;
    for (Cell& cell : cells_) {
        const double taken = takeFrom(cell, room - 2 * cell.padding, forced, part);
        any = any || taken > 0;
        height = std::max(height, taken + 2 * cell.padding);
    }
    if (!any && !forced)
        return {};
    part.height = height;
    const bool first = !begun_;
    begun_ = true;
    // What the next part will be made of.
    for (Cell& cell : cells_) {
        cell.height = 0;
        for (std::size_t i = 0; i < cell.ready.size(); ++i)
            cell.height += gapBefore(cell.ready[i], cell.ready, i) +
                           (cell.ready[i].cells ? pageHeight_ : cell.ready[i].height);
        while (!makeReady(cell))
            continue;
    }
    const bool last = isTaken();
    std::vector<Piece> frames;
    for (const Cell& cell : cells_) {
        if (!cell.style->background && cell.style->border.width <= 0)
            continue;
        FramePiece frame{
            {cell.x, 0, cell.width, height}, cell.style->background, cell.style->border};
        frame.border.top &= first; // a row that goes on is open where the page ends
        frame.border.bottom &= last;
        frames.emplace_back(frame);
    }
    part.pieces.insert(part.pieces.begin(), frames.begin(), frames.end());
    return part;
}

} // namespace layout
