#include "panels/time_controls.h"

#include "panels/motion_span.h"
#include "panels/status_panel.h"
#include "plain/plain.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include <algorithm>

namespace views {

namespace {

constexpr double rates[] = {0.1, 0.25, 0.5, 1, 2, 4};

QString rateText(double rate) { return QStringLiteral("%1 × ").arg(rate); }

} // namespace

TimeControls::TimeControls(SceneDocument& document, Playback& playback, QWidget* parent)
    : QWidget(parent), document_(document), playback_(playback) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    addButton(row, "first", Icon::first, tr("First moment (Home)"),
              [this] { playback_.seek(playback_.start()); });
    addButton(row, "stepBack", Icon::stepBack, tr("Step back (Left)"),
              [this] { playback_.step(-1); });
    playButton_ = addButton(row, "play", Icon::play, tr("Play or pause (Space)"),
                            [this] { togglePlaying(); });
    addButton(row, "stop", Icon::stop, tr("Stop (Escape)"), [this] { stop(); });
    addButton(row, "stepForward", Icon::stepForward, tr("Step (Right)"),
              [this] { playback_.step(1); });
    addButton(row, "last", Icon::last, tr("Last moment (End)"),
              [this] { playback_.seek(playback_.finish()); });
    loopButton_ = addButton(row, "loop", Icon::loop, tr("Play again and again (L)"),
                            [this] { playback_.setLoops(!playback_.loops()); });
    loopButton_->setCheckable(true);
    addRates(row);
    row->addStretch();
    span_ = new MotionSpan(document);
    connect(span_, &MotionSpan::left, this, &TimeControls::left);
    connect(span_, &MotionSpan::refused, this, &TimeControls::refused);
    row->addWidget(span_);
    row->addSpacing(12);
    time_ = plain::label();
    time_->setObjectName("time");
    QFont font = time_->font();
    font.setBold(true);
    time_->setFont(font);
    time_->setAccessibleName(tr("Time"));
    time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(time_);
    connect(&playback_, &Playback::timeChanged, this, &TimeControls::showTime);
    connect(&playback_, &Playback::stateChanged, this, &TimeControls::showState);
    showState();
}

QToolButton* TimeControls::addButton(QHBoxLayout* row, const char* name, Icon which,
                                     const QString& tip, std::function<void()> action) {
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setIconSize(QSize(20, 20));
    button->setAutoRaise(true);
    button->setToolTip(plain::tip(tip));
    button->setAccessibleName(tip.section(QStringLiteral(" ("), 0, 0));
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QToolButton::clicked, this, std::move(action));
    row->addWidget(button);
    buttons_.emplace_back(button, which);
    return button;
}

void TimeControls::addRates(QHBoxLayout* row) {
    rateButton_ = new QToolButton;
    rateButton_->setObjectName("rate");
    rateButton_->setAutoRaise(true);
    rateButton_->setPopupMode(QToolButton::InstantPopup);
    rateButton_->setToolTip(tr("How fast it is played"));
    rateButton_->setFocusPolicy(Qt::TabFocus);
    auto* menu = new QMenu(rateButton_);
    for (double rate : rates)
        menu->addAction(plain::caption(rateText(rate)), this,
                        [this, rate] { playback_.setRate(rate); });
    rateButton_->setMenu(menu);
    int widest = 0;
    for (double rate : rates) {
        rateButton_->setText(rateText(rate));
        widest = std::max(widest, rateButton_->sizeHint().width());
    }
    rateButton_->setFixedWidth(widest);
    row->addWidget(rateButton_);
}

void TimeControls::fillMenu(QMenu& menu, std::function<void()> stop) {
    playAction_ = menu.addAction(tr("&Play"), QKeySequence(Qt::Key_Space), this,
                                 &TimeControls::togglePlaying);
    menu.addAction(tr("S&top"), QKeySequence(Qt::Key_Escape), this, std::move(stop));
    menu.addAction(tr("&Step"), QKeySequence(Qt::Key_Right), this, [this] { playback_.step(1); });
    menu.addAction(tr("Step &Back"), QKeySequence(Qt::Key_Left), this,
                   [this] { playback_.step(-1); });
    menu.addAction(tr("&First Moment"), QKeySequence(Qt::Key_Home), this,
                   [this] { playback_.seek(playback_.start()); });
    menu.addAction(tr("&Last Moment"), QKeySequence(Qt::Key_End), this,
                   [this] { playback_.seek(playback_.finish()); });
    loopAction_ = menu.addAction(tr("L&oop"), QKeySequence(Qt::Key_L), this,
                                 [this] { playback_.setLoops(!playback_.loops()); });
    loopAction_->setCheckable(true);
    showState();
}

void TimeControls::togglePlaying() {
    if (playback_.isPlaying())
        playback_.pause();
    else
        playback_.play();
}

void TimeControls::stop() {
    if (document_.work() == Work::simulating)
        document_.stopComputing();
    playback_.stop();
}

std::vector<QWidget*> TimeControls::folding() const {
    std::vector<QWidget*> all;
    for (const char* name : {"last", "first", "stop", "stepBack", "stepForward", "loop"})
        all.push_back(findChild<QToolButton*>(name));
    all.push_back(rateButton_);
    return all;
}

int TimeControls::widthOfAll() const {
    int sum = 0;
    for (int i = 0; i < layout()->count(); ++i) {
        QLayoutItem* item = layout()->itemAt(i); // a hidden one has a hint, too
        const QWidget* widget = item->widget();
        const int wanted = (widget ? widget->sizeHint() : item->sizeHint()).width();
        const int least = widget ? widget->minimumWidth() : 0;
        sum += std::max(wanted, least) + layout()->spacing();
    }
    return sum;
}

QSize TimeControls::minimumSizeHint() const {
    int least = widthOfAll();
    for (const QWidget* one : folding())
        least -= one->sizeHint().width() + layout()->spacing();
    return {least, sizeHint().height()};
}

void TimeControls::fold() {
    int needed = widthOfAll();
    for (QWidget* one : folding()) {
        const bool fits = needed <= width();
        one->setVisible(fits);
        if (!fits)
            needed -= one->sizeHint().width() + layout()->spacing();
    }
}

void TimeControls::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fold();
}

bool TimeControls::event(QEvent* event) {
    const bool is = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest) // a longer motion
        fold();
    return is;
}

// Of the whole motion, however much of it is computed, or may be played.
double TimeControls::length() const {
    const Shown& shown = document_.shown();
    const scene::Simulator& simulator = shown.scene->simulator;
    return shown.motion ? shown.motion->finish() - shown.motion->start()
                        : simulator.finish - simulator.start;
}

void TimeControls::showTime() { time_->setText(timeText(playback_.time(), length())); }

// As wide as the longest time of the motion: the buttons stay where they are while time runs.
void TimeControls::reserveTime() {
    const QFontMetrics metrics = time_->fontMetrics();
    int widest = 0;
    for (const double time : {playback_.start(), playback_.start() + length()}) {
        QString text = timeText(time, length());
        for (QChar& one : text)
            if (one.isDigit())
                one = '8';
        widest = std::max(widest, metrics.horizontalAdvance(text) + 2);
    }
    if (time_->minimumWidth() != widest)
        time_->setMinimumWidth(widest);
}

void TimeControls::showState() {
    reserveTime();
    showTime();
    loopButton_->setChecked(playback_.loops());
    rateButton_->setText(rateText(playback_.rate()));
    rateButton_->setAccessibleName(tr("Rate: %1").arg(rateText(playback_.rate()).trimmed()));
    if (playAction_) {
        loopAction_->setChecked(playback_.loops());
        playAction_->setText(playback_.isPlaying() ? tr("&Pause") : tr("&Play"));
    }
    showIcons();
}

void TimeControls::showIcons() {
    for (const auto& [button, which] : buttons_)
        button->setIcon(
            icon(button == playButton_ && playback_.isPlaying() ? Icon::pause : which, palette()));
}

void TimeControls::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && playButton_ != nullptr)
        showIcons();
}

} // namespace views
