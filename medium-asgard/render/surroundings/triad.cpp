#include "surroundings/triad.h"

#include "drawing/overlay.h"
#include "drawing/stroke_text.h"

#include <algorithm>

namespace render {

namespace {

double strokeOf(Size size) { return Frame(Drawing{}, size).stroke(1); }

constexpr double arm = 27, ball = 8; // pixels of a picture 480 high

// The page that the triad is drawn on: parallel lines of sight.
Frame pageOf(Size size) {
    Drawing parallel;
    parallel.camera.orthographic = true;
    return {parallel, size};
}

Vector onPage(Size size, const Eigen::Vector2d& pixels) {
    const double unit = pixelsPerUnit(size);
    return {(pixels.x() - 0.5 * size.width) / unit, (0.5 * size.height - pixels.y()) / unit, 0};
}

} // namespace

Eigen::Vector3f axisColor(int axis) {
    static const std::array<Eigen::Vector3f, 3> colors{
        Eigen::Vector3f{0.86F, 0.25F, 0.27F}, {0.38F, 0.66F, 0.16F}, {0.20F, 0.47F, 0.86F}};
    return colors[static_cast<std::size_t>(axis)];
}

Eigen::Vector2d triadMiddle(Size size) {
    const double margin = (arm + ball + 7) * strokeOf(size);
    return {margin, size.height - margin};
}

double triadReach(Size size) { return (arm + ball + 2) * strokeOf(size); }

std::array<TriadEnd, 6> triadOf(const Camera& camera, Size size) {
    const double length = arm * strokeOf(size);
    const Eigen::Vector2d middle = triadMiddle(size);
    std::array<TriadEnd, 6> ends;
    for (int i = 0; i < 6; ++i) {
        TriadEnd& end = ends[static_cast<std::size_t>(i)];
        end.axis = i % 3;
        end.against = i > 2;
        const Vector seen = camera.rotation * end.direction();
        end.place = middle + length * Eigen::Vector2d(seen.x(), -seen.y());
        end.depth = seen.z();
    }
    std::ranges::stable_sort(ends, {}, &TriadEnd::depth);
    return ends;
}

std::optional<Vector> triadDirectionAt(const Camera& camera, Size size,
                                       const Eigen::Vector2d& pixels) {
    const auto ends = triadOf(camera, size);
    const double reach = (ball + 1.5) * strokeOf(size);
    for (auto end = ends.rbegin(); end != ends.rend(); ++end)
        if ((end->place - pixels).norm() <= reach)
            return end->direction();
    return std::nullopt;
}

void showTriad(Lines& lines, const Discs& discs, const Frame& frame,
               const scene::Color& background) {
    const Size size = frame.size();
    const Frame page = pageOf(size);
    const std::array<float, 16> projection = page.projection(1, -1);
    const Eigen::Vector3f paper = isDark(background) ? Eigen::Vector3f(0.16F, 0.17F, 0.18F)
                                                     : Eigen::Vector3f(0.97F, 0.97F, 0.98F);
    const Vector origin = onPage(size, triadMiddle(size));
    for (const TriadEnd& end : triadOf(frame.camera(), size)) {
        const Eigen::Vector3f color = axisColor(end.axis);
        const Vector place = onPage(size, end.place);
        const float near = 0.72F + 0.14F * static_cast<float>(end.depth + 1);
        lines.begin(page, projection);
        if (!end.against)
            lines.add(origin, place, {color, near, frame.stroke(2)});
        lines.draw(0);
        const Eigen::Vector3f inside = end.against ? 0.68F * paper + 0.32F * color : color;
        discs.show({{place,
                     {inside.x(), inside.y(), inside.z(), near},
                     {color.x(), color.y(), color.z(), near},
                     frame.stroke(end.against ? ball - 1.5 : ball),
                     frame.stroke(1.4)}},
                   page, projection);
        if (end.against)
            continue;
        const double height = frame.stroke(8.4);
        const char name[] = {"xyz"[end.axis], '\0'};
        // Small letters have their middle lower than digits.
        addText(lines, page, place, {0, (end.axis == 1 ? 0.28 : 0.14) * height}, name, height,
                Anchor::middle, {Eigen::Vector3f::Ones(), 1, frame.stroke(1.5)});
        lines.draw(0);
    }
}

void addAxes(Lines& lines, const Extent& extent, const Frame& frame) {
    const double length = 0.5 * extent.size, height = frame.stroke(11);
    for (int axis = 0; axis < 3; ++axis) {
        const Vector head = length * Vector::Unit(axis);
        const Ink ink{axisColor(axis), 0.95F, frame.stroke(1.7)};
        addArrow(lines, frame, Vector::Zero(), head, ink);
        const char name[] = {"xyz"[axis], '\0'};
        addText(lines, frame, frame.toView(1.04 * head), {0.9 * height, 0}, name, height,
                Anchor::middle, ink);
    }
}

} // namespace render
