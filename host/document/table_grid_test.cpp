#include "document/table_grid.h"

#include <gtest/gtest.h>

namespace document {

namespace {

// The row and the number of the cell that covers each place.
std::string printed(const TableGrid& grid) {
    std::string lines;
    for (std::size_t r = 0; r < grid.rows(); ++r) {
        for (std::size_t c = 0; c < grid.columns(); ++c) {
            const GridCell* cell = grid.at(r, c);
            lines += cell ? std::to_string(cell->row) + std::to_string(cell->number) + " " : "-- ";
        }
        lines += "\n";
    }
    return lines;
}

} // namespace

TEST(TableGrid, CellsPassWhatIsCoveredFromAbove) {
    EXPECT_EQ(printed(TableGrid({{{}, {}}, {{}, {}}})), "00 01 \n10 11 \n");
    EXPECT_EQ(printed(TableGrid({{{2, 1}, {1, 2}}, {{}, {}}, {{}}})),
              "00 00 01 \n10 11 01 \n20 -- -- \n");
    // Neither below the table nor into a cell from above.
    EXPECT_EQ(printed(TableGrid({{{}, {1, 9}}, {{5, 1}}})), "00 01 \n10 01 \n");
}

TEST(TableGrid, BandsAreHeldTogetherByCells) {
    const TableGrid grid({{{}}, {{1, 2}, {}}, {{1, 2}}, {{}}, {{}}});
    EXPECT_EQ(grid.endOfBand(0), 1u);
    EXPECT_EQ(grid.endOfBand(1), 4u);
    EXPECT_EQ(grid.endOfBand(4), 5u);
}

TEST(TableGrid, SpansAreSmallNumbers) {
    EXPECT_EQ(spannedBy("3"), 3u);
    EXPECT_EQ(spannedBy("0"), 1u);
    EXPECT_EQ(spannedBy("1000000"), 1u);
    EXPECT_EQ(spannedBy("a"), 1u);
    EXPECT_EQ(spannedBy(std::nullopt), 1u);
}

} // namespace document
