// From when to when a scene moves: two fields in a window, the `simulator` of the text.
//
// A typed time is taken with Return, and before the next action in the window: a click elsewhere, a
// key that is a command.
#pragma once

#include "workbench/scene_document.h"

#include <QEvent>
#include <QWidget>

class QLineEdit;

namespace views {

class MotionSpan : public QWidget {
    Q_OBJECT
public:
    explicit MotionSpan(SceneDocument& document, QWidget* parent = nullptr);

    // Takes what was typed, in all windows of the document.
    static void settleAll(const SceneDocument& document);

Q_SIGNALS:
    void left(); // with Return or Escape, or for something else

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLineEdit* addField(const QString& label, const QString& name, const QString& tip,
                        const char* option);
    void show(); // what the scene has
    void take(QLineEdit* field, const char* option);
    void takeBoth();
    [[nodiscard]] bool leavesField(QObject* watched, const QEvent& event) const;
    void watch(QEvent::Type focus);
    [[nodiscard]] QString change(const char* option, double value); // "" or why not

    SceneDocument& document_;
    QLineEdit* start_ = nullptr; // while its field is made, events reach this
    QLineEdit* finish_ = nullptr;
};

} // namespace views
