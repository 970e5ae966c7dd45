// The graphical viewer's window (dissertation 4.1): the picture in the middle, time buttons and the
// time scrollbar below, and panes beside them: status and switches, the text, plots. Any number of
// them, each with its own viewpoint and time.
#pragma once

#include "frame/panes.h"
#include "frame/windows.h"
#include "panels/status_panel.h"
#include "picture/scene_display.h"
#include "viewers/time_rows.h"
#include "workbench/playback.h"

#include <QMainWindow>

class QVBoxLayout;

namespace views {

class ElementCommands;
class HintLine;
class LanguageViewer;
class ParametersPanel;
class ToldBar;

class GraphicalViewer : public QMainWindow {
    Q_OBJECT
public:
    // `number` tells several viewers apart in their titles.
    GraphicalViewer(SceneDocument& document, std::shared_ptr<PictureThread> pictures,
                    Windows windows, int number);

    [[nodiscard]] Playback& playback() { return playback_; }
    [[nodiscard]] SceneDisplay& display() { return *display_; }
    [[nodiscard]] TimeRows& times() { return *times_; }
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
    void buildTextMenu();
    QWidget* makeTour();
    QWidget* makePlots();
    [[nodiscard]] QString helpAt(const QWidget& under) const;
    void connectParts();
    void buildLiveMenu(QMenu* menu);
    void connectTimeStrip();
    void connectThrowing();
    void showMenu(const MenuPlace& place, const QPoint& global);
    void beginPlaying(); // computes what is not computed, and says where nothing can move
    void updateTitle();
    void showHint();
    bool typing(bool redo); // takes back what was typed in the text, where the keyboard is
    void switchPane();
    void toggleFullScreen();
    void stop();
    void keepView();
    void showCreated(const std::optional<editing::Element>& element, HandleSwitch handles);

    SceneDocument& document_;
    Windows windows_;
    int number_;
    Playback playback_;
    SceneDisplay* display_;
    ElementCommands* commands_;
    ToldBar* told_;
    StatusPanel* panel_;
    ParametersPanel* sliders_;
    TimeRows* times_;
    HintLine* hint_;
    Panes panes_;
};

} // namespace views
