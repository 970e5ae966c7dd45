#include "contacts/contact_places.h"

#include "contacts/contact_landings.h"
#include "contacts/contact_sides.h"
#include "contacts/in_plane.h"
#include "geometry/patch_middle.h"
#include "surfaces/surface_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace simulation {
namespace {

using physics::ContactPoint;
using physics::SurfaceGap;
using physics::SurfacePiece;
using Kind = SurfacePiece::Kind;

constexpr double kept = 2e-9;      // of the parts' size: a gap that stays what it is
constexpr double sunk = 5e-10;     // an overlap that does
constexpr double rounding = 1e-13; // of the same, of what stands in a body's frame
// The sine of an angle: where edges of two faces on each other cross at a smaller one, the crossing
// runs along them far faster than the bodies move. It lies all but on the line between the points
// on both sides, which carry. LIMIT: it would carry up to half of that part of an edge farther out.
constexpr double nextToParallel = 1e-3;

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

class Polyhedra { // in touch
public:
    Polyhedra(const Touch& touch, const Placed& body, const Placed& support,
              const TouchLimits& limits)
        : touch_(touch), body_(body), support_(support), beside_(limits.gap * touch.size),
          beyond_(limits.beyond * touch.size) {
        bodyFace_ = touch.bodyFace.size() > 2 ? geometry::inOrder(touch.bodyFace, touch.normal)
                                              : touch.bodyFace;
        supportFace_ = touch.supportFace.size() > 2
                           ? geometry::inOrder(touch.supportFace, touch.normal)
                           : touch.supportFace;
    }

    [[nodiscard]] std::optional<ContactPoint> pointAt(const Corner& corner) const {
        const double near = samePlace * touch_.size;
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
    // Of edges with these ends, each in its body's frame.
    [[nodiscard]] ContactPoint crossingOf(const SurfaceGap& gap, const Ends& first,
                                          const Ends& second) const {
        ContactPoint crossing;
        crossing.gap = gap;
        // The lines cross elsewhere than the outlines of faces that lie on each other with a tilt.
        const Vector place = nearestOf(crossing.gap, body_, support_).contact;
        Sides ofFirst = sidesAt(body_, place);
        ofFirst.addEnds(first.first, first.second);
        Sides ofSecond = sidesAt(support_, place);
        ofSecond.addEnds(second.first, second.second);
        crossing.sides = std::move(ofFirst.sides);
        crossing.sides.insert(crossing.sides.end(), ofSecond.sides.begin(), ofSecond.sides.end());
        return crossing;
    }

private:
    [[nodiscard]] Sides sidesAt(const Placed& owner, const Vector& place) const {
        Sides sides(owner.index, localOf(owner, place), touch_.size, beside_);
        sides.letBeyond(beyond_);
        return sides;
    }
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
        Sides sides = sidesAt(other, vertex);
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
    [[nodiscard]] double leastAcross() const { return touch_.isFlat ? nextToParallel : uncrossing; }
    struct Crossing {
        Ends ofBody, ofSupport;
        double across = 0; // the sine of their angle
    };
    // Of the edges through a point those that cross within both, or least beyond an end: at corners
    // of equal faces on each other two pairs cross next to it. If all are next to parallel, those
    // that cross most.
    [[nodiscard]] Crossing crossingEdges(const Vector& point) const {
        constexpr double never = std::numeric_limits<double>::infinity();
        const double near = 1e-5 * touch_.size, none = samePlace * touch_.size;
        Crossing best;
        double least = never;
        for (const auto& of : edgesThrough(bodyFace_, point, touch_.normal, near))
            for (const auto& other : edgesThrough(supportFace_, point, touch_.normal, near)) {
                const Crossing found{of, other, acrossOf(of, other)};
                const bool crosses = std::abs(found.across) >= leastAcross();
                const double beyond = crosses ? std::max(none, beyondEnds(found)) : never;
                if (beyond < least ||
                    (!(beyond > least) && std::abs(found.across) > std::abs(best.across))) {
                    best = found;
                    least = beyond;
                }
            }
        return best;
    }
    [[nodiscard]] double acrossOf(const Ends& a, const Ends& b) const {
        const Vector first = (a.second - a.first).normalized();
        const Vector second = (b.second - b.first).normalized();
        return first.cross(second).dot(touch_.normal);
    }
    // How far the place where they cross lies beyond the nearest of their ends; 0: within both.
    [[nodiscard]] double beyondEnds(const Crossing& of) const {
        const Vector first = of.ofBody.second - of.ofBody.first,
                     second = of.ofSupport.second - of.ofSupport.first,
                     between = of.ofSupport.first - of.ofBody.first;
        const double across = first.cross(second).dot(touch_.normal);
        const double onFirst = between.cross(second).dot(touch_.normal) / across,
                     onSecond = between.cross(first).dot(touch_.normal) / across;
        return std::max({0.0, std::max(-onFirst, onFirst - 1) * first.norm(),
                         std::max(-onSecond, onSecond - 1) * second.norm()});
    }
    [[nodiscard]] std::optional<ContactPoint> crossingAt(const Vector& point,
                                                         bool isEnd = false) const {
        const auto [a, b, across] = crossingEdges(point);
        if (std::abs(across) < leastAcross())
            return touch_.isFlat || isEnd ? std::nullopt : endAlong(a, b);
        const std::pair first{own(body_, a.first), own(body_, a.second)};
        const std::pair second{own(support_, b.first), own(support_, b.second)};
        return crossingOf(
            {.body = lineBetween(first), .support = lineBetween(second), .isFlipped = across < 0},
            first, second);
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
            const bool isBeside = std::abs(part - 0.5) <= 0.5 + uncrossing;
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
    double beside_, beyond_; // features that overlap by less than the first do not overlap
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

// Adds the pieces that may land. Edges that have landed on the border of the other's face, with an
// end beside it, become points of the contact: a touch has the corners of one edge alone. A box
// that tips about the edge of an equal one, a little turned against it, lands where its side
// crosses that edge.
void addLandingsAndLanded(const Touch& touch, const Placed& body, const Placed& support,
                          const TouchLimits& limits, physics::ContactPlace& place,
                          std::vector<Vector>& corners) {
    constexpr double nextTo = 1e-5; // of the parts' size: that point stands for it
    const std::size_t before = place.points.size();
    for (const EdgeCrossing& crossing : addLandings(touch, body, support, limits.plane, place)) {
        const physics::NearestSurfaces at = nearestOf(crossing.gap, body, support);
        const double rate =
            at.normal.dot(body.state.velocityAt(at.contact) - support.state.velocityAt(at.contact));
        const bool isCarried = std::ranges::any_of(place.points, [&](const ContactPoint& point) {
            const Vector carries = nearestOf(point.gap, body, support).contact;
            return (carries - at.contact).norm() <= nextTo * touch.size;
        });
        const bool approaches = rate < -limits.slow && !limits.isOfBlow; // it will land
        if (isCarried || approaches || rate > limits.slow ||
            std::abs(at.gap) > limits.gap * touch.size || at.gap > sideSlack * touch.size)
            continue;
        place.points.push_back(Polyhedra(touch, body, support, limits)
                                   .crossingOf(crossing.gap, crossing.ofBody, crossing.ofSupport));
        corners.push_back(at.contact);
    }
    if (place.points.size() == before)
        return;
    place.landings.clear(); // some have landed, and others are no longer beside the contact
    (void)addLandings(touch, body, support, limits.plane, place);
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
        return Polyhedra(touch, body, support, limits).pointAt(corner);
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
        return Polyhedra(touch, body, support, limits).onRim(at, isBodys);
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
    std::size_t out = 0;
    for (const Corner& corner : touch.corners) {
        if ((corner.rate > limits.slow && !limits.wereInContact) ||
            corner.gap > limits.gap * touch.size)
            continue;
        std::optional<ContactPoint> point = pointAt(touch, corner, body, support, limits);
        if (!point) { // of next to parallel edges of two faces: points on both sides carry
            ++out;
            continue;
        }
        point->parts = corner.rate > limits.slow;
        place.points.push_back(std::move(*point));
        corners.push_back(corner.point);
    }
    found.isModelled = out == 0 || (touch.isFlat && !corners.empty());
    if (corners.empty())
        return found;
    found.rolls = std::ranges::any_of(place.points, rolls);
    const bool isWhole = corners.size() + out == touch.corners.size() && corners.size() > 2;
    const bool hasLandings = !(touch.round.isBall && !touch.round.isCurved) && !isWhole;
    if (hasLandings && !limits.plane)
        addLandingsAndLanded(touch, body, support, limits, place, corners);
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
    if (hasLandings && limits.plane)
        (void)addLandings(touch, body, support, limits.plane, place);
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
