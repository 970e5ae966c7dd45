// Which scene and motion a picture shows until those of a newer text are there: the three things
// that follower.h names, and when one gives way to the next.
#pragma once

#include "computing/worker.h"

namespace computing {

using Instant = Clock::time_point;

struct Shown {
    ScenePointer scene;               // none: no text has made one yet
    simulation::MotionPointer motion; // none: nothing of it is known, or it cannot be computed
};

// How long a quick motion is waited for before its scene is shown without it.
constexpr std::chrono::milliseconds quick{30};

class Showing {
public:
    struct Changes {
        bool scene = false;       // another scene is shown
        bool motion = false;      // another motion, or more of it
        bool otherMotion = false; // not only more of it
    };

    void setSeen(double time) { seen_ = time; }
    // A motion that waits to be shown is of no use any more.
    void dropAwaited();
    // For so long at most the scene and motion of before are shown, which belong together.
    void setPatience(std::chrono::milliseconds patience) { patience_ = patience; }
    void take(Reading reading, Instant now);
    void take(Progress progress, Instant now);
    // The motion has ended; `wanted`: it counts.
    void take(const Moved& moved, bool wanted);
    void computingTook(Clock::duration duration) { lastMotion_ = duration; }
    // The scene that is awaited is shown now, without its motion.
    void showAwaited() { showAwaited(nullptr); }
    // Shows what is due; what has changed since the last call.
    [[nodiscard]] Changes update(Instant now);
    [[nodiscard]] std::optional<Instant> deadline() const;

    [[nodiscard]] const Shown& shown() const { return shown_; }
    [[nodiscard]] const std::string& text() const { return text_; } // that its scene was read from
    [[nodiscard]] unsigned serial() const { return serial_; }
    [[nodiscard]] const ScenePointer& newestScene() const;
    // The motion is an older scene's.
    [[nodiscard]] bool isStale() const { return motionOf_ != shown_.scene; }

private:
    struct Awaited { // read, and not shown yet
        unsigned serial = 0;
        ScenePointer scene;
        std::string text;
        Instant until{}; // then it is shown, whether its motion is there or not
        bool patient = false;
    };
    struct Partial { // of a motion that goes on
        ScenePointer scene;
        simulation::MotionPointer motion;
        Instant due{};
    };
    [[nodiscard]] Instant dueOf(const Progress& progress, Instant now) const;
    void showAwaited(const simulation::MotionPointer* motion);
    void showMotion(const ScenePointer& scene, const simulation::MotionPointer& motion);
    void show(Shown shown, ScenePointer motionOf);

    Shown shown_;
    std::string text_;
    unsigned serial_ = 0;   // of the start that the shown scene is of; 0: no text yet
    ScenePointer motionOf_; // that the shown motion belongs to
    std::optional<Awaited> awaited_;
    std::optional<Partial> partial_;
    std::optional<double> seen_;
    std::chrono::milliseconds patience_ = quick;
    Clock::duration lastMotion_{}; // how long computing it took
    Instant shownAt_{};
    Changes changes_; // since the last update()
};

} // namespace computing
