// The time that a picture of a motion shows now.
//
// Time follows the real-time clock (dissertation 4.1.9): shown = anchor + rate * (now - anchored).
// It never runs past what is computed: there it waits, and goes on from there. At the finish it
// stops, or starts again when it loops. Nothing here reads a clock: `now` is given.
#pragma once

#include <chrono>
#include <optional>

namespace playing {

using Clock = std::chrono::steady_clock;
using Instant = Clock::time_point;

struct Span {
    double start = 0, finish = 0, computed = 0; // start <= computed <= finish
    bool operator==(const Span&) const = default;
};

class Playback {
public:
    // A motion of another extent or one that got further. Time stays where it is, if it can.
    void setSpan(const Span& span, Instant now);
    [[nodiscard]] const Span& span() const { return span_; }

    // Within start..computed.
    [[nodiscard]] double time(Instant now) const;
    // Within start..finish: the time that is shown as soon as the motion has got there.
    [[nodiscard]] double sought(Instant now) const;
    [[nodiscard]] bool playing() const { return playing_; }
    [[nodiscard]] double rate() const { return rate_; }
    [[nodiscard]] bool loops() const { return loops_; }

    // From the start again when it stands at the finish; as soon as there is a motion when there is
    // none yet.
    void play(Instant now);
    void pause(Instant now);
    // Clamped to start..finish as soon as these are known; waits there for the motion.
    void seek(double time, Instant now);
    void setRate(double rate, bool loops, Instant now);
    void stop(Instant now); // and back to the start
    // 1/25 s, less in a short motion, more in a long one.
    [[nodiscard]] double stepLength() const;
    // Pauses, and goes on by so many steps; at most to the end of what is computed. Steps land on
    // whole multiples from the start, however one got in between.
    void step(int steps, Instant now);

    // Waits, stops or starts again where that is due. True when `playing` changed.
    bool advance(Instant now);

private:
    [[nodiscard]] double wanted(Instant now) const; // without the limit of what is computed
    void anchor(double time, Instant now);

    Span span_;
    bool known_ = false;           // the span has been set
    std::optional<double> sought_; // before that, until the motion has got there
    bool playing_ = false, loops_ = false;
    double rate_ = 1;
    double time_ = 0;
    Instant since_{};
};

} // namespace playing
