// The places of the pages of a view: one below the other, two side by side, or one at a time, as
// when they are shown to an audience.
#pragma once

#include <QPointF>
#include <QSizeF>

#include <cstddef>

namespace view {

enum class Spread {
    column,
    pairs,
    single, // each fills the view, and the next one begins a view's height below
};

class PagePlaces {
public:
    // Of as many pages of one size, in a viewport; all in pixels.
    PagePlaces(Spread spread, QSizeF page, std::size_t count, QSizeF viewport);

    // Of all pages with what is around them.
    [[nodiscard]] QSizeF size() const;
    // Of a page, where nothing is scrolled.
    [[nodiscard]] QPointF topLeft(std::size_t page) const;
    // The page at or nearest to a point; there is one.
    [[nodiscard]] std::size_t at(QPointF point) const;
    // The first page that does not end above that height, and the one behind the last that begins
    // above it.
    [[nodiscard]] std::size_t firstAt(double y) const;
    [[nodiscard]] std::size_t endAbove(double y) const;
    // From the top of a page to that of the page below it.
    [[nodiscard]] double step() const;

    static constexpr double margin = 28; // around the pages
    static constexpr double gap = 20;    // between them

    // Of a page's width or height and that of the viewport: how many times larger it may be.
    [[nodiscard]] double widthFactor() const;
    [[nodiscard]] double heightFactor() const;

private:
    [[nodiscard]] std::size_t columns() const { return spread_ == Spread::pairs ? 2 : 1; }
    [[nodiscard]] std::size_t rows() const { return (count_ + columns() - 1) / columns(); }
    [[nodiscard]] double around() const { return spread_ == Spread::single ? 0 : margin; }
    [[nodiscard]] double rowWidth() const;
    [[nodiscard]] double top() const; // of the first row

    Spread spread_;
    QSizeF page_;
    std::size_t count_;
    QSizeF viewport_;
};

} // namespace view
