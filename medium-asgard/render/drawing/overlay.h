// The lines of bodies, their edges, and arrows.
#pragma once

#include "drawing/frame.h"
#include "drawing/lines.h"
#include "drawing/mesh.h"
#include "drawing/solids.h"

#include <map>

namespace render {

// The dark rim of faces and of balls; none where it is only a few pixels large. It also hides the
// steps of outlines that are drawn without multisampling.
void addEdges(Lines& lines, const Solid& solid, const Mesh& mesh, const Frame& frame);

// A part as bare lines: its edges, or a ball's outline and three great circles.
void addWireframe(Lines& lines, const Solid& solid, const Mesh& mesh, const Frame& frame);

// A straight arrow with a filled head: between points of the world, or of the view.
void addArrowInView(Lines& lines, const Frame& frame, const Vector& from, const Vector& to,
                    const Ink& ink);
void addArrow(Lines& lines, const Frame& frame, const Vector& from, const Vector& to,
              const Ink& ink);

} // namespace render
