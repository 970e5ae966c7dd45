#include "playing/playback.h"

#include <algorithm>
#include <cmath>

namespace playing {

double Playback::wanted(Instant now) const {
    if (!playing_)
        return time_;
    return time_ + rate_ * std::chrono::duration<double>(now - since_).count();
}

double Playback::time(Instant now) const {
    return std::clamp(wanted(now), span_.start, std::max(span_.start, span_.computed));
}

double Playback::sought(Instant now) const {
    return std::clamp(wanted(now), span_.start, std::max(span_.start, span_.finish));
}

void Playback::anchor(double time, Instant now) {
    time_ = time;
    since_ = now;
}

void Playback::setSpan(const Span& span, Instant now) {
    anchor(known_ ? wanted(now) : sought_.value_or(span.start), now);
    if (sought_ && (span.computed >= *sought_ || span.computed >= span.finish))
        sought_.reset();
    known_ = true;
    span_ = span;
    time_ = std::clamp(time_, span.start, std::max(span.start, span.finish));
    playing_ = playing_ && span.finish > span.start;
}

void Playback::play(Instant now) {
    if (playing_ || (known_ && span_.finish <= span_.start))
        return;
    if (!known_) {
        playing_ = true;
        return;
    }
    anchor(time_ >= span_.finish ? span_.start : time_, now);
    playing_ = true;
}

void Playback::pause(Instant now) {
    if (!playing_)
        return;
    if (!known_) {
        playing_ = false;
        return;
    }
    sought_.reset();
    anchor(time(now), now);
    playing_ = false;
}

void Playback::seek(double time, Instant now) {
    sought_.reset();
    if (!known_) {
        sought_ = time;
        return;
    }
    anchor(std::clamp(time, span_.start, std::max(span_.start, span_.finish)), now);
}

void Playback::setRate(double rate, bool loops, Instant now) {
    anchor(wanted(now), now);
    rate_ = rate;
    loops_ = loops;
}

void Playback::stop(Instant now) {
    pause(now);
    seek(span_.start, now);
}

double Playback::stepLength() const {
    const double length = span_.finish - span_.start;
    return std::clamp(0.04, length / 1000, std::max(length / 50, length / 1000));
}

void Playback::step(int steps, Instant now) {
    pause(now);
    if (!(stepLength() > 0))
        return;
    const double at = (sought(now) - span_.start) / stepLength();
    const double next = steps > 0 ? std::floor(at + 1e-6) : std::ceil(at - 1e-6);
    seek(std::min(span_.start + (next + steps) * stepLength(), span_.computed), now);
}

bool Playback::advance(Instant now) {
    if (!playing_ || !known_)
        return false;
    const double at = wanted(now);
    if (at < span_.computed)
        return false;
    if (span_.computed < span_.finish) { // wait for the motion
        anchor(std::max(span_.computed, sought_.value_or(span_.computed)), now);
        return false;
    }
    if (loops_) {
        anchor(span_.start + std::fmod(at - span_.finish, span_.finish - span_.start), now);
        return false;
    }
    anchor(span_.finish, now);
    playing_ = false;
    return true;
}

} // namespace playing
