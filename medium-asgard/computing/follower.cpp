#include "computing/follower.h"

#include "reports/report.h"
#include "script/locate.h"
#include "text/places.h"

#include <algorithm>
#include <utility>

namespace computing {

Follower::Follower(Tools tools, std::function<void()> wake)
    : worker_(std::move(tools), std::move(wake)) {}

void Follower::follow(const std::string& text, const Ask& ask, Instant now) {
    Order order;
    order.parameters = ask.parameters;
    order.moves = ask.asked || live_ == Live::always;
    order.anew = ask.asked;
    order.haste = ask.gesture ? Haste::gesture : Haste::now;
    order.overlap = overlap_;
    order.mostBytes = mostBytes_.value_or(order.mostBytes);
    text_ = text;
    showing_.setPatience(ask.patience);
    worker_.start(text, std::move(order));
    if (!ask.gesture) {
        welcome_ = worker_.serial();
        showing_.dropAwaited();
    }
    started_ = now;
    readAt_.reset();
    cancelled_ = false;
    work_ = Work::reading;
}

Changes Follower::update(Instant now) {
    for (News& news : worker_.collect())
        std::visit([&](auto& one) { take(std::move(one), now); }, news);
    static_cast<Showing::Changes&>(changes_) = showing_.update(now);
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
    if (reading.scene)
        showing_.take(std::move(reading), now);
}

void Follower::take(Progress progress, Instant now) {
    if (progress.serial >= welcome_)
        showing_.take(std::move(progress), now);
}

void Follower::take(const Moved& moved, Instant /*now*/) {
    if (!moved.result.cancelled)
        showing_.computingTook(moved.lasted);
    if (moved.serial < welcome_)
        return;
    showing_.take(moved, !moved.result.cancelled || isLast(moved.serial));
    if (!isLast(moved.serial))
        return;
    if (moved.result.cancelled) {
        showing_.showAwaited();
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

} // namespace computing
