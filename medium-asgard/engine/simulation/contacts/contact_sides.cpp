#include "contacts/contact_sides.h"

#include "collision/nearest_feature.h"
#include "surfaces/surface_pieces.h"

#include <algorithm>
#include <cmath>

namespace simulation {

using geometry::Curved;
using geometry::Part;
using physics::ContactPoint;
using physics::SurfacePiece;
using Piece = SurfacePiece::Kind;

Vector localOf(const Placed& owner, const Vector& point) {
    return owner.state.attitude.conjugate() * Vector(point - owner.state.position);
}

std::vector<Vector> localOf(const Placed& owner, const std::vector<Vector>& points) {
    std::vector<Vector> local;
    local.reserve(points.size());
    for (const Vector& point : points)
        local.push_back(localOf(owner, point));
    return local;
}

physics::SurfacePose poseOf(const Placed& owner) {
    return {owner.state.position, owner.state.attitude.toRotationMatrix()};
}

physics::NearestSurfaces nearestOf(const physics::SurfaceGap& gap, const Placed& body,
                                   const Placed& support) {
    return physics::nearest(gap, poseOf(body), poseOf(support));
}

SurfacePiece lineBetween(const Ends& ends) {
    return {
        .kind = Piece::line, .place = ends.first, .axis = (ends.second - ends.first).normalized()};
}

std::size_t vertexAt(const Part& part, const Vector& place) {
    const auto& vertices = part.core.vertices;
    const auto nearest = std::ranges::min_element(
        vertices, {}, [&](const Vector& vertex) { return (vertex - place).squaredNorm(); });
    return static_cast<std::size_t>(nearest - vertices.begin());
}

void Sides::moveAlong(const Vector& normal, double shift) {
    place_ += normal * shift;
    shift_ = shift;
}

double Sides::roomFor(double inside) const {
    if (inside < 0)
        return std::max(slack_ - 2 * inside, beside_ + slack_);
    return inside > slack_ ? std::min(border_, slack_) : slack_ + beyond_;
}

void Sides::add(const Vector& inward, const Vector& on) {
    const double now = inward.dot(place_ - on);
    sides.push_back({.body = body_,
                     .inward = inward,
                     .offset = -inward.dot(on) + roomFor(now),
                     .shift = shift_});
}

void Sides::addRound(const Vector& inward, double radial, double offset, const Vector& axis,
                     const Vector& on) {
    const Vector from = place_ - on;
    const double now = inward.dot(from) + radial * axis.cross(from).norm() + offset;
    sides.push_back({.body = body_,
                     .inward = inward,
                     .offset = offset - inward.dot(on) + roomFor(now),
                     .shift = shift_,
                     .radial = radial,
                     .axis = axis,
                     .on = on});
}

void Sides::addOutline(const std::vector<Vector>& outline, const Vector& normal) {
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

void Sides::addEnds(const Vector& from, const Vector& to) {
    const Vector way = (to - from).normalized();
    add(way, from);
    add(-way, to);
}

namespace {

constexpr double rimTilt = 0.1; // of a contact's normal from a round end's

// The cell of the feature (of the support's part, as vertices) in which the centre lies.
void addCell(const Part& part, const Vector& centroid, const std::vector<std::size_t>& feature,
             Sides& sides) {
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

void addCellOf(const Curved& curved, const Vector& centroid, const SurfacePiece& piece, double size,
               Sides& sides) {
    const Vector axis = curved.axis(), middle = curved.center - centroid;
    const double r = curved.radius(), half = curved.half();
    const bool isCylinder =
        curved.kind == Curved::Kind::cylinder || curved.kind == Curved::Kind::tube;
    if (isCylinder && piece.kind == Piece::line)
        return sides.addEnds(middle - half * axis, middle + half * axis);
    if (isCylinder && piece.kind == Piece::circle) {
        const Vector out = axis.dot(piece.place - middle) > 0 ? axis : Vector(-axis);
        sides.add(out, piece.place);
        return sides.addRound(Vector::Zero(), 1, -r, axis, piece.place);
    }
    if (isCylinder && piece.kind == Piece::point) { // of a rim: until all of the rim may touch
        const double cosine = std::cos(rimTilt);
        const Vector out = axis.dot(piece.place - middle) > 0 ? axis : Vector(-axis);
        return sides.add(out, piece.place + size * cosine * out);
    }
    if (curved.kind == Curved::Kind::bowl && piece.kind == Piece::point)
        return sides.add(-axis, middle);
    if (curved.kind == Curved::Kind::bowl && piece.kind == Piece::circle) {
        sides.add(axis, middle);
        return sides.addRound(Vector::Zero(), 1, -r, axis, middle);
    }
    if (curved.kind != Curved::Kind::cone)
        return;
    // Along the lines of a cone, from its apex down: sine times the distance from the axis, and
    // cosine times the depth.
    const double slant = std::hypot(r, 2 * half), cosine = 2 * half / slant, sine = r / slant;
    const Vector apex = middle + half * axis;
    if (piece.kind == Piece::point)
        return sides.addRound(cosine * axis, -sine, 0, axis, apex);
    if (piece.kind == Piece::cone) {
        sides.addRound(-cosine * axis, sine, 0, axis, apex);
        return sides.addRound(cosine * axis, -sine, slant, axis, apex);
    }
    sides.addRound(-cosine * axis, sine, -slant, axis, apex);
    sides.addRound(Vector::Zero(), 1, -r, axis, middle);
}

void addCellOf(const Placed& owner, std::size_t index, const SurfacePiece& piece, double size,
               Sides& sides) {
    const Part& part = owner.shape->parts[index];
    const Vector& centroid = owner.record->centroid;
    if (part.curved)
        return addCellOf(*part.curved, centroid, piece, size, sides);
    const auto& vertices = part.core.vertices;
    if (part.isCapsule()) {
        const Vector from = vertices[0] - centroid, to = vertices[1] - centroid;
        if (piece.kind == Piece::line)
            return sides.addEnds(from, to);
        const bool isFirst = (piece.place - from).norm() < (piece.place - to).norm();
        const Vector way = (to - from).normalized();
        return sides.add(isFirst ? Vector(-way) : way, isFirst ? from : to);
    }
    if (part.isSphere())
        return;
    if (piece.kind == Piece::point)
        return addCell(part, centroid, {vertexAt(part, piece.place + centroid)}, sides);
    for (const geometry::Edge& edge : part.core.edges) {
        const auto isOn = [&](std::size_t vertex) {
            const Vector off = vertices[vertex] - centroid - piece.place;
            return piece.axis.cross(off).norm() <= sideSlack * size;
        };
        if (isOn(edge.from) && isOn(edge.to))
            return addCell(part, centroid, {edge.from, edge.to}, sides);
    }
}

// Of a hollow part's piece, where it is what is nearest to a ball's centre.
void addWall(const Curved& curved, const Vector& centroid, const SurfacePiece& piece,
             Sides& sides) {
    const Vector axis = curved.axis(), middle = curved.center - centroid;
    const bool isTube = curved.kind == Curved::Kind::tube;
    if (isTube && piece.kind == Piece::line)
        return sides.addEnds(middle - curved.half() * axis, middle + curved.half() * axis);
    if (!isTube && piece.kind == Piece::point)
        return sides.add(-axis, middle);
    const Vector out = axis.dot(piece.place - middle) < 0 ? Vector(-axis) : axis;
    sides.add(out, piece.place); // beyond an end
    const auto from = [&](double radius) {
        sides.addRound(Vector::Zero(), 1, -radius, axis, middle);
    };
    const auto upTo = [&](double radius) {
        sides.addRound(Vector::Zero(), -1, radius, axis, middle);
    };
    const bool isEdge = piece.kind == Piece::circle && piece.radius > curved.inner;
    if (piece.kind == Piece::plane || isEdge)
        from(isEdge ? curved.radius() : curved.inner);
    if (!isEdge)
        upTo(piece.kind == Piece::plane ? curved.radius() : curved.inner);
}

} // namespace

std::vector<ContactPoint::Side> sidesOfRound(const Touch& touch, const Placed& body,
                                             const Placed& support) {
    const Part& bodyPart = body.shape->parts[touch.bodyPart];
    const Part& supportPart = support.shape->parts[touch.supportPart];
    if (bodyPart.isSphere() && supportPart.isSphere())
        return {};
    const bool isBodys = bodyPart.isSphere(); // the sphere
    const Placed &round = isBodys ? body : support, &flat = isBodys ? support : body;
    const Part &sphere = isBodys ? bodyPart : supportPart,
               &polyhedron = isBodys ? supportPart : bodyPart;
    if (polyhedron.isPlane())
        return {};
    const Vector centre =
        localOf(flat, Vector(round.state.position +
                             round.state.attitude * (sphere.center() - round.record->centroid)));
    const collision::Posed posed{.part = &polyhedron,
                                 .rotation = geometry::Matrix::Identity(),
                                 .offset = -flat.record->centroid};
    const collision::NearestFeature feature =
        collision::nearestFeature(posed, centre, touch.round.border);
    Sides sides(flat.index, centre, touch.size);
    sides.endAtBorders(2 * touch.round.border);
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

std::vector<ContactPoint::Side> sidesOfPieces(const physics::SurfaceGap& gap, const Touch& touch,
                                              const Placed& body, const Placed& support) {
    const physics::NearestSurfaces at = physics::nearest(gap, poseOf(body), poseOf(support));
    std::vector<ContactPoint::Side> found;
    for (const Placed* owner : {&body, &support}) {
        const bool isBodys = owner == &body;
        const SurfacePiece& piece = isBodys ? gap.body : gap.support;
        const std::size_t part = isBodys ? touch.bodyPart : touch.supportPart;
        const Vector outward = isBodys ? Vector(-at.normal) : at.normal;
        if (gap.isOnPlane() && piece.kind != Piece::plane)
            continue; // others land
        Sides sides(owner->index, localOf(*owner, at.place), touch.size);
        if (touch.vertex) { // at a wall
            if (const Part& own = owner->shape->parts[part]; own.isHollow())
                addWall(*own.curved, owner->record->centroid, piece, sides);
            found.insert(found.end(), sides.sides.begin(), sides.sides.end());
            continue;
        }
        const std::optional<FlatFace> face = faceTowards(*owner, part, outward);
        if (piece.kind == Piece::plane && face && !face->outline.empty()) {
            sides.addOutline(face->outline, face->plane.axis);
        } else if (piece.kind == Piece::plane && face && !face->isEndless()) {
            sides.addRound(Vector::Zero(), -1, face->radius, face->plane.axis, face->plane.place);
        } else if (piece.kind != Piece::plane) {
            if (gap.hasFeet() && piece.kind == Piece::circle)
                sides.add(piece.foot,
                          piece.place + piece.radius * std::cos(at.nearFoot()) * piece.foot);
            sides.moveAlong(owner->state.attitude.conjugate() * at.normal,
                            isBodys ? -touch.size : touch.size);
            addCellOf(*owner, part, piece, touch.size, sides);
        }
        found.insert(found.end(), sides.sides.begin(), sides.sides.end());
    }
    return found;
}

} // namespace simulation
