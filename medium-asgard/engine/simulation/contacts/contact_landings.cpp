#include "contacts/contact_landings.h"

#include "surfaces/hollow_walls.h"
#include "surfaces/surface_pieces.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace simulation {
namespace {

using physics::ContactPoint;
using physics::SurfaceGap;
using physics::SurfacePiece;
using Kind = SurfacePiece::Kind;

// Pieces that may land beside those that touch, of the one whose plane it is not: of polyhedra that
// touch at fewer points than a face has vertices that touch and part, and their neighbours; of
// a round end that lies flat its corners that part; of other curved parts all that may be lowest.
class Landings {
public:
    Landings(const Touch& touch, const Placed& body, const Placed& support,
             const std::optional<MotionPlane>& plane, physics::ContactPlace& place)
        : touch_(touch), body_(body), support_(support), plane_(plane), place_(place) {}

    std::vector<EdgeCrossing> add() {
        const SurfaceGap& gap = place_.points[0].gap;
        if (touch_.hasPieces && !gap.isOnPlane())
            return {};
        if (gap.body.kind != Kind::plane)
            addOf(body_, touch_.bodyPart, touch_.bodyFace, true);
        if (gap.support.kind != Kind::plane)
            addOf(support_, touch_.supportPart, touch_.supportFace, false);
        return std::move(crossings_);
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
        bool isAnyBeneath = false;
        for (const std::size_t vertex : vertices)
            if (addVertex(owner, Vector(of.core.vertices[vertex] - owner.record->centroid),
                          above)) {
                isAnyBeneath = true;
                for (const std::size_t next : of.core.neighbours[vertex])
                    addCrossings(owner, of.core.vertices[vertex], of.core.vertices[next], above);
            }
        if (isAnyBeneath && place_.points[0].gap.isOnPlane())
            addCornersOver(owner, above);
    }
    // A corner of the other's face may be over the face of a vertex that is beneath the other's
    // face, beside it: the corner lands there, though no edges cross.
    void addCornersOver(const Placed& owner, bool above) {
        const auto face = otherFace(above), own = otherFace(!above);
        if (!face || !own)
            return;
        for (const Vector& corner : face->outline) {
            const SurfacePiece piece{.kind = Kind::point, .place = corner};
            const SurfaceGap gap =
                above ? SurfaceGap{own->plane, piece, false} : SurfaceGap{piece, own->plane, false};
            const Vector at = nearestOf(gap, body_, support_).contact;
            if (depthIn(*own, localOf(owner, at)) >= 0 && !isOnEdge(at))
                addLanding(above ? support_ : body_, piece, !above, gap);
        }
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
            if (std::abs(across) <= uncrossing * way.norm() * along.norm())
                continue;
            const double ofEdge = (on - start).cross(along).dot(touch_.normal) / across,
                         ofBorder = (on - start).cross(way).dot(touch_.normal) / across;
            if (std::min(ofEdge, ofBorder) < 0 || std::max(ofEdge, ofBorder) > 1)
                continue;
            const SurfacePiece first = lineBetween(edge), second = lineBetween(border);
            const bool isFlipped = above ? across < 0 : across > 0;
            const SurfaceGap gap =
                above ? SurfaceGap{first, second, isFlipped} : SurfaceGap{second, first, isFlipped};
            if (addLanding(owner, first, above, gap))
                crossings_.push_back({gap, above ? edge : border, above ? border : edge});
        }
    }
    // A piece that lies on the face already may sink by the slack before it lands.
    [[nodiscard]] double roomAt(double height) const {
        return std::max(0.0, sideSlack * touch_.size - height);
    }
    // Of a crossing. False: the contact is there already.
    bool addLanding(const Placed& owner, const SurfacePiece& piece, bool above,
                    const SurfaceGap& gap) {
        const physics::NearestSurfaces nearest = nearestOf(gap, body_, support_);
        for (const ContactPoint& point : place_.points)
            if (isThere(nearestOf(point.gap, body_, support_).contact - nearest.contact))
                return false;
        place_.landings.push_back({.body = owner.index,
                                   .piece = piece,
                                   .isAbove = above,
                                   .room = roomAt(nearest.gap),
                                   .gap = gap});
        return true;
    }
    // A touch may be off by this along its normal; a corner above another is not that one.
    static constexpr double touching = 1e-4; // of the parts' size
    [[nodiscard]] bool isThere(const Vector& off) const {
        const double along = touch_.normal.dot(off);
        return (off - touch_.normal * along).norm() <= samePlace * touch_.size &&
               std::abs(along) <= touching * touch_.size;
    }
    // Two points of the contact carry the edge at whose end, beside the other's face, it is: it
    // goes up and down with them. (On a step's polynomials it seems to land again and again.)
    [[nodiscard]] bool isOnEdge(const Vector& at) const {
        if (place_.points.size() != 2 ||
            std::ranges::any_of(place_.points, &ContactPoint::parts)) // that one carries nothing
            return false;
        const Vector first = nearestOf(place_.points[0].gap, body_, support_).contact,
                     second = nearestOf(place_.points[1].gap, body_, support_).contact;
        const Vector way = second - first;
        return way.cross(at - first).norm() <= samePlace * touch_.size * way.norm();
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
    std::vector<EdgeCrossing> crossings_;
};

} // namespace

std::vector<EdgeCrossing> addLandings(const Touch& touch, const Placed& body, const Placed& support,
                                      const std::optional<MotionPlane>& plane,
                                      physics::ContactPlace& place) {
    return Landings(touch, body, support, plane, place).add();
}

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

} // namespace simulation
