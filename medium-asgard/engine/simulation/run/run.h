// One solution of a scene at given tolerances.
#pragma once

#include "collision/broad_phase.h"
#include "motion/computed_motion.h"
#include "motion/contact_log.h"
#include "motion/lost_hops.h"
#include "run/problem.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace simulation {

struct BodyError {
    double estimate = 0; // over the size of what it moves with
    double predictableUntil = solution::infinity;
    double lostHops = 0; // the part of the estimate that is the height of hops left out
};
// Of both: the larger estimate, with its part by hops, and the earlier horizon.
[[nodiscard]] BodyError worse(const BodyError& first, const BodyError& second);

// What a run has cost.
struct RunWork {
    solution::Statistics statistics;
    solution::Statistics before;                    // what was counted of it before it went on
    std::size_t pairTests = 0;                      // since then
    double secondsSettingUp = 0, secondsMoving = 0; // CPU: before the first step, and from it on
};

// How things stand at the end of a run; when it is to be explained.
struct RunEnd {
    // By body that rests or slides: on what.
    std::map<std::size_t, std::vector<std::size_t>> supports;
};

struct Run : RunWork, RunEnd {
    std::shared_ptr<const solution::Histories> histories;
    std::shared_ptr<const expression::EquationSet> equations; // as events left them
    std::map<std::size_t, Stop> stops;                        // by body
    Impacts impacts;
    ContactLog contacts;
    std::vector<std::string> notes;
    std::vector<LostHop> lostHops;
    std::vector<std::pair<std::size_t, std::size_t>> candidates; // pairs that were tested; in order
    double reached = 0;
    bool cancelled = false;
    bool isDisturbed = false; // something hit what was taken from another run

    // Which bodies belong together: bodies of one island read, hit or touch each other, directly or
    // through others. island[b] is the least body of b's.
    std::vector<std::size_t> island;
    std::vector<bool> isIntegrated; // by body: some of its motion is not exact
    std::vector<bool> isTaken;      // by body: from the run before; empty: none

    // `error`: the worst of its bodies', where it is known.
    [[nodiscard]] MotionPointer motion(const Problem& problem, bool draft,
                                       const std::optional<BodyError>& error = {}) const;
};

// Its bodies, as it moves them.
[[nodiscard]] ComputedMotion::Part partOf(const Problem& problem, const Run& run);

// The sentence about a motion whose estimated error exceeds the accuracy.
[[nodiscard]] std::string shortfallOf(double accuracy, const BodyError& error);

// Which bodies belong together when these impacts happen, these contacts last, and some meet where
// another's motion has ended.
[[nodiscard]] std::vector<std::size_t> islandsOf(const Problem& problem, const Impacts& impacts,
                                                 const ContactLog& contacts = {},
                                                 const std::vector<collision::Pair>& blocked = {});

} // namespace simulation
