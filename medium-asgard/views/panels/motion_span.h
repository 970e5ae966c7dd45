// From when to when a scene moves: two fields in a window, the `simulator` of the text.
#pragma once

#include "workbench/when_read.h"

#include <QWidget>

class QLineEdit;

namespace views {

class MotionSpan : public QWidget {
    Q_OBJECT
public:
    explicit MotionSpan(SceneDocument& document, QWidget* parent = nullptr);

Q_SIGNALS:
    void left(); // with Return or Escape, or for something else
    void refused(const QString& why);

private:
    QLineEdit* addField(const QString& label, const QString& name, const QString& tip,
                        const char* option);
    void show(); // what the scene has
    void take(QLineEdit* field, const char* option);
    [[nodiscard]] QString change(const char* option, double value); // "" or why not

    SceneDocument& document_;
    WhenRead later_;
    QLineEdit* start_ = nullptr;
    QLineEdit* finish_ = nullptr;
};

} // namespace views
