// The words beside handles in a document's picture: how many are folded, how fast a body spins.
// They stand as in a graphical viewer (render/handles/handle_layout.h).
#pragma once

#include "gestures/picking.h"
#include "render/renderer.h"

#include <vector>

namespace service {

// Into a picture that is drawn, beside what is taken there. `scale`: device pixels for each of the
// reader's.
void drawLabels(const render::HandleSet& handles, const gestures::Sight& sight, double scale,
                bool isDark, std::vector<Eigen::AlignedBox2d> taken, const render::Image& into);

} // namespace service
