// What an event changes, from the moment at which it is announced until the solver asks for it.
#pragma once

#include "motion/body_motion.h"
#include "solution/event_source.h"

#include <vector>

namespace simulation {

struct Outcome {
    std::vector<solution::Changes::Jump> jumps;
    std::vector<solution::Changes::End> ends;
    bool isContactsNew = false; // contacts that last are others

    // Of the body's unknowns those that are not the same, in the event, too; of the attitude all or
    // none, since what was solved is of length 1 only to its error.
    void jump(const physics::BodyMotion& motion, const BodyState& from, const BodyState& to,
              solution::Event& event);
};

} // namespace simulation
