// Above the values: what is selected, its name, its line, and why nothing can be changed.
#pragma once

#include "properties/element_commands.h"
#include "workbench/when_read.h"

#include <QWidget>

#include <functional>

class QLabel;
class QLineEdit;
class QPushButton;

namespace views {

class PropertyHead : public QWidget {
    Q_OBJECT
public:
    PropertyHead(SceneDocument& document, ElementCommands& commands, WhenRead& later,
                 std::function<void()> showText, QWidget* parent = nullptr);

    [[nodiscard]] QLineEdit& name() { return *name_; }
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString fault() const;
    [[nodiscard]] QString refusal() const; // of the name that was typed last; "": none

    void showElements(const std::vector<editing::Element>& elements);
    // About the name or a copy.
    void say(const QString& why);
    // What was typed and said was meant for others.
    void forget();
    // "ball, Mass: 0 is not positive": a sentence about another element than the one that is shown.
    [[nodiscard]] static QString meant(const QString& name, const QString& why);

Q_SIGNALS:
    void renamed(); // or refused

private:
    void rename();
    void showName(); // unless one is typed
    void showFault();

    SceneDocument& document_;
    ElementCommands& commands_;
    WhenRead& later_;
    std::vector<editing::Element> shown_;
    QString said_;
    unsigned forgotten_ = 0; // times
    QLabel *title_, *fault_;
    QLineEdit* name_;
    QPushButton* line_;
};

} // namespace views
