#include "computing/showing.h"

#include "computing/stale_motion.h"

#include <algorithm>
#include <utility>

namespace computing {

namespace {

// A motion is shown whole where it takes less; then as far as it is known.
constexpr std::chrono::milliseconds untilPartial{250};
constexpr std::chrono::milliseconds betweenPartial{50};

} // namespace

void Showing::dropAwaited() {
    awaited_.reset();
    partial_.reset();
}

const ScenePointer& Showing::newestScene() const {
    return awaited_ ? awaited_->scene : shown_.scene;
}

std::optional<Instant> Showing::deadline() const {
    std::optional<Instant> due;
    if (awaited_)
        due = awaited_->until;
    if (partial_)
        due = due ? std::min(*due, partial_->due) : partial_->due;
    return due;
}

Showing::Changes Showing::update(Instant now) {
    if (partial_ && now >= partial_->due) {
        const Partial partial = *std::exchange(partial_, std::nullopt);
        showMotion(partial.scene, partial.motion);
    }
    if (awaited_ && now >= awaited_->until)
        showAwaited(nullptr);
    if (changes_.motion)
        shownAt_ = now;
    return std::exchange(changes_, {});
}

void Showing::take(Reading reading, Instant now) {
    Awaited next{reading.serial, std::move(reading.scene), std::move(reading.text), now,
                 patience_ > quick};
    if (reading.moves)
        next.until = now + (next.patient          ? patience_
                            : lastMotion_ > quick ? std::chrono::milliseconds(0)
                                                  : quick);
    if (awaited_ && !next.patient) // a hand that does not rest sees those in between
        next.until = std::min(next.until, awaited_->until);
    awaited_ = std::move(next);
}

// At once where it is looked at already; else once it has taken a while.
Instant Showing::dueOf(const Progress& progress, Instant now) const {
    const bool more = progress.scene == shown_.scene && !isStale() && shown_.motion;
    if ((seen_ && (more || !shown_.scene || progress.motion->computed() >= *seen_)))
        return now;
    if (more)
        return shownAt_ + betweenPartial;
    if (awaited_ && awaited_->scene == progress.scene && awaited_->patient)
        return awaited_->until;
    return now + std::max<Clock::duration>(untilPartial - progress.lasted, {});
}

void Showing::take(Progress progress, Instant now) {
    const Instant due = dueOf(progress, now);
    const bool again = partial_ && partial_->scene == progress.scene;
    partial_ = Partial{std::move(progress.scene), std::move(progress.motion),
                       again ? std::min(partial_->due, due) : due};
}

void Showing::take(const Moved& moved, bool wanted) {
    if (partial_ && partial_->scene == moved.scene)
        partial_.reset();
    if (moved.scene && wanted)
        showMotion(moved.scene, moved.result.motion);
}

// With its own motion, or with what there is of the motion of the scene before.
void Showing::showAwaited(const simulation::MotionPointer* motion) {
    if (!awaited_)
        return;
    const Awaited next = *std::exchange(awaited_, std::nullopt);
    serial_ = next.serial;
    text_ = next.text;
    if (motion)
        return show({next.scene, *motion}, next.scene);
    auto stale = shown_.scene ? staleMotion(*shown_.scene, shown_.motion, next.scene) : nullptr;
    show({next.scene, std::move(stale)}, motionOf_);
}

void Showing::showMotion(const ScenePointer& scene, const simulation::MotionPointer& motion) {
    if (awaited_ && awaited_->scene == scene)
        return showAwaited(&motion);
    if (scene == shown_.scene)
        return show({scene, motion}, scene);
    // While a gesture lasts: of a place where the hand was a moment ago.
    if (auto stale = shown_.scene ? staleMotion(*scene, motion, shown_.scene) : nullptr)
        show({shown_.scene, std::move(stale)}, scene);
}

void Showing::show(Shown shown, ScenePointer motionOf) {
    const bool more = shown.scene == shown_.scene && shown.motion && shown_.motion &&
                      motionOf == shown.scene && motionOf_ == shown.scene;
    changes_.scene = changes_.scene || shown.scene != shown_.scene;
    changes_.motion = true;
    changes_.otherMotion = changes_.otherMotion || !more;
    shown_ = std::move(shown);
    motionOf_ = std::move(motionOf);
}

} // namespace computing
