// Handles as lines and discs of a picture.
#pragma once

#include "drawing/discs.h"
#include "drawing/lines.h"
#include "handles/handles.h"

#include <vector>

namespace render {

// Adds the arrows and lines of all handles but those of joints, or of those alone, and answers with
// their discs from back to front. Each is as deep in the picture as the front of its own body.
[[nodiscard]] std::vector<Disc> addHandles(Lines& lines, const HandleSet& set, const Frame& frame,
                                           const scene::Color& paper, bool joints);

} // namespace render
