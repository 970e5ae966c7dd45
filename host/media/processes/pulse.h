// Does a process begin, answer and end in time?
//
//   begins -> is pinged -> is asked to end
//
// Without an answer to a ping for `quiet` it does not respond, without one for `hung` it is to be
// ended. Its owner asks every interval() what is due.
#pragma once

#include <QElapsedTimer>
#include <QString>

namespace media {

// In ms; tests make them shorter.
struct TimeLimits {
    int initialize = 10'000;
    int quiet = 2'000;
    int hung = 10'000;
    int shutdown = 2'000;
    int pingEvery = 1'000;
    int restartsPerMinute = 3; // by itself
    int restartsPerHour = 10;
};

class Pulse {
public:
    explicit Pulse(TimeLimits limits) : limits_(limits) {}

    void begin();      // it was started
    void introduced(); // from now on it is pinged
    void pinged() { sincePing_.start(); }
    // True when it has not responded before.
    [[nodiscard]] bool answered();
    void askedToEnd();

    struct Due {
        enum class What { nothing, ping, sayThatItIsQuiet, end };
        What what = What::nothing;
        QString why{}; // of an end: "did not respond for 10 s"
    };
    // LIMIT: a process that is being debugged by its author is ended like one that hangs.
    [[nodiscard]] Due due();
    [[nodiscard]] int interval() const; // ms
    [[nodiscard]] bool isResponding() const { return responding_; }

private:
    [[nodiscard]] Due dueOfPing();

    TimeLimits limits_;
    enum class Phase { beginning, pinged, ending } phase_ = Phase::beginning;
    QElapsedTimer since_;     // the phase, or the last answer to a ping
    QElapsedTimer sincePing_; // valid while a ping is unanswered
    bool responding_ = true;
};

} // namespace media
