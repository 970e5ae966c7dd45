// A text as it is written, on a page: numbered lines in letters of one width. A line that is wider
// than the page goes on in the next row; rows that find no place are counted in the last one.
#pragma once

#include "charts/canvas.h"

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace charts {

class TextPage {
public:
    // `faulty`: lines that have a fault, counted from 1. `width`: of the page, in the canvas's
    // unit.
    TextPage(std::string_view text, const std::set<std::size_t>& faulty, double width);

    [[nodiscard]] std::size_t rows() const { return rows_.size(); }
    // Of a page that has room for all rows.
    [[nodiscard]] double height() const;
    // The row that stands at the top of a page of that height, if it is to be `first`: no page
    // begins behind the last full one.
    [[nodiscard]] std::size_t top(std::size_t first, double height) const;
    void draw(Canvas& canvas, double height, std::size_t first = 0) const;

private:
    struct Row {
        std::size_t line = 0; // 0: the line above goes on
        std::string text;
        bool isFaulty = false;
    };
    [[nodiscard]] std::size_t rowsIn(double height) const;

    double width_ = 0, numbers_ = 0;
    std::vector<Row> rows_;
};

} // namespace charts
