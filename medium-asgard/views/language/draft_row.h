// The row below a language viewer's text: Update, Save, Revert and Dismiss, and a sentence that
// says in which state the text is, and after an Update what that changed (dissertation 4.2.2).
#pragma once

#include "workbench/scene_document.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace views {

class Draft;
class SceneEditor;

class DraftRow : public QWidget {
    Q_OBJECT
public:
    struct Offers { // where it stands
        bool save = true, dismiss = true;
    };
    DraftRow(SceneDocument& document, Draft& draft, SceneEditor& editor, Offers offers);

    void expectChanges(); // of the Update that is under way
    void refresh();       // what can be done, and the state

Q_SIGNALS:
    void updateWanted();
    void saveWanted();
    void revertWanted();
    void dismissWanted();

private:
    [[nodiscard]] static QPushButton* made(const char* name, const QString& label,
                                           const QString& tip);
    void showState();
    void tellChanges();

    SceneDocument& document_;
    Draft& draft_;
    SceneEditor& editor_;
    QPushButton *update_, *save_, *revert_;
    QLabel* state_;
    // The scene before an Update whose scene is yet to be read, and what that Update did.
    std::optional<std::pair<std::string, std::shared_ptr<const scene::Scene>>> updating_;
    QString updated_;
};

} // namespace views
