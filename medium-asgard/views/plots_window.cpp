#include "views/plots_window.h"

#include "plain/plain.h"
#include "views/manual.h"
#include "views/plot_colors.h"
#include "views/session_actions.h"
#include "views/undo_actions.h"

#include <QMenuBar>
#include <QScrollArea>
#include <QVBoxLayout>

#include <utility>

namespace views {

namespace {

constexpr int intervals = 600; // more than a chart has pixels for each

QString listed(const std::vector<std::string>& sentences) {
    QString text;
    for (const std::string& one : sentences)
        text += (text.isEmpty() ? "" : "\n") + QString::fromStdString(one);
    return text;
}

PlotSamples namedOnly(const scene::Scene& scene, const scene::Plot& plot) {
    PlotSamples samples;
    samples.title = QString::fromStdString(plot.title.empty() ? plot.name : plot.title);
    for (std::size_t i = 0; i < plot.values.size(); ++i)
        samples.curves.push_back(
            {QString::fromStdString(i < plot.labels.size() ? plot.labels[i] : plot.values[i]),
             {},
             {}});
    colorCurves(scene, plot, samples.curves);
    return samples;
}

} // namespace

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

// None: something newer is asked for, or nothing any more.
std::optional<PlotSamples> PlotsWindow::samplesOf(const Shown& shown,
                                                  const scene::Plot& plot) const {
    PlotSamples samples = namedOnly(*shown.scene, plot);
    if (!shown.motion)
        return samples;
    std::vector<std::string> faults;
    const simulation::Quantities quantities(*shown.scene, {}, shown.motion, plot.values, faults);
    samples.fault = listed(faults);
    if (!faults.empty())
        return samples;
    const double start = shown.motion->start(), length = shown.motion->computed() - start;
    for (int i = 0; i <= intervals; ++i) {
        if (isOvertaken())
            return std::nullopt;
        const double time = start + length * i / intervals;
        const std::vector<double> values = quantities.at(time);
        samples.times.push_back(time);
        for (std::size_t k = 0; k < values.size() && k < samples.curves.size(); ++k)
            samples.curves[k].values.push_back(values[k]);
    }
    return samples;
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
        PlotSamples soon = namedOnly(scene, scene.plots[charts_.size() - 1]);
        soon.fault = tr("The values are being computed…");
        charts_.back()->setSamples(std::move(soon), scene.simulator.start, scene.simulator.finish);
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
        std::vector<PlotSamples> samples;
        for (const scene::Plot& plot : shown.scene->plots)
            if (auto one = samplesOf(shown, plot))
                samples.push_back(std::move(*one));
        if (samples.size() == shown.scene->plots.size())
            QMetaObject::invokeMethod(
                this, [this, shown, samples] { take(shown, samples); }, Qt::QueuedConnection);
        lock.lock();
    }
}

void PlotsWindow::take(const Shown& of, std::vector<PlotSamples> samples) {
    if (samples.size() != charts_.size())
        return; // of a scene that is no more
    const scene::Simulator& simulator = of.scene->simulator;
    for (std::size_t i = 0; i < samples.size(); ++i)
        charts_[i]->setSamples(std::move(samples[i]),
                               of.motion ? of.motion->start() : simulator.start,
                               of.motion ? of.motion->finish() : simulator.finish);
}

} // namespace views
