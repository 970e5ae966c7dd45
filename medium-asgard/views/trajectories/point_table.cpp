#include "trajectories/point_table.h"

#include "frame/readable.h"
#include "plain/plain.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QSignalBlocker>

#include <algorithm>

namespace views {

namespace {

bool areAlike(const editing::ControlPoint& a, const editing::ControlPoint& b) {
    return a.time == b.time && a.place == b.place && a.onCurve == b.onCurve;
}

} // namespace

PointTable::PointTable(QWidget* parent) : QTableWidget(0, columns, parent) {
    setObjectName(QStringLiteral("points"));
    setAccessibleName(tr("Points of the trajectory"));
    setSelectionMode(QAbstractItemView::SingleSelection);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false); // Tab leads on
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    setUnit({});
    connect(this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
        Q_EMIT typed(rows_[static_cast<std::size_t>(item->row())], item->column(), item->text());
    });
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row >= 0 && static_cast<std::size_t>(row) < rows_.size())
            Q_EMIT chosen(rows_[static_cast<std::size_t>(row)]);
    });
}

void PointTable::setUnit(const QString& unit) {
    const auto of = [](const QString& what, const QString& measure) {
        return measure.isEmpty() ? what : QStringLiteral("%1, %2").arg(what, measure);
    };
    setHorizontalHeaderLabels({of(tr("time"), QStringLiteral("s")), of(QStringLiteral("x"), unit),
                               of(QStringLiteral("y"), unit), of(QStringLiteral("z"), unit)});
}

void PointTable::setPoints(const std::vector<editing::ControlPoint>& points, bool tangents) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].onCurve || tangents)
            rows.push_back(i);
    if (rows == rows_ && std::ranges::equal(points, points_, areAlike))
        return;
    points_ = points;
    rows_ = std::move(rows);
    refused_.reset();
    fill();
}

std::optional<int> PointTable::rowOf(std::size_t point) const {
    const auto found = std::ranges::find(rows_, point);
    return found == rows_.end() ? std::nullopt
                                : std::optional(static_cast<int>(found - rows_.begin()));
}

QString PointTable::textOf(std::size_t point, int column) const {
    const editing::ControlPoint& of = points_[point];
    return QString::number(column == 0 ? of.time : of.place[column - 1], 'g', 12);
}

void PointTable::fill() {
    const QSignalBlocker quiet(this);
    setRowCount(static_cast<int>(rows_.size()));
    int number = 0;
    for (int row = 0; row < rowCount(); ++row) {
        const std::size_t point = rows_[static_cast<std::size_t>(row)];
        const bool isTangent = !points_[point].onCurve;
        setVerticalHeaderItem(
            row, new QTableWidgetItem(isTangent ? QStringLiteral("–") : QString::number(++number)));
        for (int column = 0; column < columns; ++column) {
            if (!item(row, column))
                setItem(row, column, new QTableWidgetItem);
            QTableWidgetItem& cell = *item(row, column);
            const bool isRefused =
                refused_ && refused_->point == point && refused_->column == column;
            cell.setText(isRefused ? refused_->text : textOf(point, column));
            cell.setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            cell.setToolTip(plain::tip(isRefused   ? refused_->reason
                                       : isTangent ? tr("The end of a tangent")
                                                   : QString()));
            QVariant ink; // none: the theme's
            if (isRefused)
                ink = readable(QColor(0xC0, 0x20, 0x20), palette().color(QPalette::Base));
            else if (isTangent)
                ink = palette().color(QPalette::PlaceholderText);
            cell.setData(Qt::ForegroundRole, ink);
            QFont font = this->font();
            font.setBold(isRefused);
            cell.setFont(font);
            cell.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable |
                          (isTangent && column == 0 ? Qt::NoItemFlags : Qt::ItemIsEditable));
        }
    }
    viewport()->update();
}

void PointTable::setChosen(std::optional<std::size_t> point) {
    const auto row = point ? rowOf(*point) : std::nullopt;
    if (row.value_or(-1) == currentRow())
        return;
    const QSignalBlocker quiet(this);
    setCurrentCell(row.value_or(-1), row ? std::max(currentColumn(), 0) : -1);
    viewport()->update();
}

void PointTable::refuse(std::size_t point, int column, const QString& text, const QString& reason) {
    refused_ = Refused{point, column, text, reason};
    fill();
}

void PointTable::forgive() {
    if (std::exchange(refused_, std::nullopt))
        fill();
}

void PointTable::changeEvent(QEvent* event) {
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        fill();
}

void PointTable::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && refused_)
        return forgive();
    QTableWidget::keyPressEvent(event);
}

} // namespace views
