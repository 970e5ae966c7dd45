// One `plot` of a scene: its quantities against time.
#pragma once

#include "views/chart_axes.h"

#include <QColor>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QPainter;
class QPen;

namespace views {

struct PlotCurve {
    QString label;
    std::vector<double> values; // at the times of the samples; NaN: not defined there
    QColor color = {};          // none: the usual one of its place
    Qt::PenStyle line = Qt::SolidLine;
};

struct PlotSamples {
    QString title;
    std::vector<double> times;
    std::vector<PlotCurve> curves;
    QString fault; // "" or why there are none
};

class PlotChart : public QWidget {
    Q_OBJECT
public:
    PlotChart();

    [[nodiscard]] static QColor usualColor(std::size_t curve);
    void setSamples(PlotSamples samples, double start, double finish);
    [[nodiscard]] const PlotSamples& samples() const { return samples_; }
    // The reading of the pointer at that place: the time and each curve's value.
    [[nodiscard]] QString readingAt(const QPointF& position) const;
    [[nodiscard]] ChartAxes axes() const;
    [[nodiscard]] QPointF placeOf(double time, double value) const;

    [[nodiscard]] QSize sizeHint() const override { return {560, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] std::optional<std::size_t> sampleAt(const QPointF& position) const;
    void paintAxes(QPainter& painter) const;
    [[nodiscard]] QPen penOf(std::size_t curve, double width) const;
    void paintCurves(QPainter& painter) const;
    void paintTitle(QPainter& painter) const;

    PlotSamples samples_;
    double start_ = 0, finish_ = 1, low_ = 0, high_ = 1;
    std::optional<QPointF> pointer_;
};

} // namespace views
