// The modelled parts of a scene, their models, and why the rest has none (docs/command-line.md).
//
// Components and equations are those in force at the end of the motion, with earlier ones that
// differ.
#pragma once

#include "reports/acting.h"

#include <cstddef>
#include <string>
#include <vector>

namespace simulation {

struct Explanation {
    struct Component {
        std::vector<std::string> unknowns, reads;
        std::vector<std::string> equations; // of first order: rod1.x' = rod1.dx
        std::vector<std::string> earlier;   // others, which ended: "..., until t = 1.43"
        std::string model;                  // as in ComponentStatistics
        std::string method;
        std::size_t order = 0, steps = 0, evaluations = 0;
        std::string why; // a clause
    };
    struct NotModelled {
        std::string what, why;
    };
    struct Never { // a pair of bodies
        std::string a, b, why;
    };
    struct Phases { // of a component that was asked for: see solution/phases_text.h
        std::vector<std::string> unknowns;
        std::string text;
    };
    std::vector<Acting> acting;
    std::vector<Component> components;
    std::vector<Phases> phases;
    std::vector<NotModelled> notModelled;
    std::size_t candidates = 0; // pairs that came near each other
    std::size_t tested = 0;     // tests of pairs, each over a stretch of the motion
    std::size_t impacts = 0;
    bool isAnyResting = false;    // or sliding, at the end
    std::vector<Never> never;     // pairs of which one can move, that were never tested
    std::size_t neverLeftOut = 0; // such pairs that the list has no place for
};

[[nodiscard]] Explanation explanationOf(const Problem& problem, const Run& run);

} // namespace simulation
