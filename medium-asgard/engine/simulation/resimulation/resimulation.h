// The motion of a scene that is being edited: motion that an edit does not concern is kept
// (dissertation 5.2.5), and the motion equals that of simulate() bit for bit.
//
// Motion is a function of the scene alone, and the motion of some bodies is a function of these
// bodies alone unless others come near them. So an edit is done thus:
//
//     changed = bodies that move by other equations, from other values, with another shape
//               (scene/difference.h), and who was in one unit with them (kept_motion.h)
//     repeat
//         solve the changed bodies, all of the fixed ones around them, as a scene of its own
//         kept bodies that come near these (or near a fixed one that changed) are changed too
//     until there are none
//     put the motion together
//
// Colours, lights, views, plots and places in the text are no part of motion: then nothing is
// solved. Another finish takes what is kept further, or reads less of it (new_finish.h). Where
// bodies are not independent of each other by the options (`whole`, no event-driven scheduling), or
// something is said of the whole scene (another accuracy, method, start; a refusal; an explanation
// that is asked for), all is solved again.
#pragma once

#include "simulation/simulation.h"

#include <memory>

namespace simulation {

class Resimulation {
public:
    Resimulation();
    ~Resimulation();
    Resimulation(Resimulation&&) noexcept;
    Resimulation& operator=(Resimulation&&) noexcept;

    // As simulate(). The statistics count the work of this call; an update that was cancelled
    // leaves what is kept as it was. Drafts that are published show kept motion beside what grows.
    [[nodiscard]] Result update(std::shared_ptr<const scene::Scene> scene,
                                const Options& options = {}, const Observer& observer = {});

    // The work of the last call, for tests.
    struct Work {
        bool whole = false;              // all was solved, as by simulate()
        std::vector<std::string> solved; // bodies that move, in the scene's order
        std::size_t kept = 0;            // how many that move were not
        std::size_t rounds = 0;          // solutions, since others came near
        std::string print() const;
    };
    [[nodiscard]] const Work& work() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace simulation
