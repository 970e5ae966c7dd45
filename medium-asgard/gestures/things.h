// The things of a scene that a click in its picture may mean, and the frame around one that is
// selected: the same in viewers and in documents.
#pragma once

#include "editing/element.h"
#include "gestures/picking.h"

namespace gestures {

struct Thing {
    editing::Element element;
    std::optional<render::Handle> handle; // of it, that is there
};
// Those under the pointer, from the front on: a handle that is shown, the sign of a joint, bodies,
// a trajectory's line. `reach`: as of a grasp.
[[nodiscard]] std::vector<Thing> thingsAt(const render::Drawing& drawing,
                                          const render::HandleSet& handles, const Sight& sight,
                                          const Eigen::Vector2d& pixels, double reach);
// The one that a click means: the first, or, where the last click was there too, the one behind
// that which is selected. None: there is nothing.
[[nodiscard]] const Thing* meant(const std::vector<Thing>& things,
                                 const std::vector<editing::Element>& selected, bool isAgain);

// The body there that is selected and that a hand may take, whatever is before it.
[[nodiscard]] std::optional<std::size_t>
selectedBodyAt(const render::Drawing& drawing, const Sight& sight, const Eigen::Vector2d& pixels,
               const std::vector<editing::Element>& selected);

// In pixels, `margin` of them around the body; empty: it has no extent, or is hidden.
[[nodiscard]] Eigen::AlignedBox2d frameOf(const render::Drawing& drawing, const Sight& sight,
                                          std::size_t body, double margin);

} // namespace gestures
