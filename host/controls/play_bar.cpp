#include "controls/play_bar.h"

#include "controls/icons.h"
#include "plain/plain.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QSlider>
#include <QToolButton>
#include <cmath>

namespace controls {

namespace {

constexpr int steps = 10'000; // of the slider

// White on the bar's dark ground, whatever the theme.
QIcon whitened(const QIcon& icon) {
    QPixmap pixmap = icon.pixmap(32);
    QPainter painter(&pixmap);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(pixmap.rect(), Qt::white);
    painter.end();
    return pixmap;
}

} // namespace

QString timeText(const ipc::TimeChanged& time) {
    const int decimals = time.finish - time.start >= 100 ? 1 : 2;
    return QStringLiteral("%1 / %2 s")
        .arg(time.time, 0, 'f', decimals)
        .arg(time.finish, 0, 'f', decimals);
}

PlayBar::PlayBar(bool dark, QWidget* parent)
    : QWidget(parent), dark_(dark), button_(new QToolButton(this)),
      slider_(new QSlider(Qt::Horizontal, this)), label_(plain::label({}, this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 0, 10, 0);
    row->setSpacing(6);
    row->addWidget(button_);
    row->addWidget(slider_, 1);
    row->addWidget(label_);
    button_->setAutoRaise(true);
    button_->setIconSize({16, 16});
    slider_->setRange(0, steps);
    button_->setObjectName("play");
    slider_->setObjectName("time");
    slider_->setAccessibleName(tr("Time"));
    slider_->setFocusPolicy(dark ? Qt::NoFocus : Qt::StrongFocus);
    button_->setFocusPolicy(dark ? Qt::NoFocus : Qt::StrongFocus);

    const QString colors =
        dark ? QStringLiteral("QLabel{color:white}"
                              "QSlider::groove:horizontal{height:3px;border-radius:1px;"
                              "background:rgba(255,255,255,80)}"
                              "QSlider::sub-page:horizontal{background:white;border-radius:1px}"
                              "QSlider::handle:horizontal{width:11px;height:11px;margin:-4px 0;"
                              "border-radius:5px;background:white}"
                              "QToolButton{border:none;padding:3px;border-radius:4px}"
                              "QToolButton:hover{background:rgba(255,255,255,50)}")
             : QStringLiteral("QSlider::groove:horizontal{height:3px;border-radius:1px;"
                              "background:palette(mid)}"
                              "QSlider::sub-page:horizontal{background:palette(highlight)}"
                              "QSlider::handle:horizontal{width:11px;height:11px;margin:-4px 0;"
                              "border-radius:5px;background:palette(highlight)}");
    setStyleSheet(colors);
    setPlaying(false);
    setCursor(Qt::ArrowCursor);
    connect(button_, &QToolButton::clicked, this, [this] {
        if (time_.playing)
            Q_EMIT pauseWanted();
        else
            Q_EMIT playWanted();
    });
    // Only what the user does: setTime() moves the slider too.
    connect(slider_, &QSlider::valueChanged, this, [this](int value) {
        Q_EMIT seekWanted(time_.start + (time_.finish - time_.start) * value / steps);
    });
}

void PlayBar::setPlaying(bool playing) {
    const QIcon icon = iconNamed(playing ? "media-playback-pause" : "media-playback-start");
    button_->setIcon(dark_ ? whitened(icon) : icon);
    button_->setToolTip(playing ? tr("Pause") : tr("Play"));
    button_->setAccessibleName(button_->toolTip());
}

void PlayBar::setTime(const ipc::TimeChanged& time) {
    const bool wasPlaying = time_.playing;
    time_ = time;
    if (time.playing != wasPlaying)
        setPlaying(time.playing);
    label_->setText(timeText(time));
    slider_->setAccessibleDescription(timeText(time)); // its value counts its own steps
    if (slider_->isSliderDown())
        return;
    const double length = time.finish - time.start;
    const QSignalBlocker blocker(slider_);
    slider_->setValue(length > 0
                          ? static_cast<int>(std::lround(
                                steps * std::clamp((time.time - time.start) / length, 0.0, 1.0)))
                          : 0);
}

void PlayBar::paintEvent(QPaintEvent*) {
    if (!dark_)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(24, 25, 28, 190));
    painter.drawRoundedRect(rect(), 6, 6);
}

} // namespace controls
