// The graphical viewer's window (dissertation 4.1): the picture in the middle, time buttons and the
// time scrollbar below, and panes beside them: status and switches, the text, plots. Any number of
// them, each with its own viewpoint and time.
#pragma once

#include "frame/panes.h"
#include "frame/undo_actions.h"
#include "frame/windows.h"
#include "panels/status_panel.h"
#include "panels/time_bar.h"
#include "picture/scene_display.h"
#include "trajectories/time_strip.h"
#include "workbench/playback.h"

#include <QMainWindow>

class QVBoxLayout;

namespace views {

class ElementCommands;
class HintLine;
class LanguageViewer;
class ParametersPanel;
class TimeControls;
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
    [[nodiscard]] Panes& panes() { return panes_; }
    [[nodiscard]] StatusPanel& switches() { return *panel_; }
    // The panes that one begins with, in their usual places.
    void showUsualPanes();
    // As they were in another window; as usual, and within the screen, where that cannot be.
    void arrange(const QByteArray& panes);
    void showTour();
    void buildToolBar();                        // once all commands are in the menus
    [[nodiscard]] LanguageViewer* text() const; // nullptr while its pane was never shown
    void showText();                            // in its pane, with the keyboard
    void tell(const QString& sentence);         // above the picture, until it was read

protected:
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void buildPicture(std::shared_ptr<PictureThread> pictures);
    void buildPanes();
    void buildMenus();
    void buildFileMenu();
    void buildEditMenu();
    void buildViewMenu();
    void buildHandlesMenu();
    void buildMotionMenu();
    void fillTextMenu(LanguageViewer& text);
    QWidget* makeTour();
    QWidget* makePlots();
    [[nodiscard]] QString helpAt(const QWidget& under) const;
    void connectParts();
    void buildLiveMenu(QMenu* menu);
    void connectTimeStrip();
    void connectThrowing();
    void showMenu(const MenuPlace& place, const QPoint& global);
    void fillViewsMenu();
    void beginPlaying(); // computes what is not computed, and says why nothing moves
    void updateRange();
    [[nodiscard]] double finish() const;
    void showFaults();
    void updateState();
    void updateTitle();
    void showHint();
    bool typing(bool redo); // takes back what was typed in the text, where the keyboard is
    void switchPane();
    void toggleFullScreen();
    void stop();
    void keepView();
    void showCreated(editing::Element element, HandleSwitch handles);

    SceneDocument& document_;
    Windows windows_;
    int number_;
    Playback playback_;
    SceneDisplay* display_;
    ElementCommands* commands_;
    ToldBar* told_;
    StatusPanel* panel_;
    ParametersPanel* sliders_;
    TimeBar* timeBar_;
    TimeStrip* timeStrip_;
    TimeControls* controls_;
    HintLine* hint_ = nullptr;
    Panes panes_;
    QMenu *viewsMenu_ = nullptr, *textMenu_ = nullptr;
    UndoActions undo_{};
    bool wasPlaying_ = false;
    bool isOpened_ = false; // another scene, which is not there yet
    bool goesOn_ = false;   // it played before a body was taken in the hand
};

} // namespace views
