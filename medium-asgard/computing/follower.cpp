#include "computing/follower.h"

#include "computing/stale_motion.h"
#include "reports/report.h"
#include "script/locate.h"
#include "text/places.h"

#include <algorithm>
#include <utility>

namespace computing {

namespace {

// A motion is shown whole where it takes less; then as far as it is known.
constexpr std::chrono::milliseconds untilPartial{250};
constexpr std::chrono::milliseconds betweenPartial{50};

} // namespace

Follower::Follower(Tools tools, std::function<void()> wake)
    : worker_(std::move(tools), std::move(wake)) {}

void Follower::follow(const std::string& text, const Ask& ask, Instant now) {
    Order order;
    order.parameters = ask.parameters;
    order.moves = ask.asked || live_ == Live::always;
    order.haste = ask.gesture ? Haste::gesture : Haste::now;
    order.overlap = overlap_;
    order.mostBytes = mostBytes_.value_or(order.mostBytes);
    text_ = text;
    patience_ = ask.patience;
    worker_.start(text, std::move(order));
    if (!ask.gesture) {
        welcome_ = worker_.serial();
        awaited_.reset();
        partial_.reset();
    }
    started_ = now;
    readAt_.reset();
    cancelled_ = false;
    work_ = Work::reading;
}

const ScenePointer& Follower::newestScene() const {
    return awaited_ ? awaited_->scene : shown_.scene;
}

std::optional<Instant> Follower::deadline() const {
    std::optional<Instant> due;
    if (awaited_)
        due = awaited_->until;
    if (partial_)
        due = due ? std::min(*due, partial_->due) : partial_->due;
    return due;
}

Changes Follower::update(Instant now) {
    for (News& news : worker_.collect())
        std::visit([&](auto& one) { take(std::move(one), now); }, news);
    showWhatIsDue(now);
    if (changes_.motion)
        shownAt_ = now;
    return std::exchange(changes_, {});
}

// --- what the worker has to say ---------------------------------------------------------------

void Follower::take(Reading reading, Instant now) {
    if (reading.serial < welcome_)
        return;
    if (isLast(reading.serial)) {
        diagnostics_ = std::move(reading.diagnostics);
        readAt_ = now;
        makesScene_ = reading.scene != nullptr;
        work_ = reading.moves ? Work::simulating : Work::none;
        changes_.diagnostics = true;
        changes_.ended = !reading.moves;
    }
    if (!reading.scene)
        return;
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
Instant Follower::dueOf(const Progress& progress, Instant now) const {
    const bool more = progress.scene == shown_.scene && !motionIsStale() && shown_.motion;
    if ((seen_ && (more || !shown_.scene || progress.motion->computed() >= *seen_)))
        return now;
    if (more)
        return shownAt_ + betweenPartial;
    if (awaited_ && awaited_->scene == progress.scene && awaited_->patient)
        return awaited_->until;
    return now + std::max<Clock::duration>(untilPartial - progress.lasted, {});
}

void Follower::take(Progress progress, Instant now) {
    if (progress.serial < welcome_)
        return;
    const Instant due = dueOf(progress, now);
    const bool again = partial_ && partial_->scene == progress.scene;
    partial_ = Partial{std::move(progress.scene), std::move(progress.motion),
                       again ? std::min(partial_->due, due) : due};
}

void Follower::take(Moved moved, Instant /*now*/) {
    if (!moved.result.cancelled)
        lastMotion_ = moved.lasted;
    if (moved.serial < welcome_)
        return;
    if (partial_ && partial_->scene == moved.scene)
        partial_.reset();
    const bool wanted = !moved.result.cancelled || isLast(moved.serial);
    if (moved.scene && wanted)
        showMotion(moved.scene, moved.result.motion);
    if (!isLast(moved.serial))
        return;
    if (moved.result.cancelled) {
        showAwaited(nullptr);
        cancelled_ = true;
    } else {
        statistics_ = moved.result.statistics;
        reportFaults(moved);
    }
    work_ = Work::none;
    changes_.diagnostics = changes_.ended = true;
}

void Follower::reportFaults(const Moved& moved) {
    const text::Places places(text_);
    const auto add = [&](scene::Diagnostic said) {
        script::locate(places, said);
        diagnostics_.push_back(std::move(said));
    };
    for (const std::string& sentence : moved.result.refusal)
        add(simulation::faultOf(*moved.scene, sentence));
    if (moved.result.motion)
        std::ranges::for_each(simulation::reportOf(*moved.scene, *moved.result.motion), add);
}

// --- what is shown ----------------------------------------------------------------------------

void Follower::showWhatIsDue(Instant now) {
    if (partial_ && now >= partial_->due) {
        const Partial partial = *std::exchange(partial_, std::nullopt);
        showMotion(partial.scene, partial.motion);
    }
    if (awaited_ && now >= awaited_->until)
        showAwaited(nullptr);
}

// With its own motion, or with what there is of the motion of the scene before.
void Follower::showAwaited(const simulation::MotionPointer* motion) {
    if (!awaited_)
        return;
    const Awaited next = *std::exchange(awaited_, std::nullopt);
    shownSerial_ = next.serial;
    shownText_ = next.text;
    if (motion)
        return show({next.scene, *motion}, next.scene);
    auto stale = shown_.scene ? staleMotion(*shown_.scene, shown_.motion, next.scene) : nullptr;
    show({next.scene, std::move(stale)}, motionOf_);
}

void Follower::showMotion(const ScenePointer& scene, const simulation::MotionPointer& motion) {
    if (awaited_ && awaited_->scene == scene)
        return showAwaited(&motion);
    if (scene == shown_.scene)
        return show({scene, motion}, scene);
    // While a gesture lasts: of a place where the hand was a moment ago.
    if (auto stale = shown_.scene ? staleMotion(*scene, motion, shown_.scene) : nullptr)
        show({shown_.scene, std::move(stale)}, scene);
}

void Follower::show(Shown shown, ScenePointer motionOf) {
    const bool more = shown.scene == shown_.scene && shown.motion && shown_.motion &&
                      motionOf == shown.scene && motionOf_ == shown.scene;
    changes_.scene = changes_.scene || shown.scene != shown_.scene;
    changes_.motion = true;
    changes_.otherMotion = changes_.otherMotion || !more;
    shown_ = std::move(shown);
    motionOf_ = std::move(motionOf);
}

} // namespace computing
