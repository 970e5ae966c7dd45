// The time of a viewer, and its moves through time: playing/ with a clock and signals.
//
// However long a picture takes to draw, the time shown is the one that the clock says
// (dissertation 4.1.9). Motion that is not computed yet is waited for.
#pragma once

#include "playing/playback.h"

#include <QObject>
#include <QTimer>

#include <functional>

namespace views {

class Playback : public QObject {
    Q_OBJECT
public:
    using Clock = std::function<double()>; // seconds since any fixed moment

    explicit Playback(QObject* parent = nullptr);
    void setClock(Clock clock) { clock_ = std::move(clock); }

    [[nodiscard]] double start() const { return core_.span().start; }
    [[nodiscard]] double finish() const { return core_.span().finish; }
    [[nodiscard]] double computed() const { return core_.span().computed; }
    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] bool isPlaying() const { return core_.playing(); }
    [[nodiscard]] double rate() const { return core_.rate(); }
    [[nodiscard]] bool loops() const { return core_.loops(); }
    [[nodiscard]] double stepLength() const { return core_.stepLength(); }

    // The motion to play. The time is kept, even where motion is not computed yet: an edit computes
    // the motion anew, and one wants to see what became of this very moment.
    void setRange(double start, double finish, double computed);
    void seek(double time);
    void play(); // from the start when at the end
    void pause();
    void stop(); // and back to the start
    // While a body is in the hand the time stands still; a motion that played goes on then, unless
    // it was played, paused or stopped meanwhile.
    void hold();
    void goOn();
    void step(int steps);
    void setRate(double rate);
    void setLoops(bool loops);
    void advance(); // to where the clock is; the timer calls it

Q_SIGNALS:
    void timeChanged();
    void stateChanged(); // playing, rate, loops or range
    void started();      // to play

private:
    [[nodiscard]] playing::Instant now() const;
    void follow(bool other = false); // `other`: the state is

    playing::Playback core_;
    double time_ = 0;
    bool wasPlaying_ = false;
    bool isHeld_ = false; // it played
    Clock clock_;
    QTimer timer_;
};

} // namespace views
