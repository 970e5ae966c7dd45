// A row of a table: cells side by side, each a flow of its own.
//
// It is made cell by cell, as far down as a page is high. A row that is not taller becomes one
// strip; of a taller one each page takes what it has room for, and each cell goes on where it was
// divided, between two lines.
#pragma once

#include "layout/flow.h"

#include <deque>

namespace layout {

class Cells {
public:
    // `columns`: the width of each; `left`: of the first.
    Cells(const Surroundings& in, const model::Row& row, const std::vector<double>& columns,
          double left);

    // Makes one more cell as far as a page is high; true: all are.
    bool prepare();
    // Nothing is left that take() has not given.
    [[nodiscard]] bool isTaken() const;
    // Does all of it fit on a page? Of a prepared row.
    [[nodiscard]] bool fitsOnPage() const;
    // The whole row, or as much as fits into `room`. Empty, of height 0, when nothing does, unless
    // it is `forced`: then each cell gives one strip at least. Of a prepared row.
    [[nodiscard]] Strip take(double room, bool forced);

private:
    struct Cell {
        double x = 0, width = 0, padding = 0;
        const schemas::BlockStyle* style = nullptr;
        Flow flow;
        std::deque<Strip> ready; // made and not taken
        double height = 0;       // of these
        bool ended = false;      // nothing is behind these
    };
    static double gapBefore(const Strip& strip, const std::deque<Strip>& all, std::size_t index);
    bool makeReady(Cell& cell) const;
    double takeFrom(Cell& cell, double room, bool forced, Strip& part);

    double pageHeight_ = 0;
    std::vector<Cell> cells_;
    std::size_t prepared_ = 0;
    bool begun_ = false; // a part of it was taken
};

} // namespace layout
