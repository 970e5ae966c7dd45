#include "contacts/contact_places.h"

#include "contacts/contact_sides.h"
#include "contacts/in_plane.h"
#include "geometry/patch_middle.h"
#include "surfaces/hollow_walls.h"
#include "surfaces/surface_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace simulation {
namespace {

using physics::ContactPoint;
using physics::SurfaceGap;
using physics::SurfacePiece;
using Kind = SurfacePiece::Kind;
using Ends = std::pair<Vector, Vector>; // of an edge

constexpr double same = 1e-9;      // of the parts' size: a corner at a vertex, or on an edge
constexpr double kept = 2e-9;      // of the same: a gap that stays what it is
constexpr double sunk = 5e-10;     // an overlap that does
constexpr double rounding = 1e-13; // of the same, of what stands in a body's frame
// The sine of an angle: where edges of two faces on each other cross at a smaller one, the crossing
// runs along them far faster than the bodies move. It lies all but on the line between the points
// on both sides, which carry. LIMIT: it would carry up to half of that part of an edge farther out.
constexpr double nextToParallel = 1e-3;
constexpr double parallel = 1e-6; // the same: such edges do not cross

// ---------------------------------------------------------------------------------- polyhedra

// The edges of an outline (or the outline, if it is one) on which a point lies: two at a vertex.
std::vector<Ends> edgesThrough(const std::vector<Vector>& outline, const Vector& point,
                               const Vector& normal, double tolerance) {
    std::vector<Ends> found;
    const std::size_t edges = outline.size() == 2 ? 1 : outline.size();
    for (std::size_t i = 0; i < edges && outline.size() > 1; ++i) {
        const Vector &a = outline[i], &b = outline[(i + 1) % outline.size()];
        Vector off = point - a;
        const Vector way = (b - a).normalized();
        off -= way * way.dot(off);
        off -= normal * normal.dot(off);
        if (off.norm() <= tolerance)
            found.emplace_back(a, b);
    }
    return found;
}

physics::NearestSurfaces nearestOf(const SurfaceGap& gap, const Placed& body,
                                   const Placed& support) {
    return physics::nearest(gap, poseOf(body), poseOf(support));
}

// In their owner's frame.
SurfacePiece lineBetween(const Ends& ends) {
    return {
        .kind = Kind::line, .place = ends.first, .axis = (ends.second - ends.first).normalized()};
}

class Polyhedra { // in touch
public:
    // `beside`: features that overlap by less do not overlap.
    Polyhedra(const Touch& touch, const Placed& body, const Placed& support, double beside)
        : touch_(touch), body_(body), support_(support), beside_(beside) {
        bodyFace_ = touch.bodyFace.size() > 2 ? geometry::inOrder(touch.bodyFace, touch.normal)
                                              : touch.bodyFace;
        supportFace_ = touch.supportFace.size() > 2
                           ? geometry::inOrder(touch.supportFace, touch.normal)
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
            return overFace(*ofBody, body_, support_, supportFace_);
        if (bodyFace_.size() > 2 && ofSupport != supportFace_.end())
            return overFace(*ofSupport, support_, body_, bodyFace_);
        return crossingAt(corner.point);
    }

    // A point of the rim of a round end of one of the two, on the other's face.
    [[nodiscard]] ContactPoint onRim(const Vector& point, bool isBodys) const {
        return isBodys ? overFace(point, body_, support_, supportFace_)
                       : overFace(point, support_, body_, bodyFace_);
    }

private:
    // A vertex of the one over a face of the other.
    [[nodiscard]] ContactPoint overFace(const Vector& vertex, const Placed& owner,
                                        const Placed& other,
                                        const std::vector<Vector>& face) const {
        const bool isBodys = &other == &body_; // the face
        const Vector out = isBodys ? Vector(-touch_.normal) : touch_.normal;
        const SurfacePiece plane{
            .kind = Kind::plane, .place = own(other, face[0]), .axis = ownNormal(other, out)};
        const SurfacePiece at{.kind = Kind::point, .place = own(owner, vertex)};
        ContactPoint point;
        point.gap = isBodys ? SurfaceGap{plane, at, false} : SurfaceGap{at, plane, false};
        const geometry::Part& part =
            other.shape->parts[isBodys ? touch_.bodyPart : touch_.supportPart];
        Sides sides(other.index, localOf(other, vertex), touch_.size, beside_);
        if (!part.curved) {
            std::vector<Vector> outline;
            outline.reserve(face.size());
            for (const Vector& corner : face)
                outline.push_back(own(other, corner));
            sides.addOutline(outline, plane.axis);
        } else if (!part.isPlane()) {
            sides.addRound(Vector::Zero(), -1, part.curved->radius(), plane.axis,
                           part.curved->center - other.record->centroid);
        }
        point.sides = std::move(sides.sides);
        return point;
    }
    [[nodiscard]] std::optional<ContactPoint> crossingAt(const Vector& point,
                                                         bool isEnd = false) const {
        const double near = 1e-5 * touch_.size;
        Ends a, b; // those that cross most
        double across = 0;
        for (const auto& of : edgesThrough(bodyFace_, point, touch_.normal, near))
            for (const auto& other : edgesThrough(supportFace_, point, touch_.normal, near)) {
                const Vector first = (of.second - of.first).normalized();
                const Vector second = (other.second - other.first).normalized();
                if (const double turn = first.cross(second).dot(touch_.normal);
                    std::abs(turn) > std::abs(across))
                    a = of, b = other, across = turn;
            }
        if (std::abs(across) < (touch_.isFlat ? nextToParallel : parallel))
            return touch_.isFlat || isEnd ? std::nullopt : endAlong(a, b);
        const std::pair first{own(body_, a.first), own(body_, a.second)};
        const std::pair second{own(support_, b.first), own(support_, b.second)};
        ContactPoint crossing;
        crossing.gap = {
            .body = lineBetween(first), .support = lineBetween(second), .isFlipped = across < 0};
        // The lines cross elsewhere than the outlines of faces that lie on each other with a tilt.
        const Vector place = nearestOf(crossing.gap, body_, support_).contact;
        Sides ofFirst(body_.index, localOf(body_, place), touch_.size, beside_);
        ofFirst.addEnds(first.first, first.second);
        Sides ofSecond(support_.index, localOf(support_, place), touch_.size, beside_);
        ofSecond.addEnds(second.first, second.second);
        crossing.sides = std::move(ofFirst.sides);
        crossing.sides.insert(crossing.sides.end(), ofSecond.sides.begin(), ofSecond.sides.end());
        return crossing;
    }
    // A box tips about an equal one's edge: its own runs along the border, next to parallel. The
    // end of their common stretch, beside the face, stands for the crossing.
    [[nodiscard]] std::optional<ContactPoint> endAlong(const Ends& ofBody,
                                                       const Ends& ofSupport) const {
        const bool isBodys = supportFace_.size() > 2; // the edge
        if (isBodys == (bodyFace_.size() > 2))
            return std::nullopt;
        const Ends &edge = isBodys ? ofBody : ofSupport, &border = isBodys ? ofSupport : ofBody;
        const auto isOn = [&](const Vector& end, const Ends& other) { // and no corner
            const Vector along = other.second - other.first;
            const double part = along.dot(end - other.first) / along.squaredNorm();
            const auto isIt = [&](const Corner& at) { return (at.point - end).norm() <= beside_; };
            const bool isBeside = std::abs(part - 0.5) <= 0.5 + parallel;
            return isBeside && std::ranges::none_of(touch_.corners, isIt);
        };
        for (const Vector& end : {edge.first, edge.second})
            if (isOn(end, border))
                return isBodys ? overFace(end, body_, support_, supportFace_)
                               : overFace(end, support_, body_, bodyFace_);
        for (const Vector& end : {border.first, border.second})
            if (isOn(end, edge))
                return crossingAt(end, true);
        return std::nullopt;
    }
    // In the owner's frame a vertex and a normal are those of its part, without the rounding of its
    // attitude: contacts of the same vertices have the same numbers. Of two faces that are next to
    // parallel each has its own normal: along the other's it would miss what its far side does.
    [[nodiscard]] const geometry::Part& partOf(const Placed& owner) const {
        return owner.shape->parts[&owner == &body_ ? touch_.bodyPart : touch_.supportPart];
    }
    [[nodiscard]] Vector own(const Placed& owner, const Vector& point) const {
        const Vector& centroid = owner.record->centroid;
        Vector local = localOf(owner, point);
        const geometry::Part& part = partOf(owner);
        if (part.core.vertices.empty())
            return local;
        const Vector vertex = part.core.vertices[vertexAt(part, local + centroid)] - centroid;
        return (vertex - local).norm() <= rounding * touch_.size ? vertex : local;
    }
    [[nodiscard]] Vector ownNormal(const Placed& owner, const Vector& normal) const {
        const Vector local = owner.state.attitude.conjugate() * normal;
        const auto face =
            faceTowards(owner, &owner == &body_ ? touch_.bodyPart : touch_.supportPart, normal);
        return face ? face->plane.axis : local;
    }

    const Touch& touch_;
    const Placed& body_;
    const Placed& support_;
    double beside_;
    std::vector<Vector> bodyFace_, supportFace_;
};

// A sphere of one of the two, by what keeps it at its distance.
SurfaceGap roundGap(const Touch& touch, const Corner::Features& of, const Placed& body,
                    const Placed& support) {
    using Of = Corner::Features::Kind;
    SurfaceGap gap;
    gap.body.place = of.bodyPoint;
    gap.support.place = of.supportPoint;
    gap.body.radius = body.shape->parts[touch.bodyPart].radius;
    gap.support.radius = support.shape->parts[touch.supportPart].radius;
    if (of.kind == Of::onSupportPlane) {
        gap.support.kind = Kind::plane;
        gap.support.axis = of.normal;
    } else if (of.kind == Of::onBodyPlane) {
        gap.body.kind = Kind::plane;
        gap.body.axis = -of.normal;
    } else if (of.kind == Of::onLine) {
        gap.support.kind = Kind::line;
        gap.support.axis = of.edge;
    }
    return gap;
}

// Pieces that may land beside those that touch, of the one whose plane it is not: of polyhedra that
// touch at fewer points than a face has vertices that touch and part, and their neighbours; of
// a round end that lies flat its corners that part; of other curved parts all that may be lowest.
class Landings {
public:
    Landings(const Touch& touch, const Placed& body, const Placed& support,
             const std::optional<MotionPlane>& plane, physics::ContactPlace& place)
        : touch_(touch), body_(body), support_(support), plane_(plane), place_(place) {}

    void add() {
        const SurfaceGap& gap = place_.points[0].gap;
        if (touch_.hasPieces && !gap.isOnPlane())
            return;
        if (gap.body.kind != Kind::plane)
            addOf(body_, touch_.bodyPart, touch_.bodyFace, true);
        if (gap.support.kind != Kind::plane)
            addOf(support_, touch_.supportPart, touch_.supportFace, false);
    }

private:
    void addOf(const Placed& owner, std::size_t part, const std::vector<Vector>& face, bool above) {
        const geometry::Part& of = owner.shape->parts[part];
        if (of.isCapsule() || (of.curved && touch_.hasPieces))
            return addExtremes(owner, part, above);
        if (of.curved) { // a round end that lies flat, and what is at the other end
            for (const Corner& corner : touch_.corners)
                if (!corner.pieces) // what crosses a border is no point of the rim
                    addVertex(owner, localOf(owner, corner.point), above);
            for (const SurfacePiece& piece : extremesOf(owner, part))
                if (std::abs(heightOf(owner, piece, above)) > touching * touch_.size)
                    addPiece(owner, piece, above);
            return;
        }
        std::set<std::size_t> vertices;
        for (const Vector& vertex : face) {
            const std::size_t at = vertexAt(of, localOf(owner, vertex) + owner.record->centroid);
            vertices.insert(at);
            vertices.insert(of.core.neighbours[at].begin(), of.core.neighbours[at].end());
        }
        for (const std::size_t vertex : vertices)
            if (addVertex(owner, Vector(of.core.vertices[vertex] - owner.record->centroid), above))
                for (const std::size_t next : of.core.neighbours[vertex])
                    addCrossings(owner, of.core.vertices[vertex], of.core.vertices[next], above);
    }
    void addExtremes(const Placed& owner, std::size_t part, bool above) {
        for (const SurfacePiece& piece : extremesOf(owner, part)) {
            const bool isOne = std::ranges::any_of(place_.points, [&](const ContactPoint& point) {
                return isOnePiece(above ? point.gap.body : point.gap.support, piece, touch_.size);
            });
            if (!isOne)
                addPiece(owner, piece, above, !isOverFace(piece, above));
        }
    }
    [[nodiscard]] bool isOverFace(const SurfacePiece& piece, bool above) const {
        const Placed& other = above ? support_ : body_;
        const auto face = faceTowards(other, above ? touch_.supportPart : touch_.bodyPart,
                                      above ? touch_.normal : Vector(-touch_.normal));
        if (!face)
            return false;
        const SurfaceGap gap =
            above ? SurfaceGap{piece, face->plane, false} : SurfaceGap{face->plane, piece, false};
        return depthIn(*face, localOf(other, nearestOf(gap, body_, support_).contact)) >= 0;
    }
    // True: it is beneath the other's face, beside it.
    bool addVertex(const Placed& owner, const Vector& vertex, bool above) {
        const Vector at = owner.state.position + owner.state.attitude * vertex;
        for (const ContactPoint& point : place_.points) {
            Vector off = nearestOf(point.gap, body_, support_).contact - at;
            if (plane_)
                off[plane_->axis] = 0;
            if (isThere(off))
                return false; // it is that point
        }
        const bool isCorner = std::ranges::any_of(
            touch_.corners, [&](const Corner& corner) { return isThere(corner.point - at); });
        return (isCorner || !isOnEdge(at)) &&
               addPiece(owner, {.kind = Kind::point, .place = vertex}, above, !isCorner);
    }
    // An edge whose end is beneath the other's face, beside it, lands where it crosses the border.
    void addCrossings(const Placed& owner, const Vector& from, const Vector& to, bool above) {
        const Placed& other = above ? support_ : body_;
        const auto face = otherFace(above);
        const auto inWorld = [](const Placed& of, const Vector& point) {
            return Vector(of.state.position + of.state.attitude * point);
        };
        const Vector& centroid = owner.record->centroid;
        const std::pair edge{Vector(from - centroid), Vector(to - centroid)};
        const Vector start = inWorld(owner, edge.first), way = inWorld(owner, edge.second) - start;
        for (std::size_t i = 0; face && i < face->outline.size(); ++i) {
            const std::pair border{face->outline[i], face->outline[(i + 1) % face->outline.size()]};
            const Vector on = inWorld(other, border.first),
                         along = inWorld(other, border.second) - on;
            const double across = way.cross(along).dot(touch_.normal);
            if (std::abs(across) <= parallel * way.norm() * along.norm())
                continue;
            const double ofEdge = (on - start).cross(along).dot(touch_.normal) / across,
                         ofBorder = (on - start).cross(way).dot(touch_.normal) / across;
            if (std::min(ofEdge, ofBorder) < 0 || std::max(ofEdge, ofBorder) > 1)
                continue;
            const SurfacePiece first = lineBetween(edge), second = lineBetween(border);
            const bool isFlipped = above ? across < 0 : across > 0;
            addLanding(owner, first, above,
                       above ? SurfaceGap{first, second, isFlipped}
                             : SurfaceGap{second, first, isFlipped});
        }
    }
    // A piece that lies on the face already may sink by the slack before it lands.
    [[nodiscard]] double roomAt(double height) const {
        return std::max(0.0, sideSlack * touch_.size - height);
    }
    // Of a crossing, unless the contact is there already.
    void addLanding(const Placed& owner, const SurfacePiece& piece, bool above,
                    const SurfaceGap& gap) {
        const physics::NearestSurfaces nearest = nearestOf(gap, body_, support_);
        for (const ContactPoint& point : place_.points)
            if (isThere(nearestOf(point.gap, body_, support_).contact - nearest.contact))
                return;
        place_.landings.push_back({.body = owner.index,
                                   .piece = piece,
                                   .isAbove = above,
                                   .room = roomAt(nearest.gap),
                                   .gap = gap});
    }
    // A touch may be off by this along its normal; a corner above another is not that one.
    static constexpr double touching = 1e-4; // of the parts' size
    [[nodiscard]] bool isThere(const Vector& off) const {
        const double along = touch_.normal.dot(off);
        return (off - touch_.normal * along).norm() <= same * touch_.size &&
               std::abs(along) <= touching * touch_.size;
    }
    // Two points of the contact carry the edge at whose end, beside the other's face, it is: it
    // goes up and down with them. (On a step's polynomials it seems to land again and again.)
    [[nodiscard]] bool isOnEdge(const Vector& at) const {
        if (place_.points.size() != 2)
            return false;
        const Vector first = nearestOf(place_.points[0].gap, body_, support_).contact,
                     second = nearestOf(place_.points[1].gap, body_, support_).contact;
        const Vector way = second - first;
        return way.cross(at - first).norm() <= same * touch_.size * way.norm();
    }
    // Of its lowest point above the plane of the first point.
    [[nodiscard]] double heightOf(const Placed& owner, const SurfacePiece& piece,
                                  bool above) const {
        const Vector at = owner.state.position + owner.state.attitude * piece.place;
        const SurfaceGap& gap = place_.points[0].gap;
        const physics::NearestSurfaces nearest = nearestOf(gap, body_, support_);
        const Vector on =
            gap.support.kind == Kind::plane
                ? Vector(support_.state.position + support_.state.attitude * gap.support.place)
            : gap.body.kind == Kind::plane
                ? Vector(body_.state.position + body_.state.attitude * gap.body.place)
                : nearest.contact;
        // As the row has it: of two edges the gap's normal is not quite that of the touch.
        const Vector up = above ? nearest.normal : Vector(-nearest.normal);
        return up.dot(at - on) - physics::reachBelow(piece, owner.state.attitude.conjugate() * up);
    }
    [[nodiscard]] std::optional<FlatFace> otherFace(bool above) const {
        return above ? faceMostTowards(support_, touch_.supportPart, touch_.normal)
                     : faceMostTowards(body_, touch_.bodyPart, -touch_.normal);
    }
    // The plane of two edges that cross turns much where one of them tilts a little, and lowers far
    // from them: there a piece is over the other's face itself.
    [[nodiscard]] std::optional<SurfaceGap> overOtherFace(const SurfacePiece& piece,
                                                          bool above) const {
        if (place_.points[0].gap.isOnPlane())
            return std::nullopt;
        const auto face = otherFace(above);
        if (!face)
            return std::nullopt;
        return above ? SurfaceGap{piece, face->plane, false}
                     : SurfaceGap{face->plane, piece, false};
    }
    // True: it is beneath. mayBeBeneath: it is beside the other's face. What has crossed the border
    // of the face there goes on beneath its plane.
    bool addPiece(const Placed& owner, const SurfacePiece& piece, bool above,
                  bool mayBeBeneath = false) {
        const std::optional<SurfaceGap> gap = overOtherFace(piece, above);
        const double height =
            gap ? nearestOf(*gap, body_, support_).gap : heightOf(owner, piece, above);
        const bool isBeneath = mayBeBeneath && height < 0;
        const double room = isBeneath ? sideSlack * touch_.size : roomAt(height);
        place_.landings.push_back({.body = owner.index,
                                   .piece = piece,
                                   .isAbove = above,
                                   .isBeneath = isBeneath,
                                   .room = room,
                                   .gap = gap});
        return isBeneath;
    }

    const Touch& touch_;
    const Placed& body_;
    const Placed& support_;
    std::optional<MotionPlane> plane_; // in which a point stands for all across it
    physics::ContactPlace& place_;
};

// In a hollow the other vertices, or ends of a capsule, may land on the wall: also those that touch
// and part.
void addLandingsInHollow(const Touch& touch, const Placed& body, const Placed& support,
                         const TouchLimits& limits, physics::ContactPlace& place) {
    const bool isBodys = !body.shape->parts[touch.bodyPart].isHollow(); // the vertices
    const Placed& owner = isBodys ? body : support;
    const geometry::Part& part = owner.shape->parts[isBodys ? touch.bodyPart : touch.supportPart];
    for (std::size_t v = 0; v < part.core.vertices.size(); ++v) {
        if (v == *touch.vertex)
            continue;
        const PieceTouch found = vertexAtWall(body, touch.bodyPart, support, touch.supportPart, v);
        const SurfaceGap& gap = found.points[0].gap;
        const bool isInside = (isBodys ? gap.support : gap.body).radius < 0;
        const double apart = found.points[0].at.gap, least = sideSlack * touch.size;
        const Vector& at = found.points[0].at.contact;
        const double rate = found.normal.dot(body.state.velocityAt(body.state.position + at) -
                                             support.state.velocityAt(body.state.position + at));
        const bool parts = !limits.wereInContact && rate > limits.slow;
        if (isInside && (parts || apart > limits.gap * touch.size))
            place.landings.push_back({.body = owner.index,
                                      .piece = isBodys ? gap.body : gap.support,
                                      .isAbove = isBodys,
                                      .room = apart < least ? least - apart : 0,
                                      .gap = gap});
    }
}

// A coordinate that is 0 but for rounding is 0: equations have the same form each time.
Vector withoutRounding(Vector v, double size) {
    for (double& x : v)
        x = std::abs(x) <= rounding * size ? 0 : x;
    return v;
}

// The surfaces roll there: no point of either stays where they touch.
bool rolls(const ContactPoint& point) {
    const auto isRound = [](const SurfacePiece& piece) {
        return piece.kind != Kind::plane &&
               (piece.radius > 0 || piece.kind == Kind::cone || piece.kind == Kind::ellipsoid);
    };
    return isRound(point.gap.body) || isRound(point.gap.support);
}

std::optional<ContactPoint> pointAt(const Touch& touch, const Corner& corner, const Placed& body,
                                    const Placed& support, const TouchLimits& limits) {
    ContactPoint point;
    if (corner.pieces) {
        point.gap = *corner.pieces;
        point.sides = sidesOfPieces(point.gap, touch, body, support);
        return point;
    }
    if (!touch.round.isBall)
        return Polyhedra(touch, body, support, limits.gap * touch.size).pointAt(corner);
    point.gap = roundGap(touch, corner.features, body, support);
    point.sides = sidesOfRound(touch, body, support);
    return point;
}

// How the round end stands, on those of the points that it leaves.
Stand standOf(const Touch& touch, const Placed& body, const Placed& support,
              const TouchLimits& limits, std::vector<ContactPoint>& points) {
    const auto was = std::ranges::find_if(limits.stands, [&](const Stand& stand) {
        return stand.bodyPart == touch.bodyPart && stand.supportPart == touch.supportPart;
    });
    const auto onRim = [&](const Vector& at, bool isBodys) {
        return Polyhedra(touch, body, support, limits.gap * touch.size).onRim(at, isBodys);
    };
    return chooseStand(touch, body, support, was == limits.stands.end() ? nullptr : &*was, onRim,
                       points);
}

LastingContact contactOf(const Touch& touch, const Placed& body, const Placed& support,
                         const TouchLimits& limits) {
    LastingContact found{.bodyPart = touch.bodyPart,
                         .supportPart = touch.supportPart,
                         .isModelled = touch.hasPieces || touch.isFlat || touch.isModelled ||
                                       (touch.round.isBall && !touch.round.isCurved),
                         .place = {}};
    physics::ContactPlace& place = found.place;
    place.body = body.index;
    place.support = support.index;
    if (!found.isModelled)
        return found;
    place.normal = touch.normal;
    place.size = touch.size;
    place.leaving = 2 * limits.gap * touch.size;
    std::vector<Vector> corners;
    bool isAnyOut = false;
    for (const Corner& corner : touch.corners) {
        if ((corner.rate > limits.slow && !limits.wereInContact) ||
            corner.gap > limits.gap * touch.size)
            continue;
        std::optional<ContactPoint> point = pointAt(touch, corner, body, support, limits);
        if (!point) { // of next to parallel edges of two faces: points on both sides carry
            isAnyOut = true;
            continue;
        }
        point->parts = corner.rate > limits.slow;
        place.points.push_back(std::move(*point));
        corners.push_back(corner.point);
    }
    found.isModelled = !isAnyOut || (touch.isFlat && !corners.empty());
    if (corners.empty())
        return found;
    found.rolls = std::ranges::any_of(place.points, rolls);
    const bool isWhole = corners.size() == touch.corners.size() && corners.size() > 2;
    const geometry::PatchMiddle middle = geometry::middleOf(corners, touch.normal);
    if (!found.rolls && corners.size() > 1)
        place.centre = withoutRounding(localOf(body, middle.centre), touch.size);
    place.friction.reach = isWhole && touch.round.reach > 0 ? touch.round.reach : middle.reach;
    if (touch.round.isPatch && isWhole && !limits.plane && !limits.isOfBlow)
        found.stand = standOf(touch, body, support, limits, place.points);
    if (limits.plane)
        putInPlane(place, corners, *limits.plane, body, support);
    if (place.points.size() == 1)
        place.centre.reset();
    if (!(touch.round.isBall && !touch.round.isCurved) && !isWhole)
        Landings(touch, body, support, limits.plane, place).add();
    if (touch.vertex)
        addLandingsInHollow(touch, body, support, limits, place);
    for (ContactPoint& point : place.points)
        if (const double gap = nearestOf(point.gap, body, support).gap;
            limits.isStart || (point.parts && gap < 0) ||
            (gap >= -sunk * touch.size && gap <= kept * touch.size))
            point.start = gap;
    return found;
}

} // namespace

std::vector<LastingContact> lastingContacts(const Placed& body, const Placed& support,
                                            const TouchLimits& limits) {
    std::vector<LastingContact> found;
    for (const Touch& touch : touchesOf(body, support, limits.gap)) {
        const Touch* lasting = touch.lasting(limits.slow);
        if (lasting == nullptr)
            continue;
        LastingContact contact = contactOf(*lasting, body, support, limits);
        if (!contact.isModelled && lasting->rate() > limits.slow)
            continue; // it parts
        if (!contact.place.points.empty() || !contact.isModelled)
            found.push_back(std::move(contact));
    }
    return found;
}

std::vector<PointInTouch> pointsInTouch(const Placed& body, const Placed& support, double gap,
                                        const std::optional<MotionPlane>& plane) {
    const TouchLimits limits{.gap = gap, .wereInContact = true, .isOfBlow = true, .plane = plane};
    std::vector<PointInTouch> found;
    std::size_t patch = 0;
    for (const Touch& touch : touchesOf(body, support, gap)) {
        const LastingContact contact = contactOf(touch, body, support, limits);
        const auto add = [&](const Vector& point, const Vector& normal,
                             const std::optional<SurfaceGap>& of) {
            found.push_back({contact.bodyPart, contact.supportPart, patch, point, normal, of});
        };
        if (contact.isModelled)
            for (const ContactPoint& point : contact.place.points) {
                const auto near = nearestOf(point.gap, body, support);
                // Of more points than a plane needs the rates agree with one normal alone.
                const bool isOne =
                    contact.place.points.size() > 3 && isOneNormal(near.normal, touch.normal);
                add(near.contact, isOne ? touch.normal : near.normal, point.gap);
            }
        else
            for (const Corner& corner : touch.corners)
                if (corner.gap <= gap * touch.size)
                    add(corner.point, touch.normal, std::nullopt);
        ++patch;
    }
    return found;
}

} // namespace simulation
