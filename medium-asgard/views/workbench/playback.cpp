#include "workbench/playback.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace views {

Playback::Playback(QObject* parent) : QObject(parent) {
    clock_ = [] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
            .count();
    };
    timer_.setInterval(16);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &Playback::advance);
}

double Playback::stepLength() const {
    const double length = finish_ - start_;
    return std::clamp(0.04, length / 1000, std::max(length / 50, length / 1000));
}

void Playback::anchor() {
    anchorTime_ = time_;
    anchorClock_ = clock_();
}

void Playback::moveTo(double time) {
    const double within = std::clamp(time, start_, std::max(start_, finish_));
    if (within == time_)
        return;
    time_ = within;
    Q_EMIT timeChanged();
}

void Playback::setRange(double start, double finish, double computed) {
    if (start == start_ && finish == finish_ && computed == computed_)
        return;
    start_ = start;
    finish_ = finish;
    computed_ = computed;
    moveTo(time_);
    anchor();
    Q_EMIT stateChanged();
}

void Playback::seek(double time) {
    moveTo(std::min(time, computed_));
    anchor();
}

void Playback::play() {
    if (playing_)
        return;
    if (time_ >= finish_)
        moveTo(start_);
    playing_ = true;
    anchor();
    timer_.start();
    Q_EMIT stateChanged();
}

void Playback::pause() {
    if (!playing_)
        return;
    playing_ = false;
    timer_.stop();
    Q_EMIT stateChanged();
}

void Playback::stop() {
    pause();
    moveTo(start_);
}

void Playback::step(int steps) {
    pause();
    if (!(stepLength() > 0))
        return;
    // Steps land on whole multiples from the start, however one got in between.
    const double at = (time_ - start_) / stepLength();
    const double next = steps > 0 ? std::floor(at + 1e-6) : std::ceil(at - 1e-6);
    moveTo(std::min(start_ + (next + steps) * stepLength(), computed_));
}

void Playback::setRate(double rate) {
    if (rate == rate_ || !(rate > 0))
        return;
    rate_ = rate;
    anchor();
    Q_EMIT stateChanged();
}

void Playback::setLoops(bool loops) {
    if (loops == loops_)
        return;
    loops_ = loops;
    Q_EMIT stateChanged();
}

void Playback::advance() {
    if (!playing_)
        return;
    const double now = anchorTime_ + rate_ * (clock_() - anchorClock_);
    if (now < std::min(computed_, finish_)) {
        moveTo(now);
    } else if (computed_ < finish_) {
        moveTo(computed_);
        anchor(); // waits for more
    } else if (loops_ && finish_ > start_) {
        moveTo(start_ + std::fmod(now - start_, finish_ - start_));
        anchor();
    } else {
        moveTo(finish_);
        pause();
    }
}

} // namespace views
