// Columns of a table whose cells are numbers: their points stand one below the other.
//
// A column is one of numbers when all its cells below the header, two at least, are numbers or say
// that there is none, and have `align-numbers`. The numbers together stand where `align` would put
// the widest. LIMIT: a formula is no number here; what is beyond Flow::lettersForColumns counts as
// what is before it.
#pragma once

#include "strips/flow.h"

namespace layout {

// A block of a cell, measured once for so many letters.
[[nodiscard]] std::shared_ptr<const Measured>
measuredOf(const Surroundings& in, const paragraphs::BlockPointer& block, std::size_t letters);

// Of one column, as its cells are read.
class NumberColumn {
public:
    // `measured`: of the cell's only block, or null.
    void add(const model::Cell& cell, const Measured* measured, bool isHeader);
    [[nodiscard]] bool isOne() const { return count_ > 1 && !hasOthers_; }
    // How wide its cells must be for all its numbers together.
    [[nodiscard]] double ofCells() const;
    // The place of the points in cells of that width, from the left of the room for text; nothing:
    // there is no room.
    [[nodiscard]] std::optional<double> point(double ofCells) const;

private:
    double before_ = 0, behind_ = 0, padding_ = 0;
    int count_ = 0;
    bool hasOthers_ = false;
    schemas::Align align_ = schemas::Align::left;
};

// How far a cell's content goes to the right, so that its point stands there.
[[nodiscard]] double shiftToPoint(const Surroundings& in, const model::Cell& cell, double point);

} // namespace layout
