// The row below a picture that plays its motion: buttons, rate, the motion's span, the time.
#pragma once

#include "frame/icons.h"
#include "workbench/playback.h"
#include "workbench/scene_document.h"

#include <QWidget>

#include <functional>
#include <utility>
#include <vector>

class QAction;
class QHBoxLayout;
class QLabel;
class QMenu;
class QToolButton;

namespace views {

class MotionSpan;

// In a narrow row the buttons that have keys fold away, those that are needed least first. The
// row's width decides which, and the motion's length; never the time that is shown.
class TimeControls : public QWidget {
    Q_OBJECT
public:
    TimeControls(SceneDocument& document, Playback& playback, QWidget* parent = nullptr);

    // The same as commands of a window, with their keys. `stop` is called for Stop.
    void fillMenu(QMenu& menu, std::function<void()> stop);

    void togglePlaying();
    // Playing, and computing.
    void stop();

    [[nodiscard]] QSize minimumSizeHint() const override; // folded

Q_SIGNALS:
    void left();                      // a field, with Return or Escape, or for something else
    void refused(const QString& why); // a value that was typed

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    QToolButton* addButton(QHBoxLayout* row, const char* name, Icon which, const QString& tip,
                           std::function<void()> action);
    void addRates(QHBoxLayout* row);
    [[nodiscard]] double length() const;
    void reserveTime();
    void showTime();
    void showState();
    void showIcons();
    [[nodiscard]] std::vector<QWidget*> folding() const; // the first goes first
    [[nodiscard]] int widthOfAll() const;
    void fold();

    SceneDocument& document_;
    Playback& playback_;
    QAction *playAction_ = nullptr, *loopAction_ = nullptr;
    QToolButton *playButton_ = nullptr, *loopButton_ = nullptr, *rateButton_ = nullptr;
    std::vector<std::pair<QToolButton*, Icon>> buttons_;
    MotionSpan* span_ = nullptr;
    QLabel* time_ = nullptr;
};

} // namespace views
