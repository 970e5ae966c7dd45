// A body in the hand while the motion is past its start (gestures/throw.h), in a viewer: while the
// motion plays the body is thrown. Where several are selected and none of them is held to what
// stands, all go by one way; one alone is thrown.
#pragma once

#include "gestures/throw.h"

#include <QObject>
#include <QPointF>

#include <optional>
#include <vector>

class QMouseEvent;
class QPainter;

namespace views {

class SceneDisplay;
class SceneDocument;

class Throwing : public QObject {
    Q_OBJECT
public:
    Throwing(SceneDocument& document, SceneDisplay& display);

    // Why a drag from there may not take the body out of its way at this moment; "": it may. None:
    // a drag does not mean that; it is the start, where one changes initial values, or nothing can
    // be changed.
    [[nodiscard]] std::optional<QString> whyNot(std::size_t body, const QPointF& position) const;
    // False: a drag does not mean that. The picture says why it may not.
    bool press(std::size_t body, const QPointF& position);
    // While the motion plays any body is taken that nothing holds, selected or not.
    void setPlays(bool plays) { plays_ = plays; }
    [[nodiscard]] bool plays() const { return plays_; }
    [[nodiscard]] bool takesAtOnce(std::size_t body, const QPointF& position) const;
    bool move(const QMouseEvent& event);    // false: nothing is held
    bool release(const QMouseEvent& event); // false: nothing is held
    bool cancel();                          // false: nothing is held
    [[nodiscard]] bool active() const { return held_.has_value(); }
    // Seconds of the motion for each of the hand; none: it is put where it is let go, and keeps its
    // velocity. For what is held now.
    void setRate(std::optional<double> rate) { rate_ = rate; }
    [[nodiscard]] QString words() const;
    void paint(QPainter& painter) const;

Q_SIGNALS:
    void changed();
    void grabbed();
    void letGo(bool isChanged); // the text has the moment as its start

private:
    [[nodiscard]] gestures::Throw::Poses companyOf(std::size_t body, const QPointF& position) const;
    [[nodiscard]] std::unique_ptr<gestures::Joined> joinedAt(std::size_t body,
                                                             const QPointF& position) const;
    [[nodiscard]] const std::string& whyHeld(std::size_t body, const QPointF& position) const;
    void paintBody(QPainter& painter, std::size_t body, const geometry::Pose& pose) const;
    [[nodiscard]] double moment() const;

    SceneDocument& document_;
    SceneDisplay& display_;
    std::optional<gestures::Throw> held_;
    std::optional<double> rate_;
    bool plays_ = false;
    struct Asked { // of joints; while it plays the answer of a moment before counts
        simulation::MotionPointer motion;
        std::size_t body;
        double moment;
        QPointF position;
        std::string why;
    };
    mutable std::optional<Asked> asked_;
};

} // namespace views
