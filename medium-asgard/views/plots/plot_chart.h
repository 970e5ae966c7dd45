// One `plot` of a scene: its quantities against time.
#pragma once

#include "charts/plots.h"
#include "plots/chart_axes.h"

#include <QString>
#include <QWidget>

#include <optional>

class QPainter;
class QPen;

namespace views {

class PlotChart : public QWidget {
    Q_OBJECT
public:
    PlotChart();

    void setPlot(charts::Plot plot, double start, double finish);
    [[nodiscard]] const charts::Plot& plot() const { return plot_; }
    void setNow(double time); // a line shows it, and the legend the values then
    [[nodiscard]] QString legendOf(std::size_t curve) const; // "height = 1.2 m"
    // The reading of the pointer at that place: the time and each curve's value.
    [[nodiscard]] QString readingAt(const QPointF& position) const;
    [[nodiscard]] ChartAxes axes() const;
    [[nodiscard]] QPointF placeOf(double time, double value) const;

    [[nodiscard]] QSize sizeHint() const override { return {560, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 140}; }

Q_SIGNALS:
    void timeChosen(double time);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] double leftSpace() const;
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] std::optional<std::size_t> sampleAt(const QPointF& position) const;
    [[nodiscard]] std::optional<std::size_t> sampleAt(double time) const;
    void choose(const QPointF& position);
    void paintNow(QPainter& painter) const;
    void paintAxes(QPainter& painter) const;
    [[nodiscard]] QPen penOf(std::size_t curve, double width) const;
    void paintCurves(QPainter& painter) const;
    void paintTitle(QPainter& painter) const;

    [[nodiscard]] QString valueOf(std::size_t curve, double value) const; // "1.2 m"

    charts::Plot plot_;
    double start_ = 0, finish_ = 1, now_ = 0;
    charts::Range range_;
    std::optional<QPointF> pointer_;
};

} // namespace views
