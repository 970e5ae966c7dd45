// The wishes of a caller beside the scene, and how the work tells of itself meanwhile.
#pragma once

#include "motion/motion.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace simulation {

struct Options {
    std::optional<double> accuracy; // overrides the scene's
    std::optional<double> finish;
    std::string method = ""; // "" : the scene's
    std::optional<double> fixedStep;
    bool whole = false;      // one component for the whole scene (dissertation 5.2.1, 5.2.4)
    bool eventDriven = true; // false: finish each component before the next (5.2.4, case 5)
    int threads = 1;         // 0: as many as the machine has cores; from 2 on, two runs at a
                             // time; the motion is the same
    // These expressions are all that will be read of the motion, as Quantities: an orientation that
    // neither they nor anything in the scene read is not solved. None: all may be read.
    std::optional<std::vector<std::string>> only = std::nullopt;
    bool explain = false; // fill Result::explanation
    // A body or one of its unknowns ("rod1", "rod1.x"): of its components the explanation has every
    // form of the equations, down to machine code. "": of none.
    std::string phasesOf = "";
    std::map<std::string, double> parameters; // override the scene's values
};

struct Observer {
    std::function<bool()> cancelled;             // true: stop soon, keep what there is
    std::function<void(MotionPointer)> progress; // a longer motion; any thread
    // Every now and then, with the time that is worked at, in whichever run; the caller's thread.
    std::function<void(double time)> working = {};
};

} // namespace simulation
