// The points of a trajectory as a table: a row for each, its time and its place.
//
// Shows and takes texts; what a text changes is the editor's. A text that is refused stays in its
// cell, marked, with the reason as its tip, until another one is taken or Escape gives it up.
#pragma once

#include "point_edits/trajectory_edit.h"

#include <QTableWidget>

#include <optional>
#include <vector>

namespace views {

class PointTable : public QTableWidget {
    Q_OBJECT
public:
    static constexpr int columns = 4; // time, x, y, z

    explicit PointTable(QWidget* parent = nullptr);

    // `tangents`: their ends have rows, too.
    void setPoints(const std::vector<editing::ControlPoint>& points, bool tangents);
    void setUnit(const QString& unit); // of the places; "": none
    void setChosen(std::optional<std::size_t> point);
    void refuse(std::size_t point, int column, const QString& text, const QString& reason);
    void forgive(); // what was refused
    [[nodiscard]] std::optional<int> rowOf(std::size_t point) const;

    [[nodiscard]] QSize sizeHint() const override { return {300, 200}; }

Q_SIGNALS:
    void chosen(std::size_t point);
    void typed(std::size_t point, int column, const QString& text);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Refused {
        std::size_t point;
        int column;
        QString text, reason;
    };
    [[nodiscard]] QString textOf(std::size_t point, int column) const;
    void fill();

    std::vector<editing::ControlPoint> points_;
    std::vector<std::size_t> rows_; // the points that have one
    std::optional<Refused> refused_;
};

} // namespace views
