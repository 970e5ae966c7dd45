#include "stepping/boundary.h"

#include <algorithm>

namespace solution {

namespace {

constexpr std::size_t mostJoints = 8; // of an input, that a step crosses

} // namespace

void Boundary::setPhases(double from, double until) {
    phasesFrom_ = from;
    phasesUntil_ = until;
}

std::optional<std::size_t> Boundary::find(const Histories& histories,
                                          std::span<const std::size_t> inputs, const Wish& wish) {
    limit_ = phasesUntil_;
    restarts_ = false;
    ends_.reset();
    lookedAt_.resize(inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (const auto waiting = look(histories, inputs[i], wish, lookedAt_[i]))
            return waiting;
    return std::nullopt;
}

void Boundary::mayEndAt(double t, bool restarts) {
    if (t < limit_ || (t == limit_ && restarts)) {
        limit_ = t;
        restarts_ = restarts;
        ends_.reset();
    }
}

std::optional<std::size_t> Boundary::look(const Histories& histories, std::size_t unknown,
                                          const Wish& wish, std::size_t& near) {
    const History& input = *histories.place(unknown, wish.time).history;
    const std::size_t joints = wish.isOnePiece ? 1 : mostJoints;
    std::size_t passed = 0;
    near = input.find(wish.time, near);
    for (std::size_t i = near; i + 1 < input.size(); ++i) {
        const History::Step next = input.step(i + 1);
        if (next.origin <= wish.time)
            continue;
        if (next.fresh || ++passed == joints) {
            mayEndAt(next.origin, next.fresh);
            return std::nullopt;
        }
        if (next.origin >= std::min(limit_, wish.until))
            return std::nullopt;
    }
    const double until = input.until();
    if (histories.stop(unknown)) {
        if (until < limit_) {
            mayEndAt(until, false);
            ends_ = unknown;
        }
        return std::nullopt;
    }
    if (wish.isOnePiece && until > wish.time) { // it is known
        mayEndAt(until, false);
        return std::nullopt;
    }
    // Beyond the wished end, not just to it: an event there must be known before the step is made.
    if (until <= wish.time || (until < limit_ && until <= wish.until))
        return unknown;
    return std::nullopt;
}

} // namespace solution
