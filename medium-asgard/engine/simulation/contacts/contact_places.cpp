#include "contacts/contact_places.h"

#include "collision/nearest_feature.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace simulation {
namespace {

using physics::ContactPoint;
using physics::GapConstraint;
using Kind = GapConstraint::Kind;

constexpr double same = 1e-9;  // of the parts' size: a corner at a vertex, or on an edge
constexpr double slack = 1e-9; // of the same: so far a contact goes beyond its side
constexpr double kept = 2e-9;  // of the same: a gap that stays what it is

Vector localOf(const Placed& owner, const Vector& point) {
    return owner.state.attitude.conjugate() * Vector(point - owner.state.position);
}

std::vector<Vector> localOf(const Placed& owner, const std::vector<Vector>& points) {
    std::vector<Vector> local;
    for (const Vector& point : points)
        local.push_back(localOf(owner, point));
    return local;
}

// Vertices in order of the angle about their middle.
std::vector<Vector> inOrder(std::vector<Vector> corners, const Vector& normal) {
    Vector middle = Vector::Zero();
    for (const Vector& corner : corners)
        middle += corner / static_cast<double>(corners.size());
    const Vector across = normal.unitOrthogonal(), along = normal.cross(across);
    std::ranges::sort(corners, {}, [&](const Vector& corner) {
        return std::atan2(along.dot(corner - middle), across.dot(corner - middle));
    });
    return corners;
}

class Sides {
public:
    Sides(std::size_t body, const Vector& place, double size)
        : body_(body), place_(place), slack_(slack * size) {}

    // inward . (p - on) >= 0; what is beyond already by rounding stays.
    void add(const Vector& inward, const Vector& on) {
        const double now = inward.dot(place_ - on);
        sides.push_back({.body = body_,
                         .inward = inward,
                         .offset = -inward.dot(on) + std::max(0.0, -now) + slack_});
    }
    void addOutline(const std::vector<Vector>& outline, const Vector& normal) {
        Vector middle = Vector::Zero();
        for (const Vector& vertex : outline)
            middle += vertex / static_cast<double>(outline.size());
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vector& from = outline[i];
            Vector inward = normal.cross(outline[(i + 1) % outline.size()] - from).normalized();
            if (inward.dot(middle - from) < 0)
                inward = -inward;
            add(inward, from);
        }
    }
    void addEnds(const Vector& from, const Vector& to) {
        const Vector way = (to - from).normalized();
        add(way, from);
        add(-way, to);
    }

    std::vector<ContactPoint::Side> sides;

private:
    std::size_t body_;
    Vector place_; // of the point, in the body's frame
    double slack_;
};

// ------------------------------------------------------------------------------------ spheres

std::size_t vertexAt(const geometry::Part& part, const Vector& place) {
    const auto& vertices = part.core.vertices;
    const auto nearest = std::ranges::min_element(
        vertices, {}, [&](const Vector& vertex) { return (vertex - place).squaredNorm(); });
    return static_cast<std::size_t>(nearest - vertices.begin());
}

// The cell of the feature (of the support's part, as vertices) in which the centre lies.
void addCell(const geometry::Part& part, const Vector& centroid,
             const std::vector<std::size_t>& feature, Sides& sides) {
    const auto at = [&](std::size_t vertex) {
        return Vector(part.core.vertices[vertex] - centroid);
    };
    if (feature.size() == 1) {
        for (const std::size_t other : part.core.neighbours[feature[0]])
            sides.add((at(feature[0]) - at(other)).normalized(), at(feature[0]));
        return;
    }
    sides.addEnds(at(feature[0]), at(feature[1]));
    for (const geometry::Edge& edge : part.core.edges) {
        const bool isIt = (edge.from == feature[0] && edge.to == feature[1]) ||
                          (edge.from == feature[1] && edge.to == feature[0]);
        for (const std::size_t face : {edge.left, edge.right}) {
            if (!isIt)
                continue;
            const Vector way = (at(edge.to) - at(edge.from)).normalized();
            Vector out = way.cross(part.core.faces[face].normal); // out of the face, in its plane
            if (face == edge.right)
                out = -out;
            sides.add(out, at(edge.from));
        }
    }
}

std::vector<ContactPoint::Side> sidesOfRound(const Touch& touch, const Placed& body,
                                             const Placed& support) {
    const geometry::Part& bodyPart = body.shape->parts[touch.bodyPart];
    const geometry::Part& supportPart = support.shape->parts[touch.supportPart];
    if (bodyPart.isSphere() && supportPart.isSphere())
        return {};
    const bool isBodys = bodyPart.isSphere(); // the sphere
    const Placed &round = isBodys ? body : support, &flat = isBodys ? support : body;
    const geometry::Part &sphere = isBodys ? bodyPart : supportPart,
                         &polyhedron = isBodys ? supportPart : bodyPart;
    const Vector centre =
        localOf(flat, Vector(round.state.position +
                             round.state.attitude * (sphere.center() - round.record->centroid)));
    const collision::Posed posed{.part = &polyhedron,
                                 .rotation = geometry::Matrix::Identity(),
                                 .offset = -flat.record->centroid};
    const double border = resolution::ofPlaces * touch.size;
    const collision::NearestFeature feature = collision::nearestFeature(posed, centre, border);
    Sides sides(flat.index, centre, touch.size);
    if (feature.corners.size() > 2) {
        sides.addOutline(feature.corners, feature.normal);
        return sides.sides;
    }
    std::vector<std::size_t> vertices;
    for (const Vector& corner : feature.corners)
        vertices.push_back(vertexAt(polyhedron, corner + flat.record->centroid));
    addCell(polyhedron, flat.record->centroid, vertices, sides);
    return sides.sides;
}

// ---------------------------------------------------------------------------------- polyhedra

// The edge of an outline (or the outline, if it is one) on which a point lies.
std::optional<std::pair<Vector, Vector>> edgeThrough(const std::vector<Vector>& outline,
                                                     const Vector& point, const Vector& normal,
                                                     double tolerance) {
    std::optional<std::pair<Vector, Vector>> best;
    double least = tolerance;
    const std::size_t edges = outline.size() == 2 ? 1 : outline.size();
    for (std::size_t i = 0; i < edges && outline.size() > 1; ++i) {
        const Vector &a = outline[i], &b = outline[(i + 1) % outline.size()];
        Vector off = point - a;
        const Vector way = (b - a).normalized();
        off -= way * way.dot(off);
        off -= normal * normal.dot(off);
        if (off.norm() <= least) {
            least = off.norm();
            best = {a, b};
        }
    }
    return best;
}

class Polyhedra { // in touch
public:
    Polyhedra(const Touch& touch, const Placed& body, const Placed& support)
        : touch_(touch), body_(body), support_(support) {
        bodyFace_ =
            touch.bodyFace.size() > 2 ? inOrder(touch.bodyFace, touch.normal) : touch.bodyFace;
        supportFace_ = touch.supportFace.size() > 2 ? inOrder(touch.supportFace, touch.normal)
                                                    : touch.supportFace;
    }

    [[nodiscard]] std::optional<ContactPoint> pointAt(const Corner& corner) const {
        const double near = same * touch_.size;
        const auto isAt = [&](const Vector& vertex) {
            const Vector off = vertex - corner.point;
            return (off - touch_.normal * touch_.normal.dot(off)).norm() <= near;
        };
        const auto ofBody = std::ranges::find_if(bodyFace_, isAt);
        const auto ofSupport = std::ranges::find_if(supportFace_, isAt);
        if (supportFace_.size() > 2 && ofBody != bodyFace_.end())
            return overFace(*ofBody, support_, supportFace_, Kind::onSupportPlane);
        if (bodyFace_.size() > 2 && ofSupport != supportFace_.end())
            return overFace(*ofSupport, body_, bodyFace_, Kind::onBodyPlane);
        return crossingAt(corner);
    }

private:
    [[nodiscard]] GapConstraint onPlane(Kind kind, const Vector& bodyPoint,
                                        const Vector& supportPoint) const {
        GapConstraint c;
        c.kind = kind;
        c.support = support_.index;
        c.bodyPoint = localOf(body_, bodyPoint);
        c.supportPoint = localOf(support_, supportPoint);
        const Placed& owner = kind == Kind::onBodyPlane ? body_ : support_;
        c.normal = owner.state.attitude.conjugate() * touch_.normal;
        return c;
    }
    // A vertex of the one over a face of the other.
    [[nodiscard]] ContactPoint overFace(const Vector& vertex, const Placed& other,
                                        const std::vector<Vector>& face, Kind kind) const {
        ContactPoint point;
        point.gap = kind == Kind::onSupportPlane ? onPlane(kind, vertex, face[0])
                                                 : onPlane(kind, face[0], vertex);
        Sides sides(other.index, localOf(other, vertex), touch_.size);
        sides.addOutline(localOf(other, face), point.gap.normal);
        point.sides = std::move(sides.sides);
        return point;
    }
    [[nodiscard]] std::optional<ContactPoint> crossingAt(const Corner& corner) const {
        constexpr double parallel = 1e-6, near = 1e-5;
        const auto a = edgeThrough(bodyFace_, corner.point, touch_.normal, near * touch_.size);
        const auto b = edgeThrough(supportFace_, corner.point, touch_.normal, near * touch_.size);
        if (!a || !b)
            return std::nullopt;
        const Vector ofBody = (a->second - a->first).normalized(),
                     ofSupport = (b->second - b->first).normalized();
        const double across = ofBody.cross(ofSupport).dot(touch_.normal);
        if (std::abs(across) < parallel)
            return std::nullopt;
        ContactPoint point;
        point.gap = onPlane(Kind::edgeOnEdge, a->first, b->first);
        point.gap.bodyEdge = body_.state.attitude.conjugate() * ofBody;
        point.gap.supportEdge = support_.state.attitude.conjugate() * ofSupport;
        point.gap.flipped = across < 0;
        Sides first(body_.index, localOf(body_, corner.point), touch_.size);
        first.addEnds(localOf(body_, a->first), localOf(body_, a->second));
        Sides second(support_.index, localOf(support_, corner.point), touch_.size);
        second.addEnds(localOf(support_, b->first), localOf(support_, b->second));
        point.sides = std::move(first.sides);
        point.sides.insert(point.sides.end(), second.sides.begin(), second.sides.end());
        return point;
    }

    const Touch& touch_;
    const Placed& body_;
    const Placed& support_;
    std::vector<Vector> bodyFace_, supportFace_;
};

Vector apartOf(const GapConstraint& gap, const Placed& body, const Placed& support) {
    return (body.state.position - support.state.position) +
           (body.state.attitude * gap.bodyPoint - support.state.attitude * gap.supportPoint);
}

Vector normalOf(const GapConstraint& gap, const Placed& body, const Placed& support) {
    const Vector apart = apartOf(gap, body, support);
    const Vector b = support.state.attitude * gap.supportEdge;
    switch (gap.kind) {
    case Kind::onSupportPlane:
        return support.state.attitude * gap.normal;
    case Kind::onBodyPlane:
        return body.state.attitude * gap.normal;
    case Kind::roundOnPoint:
        return apart.normalized();
    case Kind::roundOnLine:
        return (apart - b * b.dot(apart)).normalized();
    case Kind::edgeOnEdge:
    case Kind::tilt:
        break;
    }
    const Vector a = body.state.attitude * gap.bodyEdge;
    return (gap.flipped ? b.cross(a) : a.cross(b)).normalized();
}

double gapOf(const GapConstraint& gap, const Placed& body, const Placed& support) {
    return normalOf(gap, body, support).dot(apartOf(gap, body, support)) - gap.radius;
}

// Vertices of polyhedra that touch at fewer points than a face has, which may land beside them: of
// the one whose plane it is not, those that touch and part, and their neighbours.
class Landings {
public:
    Landings(const Touch& touch, const Placed& body, const Placed& support,
             physics::ContactPlace& place)
        : touch_(touch), body_(body), support_(support), place_(place) {}

    void add() {
        const Kind kind = place_.points[0].gap.kind;
        if (kind != Kind::onBodyPlane)
            addOf(body_, touch_.bodyPart, touch_.bodyFace, true);
        if (kind != Kind::onSupportPlane)
            addOf(support_, touch_.supportPart, touch_.supportFace, false);
    }

private:
    void addOf(const Placed& owner, std::size_t part, const std::vector<Vector>& face, bool above) {
        const geometry::Part& of = owner.shape->parts[part];
        std::set<std::size_t> vertices;
        for (const Vector& vertex : face) {
            const std::size_t at = vertexAt(of, localOf(owner, vertex) + owner.record->centroid);
            vertices.insert(at);
            vertices.insert(of.core.neighbours[at].begin(), of.core.neighbours[at].end());
        }
        for (const std::size_t vertex : vertices)
            add(owner, Vector(of.core.vertices[vertex] - owner.record->centroid), above);
    }
    void add(const Placed& owner, const Vector& vertex, bool above) {
        const Vector& normal = touch_.normal;
        const Vector at = owner.state.position + owner.state.attitude * vertex;
        for (const physics::ContactPoint& point : place_.points) {
            const Vector off = worldOf(point, 0, body_, support_).point - at;
            if ((off - normal * normal.dot(off)).norm() <= same * touch_.size)
                return; // it is that point
        }
        const GapConstraint& gap = place_.points[0].gap;
        const Vector on =
            gap.kind == Kind::onSupportPlane
                ? Vector(support_.state.position + support_.state.attitude * gap.supportPoint)
            : gap.kind == Kind::onBodyPlane
                ? Vector(body_.state.position + body_.state.attitude * gap.bodyPoint)
                : worldOf(place_.points[0], 0, body_, support_).point;
        const double height = (above ? 1 : -1) * normal.dot(at - on);
        const double room = height < slack * touch_.size ? slack * touch_.size - height : 0;
        place_.landings.push_back(
            {.body = owner.index, .vertex = vertex, .isAbove = above, .room = room});
    }

    const Touch& touch_;
    const Placed& body_;
    const Placed& support_;
    physics::ContactPlace& place_;
};

// Where each of the points goes in the plane: the place of the one that stands for it; none of them
// where they do not lie symmetrically.
std::vector<std::size_t> standing(const std::vector<Vector>& points, const MotionPlane& plane,
                                  double size) {
    const double near = same * size;
    std::vector<std::size_t> first;
    std::vector<double> sums(points.size(), 0), counts(points.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::size_t of = 0;
        for (; of < i; ++of) {
            Vector off = points[i] - points[of];
            off[plane.axis] = 0;
            if (first[of] == of && off.norm() <= near)
                break;
        }
        first.push_back(of);
        sums[of] += points[i][plane.axis];
        counts[of] += 1;
    }
    for (std::size_t i = 0; i < points.size(); ++i)
        if (first[i] == i && !(std::abs(sums[i] / counts[i] - plane.at) <= near))
            return {};
    return first;
}

// In the plane a corner is a vertex of the one or the other: where an edge crosses the plane.
void flatten(ContactPoint& point, const MotionPlane& plane, const Vector& corner,
             const Placed& body, const Placed& support) {
    GapConstraint& gap = point.gap;
    const auto isAcross = [&](const Vector& edge, const Placed& owner) {
        return std::abs((owner.state.attitude * edge)[plane.axis]) >= 1 - same;
    };
    const auto set = [&](Kind kind) {
        const Vector normal = normalOf(gap, body, support);
        const Placed& owner = kind == Kind::onBodyPlane ? body : support;
        gap.kind = kind;
        gap.bodyPoint = localOf(body, corner);
        gap.supportPoint = localOf(support, corner);
        gap.normal = owner.state.attitude.conjugate() * normal;
    };
    if (gap.kind == Kind::edgeOnEdge && isAcross(gap.bodyEdge, body))
        set(Kind::onSupportPlane);
    else if (gap.kind == Kind::edgeOnEdge && isAcross(gap.supportEdge, support))
        set(Kind::onBodyPlane);
    for (const auto& [owner, at] :
         {std::pair(&body, &gap.bodyPoint), {&support, &gap.supportPoint}})
        if (!owner->record->isFixed)
            (*at)[plane.axis] = 0;
    if (!body.record->isFixed || !support.record->isFixed) {
        gap.normal[plane.axis] = 0;
        gap.normal.normalize();
    }
}

void putInPlane(physics::ContactPlace& place, const std::vector<Vector>& corners,
                const MotionPlane& plane, const Placed& body, const Placed& support) {
    const std::vector<std::size_t> first = standing(corners, plane, place.size);
    if (first.empty() || std::abs(place.normal[plane.axis]) > same)
        return;
    std::vector<ContactPoint> points;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] != i)
            continue;
        Vector corner = corners[i];
        corner[plane.axis] = plane.at;
        points.push_back(std::move(place.points[i]));
        flatten(points.back(), plane, corner, body, support);
    }
    place.points = std::move(points);
    place.normal[plane.axis] = 0;
    place.normal.normalize();
    place.centre[plane.axis] = 0;
}

LastingContact contactOf(const Touch& touch, const Placed& body, const Placed& support,
                         const TouchLimits& limits) {
    LastingContact found{.bodyPart = touch.bodyPart,
                         .supportPart = touch.supportPart,
                         .isModelled = touch.isRound || touch.isModelled,
                         .place = {}};
    physics::ContactPlace& place = found.place;
    place.body = body.index;
    place.support = support.index;
    place.normal = touch.normal;
    place.size = touch.size;
    place.leaving = 2 * limits.gap * touch.size;
    const geometry::Part& part = body.shape->parts[touch.bodyPart];
    place.bodyRadius = part.isSphere() ? part.radius : 0;
    std::vector<Vector> corners;
    const Polyhedra polyhedra(touch, body, support);
    for (const Corner& corner : touch.corners) {
        if ((corner.rate > limits.slow && !limits.wereInContact) ||
            corner.gap > limits.gap * touch.size)
            continue;
        std::optional<ContactPoint> point;
        if (touch.isRound) {
            point.emplace();
            point->gap = corner.constraint;
            point->sides = sidesOfRound(touch, body, support);
        } else {
            point = polyhedra.pointAt(corner);
        }
        if (!point) {
            found.isModelled = false;
            continue;
        }
        point->parts = corner.rate > limits.slow;
        place.points.push_back(std::move(*point));
        corners.push_back(corner.point);
    }
    if (corners.empty())
        return found;
    const bool isWhole = corners.size() == touch.corners.size() && corners.size() > 2;
    const PatchMiddle middle = middleOf(corners, touch.normal);
    place.centre = localOf(body, middle.centre);
    place.friction.reach = middle.reach;
    if (limits.plane && !touch.isRound)
        putInPlane(place, corners, *limits.plane, body, support);
    if (!touch.isRound && !isWhole)
        Landings(touch, body, support, place).add();
    for (ContactPoint& point : place.points)
        if (const double gap = gapOf(point.gap, body, support);
            limits.isStart || point.parts || std::abs(gap) <= kept * touch.size)
            point.start = gap;
    return found;
}

// Of the triangle from the origin to p and q: its area, and the integral of the distance.
std::pair<double, double> wedgeOf(const Vector& p, const Vector& q, const Vector& normal) {
    const double area = normal.dot(p.cross(q)) / 2, side = (q - p).norm();
    if (!(side > 0))
        return {0, 0};
    const double height = std::abs(2 * area) / side;
    const Vector way = (q - p) / side;
    const auto upTo = [&](double s) { // of the distance, from the foot of the height to s along
        const double far = std::hypot(height, s);
        return height * (s * far + (height > 0 ? height * height * std::asinh(s / height) : 0)) / 6;
    };
    const double integral = upTo(way.dot(q)) - upTo(way.dot(p));
    return {area, area < 0 ? -integral : integral};
}

} // namespace

PatchMiddle middleOf(const std::vector<Vector>& corners, const Vector& normal) {
    PatchMiddle middle;
    for (const Vector& corner : corners)
        middle.centre += corner / static_cast<double>(corners.size());
    if (corners.size() == 2)
        middle.reach = (corners[1] - corners[0]).norm() / 4;
    if (corners.size() < 3)
        return middle;
    const std::vector<Vector> outline = inOrder(corners, normal);
    Vector moment = Vector::Zero();
    double area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector p = outline[i] - middle.centre,
                     q = outline[(i + 1) % outline.size()] - middle.centre;
        const double part = normal.dot(p.cross(q)) / 2;
        area += part;
        moment += part * (p + q) / 3;
    }
    if (!(std::abs(area) > 0))
        return middle;
    middle.centre += moment / area;
    double integral = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        integral += wedgeOf(outline[i] - middle.centre,
                            outline[(i + 1) % outline.size()] - middle.centre, normal)
                        .second;
    middle.reach = std::abs(integral / area);
    return middle;
}

std::vector<Vector> inPlane(const std::vector<Vector>& points,
                            const std::optional<MotionPlane>& plane, double size) {
    if (!plane)
        return points;
    const std::vector<std::size_t> first = standing(points, *plane, size);
    if (first.empty())
        return points;
    std::vector<Vector> left;
    for (std::size_t i = 0; i < first.size(); ++i)
        if (first[i] == i) {
            left.push_back(points[i]);
            left.back()[plane->axis] = plane->at;
        }
    return left;
}

WorldPoint worldOf(const physics::ContactPoint& point, double bodyRadius, const Placed& body,
                   const Placed& support) {
    const GapConstraint& gap = point.gap;
    WorldPoint found;
    found.normal = normalOf(gap, body, support);
    const Vector ofBody = body.state.position + body.state.attitude * gap.bodyPoint;
    found.point = ofBody - bodyRadius * found.normal;
    if (gap.kind == Kind::onBodyPlane)
        found.point = support.state.position + support.state.attitude * gap.supportPoint +
                      gap.radius * found.normal;
    if (gap.kind == Kind::edgeOnEdge) {
        const Vector a = body.state.attitude * gap.bodyEdge,
                     b = support.state.attitude * gap.supportEdge,
                     apart = apartOf(gap, body, support);
        const double both = a.dot(b);
        found.point = ofBody + a * ((both * b.dot(apart) - a.dot(apart)) / (1 - both * both));
    }
    return found;
}

std::vector<LastingContact> lastingContacts(const Placed& body, const Placed& support,
                                            const TouchLimits& limits) {
    std::vector<LastingContact> found;
    for (const Touch& touch : touchesOf(body, support, limits.gap)) {
        if (touch.passes(limits.slow))
            continue;
        LastingContact contact = contactOf(touch, body, support, limits);
        if (!contact.place.points.empty() || !contact.isModelled)
            found.push_back(std::move(contact));
    }
    return found;
}

} // namespace simulation
