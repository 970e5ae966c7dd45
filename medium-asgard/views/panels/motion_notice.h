// What the picture says of its motion, at its lower edge: that it is computed, how far and for how
// long, that it is an older scene's, that computing was stopped, and why it ends before its time.
#pragma once

#include "workbench/playback.h"
#include "workbench/scene_document.h"

#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>

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

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Said {
        QString words;
        bool isFault = false, mayStop = false, mayCompute = false;
    };
    [[nodiscard]] Said said() const;
    [[nodiscard]] QString progress() const;
    [[nodiscard]] QString unread() const;
    void follow();
    void show(const Said& said);
    void place();

    SceneDocument& document_;
    Playback& playback_;
    QLabel* words_;
    QToolButton *stop_, *compute_;
    QTimer tick_;
    QElapsedTimer worksSince_, staleSince_; // invalid: it does not, it is not
};

} // namespace views
