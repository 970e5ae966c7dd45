// How texts become scenes, and scenes motion.
#pragma once

#include "script/reader.h"
#include "simulation/simulation.h"

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace computing {

using ScenePointer = std::shared_ptr<const scene::Scene>;
using ParameterValues = std::map<std::string, double>; // by name, in place of the text's

// `read` is called on one thread, `simulate` on another, cancelReading on any.
struct Tools {
    std::function<script::ReadResult(const std::string& text, const ParameterValues&)> read;
    std::function<void()> cancelReading;
    std::function<simulation::Result(const ScenePointer&, const simulation::Options&,
                                     const simulation::Observer&)>
        simulate;
};

// The evaluator, and the engine, which keeps the motion that an edit does not concern.
[[nodiscard]] Tools toolsOf(script::Reader& reader);

} // namespace computing
