// The control panel (dissertation 4): the small window that manages the whole of a stand-alone
// session - its file, its simulation, its viewers.
#pragma once

#include "viewers/exports.h"
#include "viewers/graphical_viewer.h"
#include "workbench/scene_document.h"

#include <QMainWindow>

class QLabel;
class QProgressBar;
class QPushButton;

namespace views {

class ControlPanel : public QMainWindow {
    Q_OBJECT
public:
    ControlPanel(SceneDocument& document, Windows windows);

    // Opens a file in place of the present one; asks first when that would lose changes.
    void open();
    void open(const QString& path);
    // `from`: the window that it is asked in, which has the dialogs, and the keyboard afterwards.
    void newScene(QWidget* from = nullptr);
    bool save(QWidget* from = nullptr); // false: not saved
    [[nodiscard]] Exports& exports() { return exports_; }
    bool saveAs(QWidget* from = nullptr);
    // Nothing would be lost, or the user agreed to what is.
    bool mayLeave(QWidget* from = nullptr);

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void buildMenus();
    void showState();
    bool saveTo(const QString& path, QWidget* from);

    SceneDocument& document_;
    Windows windows_;
    QLabel *name_, *place_, *state_;
    QProgressBar* progress_;
    QPushButton* simulate_;
    Exports& exports_;
};

} // namespace views
