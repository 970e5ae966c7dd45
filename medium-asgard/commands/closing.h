// The offer to close joints that their bodies miss at the start, and to move bodies apart that
// overlap there: the free bodies move as little as possible, as `asgard assemble` does, and the
// text has their places as numbers.
#pragma once

#include "scene/diagnostic.h"
#include "scene/scene.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace commands {

// The numbers of faults that ask for it.
struct Misplaced {
    int openJoints = 0, overlaps = 0;
    bool operator==(const Misplaced&) const = default;
};
[[nodiscard]] Misplaced misplacedIn(const std::vector<scene::Diagnostic>& faults);

// "Close It", "Close Them", "Move Apart"; and the step of undo.
[[nodiscard]] std::string offerOf(const Misplaced& misplaced);
[[nodiscard]] std::string labelOf(const Misplaced& misplaced);

struct Closed {
    std::string text, reason; // why it cannot be; "": the text has the places
};
// Takes a while: for a thread of its own; `cancelled` is asked now and then. Cancelled, it is
// empty.
[[nodiscard]] Closed closed(const std::string& text,
                            const std::shared_ptr<const scene::Scene>& scene,
                            const std::function<bool()>& cancelled);

} // namespace commands
