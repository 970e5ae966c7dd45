#include "drawing/overlay.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

// Outlines of what is curved, as the eye sees it: where lines of sight touch the surface. In the
// solid's own frame, with the eye at e and the normal n at x on the surface: n.(e - x) = 0.
class Contour {
public:
    Contour(Lines& lines, const Solid& solid, const Vector& eye, int parts, const Ink& ink)
        : lines_(lines), solid_(solid), parts_(parts), ink_(ink),
          eye_(solid.linear.inverse() * (eye - solid.place)) {}

    void operator()(const scene::CylinderShape& c) const { addSides(c.radius, c.height); }
    void operator()(const scene::TubeShape& t) const { addSides(t.outer, t.height); }
    void operator()(const scene::BowlShape& b) const {
        addEllipse(Vector::Constant(b.outer), Vector::Zero(), -1);
    }
    void operator()(const scene::CapsuleShape& c) const {
        addSides(c.radius, c.height);
        for (const double end : {-1.0, 1.0})
            addEllipse(Vector::Constant(c.radius), {0, end * c.height / 2, 0}, end);
    }
    void operator()(const scene::EllipsoidShape& e) const { addEllipse(e.axes, Vector::Zero(), 0); }
    // n = (h e + r y) / |..| for the direction e across the axis, and x the apex.
    void operator()(const scene::ConeShape& c) const {
        const Vector apex(0, c.height / 2, 0), d = eye_ - apex;
        const double across = std::hypot(d.x(), d.z());
        const double cosine = -c.radius * d.y() / (c.height * across);
        for (const double angle : touching(d, cosine))
            add(apex, {c.radius * std::cos(angle), -c.height / 2, c.radius * std::sin(angle)});
    }
    template <typename Other> void operator()(const Other&) const {}

private:
    // The directions across the axis at that cosine from d; none: it sees no side, or all.
    static std::vector<double> touching(const Vector& d, double cosine) {
        if (!(std::abs(cosine) < 1))
            return {};
        const double middle = std::atan2(d.z(), d.x()), half = std::acos(cosine);
        return {middle - half, middle + half};
    }
    void addSides(double radius, double height) const {
        for (const double angle : touching(eye_, radius / std::hypot(eye_.x(), eye_.z()))) {
            const Vector out(radius * std::cos(angle), 0, radius * std::sin(angle));
            add(out + Vector(0, height / 2, 0), out - Vector(0, height / 2, 0));
        }
    }
    // Of the ball that the ellipsoid is with its axes as units; of it only what lies towards `end`.
    void addEllipse(const Vector& axes, const Vector& centre, double end) const {
        const Vector eye = (eye_ - centre).cwiseQuotient(axes);
        const double distance = eye.norm();
        if (distance <= 1)
            return;
        const Vector axis = eye / distance, u = axis.unitOrthogonal(), v = axis.cross(u);
        const double radius = std::sqrt(1 - 1 / (distance * distance));
        const auto at = [&](int k) {
            const double angle = 2 * M_PI * k / parts_;
            return Vector(axis / distance + radius * (std::cos(angle) * u + std::sin(angle) * v));
        };
        for (int k = 0; k < parts_; ++k)
            if (const Vector from = at(k), to = at(k + 1); end * (from + to).y() >= 0)
                add(centre + axes.cwiseProduct(from), centre + axes.cwiseProduct(to));
    }
    void add(const Vector& from, const Vector& to) const {
        lines_.add(solid_.toView(from), solid_.toView(to), ink_);
    }

    Lines& lines_;
    const Solid& solid_;
    int parts_;
    const Ink& ink_;
    Vector eye_;
};

void addContour(Lines& lines, const Solid& solid, const Frame& frame, int parts, const Ink& ink) {
    std::visit(Contour(lines, solid, frame.eye(), parts, ink), solid.part->shape);
}

bool isSphere(const Solid& solid) {
    return std::holds_alternative<scene::SphereShape>(solid.part->shape);
}

// With the hue of the surface, dark enough to be seen, or light enough on what is dark.
Ink rim(const Solid& solid, const Frame& frame, double width, float alpha) {
    const float lightness = solid.color.dot(Eigen::Vector3f(0.3F, 0.6F, 0.1F));
    const Eigen::Vector3f ink = lightness < 0.2F ? Eigen::Vector3f(solid.color.array() + 0.32F)
                                                 : Eigen::Vector3f(solid.color * 0.33F);
    return {ink, alpha, frame.stroke(width)};
}

// A circle about `middle` in the plane of u and v.
void addCircle(Lines& lines, const Vector& middle, const Vector& u, const Vector& v, int parts,
               const Ink& ink) {
    Vector last = middle + u;
    for (int i = 1; i <= parts; ++i) {
        const double angle = 2 * M_PI * i / parts;
        const Vector next = middle + std::cos(angle) * u + std::sin(angle) * v;
        lines.add(last, next, ink);
        last = next;
    }
}

int circleParts(double radiusInPixels) {
    return std::clamp(static_cast<int>(4 * std::sqrt(radiusInPixels)), 12, 96);
}

// The outline of a ball as the eye sees it: the circle where lines of sight touch it.
void addOutline(Lines& lines, const Solid& solid, const Frame& frame, int parts, const Ink& ink) {
    const Vector toEye = frame.eye() - solid.place;
    const double distance = toEye.norm(), r = solid.radius;
    if (distance <= r)
        return;
    const Vector axis = toEye / distance;
    const Vector u = axis.unitOrthogonal(), v = axis.cross(u);
    const double radius = r * std::sqrt(1 - r * r / (distance * distance));
    addCircle(lines, solid.place + axis * (r * r / distance), radius * u, radius * v, parts, ink);
}

} // namespace

void addEdges(Lines& lines, const Solid& solid, const Mesh& mesh, const Frame& frame) {
    const double size = frame.pixels(solid.radius, solid.middle.z()) / frame.stroke(1);
    if (size < 5)
        return;
    const float alpha = solid.alpha * static_cast<float>(std::min(1.0, size / 16));
    if (isSphere(solid)) {
        addOutline(lines, solid, frame, circleParts(frame.pixels(solid.radius, solid.middle.z())),
                   rim(solid, frame, 1.0, 0.6F * alpha));
        return;
    }
    const Ink ink = rim(solid, frame, 1.1, 0.75F * alpha);
    addContour(lines, solid, frame, circleParts(frame.pixels(solid.radius, solid.middle.z())), ink);
    for (const auto& [from, to] : mesh.edges)
        lines.add(solid.toView(from), solid.toView(to), ink);
}

void addWireframe(Lines& lines, const Solid& solid, const Mesh& mesh, const Frame& frame) {
    const Ink ink = rim(solid, frame, 1.2, 0.9F);
    if (!isSphere(solid)) {
        addContour(lines, solid, frame, circleParts(frame.pixels(solid.radius, solid.middle.z())),
                   ink);
        for (const auto& [from, to] : mesh.edges)
            lines.add(solid.toView(from), solid.toView(to), ink);
        return;
    }
    const int parts = circleParts(frame.pixels(solid.radius, solid.middle.z()));
    addOutline(lines, solid, frame, parts, ink);
    Ink faint = ink;
    faint.alpha = 0.4F;
    for (int axis = 0; axis < 3; ++axis)
        addCircle(lines, solid.place, solid.linear.col(axis), solid.linear.col((axis + 1) % 3),
                  parts, faint);
}

void addArrow(Lines& lines, const Frame& frame, const Vector& from, const Vector& to,
              const Ink& ink) {
    addArrowInView(lines, frame, frame.toView(from), frame.toView(to), ink);
}

void addArrowInView(Lines& lines, const Frame& frame, const Vector& a, const Vector& b,
                    const Ink& ink) {
    const double length = (b - a).norm();
    const double perPixel = 1 / std::max(frame.pixels(1, b.z()), 1e-12);
    const double head = std::min(0.45 * length, 6.5 * ink.width * perPixel);
    if (head <= 0)
        return;
    const Vector neck = b - head / length * (b - a);
    lines.add(a, neck, ink);
    Ink filled = ink;
    filled.width = std::min(4.2F * ink.width, static_cast<float>(0.9 * head / perPixel));
    lines.addPointed(neck, b, filled);
}

} // namespace render
