// An exact value: what stands in the text for each of its numbers, to be typed anew.
//
// Opens over the picture beside what it is about. While one types it shows the line of the text
// before and after, or says why the number cannot be changed there and offers what can be done,
// previewed in the same way. Return takes the value, Escape leaves everything as it is.
#pragma once

#include "commands/asked_value.h"
#include "workbench/scene_document.h"

#include <QFrame>
#include <QLabel>
#include <QLineEdit>

class QVBoxLayout;

namespace views {

class ValueEntry : public QFrame {
    Q_OBJECT
public:
    ValueEntry(SceneDocument& document, commands::AskedValue asked, QWidget* parent);

    void openAt(const QPoint& handle);
    // The values that a gesture asked for, as if they were typed.
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
    void update();
    void take(const text::Edits& edits);
    void leave();

    SceneDocument& document_;
    const commands::AskedValue asked_;
    std::vector<QLineEdit*> fields_;
    QLabel* says_;
    QVBoxLayout* offers_;
    editing::Answer answer_;
};

} // namespace views
