// The plots of a scene, each a chart of its quantities against time, in step with the motion.
#pragma once

#include "charts/plot_sampler.h"
#include "plots/plot_chart.h"
#include "workbench/scene_document.h"

#include <QScrollArea>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace views {

class PlotsPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit PlotsPanel(SceneDocument& document);
    [[nodiscard]] const std::vector<PlotChart*>& charts() const { return charts_; }
    void setTime(double time); // that the picture shows

Q_SIGNALS:
    void plotWanted();
    void timeChosen(double time);                            // by the pointer in a chart
    void menuWanted(std::size_t plot, const QPoint& global); // by the right button on a chart

protected:
    void showEvent(QShowEvent* event) override;

private:
    void ask();        // for what is shown now; nothing while nobody sees it
    void makeCharts(); // of its plots, still without values
    void take(const charts::PlotSampler::Wish& of, std::vector<charts::Plot> plots);

    SceneDocument& document_;
    QVBoxLayout* column_;
    QLabel* none_;
    QPushButton* new_;
    double time_ = 0;
    std::vector<PlotChart*> charts_;
    charts::PlotSampler sampler_; // the first to go
};

} // namespace views
