#include "handles/handle_marks.h"

#include "drawing/overlay.h"

#include <algorithm>

namespace render {

namespace {

Eigen::Vector3f shade(const scene::Color& c) {
    return Eigen::Vector3d(c.red, c.green, c.blue).cast<float>();
}

// Nearer to the eye along its line of sight: at the same place of the picture.
Vector lifted(const Frame& frame, const Vector& view, double by) {
    const Vector toEye = frame.eye() - view;
    const double distance = toEye.norm();
    // LIMIT: one whose body reaches almost to the eye may be hidden by it.
    return view + toEye * (std::min(by, 0.8 * distance) / std::max(distance, 1e-12));
}

Vector moved(const Frame& frame, const Vector& view, const Eigen::Vector2d& pixels) {
    const double perPixel = 1 / std::max(frame.pixels(1, view.z()), 1e-12);
    return view + perPixel * Vector(pixels.x(), -pixels.y(), 0);
}

} // namespace

std::vector<Disc> addHandles(Lines& lines, const HandleSet& set, const Frame& frame,
                             const scene::Color& paper, bool joints) {
    const Eigen::Vector3f rim = shade(paper);
    const auto lift = [&](const Handle& handle) {
        return 1.02 * handle.clear * frame.camera().scale;
    };
    for (const HandleLine& line : set.lines)
        for (std::size_t i = 0; !joints && i + 1 < line.points.size(); ++i)
            lines.add(frame.toView(line.points[i]), frame.toView(line.points[i + 1]),
                      {0.85F * shade(colorOf(line.kind)), 0.9F, frame.stroke(1.5)});
    struct Placed {
        double depth;
        Disc disc;
    };
    std::vector<Placed> placed;
    for (const Handle& handle : set.handles) {
        if (isJoint(handle.kind) != joints)
            continue;
        const Eigen::Vector3f color = shade(colorOf(handle.kind));
        const Vector place = lifted(frame, frame.toView(handle.place), lift(handle));
        if (handle.isArrow())
            addArrowInView(lines, frame, lifted(frame, frame.toView(handle.base), lift(handle)),
                           place,
                           {0.9F * color, 0.95F,
                            frame.stroke(handle.kind == HandleKind::orientation ? 1.3 : 2.2)});
        if (!handle.movable || handle.folded)
            continue;
        const Vector stand = moved(frame, place, handle.aside);
        if (!handle.aside.isZero()) {
            lines.add(place, stand, {color, 0.8F, frame.stroke(1)});
            placed.push_back(
                {place.z(),
                 {place, color.homogeneous(), color.homogeneous(), frame.stroke(1.8), 0}});
        }
        const float radius = frame.stroke(radiusOf(handle.kind) + 1), edge = frame.stroke(1.3);
        const Eigen::Vector4f ink = color.homogeneous(), halo = rim.homogeneous();
        if (!isTarget(handle.kind)) {
            placed.push_back({stand.z(), {stand, ink, halo, radius, edge}});
            continue;
        }
        const Eigen::Vector4f clear(rim.x(), rim.y(), rim.z(), 0.25F);
        const Eigen::Vector4f none(color.x(), color.y(), color.z(), 0);
        placed.push_back({stand.z(), {stand, clear, halo, radius + edge, 2 * edge}});
        placed.push_back({stand.z(), {stand, none, ink, radius, 1.5F * edge}});
        placed.push_back({stand.z(), {stand, ink, ink, 2 * edge, 0}});
    }
    // Of two in one place the smaller is on top.
    std::ranges::stable_sort(placed, [](const Placed& a, const Placed& b) {
        return std::abs(a.depth - b.depth) > 1e-6 ? a.depth < b.depth
                                                  : a.disc.radius > b.disc.radius;
    });
    std::vector<Disc> discs;
    discs.reserve(placed.size());
    for (const Placed& one : placed)
        discs.push_back(one.disc);
    return discs;
}

} // namespace render
