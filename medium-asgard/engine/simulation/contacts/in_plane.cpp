#include "contacts/in_plane.h"

#include "contacts/contact_sides.h"

#include <cmath>
#include <utility>

namespace simulation {
namespace {

using geometry::Matrix;
using physics::ContactPoint;
using physics::SurfaceGap;
using physics::SurfacePiece;
using Kind = SurfacePiece::Kind;

constexpr double negligible = 1e-9; // of the parts' size, and of unit vectors

// For each of the points the place of the one that stands for it in the plane, or, between the
// outermost two, none; nothing for points that do not lie symmetrically.
std::vector<std::size_t> standing(const std::vector<Vector>& points, const MotionPlane& plane,
                                  double size) {
    const double near = negligible * size;
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
    Vector along = Vector::Zero(); // the face's line in the plane
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (first[i] != i)
            continue;
        if (!(std::abs(sums[i] / counts[i] - plane.at) <= near))
            return {};
        Vector way = points[i] - points[0];
        way[plane.axis] = 0;
        if (way.norm() > along.norm())
            along = way;
    }
    std::size_t low = 0, high = 0; // furthest along it
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (first[i] == i && along.dot(points[i] - points[low]) < 0)
            low = i;
        if (first[i] == i && along.dot(points[i] - points[high]) > 0)
            high = i;
    }
    for (std::size_t i = 0; i < points.size(); ++i)
        if (first[i] == i && i != low && i != high)
            first[i] = points.size(); // between them
    return first;
}

// Of a point in the plane.
struct InPlane {
    SurfaceGap gap;
    Matrix follows = Matrix::Identity(); // how it moves in space as it moves in the plane
    bool isAcrossRim = false;            // on a round end, the rim of which it was on
};

class Flattening {
public:
    Flattening(const MotionPlane& plane, const Placed& body, const Placed& support)
        : plane_(plane), body_(body), support_(support), across_(Vector::Unit(plane.axis)) {}

    // Nothing for two edges askew to the plane.
    [[nodiscard]] std::optional<InPlane> of(const SurfaceGap& gap) const {
        InPlane found{.gap = gap};
        SurfacePiece &first = found.gap.body, &second = found.gap.support;
        const Vector normal = physics::nearest(gap, poseOf(body_), poseOf(support_)).normal;
        found.follows -= across_ * across_.transpose();
        if (gap.isCrossing()) {
            atFoot(first, body_);
            atFoot(second, support_);
        }
        const bool isFirst = isAcross(first, body_), isSecond = isAcross(second, support_);
        const bool isAnyRim = first.kind == Kind::circle || second.kind == Kind::circle;
        const bool isSharp = isAnyRim || first.radius + second.radius == 0;
        if (isFirst)
            atPlane(first, body_, plane_.at);
        if (isSecond)
            atPlane(second, support_, plane_.at);
        if (!found.gap.isOnPlane() && isFirst != isSecond) {
            SurfacePiece& other = isFirst ? second : first;
            const Placed& owner = isFirst ? support_ : body_;
            found.isAcrossRim = other.kind == Kind::circle;
            if (other.kind == Kind::line)
                follow(owner.state.attitude * other.axis, found.follows);
            if (isSharp)
                other = planeAt(other.place, owner, isFirst ? normal : Vector(-normal));
        } else if (!found.gap.isOnPlane() && first.kind == Kind::line &&
                   second.kind == Kind::line) {
            const bool isAlong = isInPlane(first, body_);
            SurfacePiece &along = isAlong ? first : second, &askew = isAlong ? second : first;
            if ((!isAlong && !isInPlane(second, support_)) || askew.radius > 0)
                return std::nullopt;
            atPlane(askew, isAlong ? support_ : body_, acrossAt(along, isAlong ? body_ : support_));
            if (isSharp)
                along = planeAt(along.place, isAlong ? body_ : support_,
                                isAlong ? Vector(-normal) : normal);
        }
        put(first, body_);
        put(second, support_);
        return found;
    }

private:
    // A rim that a line only touches has one point there, in the plane.
    void atFoot(SurfacePiece& piece, const Placed& owner) const {
        const Vector foot = owner.state.attitude * piece.foot;
        if (piece.kind == Kind::circle && std::abs(foot.dot(across_)) <= negligible)
            piece = {.kind = Kind::point, .place = piece.place + piece.radius * piece.foot};
    }
    [[nodiscard]] double acrossOf(const SurfacePiece& piece, const Placed& owner) const {
        return std::abs(across_.dot(owner.state.attitude * piece.axis));
    }
    [[nodiscard]] bool isAcross(const SurfacePiece& piece, const Placed& owner) const {
        const bool hasAxis = piece.kind == Kind::line || piece.kind == Kind::circle;
        return hasAxis && acrossOf(piece, owner) >= 1 - negligible;
    }
    [[nodiscard]] bool isInPlane(const SurfacePiece& piece, const Placed& owner) const {
        return acrossOf(piece, owner) <= negligible;
    }
    [[nodiscard]] double acrossAt(const SurfacePiece& piece, const Placed& owner) const {
        return across_.dot(owner.state.position + owner.state.attitude * piece.place);
    }
    // The point of a line at this place across the plane.
    void atPlane(SurfacePiece& piece, const Placed& owner, double place) const {
        const double along = across_.dot(owner.state.attitude * piece.axis);
        piece.place += piece.axis * ((place - acrossAt(piece, owner)) / along);
        piece.kind = Kind::point;
        piece.axis = Vector::UnitX();
    }
    // An edge across the plane crosses a line along this way.
    void follow(const Vector& way, Matrix& follows) const {
        const Vector within = way - across_ * across_.dot(way);
        follows += across_ * (across_.dot(way) / within.squaredNorm() * within.transpose());
    }
    [[nodiscard]] static SurfacePiece planeAt(const Vector& place, const Placed& owner,
                                              const Vector& outward) {
        return {.kind = Kind::plane,
                .place = place,
                .axis = owner.state.attitude.conjugate() * outward};
    }
    void put(SurfacePiece& piece, const Placed& owner) const {
        const Vector at = owner.state.position + owner.state.attitude * piece.place;
        const Vector off = (plane_.at - across_.dot(at)) * across_;
        piece.place += owner.state.attitude.conjugate() * off;
        if (!owner.record->isFixed)
            piece.place[plane_.axis] = 0;
        if (piece.kind != Kind::plane && piece.kind != Kind::line)
            return;
        Vector axis = owner.state.attitude * piece.axis;
        if (axis[plane_.axis] == 0)
            return;
        axis[plane_.axis] = 0;
        piece.axis = owner.state.attitude.conjugate() * axis.normalized();
    }

    const MotionPlane& plane_;
    const Placed& body_;
    const Placed& support_;
    Vector across_;
};

// The sides of a point, for the same point in the plane.
class SidesInPlane {
public:
    SidesInPlane(const ContactPoint& point, const InPlane& flat, const MotionPlane& plane,
                 double size, const Placed& body, const Placed& support)
        : point_(point), flat_(flat), plane_(plane), size_(size), body_(body), support_(support),
          before_(physics::nearest(point.gap, poseOf(body), poseOf(support))),
          after_(physics::nearest(flat.gap, poseOf(body), poseOf(support))) {}

    [[nodiscard]] std::vector<ContactPoint::Side> sides() const {
        std::vector<ContactPoint::Side> found;
        for (const ContactPoint::Side& side : point_.sides) {
            const Placed& owner = side.body == body_.index ? body_ : support_;
            const bool isRims = flat_.isAcrossRim && &owner == &rimsOwner();
            if (isRims || isAcross(side, owner))
                continue;
            found.push_back(moved(side, owner));
        }
        if (flat_.isAcrossRim)
            found.push_back(onEnd());
        return found;
    }

private:
    [[nodiscard]] const Placed& rimsOwner() const {
        return point_.gap.body.kind == Kind::circle ? body_ : support_;
    }
    // The ends of an edge across the plane: they do not count there.
    [[nodiscard]] bool isAcross(const ContactPoint::Side& side, const Placed& owner) const {
        const Vector inward = owner.state.attitude * side.inward;
        return side.radial == 0 && std::abs(inward[plane_.axis]) >= 1 - negligible;
    }
    // In the owner's frame.
    [[nodiscard]] static Vector placeOf(const ContactPoint::Side& side, const Placed& owner,
                                        const physics::NearestSurfaces& at) {
        return localOf(owner, at.place + side.shift * at.normal);
    }
    [[nodiscard]] ContactPoint::Side moved(ContactPoint::Side side, const Placed& owner) const {
        const Vector from = placeOf(side, owner, before_), to = placeOf(side, owner, after_);
        const Vector inward = owner.state.attitude * side.inward;
        const double now = side.inward.dot(from) + side.offset;
        side.inward = owner.state.attitude.conjugate() * Vector(flat_.follows.transpose() * inward);
        side.offset = now - side.inward.dot(to);
        Vector across = owner.state.attitude * Vector(from - to); // a vertex stays beside
        across -= Vector::Unit(plane_.axis) * across[plane_.axis];
        side.on += owner.state.attitude.conjugate() * Vector(across) - (from - to);
        return side;
    }
    // An edge across a round end has its ends on the rim; in the plane its point is on the end from
    // one side of the rim to the other.
    [[nodiscard]] ContactPoint::Side onEnd() const {
        const Placed& owner = rimsOwner();
        const bool isBodys = &owner == &body_;
        const SurfacePiece& rim = isBodys ? point_.gap.body : point_.gap.support;
        Sides sides(owner.index, localOf(owner, after_.contact), size_);
        sides.addRound(Vector::Zero(), -1, rim.radius, rim.axis, rim.place);
        return sides.sides[0];
    }

    const ContactPoint& point_;
    const InPlane& flat_;
    const MotionPlane& plane_;
    double size_;
    const Placed& body_;
    const Placed& support_;
    physics::NearestSurfaces before_, after_;
};

} // namespace

void putInPlane(physics::ContactPlace& place, const std::vector<Vector>& corners,
                const MotionPlane& plane, const Placed& body, const Placed& support) {
    const std::vector<std::size_t> first = standing(corners, plane, place.size);
    if (first.empty() || std::abs(place.normal[plane.axis]) > negligible)
        return;
    std::vector<ContactPoint> points;
    std::vector<std::size_t> pointOf(first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] == first.size() || first[first[i]] != first[i])
            continue; // between them
        const ContactPoint& point = place.points[i];
        const auto flat = Flattening(plane, body, support).of(point.gap);
        if (!flat)
            return;
        const auto sides = SidesInPlane(point, *flat, plane, place.size, body, support).sides();
        if (first[i] == i) {
            pointOf[i] = points.size();
            points.push_back(point);
            points.back().gap = flat->gap;
            points.back().sides.clear();
        }
        auto& all = points[pointOf[first[i]]].sides;
        all.insert(all.end(), sides.begin(), sides.end());
    }
    place.points = std::move(points);
    place.normal[plane.axis] = 0;
    place.normal.normalize();
    if (place.centre)
        (*place.centre)[plane.axis] = 0;
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

} // namespace simulation
