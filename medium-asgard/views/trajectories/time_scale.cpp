#include "trajectories/time_scale.h"

#include <algorithm>
#include <cmath>

namespace views {

namespace {

constexpr double leastShown = 1e-5; // of the motion

} // namespace

bool TimeScale::set(double from, double to) {
    const double whole = std::max({finish_ - start_, std::abs(finish_), 1e-9});
    if (!(to - from >= leastShown * whole) || !(to - from <= whole / leastShown))
        return false;
    from_ = from;
    to_ = to;
    return true;
}

void TimeScale::setRange(double start, double finish) {
    start_ = start;
    finish_ = finish;
    if (!zoomed_)
        (void)set(start, finish);
}

bool TimeScale::show(double from, double to) {
    zoomed_ = true;
    return set(from, to);
}

bool TimeScale::zoom(double factor, double about) {
    return show(about + factor * (from_ - about), about + factor * (to_ - about));
}

bool TimeScale::pan(double by) { return show(from_ + by, to_ + by); }

bool TimeScale::showAll(double first, double last) {
    zoomed_ = first < start_ || last > finish_;
    first = std::min(first, start_);
    last = std::max(last, finish_);
    const double room = zoomed_ ? 0.03 * (last - first) : 0;
    return set(first - room, last + room);
}

} // namespace views
