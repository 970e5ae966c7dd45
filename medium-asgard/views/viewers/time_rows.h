// The rows of a window that show its time: the buttons that play, the strip of a trajectory's
// points, and the time scrollbar. They and the playback follow the scene's motion: its span, as far
// as it is computed, its impacts and faults.
#pragma once

#include "panels/time_bar.h"
#include "panels/time_controls.h"
#include "trajectories/time_strip.h"
#include "workbench/playback.h"
#include "workbench/scene_document.h"

#include <QWidget>

namespace views {

class TimeRows : public QWidget {
    Q_OBJECT
public:
    // Both outlive it.
    TimeRows(SceneDocument& document, Playback& playback);

    [[nodiscard]] TimeControls& controls() { return *controls_; }
    [[nodiscard]] TimeStrip& strip() { return *strip_; }
    [[nodiscard]] TimeBar& bar() { return *bar_; }

private:
    [[nodiscard]] double finish() const;
    void followMotion();
    void showFaults();
    void showSpan();
    void showTime();

    SceneDocument& document_;
    Playback& playback_;
    TimeControls* controls_;
    TimeStrip* strip_;
    TimeBar* bar_;
    bool isOpened_ = false; // another scene, which is not there yet
};

} // namespace views
