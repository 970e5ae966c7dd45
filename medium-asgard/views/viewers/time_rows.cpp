#include "viewers/time_rows.h"

#include "frame/help_page.h"
#include "motion/known_span.h"

#include <QGridLayout>
#include <QVBoxLayout>

#include <utility>

namespace views {

TimeRows::TimeRows(SceneDocument& document, Playback& playback)
    : document_(document), playback_(playback), controls_(new TimeControls(document, playback)),
      strip_(new TimeStrip(document)), bar_(new TimeBar) {
    bar_->setObjectName("timeBar");
    strip_->setObjectName("timeStrip");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(controls_);
    auto* times = new QGridLayout; // the same times above each other
    times->setSpacing(2);
    times->addWidget(strip_->controls(), 0, 0);
    times->addWidget(strip_, 0, 1);
    times->addWidget(bar_, 1, 1);
    column->addLayout(times);
    for (QWidget* one : std::initializer_list<QWidget*>{controls_, bar_})
        setHelp(*one, QStringLiteral("Time"));
    for (QWidget* one : std::initializer_list<QWidget*>{strip_, strip_->controls()})
        setHelp(*one, QStringLiteral("Strip of times"));

    connect(&playback_, &Playback::timeChanged, this, &TimeRows::showTime);
    connect(&playback_, &Playback::stateChanged, this, &TimeRows::showSpan);
    connect(bar_, &TimeBar::timeChosen, &playback_, &Playback::seek);
    connect(&document_, &SceneDocument::motionChanged, this, &TimeRows::followMotion);
    connect(&document_, &SceneDocument::workChanged, this, [this] {
        bar_->setStale(document_.motionIsStale());
        followMotion(); // a motion that is all there ends where it stops
    });
    connect(&document_, &SceneDocument::diagnosticsChanged, this, &TimeRows::showFaults);
    connect(&document_, &SceneDocument::opened, this, [this] { // seen as if for the first time
        playback_.stop();
        isOpened_ = true;
    });
    followMotion();
    showFaults();
    showSpan();
}

// Of the scene's motion, even where it stops before that.
double TimeRows::finish() const {
    const Shown& shown = document_.shown();
    return shown.motion ? shown.motion->finish() : shown.scene->simulator.finish;
}

void TimeRows::followMotion() {
    const Shown& shown = document_.shown();
    const scene::Simulator& simulator = shown.scene->simulator;
    const bool known = shown.motion != nullptr;
    const simulation::KnownSpan span = known ? simulation::knownSpan(*shown.motion)
                                             : simulation::KnownSpan{simulator.start, {}, 0};
    playback_.setRange(known ? shown.motion->start() : simulator.start,
                       known ? span.playsTo(*shown.motion, document_.work() != Work::none)
                             : simulator.finish,
                       span.computed);
    if (document_.sceneIsCurrent() && std::exchange(isOpened_, false))
        playback_.stop(); // at its own first moment
    std::vector<double> impacts;
    if (known)
        for (const simulation::Impact& impact : shown.motion->impacts())
            impacts.push_back(impact.time);
    bar_->setRange(playback_.start(), finish(), span.computed);
    bar_->setMarks(span.reliableUntil, impacts);
    bar_->setEnabled(known);
}

void TimeRows::showFaults() {
    std::vector<TimeBar::Fault> faults;
    for (const scene::Diagnostic& one : document_.diagnostics())
        if (one.time)
            faults.push_back({*one.time, one.severity == scene::Severity::error,
                              QString::fromStdString(one.message)});
    bar_->setFaults(std::move(faults));
}

void TimeRows::showSpan() {
    strip_->setRange(playback_.start(), finish());
    showTime();
}

void TimeRows::showTime() {
    bar_->setTime(playback_.time());
    strip_->setTime(playback_.time());
}

} // namespace views
