// What the picture says of its motion, at its lower edge: that it is computed, how far and for how
// long, that it is an older scene's, that computing was stopped, why it ends before its time, and
// that bodies fall through the grid, which a click gives a floor.
#pragma once

#include "workbench/playback.h"
#include "workbench/scene_document.h"

#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>

#include <memory>
#include <utility>
#include <vector>

class QLabel;
class QToolButton;

namespace views {

class MotionNotice : public QFrame {
    Q_OBJECT
public:
    // Over the picture, in front of whatever it paints.
    MotionNotice(SceneDocument& document, Playback& playback, QWidget& picture);

    [[nodiscard]] QString words() const;

Q_SIGNALS:
    void stopWanted();
    void floorWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Said {
        QString words;
        bool isFault = false, mayStop = false, mayCompute = false, mayFloor = false;
    };
    [[nodiscard]] Said said();
    [[nodiscard]] Said saidOfMotion() const;
    [[nodiscard]] Said saidOfFalls();
    [[nodiscard]] QString progress() const;
    [[nodiscard]] QString unread() const;
    void follow();
    void show(const Said& said);
    void place();

    SceneDocument& document_;
    Playback& playback_;
    QLabel* words_;
    QToolButton *stop_, *compute_, *floor_;
    QTimer tick_;
    QElapsedTimer worksSince_, staleSince_; // invalid: it does not, it is not
    // Of that scene, the bodies that fall through the grid.
    std::pair<std::shared_ptr<const scene::Scene>, std::vector<std::size_t>> falls_;
};

} // namespace views
