// The words beside handles: how many are folded, how fast a body spins. They stand as in a
// document's picture (render/handles/handle_layout.h).
#pragma once

#include "labels/seen_picture.h"

class QPainter;

namespace views {

void paintLabels(QPainter& painter, SeenPicture& picture);

} // namespace views
