#include "view/column_drag.h"

#include "controls/accent.h"

#include "paragraphs/measure.h"
#include "strips/stock.h"
#include "view/document_view.h"
#include "view/writing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace view {

namespace {

constexpr double slack = 4;        // logical pixels on each side of a border
constexpr double leastPoints = 12; // of a column

} // namespace

std::optional<ColumnDrag::Border> ColumnDrag::borderAt(QPointF point) const {
    const layout::Pages& pages = view_.pages();
    if (pages.pages.empty())
        return std::nullopt;
    const auto [page, on] = view_.pagePointAt(point);
    for (const layout::PlacedRows& rows : pages.pages[page]->tables) {
        if (on.y() < rows.top || on.y() > rows.bottom)
            continue;
        double x = rows.left;
        for (std::size_t c = 0; c < rows.columns->widths.size(); ++c) {
            x += rows.columns->widths[c];
            if (std::abs(view_.inViewport(page, {x, on.y(), 0, 0}).x() - point.x()) <= slack)
                return Border{rows, page, c, x};
        }
    }
    return std::nullopt;
}

sgml::NodeId ColumnDrag::tableOf(const Border& border) const {
    const sgml::Tree& tree = view_.document().document().tree();
    for (const model::Row& row : border.rows.columns->block->rows)
        if (!row.empty() && tree.holds(row.front().element))
            return tree.node(tree.node(row.front().element).parent).parent;
    return sgml::noNode;
}

std::optional<Qt::CursorShape> ColumnDrag::cursorAt(QPointF point) {
    return taken_ || borderAt(point) ? std::optional(Qt::SplitHCursor) : std::nullopt;
}

void ColumnDrag::take(QPointF point) {
    taken_ = borderAt(point);
    if (!taken_)
        return;
    x_ = taken_->x;
    grip_ = point.x() - view_.inViewport(taken_->page, {x_, 0, 0, 0}).x();
}

void ColumnDrag::drag(QPointF point) {
    if (!taken_)
        return;
    const std::vector<double>& widths = taken_->rows.columns->widths;
    const std::size_t column = taken_->column;
    const double origin = view_.inViewport(taken_->page, {}).x();
    const double one = view_.inViewport(taken_->page, {0, 0, 1, 1}).width(); // pixels to a twip
    const double least = paragraphs::fromPoints(leastPoints);
    const double left = taken_->x - widths[column];
    double right = taken_->x + (column + 1 < widths.size() ? widths[column + 1] : 0) - least;
    if (column + 1 == widths.size())
        if (const std::shared_ptr<const model::Model> model = view_.model())
            right = paragraphs::fromPoints(model->page.width - model->page.marginRight);
    x_ =
        std::clamp((point.x() - grip_ - origin) / one, left + least, std::max(right, left + least));
}

void ColumnDrag::finish() {
    const std::optional<Border> done = std::exchange(taken_, std::nullopt);
    if (!done || std::abs(x_ - done->x) < 1)
        return;
    const auto points = [](double twips) { return twips / paragraphs::twipsPerPoint; };
    const std::vector<double>& widths = done->rows.columns->widths;
    const std::size_t column = done->column;
    std::vector<double> now(column + 1, -1);
    now[column] = points(widths[column] + x_ - done->x);
    if (column + 1 < widths.size())
        now.push_back(points(widths[column + 1] - (x_ - done->x)));
    setWidths(*done, now);
}

void ColumnDrag::takeTwice(QPointF point) {
    taken_.reset();
    if (const std::optional<Border> border = borderAt(point)) {
        std::vector<double> now(border->column + 1, -1);
        now[border->column] = 0;
        setWidths(*border, now);
    }
}

void ColumnDrag::setWidths(const Border& border, const std::vector<double>& points) {
    const sgml::NodeId table = tableOf(border);
    view_.writing().change([&](const authoring::Manuscript& in, authoring::Selection at) {
        return authoring::setColumnWidths(in, at, table, points);
    });
}

// The place that the border would have.
void ColumnDrag::paint(QPainter& painter) const {
    if (!taken_)
        return;
    const QRectF line = view_.inViewport(
        taken_->page, {x_, taken_->rows.top, 0, taken_->rows.bottom - taken_->rows.top});
    painter.setPen(QPen(controls::accent, 2, Qt::DashLine));
    painter.drawLine(line.topLeft(), line.bottomLeft());
}

} // namespace view
