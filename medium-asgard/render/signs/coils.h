// The springs of a scene, drawn as coils from end to end, as engineers draw them.
//
// A coil has as many turns at any length, so that one sees how it is stretched. A spring that only
// pulls is a bare line while it is slack. LIMIT: in a crowd of springs coils have fewer corners.
#pragma once

#include "drawing/drawing.h"
#include "drawing/frame.h"
#include "drawing/lines.h"
#include "run/quantities.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace render {

// The corners of a coil between two points, both included; `across`: how far it reaches sideways.
[[nodiscard]] std::vector<Vector> coilBetween(const Vector& from, const Vector& to, double across,
                                              int cornersPerTurn);

class Coils {
public:
    // Adds the springs at the drawing's time to the lines.
    void add(Lines& lines, const Drawing& drawing, double sceneSize, const Frame& frame);

private:
    using Ends = std::pair<Vector, Vector>;
    [[nodiscard]] std::optional<Ends> endsOf(const scene::Link& spring, const Drawing& drawing);
    [[nodiscard]] std::optional<Vector> onBody(const scene::BodyEnd& end, const Drawing& drawing);
    [[nodiscard]] std::optional<Vector> valueOf(const std::array<std::string, 3>& texts,
                                                const Drawing& drawing);
    void follow(const Drawing& drawing);

    // Of points that change: their coordinates, read from this motion.
    std::weak_ptr<const simulation::Motion> of_;
    std::vector<std::string> texts_;
    std::optional<simulation::Quantities> quantities_;
};

} // namespace render
