// Values of a motion for a host: each expression has a number or a sentence, whatever is wrong with
// the others. LIMIT: one faulty expression costs equations of motion for each of the others, and so
// does each time that is asked for: hundreds of times on a large scene are slow.
#pragma once

#include "ipc/messages.h"
#include "simulation/simulation.h"

#include <optional>
#include <string>
#include <vector>

namespace service {

class ValueReader {
public:
    ValueReader(const scene::Scene& scene, const simulation::Options& options,
                const simulation::MotionPointer& motion,
                const std::vector<std::string>& expressions);

    // At a time in start..computed.
    [[nodiscard]] ipc::Values at(double time) const;
    // None of them is known at this time: the sentence says why, where an expression is sound.
    [[nodiscard]] ipc::Values none(const std::string& why) const;

private:
    std::vector<std::string> faults_;             // of each expression; "" for a sound one
    std::optional<simulation::Quantities> sound_; // of the sound ones
};

} // namespace service
