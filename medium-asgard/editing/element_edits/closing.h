// Writes where bodies are to stand into a scene's text, as numbers of -init_pos and -init_rot: how
// joints are closed (physics/assembly.h), and how bodies go that a hand pulls (physics/pulling.h).
#pragma once

#include "editing/value_edit.h"
#include "geometry/pose.h"

#include <optional>
#include <string>
#include <vector>

namespace editing {

struct NewPlace {
    std::size_t body = 0;
    geometry::Pose pose; // of its reference point
    bool turns = false;
    struct Velocity {
        geometry::Vector linear, angular; // of the centre of mass; world
    };
    std::optional<Velocity> velocity = std::nullopt; // none: as it is written
};

[[nodiscard]] std::vector<Wish> wishesOf(const Mapper& mapper, const NewPlace& place);

struct Closing {
    text::Edits edits;
    std::string reason; // why the text cannot say so: one sentence; "": it can
    scene::Range cause; // what is meant by it, where it has a place
};

// All of them, or none.
[[nodiscard]] Closing closingEdits(const Mapper& mapper, const scene::Scene& scene,
                                   const std::vector<NewPlace>& places);

} // namespace editing
