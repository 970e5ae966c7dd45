// The words beside handles: how many are folded, how fast a body spins. They stand as in a
// document's picture (render/handles/handle_layout.h).
#pragma once

#include "labels/meters.h"

namespace views {

// Beside the values, which stand where they are.
void paintLabels(QPainter& painter, SeenPicture& picture, const Meters& meters);

} // namespace views
