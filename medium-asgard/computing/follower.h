// Follows a text: the scene that it makes, and the motion of that.
//
// A text that is faulty leaves the last good scene in force, with its motion. Reading and computing
// take time; until both are done, a picture shows one of three things:
//   - for a moment (Ask::patience) the scene and motion of before, which belong together;
//   - then the new scene with the motion of before (stale_motion.h), where both have the same
//     bodies: what is dragged follows the hand;
//   - the new scene with as much of its motion as there is, once that reaches the time that is
//     looked at (setSeen()), or after a while.
// The motion of before stays while motion is computed only when it is asked for (setLive()).
//
// The owner is woken when there is something to do, and when deadline() has come; then update()
// does it and says what changed. Nothing here reads a clock but for how long a motion took.
#pragma once

#include "computing/showing.h"

namespace computing {

enum class Work { none, reading, simulating };

// Whether an edit's motion is computed without being asked for.
enum class Live { always, never };

struct Ask {
    ParameterValues parameters = {};
    bool asked = false;   // the motion is wanted, however long it takes
    bool gesture = false; // more texts follow soon, and each that is done is worth showing
    std::chrono::milliseconds patience = quick; // with the scene and motion of before
};

struct Changes : Showing::Changes { // of other motion: pictures of the same time may differ
    bool diagnostics = false;       // the set is complete for the text
    bool ended = false;             // nothing is being read or computed any more
};

class Follower {
public:
    // `wake` is called on any thread when update() has something to do.
    Follower(Tools tools, std::function<void()> wake);

    void follow(const std::string& text, const Ask& ask, Instant now);
    // Ends soon, with the motion that there is. The next edit's is computed as ever.
    void cancel() { worker_.cancel(); }
    Changes update(Instant now);
    [[nodiscard]] std::optional<Instant> deadline() const { return showing_.deadline(); }

    // The time that is looked at, if it is one: a motion that has got there is shown at once.
    void setSeen(double time) { showing_.setSeen(time); }
    [[nodiscard]] Live live() const { return live_; }
    void setLive(Live live) { live_ = live; }
    // In a gesture the motion of an older text may go on for so long (Worker).
    void setOverlap(std::chrono::milliseconds overlap) { overlap_ = overlap; }
    void setMostBytes(std::size_t most) { mostBytes_ = most; } // of a motion; else Order's

    [[nodiscard]] const Shown& shown() const { return showing_.shown(); }
    // That the shown scene was read from.
    [[nodiscard]] const std::string& shownText() const { return showing_.text(); }
    // Of the newest text that makes a scene, shown or not yet.
    [[nodiscard]] const ScenePointer& newestScene() const { return showing_.newestScene(); }
    // Faults of the text and, once it has ended, of its motion.
    [[nodiscard]] const std::vector<scene::Diagnostic>& diagnostics() const { return diagnostics_; }
    [[nodiscard]] const std::optional<simulation::Statistics>& statistics() const {
        return statistics_; // of the last motion that ended
    }
    [[nodiscard]] Work work() const { return work_; }
    // The scene that is shown was read from the newest text.
    [[nodiscard]] bool isCurrent() const { return showing_.serial() == worker_.serial(); }
    [[nodiscard]] bool isFaulty() const { return readAt_ && !makesScene_; } // the newest text
    // The motion that is shown is an older scene's.
    [[nodiscard]] bool motionIsStale() const { return showing_.isStale(); }
    // It stays so until the motion is asked for.
    [[nodiscard]] bool waitsToBeAsked() const { return motionIsStale() && work_ == Work::none; }
    [[nodiscard]] bool isCancelled() const { return cancelled_; } // the newest motion, by cancel()
    [[nodiscard]] Instant startedAt() const { return started_; }
    // When reading the newest text had ended; none: it goes on.
    [[nodiscard]] std::optional<Instant> readAt() const { return readAt_; }

private:
    void take(Reading reading, Instant now);
    void take(Progress progress, Instant now);
    void take(const Moved& moved, Instant now);
    [[nodiscard]] bool isLast(unsigned serial) const { return serial == worker_.serial(); }
    void reportFaults(const Moved& moved);

    Worker worker_;
    Showing showing_;
    std::string text_;
    std::vector<scene::Diagnostic> diagnostics_;
    std::optional<simulation::Statistics> statistics_;
    Work work_ = Work::none;
    Live live_ = Live::always;
    std::chrono::milliseconds overlap_{300};
    std::optional<std::size_t> mostBytes_;
    bool makesScene_ = false, cancelled_ = false;
    unsigned welcome_ = 0; // results of older starts are of no use
    Instant started_{};
    std::optional<Instant> readAt_;
    Changes changes_; // since the last update()
};

} // namespace computing
