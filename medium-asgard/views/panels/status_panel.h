// The area beside a viewer's picture: where the motion stands, and what is shown.
#pragma once

#include "drawing/drawing.h"
#include "workbench/playback.h"
#include "workbench/scene_document.h"

#include <QCheckBox>
#include <QLabel>
#include <QWidget>

namespace views {

// "2.413 s", with as many digits as the length of the motion makes sense of.
[[nodiscard]] QString timeText(double time, double length);

class StatusPanel : public QWidget {
    Q_OBJECT
public:
    StatusPanel(SceneDocument& document, Playback& playback, const render::Display& display,
                QWidget* parent = nullptr);

    // The switches of what is shown; the viewer's menu has the same.
    struct Switch {
        QCheckBox* box;
        bool render::Display::*what;
        bool isHandle = false;
        bool isUsual = false;  // on
        bool isChosen = false; // on, when the user, and no command, has switched it last
    };
    [[nodiscard]] const std::vector<Switch>& switches() const { return switches_; }

    // Switches it on, for a command.
    void show(bool render::Display::*what);
    // Switches that are not as usual: "+grid" is on, "-joints" off; by the names of their boxes,
    // the same in each language. Switches that others do not name are as usual.
    [[nodiscard]] QStringList shown() const;
    [[nodiscard]] QStringList chosen() const; // by the user
    void setShown(const QStringList& names);

Q_SIGNALS:
    void displayChanged(const render::Display& display);

private:
    void addSwitches(const render::Display& display);
    [[nodiscard]] QStringList unusual(bool (*isOn)(const Switch& one)) const;
    void showTime();
    void showMotion();

    SceneDocument& document_;
    Playback& playback_;
    render::Display display_;
    QLabel *time_, *computed_, *accuracy_, *predictable_, *impacts_, *state_;
    std::vector<Switch> switches_;
    bool isCommanded_ = false; // what is switched now
};

} // namespace views
