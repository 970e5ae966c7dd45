// The graphical viewer's window (dissertation 4.1): menu bar, picture, status and switches at the
// right, time buttons and the time scrollbar below. Any number of them, each with its own
// viewpoint and time.
#pragma once

#include "frame/icons.h"
#include "frame/windows.h"
#include "picture/scene_display.h"
#include "trajectories/time_strip.h"
#include "viewers/status_panel.h"
#include "viewers/time_bar.h"
#include "workbench/playback.h"

#include <QMainWindow>
#include <QToolButton>

class QHBoxLayout;
class QVBoxLayout;

namespace views {

class ToldBar;

class GraphicalViewer : public QMainWindow {
    Q_OBJECT
public:
    // `number` tells several viewers apart in their titles.
    GraphicalViewer(SceneDocument& document, std::shared_ptr<PictureThread> pictures,
                    Windows windows, int number);

    [[nodiscard]] Playback& playback() { return playback_; }
    [[nodiscard]] SceneDisplay& display() { return *display_; }
    [[nodiscard]] TimeBar& timeBar() { return *timeBar_; }
    [[nodiscard]] TimeStrip& timeStrip() { return *timeStrip_; }
    void tell(const QString& sentence); // above the picture, until it was read

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void buildMenus();
    void buildViewMenu();
    void buildLiveMenu(QMenu* menu);
    void buildTimeControls(QVBoxLayout* column);
    QToolButton* addButton(QHBoxLayout* row, const char* name, Icon which, const QString& tip,
                           std::function<void()> action);
    void connectTimeStrip();
    void connectBody();
    void showMenu(const MenuPlace& place);
    void fillViewsMenu();
    void updateRange();
    void updateState();
    void updateIcons();
    void updateTitle();
    void showHint();
    void togglePlaying();
    void stop();
    void keepView();
    void showCreated(editing::Element element, HandleSwitch handles);

    SceneDocument& document_;
    Windows windows_;
    int number_;
    Playback playback_;
    SceneDisplay* display_;
    ToldBar* told_;
    StatusPanel* panel_;
    TimeBar* timeBar_;
    TimeStrip* timeStrip_;
    QMenu* viewsMenu_ = nullptr;
    QAction *playAction_ = nullptr, *loopAction_ = nullptr;
    QToolButton *playButton_ = nullptr, *loopButton_ = nullptr, *rateButton_ = nullptr;
    std::vector<std::pair<QToolButton*, Icon>> buttons_;
    QLabel *timeLabel_ = nullptr, *hint_ = nullptr;
};

} // namespace views
