// A band of a table: a row, or several that cells hold together which reach over rows; cells side
// by side, each a flow of its own.
//
// It is made cell by cell, as far down as a page is high. A band that is not taller becomes one
// strip; of a taller one each page takes what it has room for, and each cell goes on where it was
// divided, between two lines.
#pragma once

#include "strips/flow.h"

#include <deque>
#include <span>

namespace layout {

class Cells {
public:
    // `left`: of the first column.
    Cells(const Surroundings& in, const model::Block& table, const Columns& columns,
          std::size_t band, double left);

    // Makes one more cell as far as a page is high; true: all are.
    bool prepare();
    // Nothing is left that take() has not given.
    [[nodiscard]] bool isTaken() const { return row_ == rows(); }
    // Does all of it fit on a page? Of a prepared band.
    [[nodiscard]] bool fitsOnPage();
    // All of it, or as much as fits into `room`. Empty, of height 0, when nothing does, unless it
    // is `forced`: then each cell gives one strip at least. Of a prepared band.
    [[nodiscard]] Strip take(double room, bool forced);

private:
    struct Cell {
        double x = 0, width = 0, padding = 0;
        double shift = 0;                // to the right, of a number
        std::size_t first = 0, last = 0; // rows of the band
        const schemas::BlockStyle* style = nullptr;
        Flow flow;
        std::deque<Strip> ready{}; // made and not taken
        double height = 0;         // of these
        bool ended = false;        // nothing is behind these
        bool begun = false;        // a part of it was taken
        // Of the part that is being taken: where the cell begins, how high what is in it is, and
        // the space behind that.
        double top = 0, taken = 0, after = 0;
        bool any = false;
    };
    [[nodiscard]] std::size_t rows() const { return starts_.size() - 1; }
    [[nodiscard]] std::span<Cell> reaching(std::size_t row);
    static double gapBefore(const Strip& strip, const std::deque<Strip>& all, std::size_t index);
    bool makeReady(Cell& cell) const;
    void refill(Cell& cell) const;
    static void takeFrom(Cell& cell, double to, bool forced, Strip& part);
    [[nodiscard]] std::optional<double> takeRow(double top, double room, bool forced, Strip& part);
    void addFrames(std::size_t from, const std::vector<double>& tops, Strip& part);

    double pageHeight_ = 0;
    std::vector<Cell> cells_;            // row by row
    std::vector<std::size_t> starts_{0}; // of each row the first cell, and behind the last
    std::size_t row_ = 0;                // the first that is not taken
    std::size_t prepared_ = 0;
};

} // namespace layout
