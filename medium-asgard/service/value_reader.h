// Values of a motion for a host: each expression has a number or a sentence, whatever is wrong with
// the others.
#pragma once

#include "ipc/messages.h"
#include "service/subdocument.h"

#include <optional>
#include <string>
#include <vector>

namespace service {

class ValueReader {
public:
    explicit ValueReader(simulation::Quantities of) : of_(std::move(of)) {}

    // At a time in start..computed.
    [[nodiscard]] ipc::Values at(double time) const;
    // None of them is known at this time: the sentence says why, where an expression is sound.
    [[nodiscard]] ipc::Values none(const std::string& why) const;

private:
    simulation::Quantities of_;
};

// Makes the readers of a scene's motions. It builds the equations of a scene once, for all
// expressions, times and motions that are asked for. The values of its parameters are the scene's:
// those that were set later belong to the next scene.
class ValueSource {
public:
    [[nodiscard]] ValueReader reader(const ScenePointer& scene,
                                     const simulation::MotionPointer& motion,
                                     const std::vector<std::string>& expressions);
    // How often it has built equations.
    [[nodiscard]] std::size_t built() const { return built_; }

private:
    ScenePointer of_;
    std::optional<simulation::ReadableScene> scene_;
    std::size_t read_ = 0; // expressions of that scene
    std::size_t built_ = 0;
};

} // namespace service
