// When was a component's motion at switches, and do these switches accumulate?
//
// Swings about a switching surface may become ever shorter, by the same factor each time: their
// switches end at a time that is hardly later than now (Zeno's accumulation). Others go to and fro
// between surfaces that meet at one point, by what counts as standing on a surface. Both are told
// here from the times of the switches alone; a motion whose switches have no such pattern and no
// end either must stop.
//
// Times are compared with a part of the time since the start: what goes to and fro by itself,
// however fast, has as many switches in a part of that time as in any other.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace solution {

class SwitchLog {
public:
    // Switches in next to no time that are looked at for an accumulation.
    static constexpr std::size_t often = 10;

    explicit SwitchLog(double start) : start_(start) {}

    // A switch of these surfaces after a step to t. Times do not decrease.
    void add(double t, std::vector<std::size_t> surfaces);
    // One more switch at the same time, without a step before; how many these are now.
    std::size_t addAtOnce() { return ++atOnce_; }
    [[nodiscard]] std::size_t atOnce() const { return atOnce_; }
    // Time has gone on.
    void goOn() { atOnce_ = 0; }
    // The motion came to rest on several surfaces at t; it was put onto one surface at t. Switches
    // before a rest say nothing of those after it.
    void rest(double t) { rests_.push_back(t); }
    void stay(double t) { stays_.push_back(t); }
    // Forgets everything after t: an event.
    void backTo(double t);

    // The last switches were as many and as near that they have no end.
    [[nodiscard]] bool isEndless(double now) const;
    // `times` switches in that part of the time.
    [[nodiscard]] bool hasSwitched(double now, std::size_t times = often,
                                   double part = 1e-10) const;
    // Intervals between switches become shorter by the same factor again and again. Switches before
    // `since`, when the equations changed, do not count.
    [[nodiscard]] bool swingsShrink(double now, double since) const;
    // As long each time, within next to no time.
    [[nodiscard]] bool goesToAndFro(double now, double since) const;
    // The motion was put onto a surface lately, or at just this time.
    [[nodiscard]] bool hasStayedNear(double now) const;
    [[nodiscard]] bool staysAt(double now) const { return !stays_.empty() && stays_.back() == now; }

    // The time of the first of the last `often` switches, and the surfaces of all of these in
    // order, each once.
    [[nodiscard]] double timeOfLast() const { return timeBack(often); }
    [[nodiscard]] std::vector<std::size_t> surfacesOfLast() const;

private:
    // Of the last switch (1), the one before (2), ...
    [[nodiscard]] double timeBack(std::size_t n) const {
        return switches_[switches_.size() - n].time;
    }
    [[nodiscard]] bool isAfterRest(double t, double since) const {
        return t >= since && (rests_.empty() || t > rests_.back());
    }
    [[nodiscard]] bool isEndless(double now, std::size_t times, double part) const;

    struct Switch {
        double time;
        std::vector<std::size_t> surfaces;
    };
    double start_;
    std::size_t atOnce_ = 0;
    std::deque<Switch> switches_;
    std::vector<double> rests_, stays_;
};

} // namespace solution
