// The exact value of a handle: what stands in the text for each of its numbers, to be typed anew.
//
// Opens over the picture beside the handle. While one types it shows the line of the text before
// and after, or says why the number cannot be changed there and offers what can be done, previewed
// in the same way. Return takes the value, Escape leaves everything as it is.
#pragma once

#include "editing/trajectory_edit.h"
#include "editing/value_edit.h"
#include "render/handles.h"
#include "views/scene_document.h"

#include <QFrame>
#include <QLabel>
#include <QLineEdit>

class QVBoxLayout;

namespace views {

class ValueEntry : public QFrame {
    Q_OBJECT
public:
    // `of`: the scene that was read from the text as it is.
    ValueEntry(SceneDocument& document, const Shown& of, const render::Handle& handle,
               QWidget* parent);

    void openAt(const QPoint& handle);
    // What a gesture asked for, as if it was typed.
    void propose(const std::vector<editing::Wish>& wishes);
    [[nodiscard]] const std::vector<QLineEdit*>& fields() const { return fields_; }
    [[nodiscard]] QString saying() const { return says_->text(); }
    void accept();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override; // stays in it
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] std::optional<std::vector<double>> values() const;
    void addFields(QVBoxLayout* column);
    [[nodiscard]] editing::Answer asked(const std::vector<double>& wanted) const;
    void update();
    void showOffers();
    void take(const std::vector<editing::TextEdit>& edits);
    void leave();

    SceneDocument& document_;
    std::string text_;
    std::shared_ptr<const scene::Scene> scene_;
    simulation::MotionPointer motion_;
    editing::Mapper mapper_;
    render::Handle handle_;
    std::optional<editing::TrajectoryEdits> path_; // of a trajectory's point
    std::vector<editing::Wish> wishes_;
    std::vector<double> now_;
    std::vector<QLineEdit*> fields_;
    std::vector<QString> first_; // what they showed at first
    QLabel* says_;
    QVBoxLayout* offers_;
    editing::Answer answer_;
};

} // namespace views
