#include "plots/plots_window.h"

#include "frame/manual.h"
#include "frame/session_actions.h"
#include "frame/undo_actions.h"
#include "plain/plain.h"

#include <QMenuBar>
#include <QScrollArea>
#include <QVBoxLayout>

#include <utility>

namespace views {

PlotsWindow::PlotsWindow(SceneDocument& document)
    : document_(document),
      sampler_([this](const charts::PlotSampler::Wish& of, std::vector<charts::Plot> plots) {
          QMetaObject::invokeMethod(
              this, [this, of, plots = std::move(plots)] { take(of, plots); },
              Qt::QueuedConnection);
      }) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("plots");
    auto* whole = new QWidget;
    column_ = new QVBoxLayout(whole);
    column_->setContentsMargins(8, 8, 8, 8);
    column_->setSpacing(8);
    none_ = plain::label(
        tr("This scene has no plots. Create > Plot… in a graphical viewer makes one."));
    none_->setAlignment(Qt::AlignCenter);
    none_->setWordWrap(true);
    column_->addWidget(none_);
    auto* scroll = new QScrollArea; // many plots are higher than the screen
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(whole);
    setCentralWidget(scroll);
    addUndoActions(menuBar()->addMenu(tr("&Edit")), document_);
    addHelpMenu(this, QStringLiteral("In a picture"));
    const auto name = [this] {
        setWindowTitle(tr("%1[*] – Plots").arg(plain::title(document_.name())));
        setWindowModified(!document_.hasHost() && document_.isModified());
    };
    name();
    connect(&document_, &SceneDocument::nameChanged, this, name);
    connect(&document_, &SceneDocument::sceneChanged, this, &PlotsWindow::ask);
    connect(&document_, &SceneDocument::motionChanged, this, &PlotsWindow::ask);
    closeByEscape(*this);
    resize(620, 380);
    ask();
}

void PlotsWindow::ask() {
    sampler_.sample({document_.shown().scene, document_.shown().motion});
    makeCharts();
}

void PlotsWindow::makeCharts() {
    const scene::Scene& scene = *document_.shown().scene;
    while (charts_.size() > scene.plots.size()) {
        delete charts_.back();
        charts_.pop_back();
    }
    while (charts_.size() < scene.plots.size()) {
        charts_.push_back(new PlotChart);
        column_->addWidget(charts_.back(), 1);
        charts::Plot soon = charts::named(scene, scene.plots[charts_.size() - 1]);
        soon.fault = tr("The values are being computed…").toStdString();
        charts_.back()->setPlot(std::move(soon), scene.simulator.start, scene.simulator.finish);
    }
    none_->setVisible(scene.plots.empty());
}

void PlotsWindow::take(const charts::PlotSampler::Wish& of, std::vector<charts::Plot> plots) {
    if (plots.size() != charts_.size())
        return; // of a scene that is no more
    const scene::Simulator& simulator = of.scene->simulator;
    for (std::size_t i = 0; i < plots.size(); ++i)
        charts_[i]->setPlot(std::move(plots[i]), of.motion ? of.motion->start() : simulator.start,
                            of.motion ? of.motion->finish() : simulator.finish);
}

} // namespace views
