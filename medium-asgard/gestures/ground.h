// The base of a gesture: a scene as its window shows it, and the receiver of the texts that the
// gesture makes of its text. A gesture is one step of undo, however many texts it made on its way.
#pragma once

#include "scene/scene.h"
#include "simulation/simulation.h"

#include <functional>
#include <memory>
#include <string>

namespace gestures {

struct Ground {
    std::string text;                          // when the gesture begins
    std::shared_ptr<const scene::Scene> scene; // read from it
    simulation::MotionPointer motion;          // tells masses
    // Shown and read, and no step of undo yet.
    std::function<void(const std::string& text)> preview;
    // The last one: a step of undo of that name, none where it is the text as it was.
    std::function<void(const std::string& text, const std::string& label)> finish;
};

} // namespace gestures
