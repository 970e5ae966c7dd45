// What the picture says of its motion, at its lower edge: that it is computed, how far and for how
// long, that it is an older scene's, that computing was stopped, and why it ends before its time. A
// click moves bodies apart that overlap, gives a floor to bodies that fall through the grid, and
// gravity where nothing falls.
#pragma once

#include "workbench/playback.h"
#include "workbench/scene_document.h"

#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QAbstractButton;
class QLabel;

namespace views {

class MotionNotice : public QFrame {
    Q_OBJECT
public:
    // Over the picture, in front of whatever it paints.
    MotionNotice(SceneDocument& document, Playback& playback, QWidget& picture);

    [[nodiscard]] QString words() const;
    // The moment has become the start, by a throw: said until the text changes.
    void tellNewStart();

Q_SIGNALS:
    void stopWanted();
    void floorWanted();
    void gravityWanted();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Offer { none, stop, compute, floor, gravity, part, undo };
    struct Said {
        QString words;
        bool isFault = false;
        Offer offer = Offer::none;
        bool operator==(const Said&) const = default;
    };
    struct Button {
        Offer offer;
        QAbstractButton* widget;
    };
    void makeButton(Offer offer, const QString& name, const QString& words, const QString& tip);
    [[nodiscard]] QAbstractButton* buttonOf(Offer offer) const; // none has none
    void take(Offer offer);
    [[nodiscard]] Said said();
    [[nodiscard]] Said saidOfMotion() const;
    [[nodiscard]] Said saidOfStart() const;
    [[nodiscard]] Said saidOfNewStart() const;
    [[nodiscard]] Said saidOfForces();
    [[nodiscard]] QString progress() const;
    [[nodiscard]] QString unread() const;
    void follow();
    void show(const Said& said);
    void place();

    SceneDocument& document_;
    Playback& playback_;
    QLabel* words_;
    std::vector<Button> buttons_;
    Said shown_;
    std::optional<int> newStart_; // the text's revision that has it
    QTimer tick_;
    QElapsedTimer worksSince_, staleSince_; // invalid: it does not, it is not
    struct Falls {
        Shown of;
        bool lacksWeight = false;
        std::vector<std::size_t> bodies; // that fall through the grid
    };
    Falls falls_;
};

} // namespace views
