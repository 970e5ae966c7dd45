// The time of a viewer, and its moves through time.
//
// Playing follows the real-time clock: however long a picture takes to draw, the time shown is the
// one that the clock says (dissertation 4.1.9). Motion that is not computed yet is waited for.
#pragma once

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

    [[nodiscard]] double start() const { return start_; }
    [[nodiscard]] double finish() const { return finish_; }
    [[nodiscard]] double computed() const { return computed_; }
    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] bool isPlaying() const { return playing_; }
    [[nodiscard]] double rate() const { return rate_; }
    [[nodiscard]] bool loops() const { return loops_; }
    // A step forwards or back: 1/25 s, less in a short motion, more in a long one.
    [[nodiscard]] double stepLength() const;

    // The motion to play. The time is kept, even where motion is not computed yet: an edit computes
    // the motion anew, and one wants to see what became of this very moment.
    void setRange(double start, double finish, double computed);
    void seek(double time);
    void play(); // from the start when at the end
    void pause();
    void stop(); // and back to the start
    void step(int steps);
    void setRate(double rate);
    void setLoops(bool loops);
    void advance(); // to where the clock is; the timer calls it

Q_SIGNALS:
    void timeChanged();
    void stateChanged(); // playing, rate, loops or range

private:
    void moveTo(double time);
    void anchor();

    double start_ = 0, finish_ = 0, computed_ = 0, time_ = 0;
    double rate_ = 1;
    bool playing_ = false, loops_ = false;
    double anchorTime_ = 0, anchorClock_ = 0; // where and when playing began
    Clock clock_;
    QTimer timer_;
};

} // namespace views
