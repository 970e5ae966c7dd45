#include "onpage/page_places.h"

#include <algorithm>
#include <cmath>

namespace view {

PagePlaces::PagePlaces(Spread spread, QSizeF page, std::size_t count, QSizeF viewport)
    : spread_(spread), page_(page), count_(count), viewport_(viewport) {}

double PagePlaces::rowWidth() const {
    const auto columns = static_cast<double>(this->columns());
    return columns * page_.width() + (columns - 1) * gap;
}

double PagePlaces::step() const {
    return spread_ == Spread::single ? std::max(viewport_.height(), page_.height())
                                     : page_.height() + gap;
}

double PagePlaces::top() const {
    return spread_ == Spread::single ? (step() - page_.height()) / 2 : margin;
}

QSizeF PagePlaces::size() const {
    const double width = rowWidth() + 2 * around();
    const auto rows = static_cast<double>(this->rows());
    if (spread_ == Spread::single)
        return {width, rows * step()};
    return {width, 2 * margin + rows * step() - gap};
}

QPointF PagePlaces::topLeft(std::size_t page) const {
    const double left = std::max(around(), std::floor((viewport_.width() - rowWidth()) / 2));
    const auto column = static_cast<double>(page % columns());
    const std::size_t above = page / columns(); // rows
    const auto row = static_cast<double>(above);
    return {left + column * (page_.width() + gap), std::floor(top()) + std::floor(row * step())};
}

std::size_t PagePlaces::at(QPointF point) const {
    const double between = step() - page_.height();
    const double last = static_cast<double>(rows()) - 1;
    const double row = std::clamp(std::floor((point.y() - top() + between / 2) / step()), 0.0,
                                  std::max(0.0, last));
    const auto first = static_cast<std::size_t>(row) * columns();
    const bool isRight = columns() == 2 && point.x() > topLeft(first + 1).x() - gap / 2;
    return std::min(first + (isRight ? 1 : 0), count_ - 1);
}

std::size_t PagePlaces::firstAt(double y) const {
    const double row = std::floor((y - top()) / step());
    return std::min(static_cast<std::size_t>(std::max(0.0, row)) * columns(), count_);
}

std::size_t PagePlaces::endAbove(double y) const {
    const double row = std::floor((y - top()) / step()) + 1;
    return std::min(static_cast<std::size_t>(std::max(0.0, row)) * columns(), count_);
}

double PagePlaces::widthFactor() const {
    const auto columns = static_cast<double>(this->columns());
    const double room = viewport_.width() - 2 * around() - (columns - 1) * gap;
    return room / (columns * page_.width());
}

double PagePlaces::heightFactor() const {
    return (viewport_.height() - (spread_ == Spread::single ? 0 : 2 * gap)) / page_.height();
}

} // namespace view
