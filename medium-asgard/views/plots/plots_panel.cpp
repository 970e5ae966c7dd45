#include "plots/plots_panel.h"

#include "plain/plain.h"

#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace views {

PlotsPanel::PlotsPanel(SceneDocument& document)
    : document_(document),
      sampler_([this](const charts::PlotSampler::Wish& of, std::vector<charts::Plot> plots) {
          QMetaObject::invokeMethod(
              this, [this, of, plots = std::move(plots)] { take(of, plots); },
              Qt::QueuedConnection);
      }) {
    setObjectName("plots");
    auto* whole = new QWidget;
    column_ = new QVBoxLayout(whole);
    column_->setContentsMargins(8, 8, 8, 8);
    column_->setSpacing(8);
    none_ = plain::label(tr("This scene has no plots yet: of a height, a speed, an angle."));
    none_->setAlignment(Qt::AlignCenter);
    none_->setWordWrap(true);
    column_->addWidget(none_);
    new_ = new QPushButton(tr("New &Plot…"));
    new_->setObjectName("newPlotButton");
    connect(new_, &QPushButton::clicked, this, &PlotsPanel::plotWanted);
    column_->addWidget(new_, 0, Qt::AlignHCenter);
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true); // many plots are higher than the screen
    setWidget(whole);
    const QMargins around = column_->contentsMargins(); // a chart is seen whole
    setMinimumSize(260, PlotChart().minimumSizeHint().height() + around.top() + around.bottom());
    connect(&document_, &SceneDocument::sceneChanged, this, &PlotsPanel::ask);
    connect(&document_, &SceneDocument::motionChanged, this, &PlotsPanel::ask);
    makeCharts();
}

void PlotsPanel::showEvent(QShowEvent* event) {
    QScrollArea::showEvent(event);
    ask();
}

void PlotsPanel::setTime(double time) {
    time_ = time;
    for (PlotChart* chart : charts_)
        chart->setNow(time);
}

void PlotsPanel::ask() {
    makeCharts();
    if (isVisible())
        sampler_.sample({document_.shown().scene, document_.shown().motion});
}

void PlotsPanel::makeCharts() {
    const scene::Scene& scene = *document_.shown().scene;
    while (charts_.size() > scene.plots.size()) {
        delete charts_.back();
        charts_.pop_back();
    }
    while (charts_.size() < scene.plots.size()) {
        charts_.push_back(new PlotChart);
        column_->insertWidget(column_->count() - 1, charts_.back(), 1); // before the button
        charts_.back()->setNow(time_);
        connect(charts_.back(), &PlotChart::timeChosen, this, &PlotsPanel::timeChosen);
        PlotChart* chart = charts_.back();
        chart->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(chart, &QWidget::customContextMenuRequested, this,
                [this, chart, plot = charts_.size() - 1](const QPoint& position) {
                    Q_EMIT menuWanted(plot, chart->mapToGlobal(position));
                });
        charts::Plot soon = charts::named(scene, scene.plots[charts_.size() - 1]);
        soon.fault = tr("The values are being computed…").toStdString();
        charts_.back()->setPlot(std::move(soon), scene.simulator.start, scene.simulator.finish);
    }
    none_->setVisible(scene.plots.empty());
    new_->setVisible(scene.plots.empty()); // later the room is for the charts
}

void PlotsPanel::take(const charts::PlotSampler::Wish& of, std::vector<charts::Plot> plots) {
    if (plots.size() != charts_.size())
        return; // of a scene that is no more
    const scene::Simulator& simulator = of.scene->simulator;
    for (std::size_t i = 0; i < plots.size(); ++i)
        charts_[i]->setPlot(std::move(plots[i]), of.motion ? of.motion->start() : simulator.start,
                            of.motion ? of.motion->finish() : simulator.finish);
}

} // namespace views
