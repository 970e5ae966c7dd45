// One component of a trajectory against time, with its points and tangents (dissertation, Figure
// 4.4). Draws and takes gestures; what they mean is the editor's.
#pragma once

#include "plots/chart_axes.h"
#include "point_edits/trajectory_edit.h"

#include <QWidget>

#include <optional>
#include <variant>
#include <vector>

namespace views {

class TrajectoryGraph : public QWidget {
    Q_OBJECT
public:
    TrajectoryGraph(int component, const QString& name);

    [[nodiscard]] int component() const { return component_; }
    void setCurves(std::vector<scene::BezierCurve> curves,
                   std::vector<editing::ControlPoint> points);
    void setChosen(std::optional<std::size_t> point);
    void setTimes(double from, double to); // what is seen of the axis
    void setNow(std::optional<double> time);
    void setHoldsValues(bool holds) { holdsValues_ = holds; } // the axis stays while one drags

    void letGo(); // of what is dragged, though the button is still down

    [[nodiscard]] QSize sizeHint() const override { return {560, 170}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 100}; }

    [[nodiscard]] ChartAxes axes() const;
    [[nodiscard]] QPointF place(double time, double value) const; // in this widget
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double valueAt(double y) const;
    // The value of one pixel.
    [[nodiscard]] double timeStep() const { return timeAt(1) - timeAt(0); }
    [[nodiscard]] double valueStep() const { return valueAt(0) - valueAt(1); }

Q_SIGNALS:
    void chosen(std::size_t point);
    void dragged(double time, double value, Qt::KeyboardModifiers modifiers);
    void released();
    void addWanted(double time, double value);
    void menuWanted(const QPoint& at, std::optional<std::size_t> point, double time, double value);
    void timesWanted(double from, double to);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] std::optional<std::size_t> pointAt(const QPointF& position) const;
    [[nodiscard]] bool isShown(std::size_t point) const; // no tangent, or one of the chosen point
    void fitValues();
    void paintAxes(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;

    int component_;
    QString name_;
    std::vector<scene::BezierCurve> curves_;
    std::vector<editing::ControlPoint> points_;
    std::optional<std::size_t> chosen_;
    double from_ = 0, to_ = 1, low_ = 0, high_ = 1;
    bool holdsValues_ = false;
    std::optional<double> now_;
    // While a button is down. A point keeps its time until the pointer has left that clearly.
    struct PointDrag {
        QPointF from, offset;
        double time = 0;
        bool keepsTime = true;
    };
    struct PlaneDrag { // the plane is shifted
        QPointF from;
        double first = 0, last = 1; // times
    };
    std::variant<std::monostate, PointDrag, PlaneDrag> drag_;
};

} // namespace views
