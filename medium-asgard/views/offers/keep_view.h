// Keep This View: where a picture is seen from becomes a `view` of the scene, or one that is there
// is changed to it (dissertation 4.1.7). Turning alone is no edit.
#pragma once

#include "editing/value_edit.h"
#include "gestures/picking.h"
#include "workbench/scene_document.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QPushButton;

namespace views {

// The numbers of that view become those of the sight; what it says by eye and look stays so.
[[nodiscard]] editing::Answer changedView(const std::string& text,
                                          const std::shared_ptr<const scene::Scene>& scene,
                                          std::size_t view, const gestures::Sight& sight);

// Which view is to become this one, with the change of the text; or a new one.
class KeepViewDialog : public QDialog {
    Q_OBJECT
public:
    // `preferred`: its name is chosen at first.
    KeepViewDialog(const SceneDocument& document, const gestures::Sight& sight,
                   const QString& preferred, QWidget* parent);

    [[nodiscard]] QComboBox& views() { return *views_; }
    [[nodiscard]] bool wantsNew() const;
    // Of the view that is chosen.
    [[nodiscard]] const editing::Answer& answer() const { return answer_; }
    [[nodiscard]] QString name() const;

private:
    void follow();

    std::string text_;
    std::shared_ptr<const scene::Scene> scene_;
    gestures::Sight sight_;
    QComboBox* views_;
    QLabel* says_;
    QPushButton* take_ = nullptr;
    editing::Answer answer_;
};

} // namespace views
