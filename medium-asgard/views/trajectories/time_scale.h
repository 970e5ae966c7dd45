// The part of a motion's time that a scale shows, from its left end to its right one.
//
// At first it is all of the motion. Zooming and panning leave that; nothing shorter or longer is
// shown than numbers can tell apart.
#pragma once

namespace views {

class TimeScale {
public:
    // Of the motion; what is seen follows, until somebody zooms.
    void setRange(double start, double finish);
    // False: too short, or too long, and it stays as it was.
    bool show(double from, double to);
    bool zoom(double factor, double about); // about a time
    bool pan(double by);
    // All of the motion and that span; with room at both ends where the span reaches beyond.
    bool showAll(double first, double last);

    [[nodiscard]] double from() const { return from_; }
    [[nodiscard]] double to() const { return to_; }
    [[nodiscard]] double length() const { return to_ - from_; }
    [[nodiscard]] double middle() const { return (from_ + to_) / 2; }
    [[nodiscard]] double start() const { return start_; } // of the motion
    [[nodiscard]] double finish() const { return finish_; }
    [[nodiscard]] bool shows(double time) const { return from_ <= time && time <= to_; }
    // How far along the scale, 0 to 1 for what is seen; and back.
    [[nodiscard]] double along(double time) const { return (time - from_) / length(); }
    [[nodiscard]] double timeAt(double along) const { return from_ + along * length(); }

private:
    [[nodiscard]] bool set(double from, double to);

    double start_ = 0, finish_ = 1, from_ = 0, to_ = 1;
    bool zoomed_ = false;
};

} // namespace views
