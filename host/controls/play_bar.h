// The slim bar over a rendition that has time: play or pause, a slider, the time in words.
// A view shows it over the rendition that the pointer is over, and nowhere else.
#pragma once

#include "ipc/messages.h"

#include <QWidget>

class QLabel;
class QSlider;
class QToolButton;

namespace controls {

// "1.25 / 3.00 s"
[[nodiscard]] QString timeText(const ipc::TimeChanged& time);

class PlayBar : public QWidget {
    Q_OBJECT

public:
    static constexpr int barHeight = 34;

    // `dark`: lies over a picture; else it stands in a tool area.
    PlayBar(bool dark, QWidget* parent);
    void setTime(const ipc::TimeChanged& time);

Q_SIGNALS:
    void playWanted();
    void pauseWanted();
    void seekWanted(double time);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void setPlaying(bool playing);

    bool dark_;
    QToolButton* button_;
    QSlider* slider_;
    QLabel* label_;
    ipc::TimeChanged time_;
};

} // namespace controls
