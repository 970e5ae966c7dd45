// May a medium that ended be started again by itself?
// A few times in a minute and in an hour: what ends again and again is said, and waits for a click.
#pragma once

#include <QString>
#include <vector>

namespace media {

class Restarts {
public:
    Restarts(int perMinute, int perHour) : perMinute_(perMinute), perHour_(perHour) {}

    // Counts this one when it may. `now` in ms of a clock that only runs forward.
    [[nodiscard]] bool mayTry(qint64 now);
    void forget() { times_.clear(); } // after a click
    // "It was started again 3 times within a minute." Nothing when it never was.
    [[nodiscard]] QString told(qint64 now) const;

private:
    [[nodiscard]] int since(qint64 time) const;

    int perMinute_, perHour_;
    std::vector<qint64> times_;
};

} // namespace media
