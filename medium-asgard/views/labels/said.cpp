#include "labels/said.h"

#include <utility>

namespace views {

namespace {

using std::chrono::milliseconds;

constexpr int steps = 12;
constexpr milliseconds step{40};

double pace = 1;

} // namespace

Said::Said() {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &Said::fade);
}

void Said::setPace(double factor) { pace = factor; }

// Seeing that something is there takes a while, and then a sign so long.
milliseconds Said::readingTime(const QString& sentence) {
    constexpr milliseconds noticing{4000}, sign{70};
    return noticing + sentence.size() * sign;
}

double Said::opacity() const { return static_cast<double>(left_) / steps; }

void Said::say(const QString& sentence, bool isFault) {
    timer_.stop();
    const bool isPale = std::exchange(left_, steps) < steps && !text_.isEmpty();
    if (!sentence.isEmpty())
        timer_.start(std::chrono::duration_cast<milliseconds>(pace * readingTime(sentence)));
    if (sentence == text_ && isFault == isFault_ && !isPale)
        return;
    text_ = sentence;
    isFault_ = isFault;
    Q_EMIT changed();
}

void Said::fade() {
    if (--left_ > 0)
        timer_.start(std::chrono::duration_cast<milliseconds>(std::min(pace, 1.0) * step));
    else
        text_.clear();
    Q_EMIT changed();
}

} // namespace views
