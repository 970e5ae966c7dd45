#include "views/plots_window.h"

#include "plain/plain.h"
#include "views/manual.h"
#include "views/session_actions.h"
#include "views/undo_actions.h"

#include <QMenuBar>
#include <QScrollArea>
#include <QVBoxLayout>

#include <utility>

namespace views {

PlotsWindow::PlotsWindow(SceneDocument& document) : document_(document) {
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
    thread_ = std::thread([this] { run(); });
    ask();
}

PlotsWindow::~PlotsWindow() {
    overtaken_ = true;
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    asked_.notify_one();
    thread_.join();
}

void PlotsWindow::ask() {
    {
        const std::lock_guard lock(mutex_);
        // While a motion grows each piece is shown; another scene's is not waited for.
        if (sampled_ != document_.shown().scene)
            overtaken_ = true;
        wish_ = document_.shown();
    }
    asked_.notify_one();
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

void PlotsWindow::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        asked_.wait(lock, [this] { return stop_ || wish_; });
        if (stop_)
            return;
        const Shown shown = *std::exchange(wish_, std::nullopt);
        sampled_ = shown.scene;
        overtaken_ = false;
        lock.unlock();
        std::vector<charts::Plot> plots;
        for (const scene::Plot& plot : shown.scene->plots)
            if (auto one = charts::sampled(*shown.scene, plot, shown.motion, {},
                                           [this] { return isOvertaken(); }))
                plots.push_back(std::move(*one));
        if (plots.size() == shown.scene->plots.size())
            QMetaObject::invokeMethod(
                this, [this, shown, plots] { take(shown, plots); }, Qt::QueuedConnection);
        lock.lock();
    }
}

void PlotsWindow::take(const Shown& of, std::vector<charts::Plot> plots) {
    if (plots.size() != charts_.size())
        return; // of a scene that is no more
    const scene::Simulator& simulator = of.scene->simulator;
    for (std::size_t i = 0; i < plots.size(); ++i)
        charts_[i]->setPlot(std::move(plots[i]), of.motion ? of.motion->start() : simulator.start,
                            of.motion ? of.motion->finish() : simulator.finish);
}

} // namespace views
