// The motion that is known, to another finish.
//
// Runs are taken further, or read up to where the motion ends now (kept_runs.h). What they do not
// tell is left to be solved again: bodies whose accuracy asks for other tolerances over the new
// time, that meet in the time that was added without having been solved together, that meet what
// they were solved with and what is not there any more, or whose runs were too large to keep. Where
// bodies change in the same edit, a part is taken further as long as that is soon done: without the
// change they may bounce for ever in the time that is added.
#pragma once

#include "resimulation/kept_motion.h"

#include <functional>

namespace simulation {

struct NewFinish {
    KnownMotion motion;               // of the same scene, which ends at the new time
    std::vector<std::size_t> unclear; // bodies that move, to be solved again
    Statistics work;
    // Then the rest says nothing, but for the work, and what there was by then.
    bool cancelled = false;
    MotionPointer draft;
};

// `work` of one solution is added to the second.
using AddWork = std::function<void(const Statistics&, Statistics&)>;
// `isChanging`: by body, it moves otherwise in the scene that this is for, or is not in it.
[[nodiscard]] NewFinish atFinish(const KnownMotion& known, double finish,
                                 const std::vector<bool>& isChanging, const Observer& observer,
                                 const AddWork& add);

} // namespace simulation
