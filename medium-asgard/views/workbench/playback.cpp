#include "workbench/playback.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace views {

Playback::Playback(QObject* parent) : QObject(parent) {
    clock_ = [] {
        return std::chrono::duration<double>(playing::Clock::now().time_since_epoch()).count();
    };
    timer_.setInterval(16);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &Playback::advance);
}

playing::Instant Playback::now() const {
    return playing::Instant(
        std::chrono::round<playing::Clock::duration>(std::chrono::duration<double>(clock_())));
}

void Playback::follow(bool other) {
    const playing::Instant moment = now();
    core_.advance(moment);
    if (isPlaying() && !timer_.isActive())
        timer_.start();
    else if (!isPlaying())
        timer_.stop();
    if (std::exchange(time_, core_.sought(moment)) != time_)
        Q_EMIT timeChanged();
    const bool isAnother = std::exchange(wasPlaying_, isPlaying()) != isPlaying();
    if (isAnother || other)
        Q_EMIT stateChanged();
    if (isAnother && isPlaying())
        Q_EMIT started();
}

void Playback::setRange(double start, double finish, double computed) {
    const playing::Span span{start, finish, computed};
    if (span == core_.span())
        return;
    core_.setSpan(span, now());
    follow(true);
}

void Playback::seek(double time) {
    core_.seek(std::min(time, computed()), now());
    follow();
}

void Playback::play() {
    isHeld_ = false;
    core_.play(now());
    follow();
}

void Playback::pause() {
    isHeld_ = false;
    core_.pause(now());
    follow();
}

void Playback::stop() {
    isHeld_ = false;
    core_.stop(now());
    follow();
}

void Playback::hold() {
    const bool played = isPlaying();
    pause();
    isHeld_ = played;
}

void Playback::goOn() {
    if (isHeld_)
        play();
}

void Playback::step(int steps) {
    core_.step(steps, now());
    follow();
}

void Playback::setRate(double rate) {
    if (rate == core_.rate() || !(rate > 0))
        return;
    core_.setRate(rate, loops(), now());
    follow(true);
}

void Playback::setLoops(bool loops) {
    if (loops == core_.loops())
        return;
    core_.setRate(rate(), loops, now());
    follow(true);
}

void Playback::advance() { follow(); }

} // namespace views
