// Do events follow each other without end?
//
// A body that bounces between walls that close in, a contact that opens and closes, an event that
// leads to the next at the same instant: each is one more of a sequence of events, told in order of
// time. How many of them are too many, and within which time, is a law of their kind.
//
//     converges     so many within so little of the time since the start: the sequence accumulates
//     no progress   many, each so soon after the one before that time does not go on
//     too long      more than there may be at all
//
// Laws scale with the time since the start, so that no unit of time is better than another.
#pragma once

#include <cstddef>
#include <limits>

namespace solution {

struct AccumulationLaw {
    static constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
    std::size_t many = any;  // events
    double within = 0;       // of the time since the start
    std::size_t close = any; // events that follow each other closely; more have no end
    double pause = 0;        // of the time since the start; 0: at one instant
    std::size_t most = any;  // events at all
};

class AccumulationMonitor {
public:
    enum class Verdict { goesOn, converges, noProgress, tooLong };

    // One more event, so long after the start. Its law may differ from that of the event before.
    Verdict add(double elapsed, const AccumulationLaw& law) {
        close_ = elapsed - last_ <= law.pause * elapsed ? close_ + 1 : 1;
        last_ = elapsed;
        if (++count_ >= law.most)
            return Verdict::tooLong;
        if (isAtMark(law)) {
            const double since = markedAt_;
            markedAt_ = elapsed;
            if (elapsed - since < law.within * elapsed)
                return Verdict::converges;
        }
        return close_ > law.close ? Verdict::noProgress : Verdict::goesOn;
    }
    // The last event was the last of so many: the next are counted anew.
    [[nodiscard]] bool isAtMark(const AccumulationLaw& law) const { return count_ % law.many == 0; }
    [[nodiscard]] std::size_t count() const { return count_; }
    // Events at this time, which is that of the last one or later.
    [[nodiscard]] std::size_t closeAt(double elapsed) const {
        return elapsed == last_ ? close_ : 0;
    }

private:
    static constexpr double never = -std::numeric_limits<double>::infinity();
    std::size_t count_ = 0, close_ = 0;
    double last_ = never, markedAt_ = never;
};

} // namespace solution
