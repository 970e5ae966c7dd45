// The control panel (dissertation 4): the small window that manages the whole of a stand-alone
// session - its file, its simulation, its viewers.
#pragma once

#include "views/exporting.h"
#include "views/graphical_viewer.h"
#include "views/scene_document.h"

#include <QMainWindow>
#include <QPointer>

class QLabel;
class QProgressBar;
class QProgressDialog;
class QPushButton;

namespace views {

class ControlPanel : public QMainWindow {
    Q_OBJECT
public:
    ControlPanel(SceneDocument& document, Windows windows);

    // Opens a file in place of the present one; asks first when that would lose changes.
    void open();
    void open(const QString& path);
    void newScene();
    bool save(); // false: not saved
    // What there is to export; nothing: no picture is open.
    void setExported(std::function<std::optional<ToExport>()> exported) {
        exported_ = std::move(exported);
    }
    void exportTo(const QString& path, ExportFormat format);
    bool saveAs();
    // Nothing would be lost, or the user agreed to what is.
    bool mayLeave();

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void buildMenus();
    void askForExport();
    void showState();
    bool saveTo(const QString& path);

    SceneDocument& document_;
    Windows windows_;
    QLabel *name_, *place_, *state_;
    QProgressBar* progress_;
    QPushButton* simulate_;
    std::function<std::optional<ToExport>()> exported_;
    QPointer<QProgressDialog> progressing_;
};

} // namespace views
