// Begins pages so that all up to the next break that the document asks for are filled alike
// (PAGE { balance: yes }, as slides are).
//
// Method: of all ways to divide what comes next into pages, the one of least cost, by dynamic
// programming from the end. A page costs 1, the square of the part of it that stays empty, and what
// its first line says: within a paragraph or a list a page begins badly, with a heading well. The
// plan of the rest is the rest of the plan: so it does not matter where one begins to plan.
//
// LIMIT: what comes next is read for some pages; what lies behind them is thought to fill the last.
#pragma once

#include <cstddef>
#include <vector>

namespace layout {

// Strips that stay on one page.
struct Portion {
    double height = 0;            // with its footnotes, without the space around it
    double before = 0, after = 0; // of two that meet the larger counts; none at the top of a page
    double cost = 0;              // of a page that begins with it
};

// The portion that the second page begins with; `portions.size()`: all stand on the first one.
// `goesOn`: more follows the last one without a break. A portion that is taller than a page stands
// alone.
[[nodiscard]] std::size_t secondPage(const std::vector<Portion>& portions, bool goesOn,
                                     double pageHeight);

// The costs of pages that begin within a block, within a list, or with a heading.
inline constexpr double withinBlockCost = 0.5, withinListCost = 0.3, headingCost = -0.2;

} // namespace layout
