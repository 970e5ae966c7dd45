// Find and replace, below the text.
//
// All places are marked while the bar is open. Case counts when the words have capitals.
#pragma once

#include "language/scene_editor.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace views {

class FindBar : public QWidget {
    Q_OBJECT
public:
    explicit FindBar(SceneEditor& editor);

    void open(bool replacing); // with what is selected
    void close();
    // From the selection on and round the end; false: nowhere.
    bool find(const QString& what, bool forward = true);
    bool findNext(bool forward = true);
    void replaceOne(); // the selected place, and on to the next
    int replaceAll();

    [[nodiscard]] QLineEdit& what() { return *what_; }
    [[nodiscard]] QLineEdit& with() { return *with_; }

Q_SIGNALS:
    void wanted(scene::Range range);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] std::vector<scene::Range> places(const QString& what) const;
    void markAll();
    void say(const QString& words, bool fault = false);

    SceneEditor& editor_;
    QLineEdit *what_, *with_;
    QCheckBox* wholeWords_;
    QLabel* words_;
    QWidget* replaceRow_;
};

} // namespace views
