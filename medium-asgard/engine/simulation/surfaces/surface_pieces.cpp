#include "surfaces/surface_pieces.h"

#include "collision/contact_points.h"
#include "collision/patch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulation {
namespace {

using collision::Feature;
using geometry::Curved;
using geometry::Part;
using physics::SurfaceGap;
using physics::SurfacePiece;
using Kind = SurfacePiece::Kind;

constexpr double parallel = 1e-6; // sine of an angle between axes
// Of the tolerance: less than what a point goes beyond its sides (contact_sides.h) before its
// bodies are looked at again.
constexpr double beyond = 1e-4;
constexpr double farthest = 10;    // of the tolerance: how deep what touches overlaps
constexpr double sameWay = 0.9;    // cosine between the normals of one touch
constexpr double shortest = 0.015; // of the rim's radius: half of a line across it
constexpr double steadyEnough = 2 * physics::leastSteady;

const Part& partOf(const Placed& owner, std::size_t part) { return owner.shape->parts[part]; }

Vector toWorld(const Placed& owner, const Vector& direction) {
    return owner.state.attitude * direction;
}

SurfacePiece pointAt(const Vector& place, double radius) {
    return {.kind = Kind::point, .place = place, .radius = radius};
}

SurfacePiece rimOf(const Curved& curved, const Vector& centroid, double sign) {
    return {.kind = Kind::circle,
            .place = curved.center + sign * curved.half() * curved.axis() - centroid,
            .axis = curved.axis(),
            .radius = curved.radius()};
}

SurfacePiece rimOf(const FlatFace& round) {
    return {.kind = Kind::circle,
            .place = round.plane.place,
            .axis = round.plane.axis,
            .radius = round.radius};
}

std::optional<SurfacePiece> pieceOf(const Feature& feature, const Vector& centroid) {
    SurfacePiece piece{.place = feature.place - centroid,
                       .axis = feature.axis,
                       .radius = feature.radius,
                       .sine = feature.sine,
                       .axes = feature.axes};
    switch (feature.kind) {
    case Feature::Kind::point:
        piece.kind = Kind::point;
        return piece;
    case Feature::Kind::segment:
        piece.kind = Kind::line;
        return piece;
    case Feature::Kind::circle:
        piece.kind = Kind::circle;
        return piece;
    case Feature::Kind::cone:
        piece.kind = Kind::cone;
        piece.radius = 0;
        return piece;
    case Feature::Kind::ellipsoid:
        piece.kind = Kind::ellipsoid;
        return piece;
    case Feature::Kind::face:
        break;
    }
    return std::nullopt;
}

class Pieces {
public:
    Pieces(const Placed& body, std::size_t bodyPart, const Placed& support, std::size_t supportPart,
           double tolerance)
        : body_(body), support_(support), bodyPart_(bodyPart), supportPart_(supportPart),
          tolerance_(tolerance), ofBody_(poseOf(body)), ofSupport_(poseOf(support)) {}

    PieceTouch find(const Vector& normal) {
        const PieceTouch none{.normal = normal, .points = {}, .isModelled = true};
        found_ = none;
        const auto under = faceTowards(support_, supportPart_, normal);
        const bool isAcross = !under || onFace(*under, false);
        const auto over = faceTowards(body_, bodyPart_, -normal);
        if (isAcross && over) { // a part that juts out may bear on the other's face
            const PieceTouch onSupport = std::exchange(found_, none);
            onFace(*over, true);
            if (!onSupport.points.empty() && !isLower(found_, onSupport))
                found_ = onSupport;
        }
        if (found_.points.empty()) {
            found_ = {.normal = normal, .points = {}, .isModelled = true};
            onPieces();
        }
        found_.isModelled = found_.isModelled && !found_.points.empty();
        return std::move(found_);
    }

    std::vector<PiecePoint> crossings(const Vector& normal) {
        found_.normal = normal;
        const auto over = faceTowards(body_, bodyPart_, -normal);
        const auto under = faceTowards(support_, supportPart_, normal);
        if (!over || !under || over->isEndless() || under->isEndless())
            return {};
        if (over->outline.empty() && under->outline.empty())
            rimsCross(*over, *under);
        else if (over->outline.empty())
            rimCrosses(*over, true, *under);
        else
            rimCrosses(*under, false, *over);
        return std::move(found_.points);
    }

private:
    // Places from the body's centre of mass.
    [[nodiscard]] physics::SurfacePose poseOf(const Placed& owner) const {
        return {owner.state.position - body_.state.position,
                owner.state.attitude.toRotationMatrix()};
    }
    [[nodiscard]] collision::Posed posed(const Placed& owner, std::size_t part) const {
        const physics::SurfacePose pose = poseOf(owner);
        return {.part = &partOf(owner, part),
                .rotation = pose.rotation,
                .offset = pose.centre - pose.rotation * owner.record->centroid};
    }

    // Curves that have feet begin where their pieces say; then the feet are where they touch.
    [[nodiscard]] PiecePoint pointOf(const SurfaceGap& gap) const {
        PiecePoint point{.gap = gap, .at = physics::nearest(gap, ofBody_, ofSupport_)};
        constexpr int times = 3;
        for (int i = 0; i < times && gap.hasFeet(); ++i) {
            putFoot(point.gap.body, ofBody_, point.at.contact);
            putFoot(point.gap.support, ofSupport_, point.at.contact);
            point.at = physics::nearest(point.gap, ofBody_, ofSupport_);
        }
        point.gap = physics::fromSphereIfSteady(point.gap, ofBody_, ofSupport_);
        if (point.gap.branch != 0)
            point.at = physics::nearest(point.gap, ofBody_, ofSupport_);
        return point;
    }
    // Of two curves whose normal may be the opposite one.
    [[nodiscard]] PiecePoint crossingOf(const SurfacePiece& body,
                                        const SurfacePiece& support) const {
        const PiecePoint point = pointOf({body, support, false});
        return point.at.normal.dot(found_.normal) < 0 ? pointOf({body, support, true}) : point;
    }
    // On the circle the point that is nearest to one of the world.
    static void putFoot(SurfacePiece& piece, const physics::SurfacePose& of, const Vector& point) {
        if (piece.kind != Kind::circle)
            return;
        Vector off = of.rotation.transpose() * Vector(point - of.centre) - piece.place;
        off -= piece.axis * piece.axis.dot(off);
        piece.foot = off.normalized();
    }
    // Two circles with their feet at each of their two crossings. Circles that only graze each
    // other have none.
    static std::vector<std::pair<SurfacePiece, SurfacePiece>>
    feetOnSpheres(SurfacePiece first, const physics::SurfacePose& ofFirst, SurfacePiece second,
                  const physics::SurfacePose& ofSecond) {
        std::vector<std::pair<SurfacePiece, SurfacePiece>> found;
        for (const double branch : {1.0, -1.0}) {
            const SurfaceGap gap{.body = first, .support = second, .branch = branch};
            const physics::NearestSurfaces at = physics::nearest(gap, ofFirst, ofSecond);
            if (!(at.steady > steadyEnough))
                continue;
            putFoot(first, ofFirst, at.contact);
            putFoot(second, ofSecond, at.contact);
            if (physics::fromSphereIfSteady({first, second}, ofFirst, ofSecond).branch != 0)
                found.emplace_back(first, second);
        }
        return found;
    }
    void keep(const PiecePoint& point) { found_.points.push_back(point); }

    [[nodiscard]] bool isLower(const PieceTouch& touch, const PieceTouch& other) const {
        const auto gapOf = [](const PieceTouch& of) {
            return std::ranges::min(of.points, {}, [](const PiecePoint& p) { return p.at.gap; })
                .at.gap;
        };
        return touch.isModelled && !touch.points.empty() &&
               gapOf(touch) < gapOf(other) - beyond * tolerance_;
    }

    // True: a piece of the other part lies across the border, or none on the face.
    bool onFace(const FlatFace& face, bool isBodys) {
        const Placed &owner = isBodys ? body_ : support_, &round = isBodys ? support_ : body_;
        found_.normal = toWorld(owner, face.plane.axis) * (isBodys ? -1 : 1);
        const physics::SurfacePose& ofOwner = isBodys ? ofBody_ : ofSupport_;
        bool isBeyond = false; // the border of the face
        for (const SurfacePiece& piece : extremesOf(round, isBodys ? supportPart_ : bodyPart_)) {
            if (isOverEdge(round, isBodys ? supportPart_ : bodyPart_, piece))
                continue;
            const PiecePoint point = pointOf(isBodys ? SurfaceGap{face.plane, piece, false}
                                                     : SurfaceGap{piece, face.plane, false});
            if (!(point.at.gap <= tolerance_))
                continue;
            const Vector foot =
                ofOwner.rotation.transpose() * Vector(point.at.contact - ofOwner.centre);
            if (depthIn(face, foot) < -beyond * tolerance_)
                isBeyond = true;
            else
                keep(point);
        }
        if (!isBeyond && !found_.points.empty())
            return false;
        acrossBorder(face, isBodys);
        return true;
    }

    // The outside of a bowl whose edge is lower.
    [[nodiscard]] bool isOverEdge(const Placed& round, std::size_t part,
                                  const SurfacePiece& piece) const {
        const Part& of = partOf(round, part);
        if (!of.isHollow() || of.curved->kind != Curved::Kind::bowl || piece.kind != Kind::point)
            return false;
        const Vector up = found_.normal * (&round == &body_ ? 1 : -1); // from the face
        return up.dot(toWorld(round, of.curved->axis())) < 0;
    }

    // A line lies on the face to where it crosses the border, a polyhedron with each vertex within;
    // a rim that has come over the border crosses it.
    void acrossBorder(const FlatFace& face, bool isBodys) {
        const Placed& other = isBodys ? support_ : body_;
        const std::size_t part = isBodys ? supportPart_ : bodyPart_;
        const Vector towards = found_.normal * (isBodys ? 1 : -1); // of the other part, outward
        const Feature feature = collision::bearingFeature(
            partOf(other, part), other.state.attitude.conjugate() * towards, tolerance_);
        std::optional<SurfacePiece> piece = pieceOf(feature, other.record->centroid);
        if (!piece || piece->kind > Kind::circle || face.isEndless()) {
            found_.isModelled = false;
            return;
        }
        if (partOf(other, part).isPolyhedron())
            for (const double end : {-0.5, 0.5})
                if (end < 0 || piece->kind == Kind::line)
                    keepOver(face, isBodys,
                             pointAt(piece->place + end * feature.length * piece->axis, 0));
        if (piece->kind == Kind::point)
            return;
        if (piece->kind == Kind::circle)
            piece->foot = footOf(*piece, other.state.attitude.conjugate() * towards);
        if (face.outline.empty())
            acrossRim(face, isBodys, *piece, feature.length);
        else
            acrossOutline(face, isBodys, *piece, feature.length);
    }

    // Of the circle the point furthest along a direction, from its centre.
    static Vector footOf(const SurfacePiece& circle, const Vector& direction) {
        return (direction - circle.axis * circle.axis.dot(direction)).normalized();
    }

    void keepOver(const FlatFace& face, bool isBodys, const SurfacePiece& vertex) {
        const PiecePoint point = pointOf(isBodys ? SurfaceGap{face.plane, vertex, false}
                                                 : SurfaceGap{vertex, face.plane, false});
        const physics::SurfacePose& of = isBodys ? ofBody_ : ofSupport_;
        if (point.at.gap <= tolerance_ &&
            depthIn(face, of.rotation.transpose() * Vector(point.at.contact - of.centre)) >= 0)
            keep(point);
    }

    // The crossing of the other's piece, of this length, and a piece of the face's border.
    void keepCrossing(const FlatFace& face, bool isBodys, const SurfacePiece& border,
                      const SurfacePiece& piece, double length) {
        const PiecePoint point = isBodys ? crossingOf(border, piece) : crossingOf(piece, border);
        const physics::SurfacePose& ofOwner = isBodys ? ofBody_ : ofSupport_;
        const physics::SurfacePose& ofOther = isBodys ? ofSupport_ : ofBody_;
        const Vector at = ofOwner.rotation.transpose() * Vector(point.at.contact - ofOwner.centre);
        const Vector on = ofOther.rotation.transpose() * Vector(point.at.contact - ofOther.centre);
        const bool isIn =
            piece.kind == Kind::circle || std::abs(piece.axis.dot(on - piece.place)) <= length / 2;
        if (isIn && depthIn(face, at) >= -tolerance_ && isThere(point))
            keep(point);
    }
    // A crossing was found, near where the parts touch.
    [[nodiscard]] bool isThere(const PiecePoint& point) const {
        return !point.gap.isCrossing() ||
               (point.at.gap <= tolerance_ && point.at.gap >= -farthest * tolerance_ &&
                point.at.normal.dot(found_.normal) > sameWay && point.at.steady > steadyEnough);
    }

    // A vertex of the face that lies under a side, of this length.
    bool keepUnder(bool isBodys, const Vector& vertex, const SurfacePiece& side, double length) {
        const Placed &owner = isBodys ? body_ : support_, &other = isBodys ? support_ : body_;
        if (side.kind != Kind::line || !(side.radius > 0))
            return false;
        const Vector apart = owner.state.position - other.state.position;
        const Vector off =
            other.state.attitude.conjugate() * Vector(toWorld(owner, vertex) + apart) - side.place;
        const Vector across = toWorld(other, Vector(off - side.axis * side.axis.dot(off)));
        if ((across - found_.normal * found_.normal.dot(across)).norm() > tolerance_ ||
            std::abs(side.axis.dot(off)) > length / 2)
            return false;
        const SurfacePiece corner = pointAt(vertex, 0);
        keep(pointOf(isBodys ? SurfaceGap{corner, side, false} : SurfaceGap{side, corner, false}));
        return true;
    }

    void acrossOutline(const FlatFace& face, bool isBodys, const SurfacePiece& piece,
                       double pieceLength) {
        const Placed &owner = isBodys ? body_ : support_, &other = isBodys ? support_ : body_;
        const Vector along = owner.state.attitude.conjugate() * toWorld(other, piece.axis);
        const std::size_t size = face.outline.size();
        std::vector<char> isUnder(size, 0); // a side that lies on this vertex
        for (std::size_t i = 0; i < size; ++i)
            isUnder[i] = keepUnder(isBodys, face.outline[i], piece, pieceLength);
        for (std::size_t i = 0; i < size; ++i) {
            const Vector &from = face.outline[i], &to = face.outline[(i + 1) % size];
            if (isUnder[i] || isUnder[(i + 1) % size])
                continue;
            const Vector way = (to - from).normalized();
            const SurfacePiece edge{.kind = Kind::line, .place = (from + to) / 2, .axis = way};
            if (piece.kind == Kind::line && way.cross(along).norm() < parallel) {
                const Vector apart = other.state.position - owner.state.position;
                const Vector at =
                    owner.state.attitude.conjugate() * Vector(toWorld(other, piece.place) + apart);
                const double in = face.plane.axis.cross(way).dot(at - from);
                const double length = (to - from).norm();
                if (in < 0 && in >= -tolerance_)
                    return isBodys ? sideBySide(edge, length, piece, pieceLength)
                                   : sideBySide(piece, pieceLength, edge, length);
                continue;
            }
            keepCrossing(face, isBodys, edge, piece, pieceLength);
        }
    }

    void acrossRim(const FlatFace& face, bool isBodys, const SurfacePiece& piece, double length) {
        SurfacePiece rim = rimOf(face);
        const physics::SurfacePose& ofOwner = isBodys ? ofBody_ : ofSupport_;
        const physics::SurfacePose& ofOther = isBodys ? ofSupport_ : ofBody_;
        const auto turned = [&](const Vector& direction) {
            return Vector(ofOwner.rotation.transpose() * (ofOther.rotation * direction));
        };
        const Vector apart = ofOwner.rotation.transpose() * (ofOther.centre - ofOwner.centre) +
                             turned(piece.place) - rim.place;
        if (piece.kind == Kind::circle) {
            if (const auto pairs = feetOnSpheres(rim, ofOwner, piece, ofOther); !pairs.empty()) {
                for (const auto& [own, other] : pairs)
                    keepCrossing(face, isBodys, own, other, length);
                return;
            }
            rim.foot = footOf(rim, apart + piece.radius * turned(piece.foot));
            return keepCrossing(face, isBodys, rim, piece, length);
        }
        const Vector way = footOf(rim, turned(piece.axis));
        Vector nearest = apart - way * way.dot(apart);
        nearest -= rim.axis * rim.axis.dot(nearest);
        const double half = std::sqrt(1 - nearest.squaredNorm() / (rim.radius * rim.radius));
        if (!(half > shortest)) {
            const Vector along = turned(piece.axis);
            const double at = way.dot(nearest - apart) / way.dot(along);
            return touchingRim(face, isBodys, rim.radius * nearest.normalized(),
                               pointAt(piece.place + at * piece.axis, piece.radius), piece);
        }
        for (const double sign : {-1.0, 1.0}) {
            rim.foot = nearest / rim.radius + sign * half * way;
            keepCrossing(face, isBodys, rim, piece, length);
        }
    }

    // A line lies next to the outermost point of the rim: its own point there is on the face, or,
    // beyond the rim, a round one is on that point of the rim. LIMIT: the line's ends on the rim
    // are less than 0.03 of its radius apart.
    void touchingRim(const FlatFace& face, bool isBodys, const Vector& out,
                     const SurfacePiece& point, const SurfacePiece& line) {
        keepOver(face, isBodys, point);
        if (!found_.points.empty() || !(line.radius > 0))
            return;
        const SurfacePiece vertex = pointAt(face.plane.place + out, 0);
        keep(pointOf(isBodys ? SurfaceGap{vertex, line, false} : SurfaceGap{line, vertex, false}));
    }

    // A round end, the body's or the support's, and a face with edges.
    void rimCrosses(const FlatFace& round, bool isBodys, const FlatFace& face) {
        const physics::SurfacePose& of = isBodys ? ofBody_ : ofSupport_;
        const physics::SurfacePose& ofFace = isBodys ? ofSupport_ : ofBody_;
        SurfacePiece rim = rimOf(round);
        for (std::size_t i = 0; i < face.outline.size(); ++i) {
            const Vector &from = face.outline[i], &to = face.outline[(i + 1) % face.outline.size()];
            const double length = (to - from).norm();
            const SurfacePiece edge{
                .kind = Kind::line, .place = (from + to) / 2, .axis = (to - from) / length};
            const Vector way = of.rotation.transpose() * (ofFace.rotation * edge.axis);
            Vector off = of.rotation.transpose() *
                             Vector(ofFace.centre + ofFace.rotation * from - of.centre) -
                         rim.place;
            off -= rim.axis * rim.axis.dot(off);
            const double middle = -way.dot(off);
            const Vector nearest = off + middle * way;
            const double half =
                std::sqrt(std::max(0.0, rim.radius * rim.radius - nearest.squaredNorm()));
            for (const double sign : {-1.0, 1.0})
                if (const double at = middle + sign * half;
                    half > shortest * rim.radius && at >= 0 && at <= length) {
                    rim.foot = (nearest + sign * half * way).normalized();
                    keepIfThere(isBodys ? crossingOf(rim, edge) : crossingOf(edge, rim));
                }
        }
    }

    void rimsCross(const FlatFace& over, const FlatFace& under) {
        SurfacePiece body = rimOf(over), support = rimOf(under);
        const Vector axis = ofBody_.rotation * body.axis;
        const Vector middle = ofBody_.centre + ofBody_.rotation * body.place;
        Vector apart = ofSupport_.centre + ofSupport_.rotation * support.place - middle;
        apart -= axis * axis.dot(apart);
        const double length = apart.norm();
        // From the body's middle on: to the line through both crossings, and half of that line.
        const double to =
            (length * length + body.radius * body.radius - support.radius * support.radius) /
            (2 * length);
        const double square = body.radius * body.radius - to * to;
        const double smaller = std::min(body.radius, support.radius);
        if (!(square > shortest * shortest * smaller * smaller))
            return;
        for (const double sign : {-1.0, 1.0}) {
            const Vector out =
                to / length * apart + sign * std::sqrt(square) / length * axis.cross(apart);
            putFoot(body, ofBody_, middle + out);
            putFoot(support, ofSupport_, middle + out);
            keepIfThere(crossingOf(body, support));
        }
    }

    void keepIfThere(const PiecePoint& point) {
        if (isThere(point))
            keep(point);
    }

    [[nodiscard]] std::optional<SurfacePiece> bearing(const Placed& owner, std::size_t part,
                                                      const Vector& direction, double tolerance,
                                                      double& length) const {
        const Feature feature = collision::bearingFeature(
            partOf(owner, part), owner.state.attitude.conjugate() * direction, tolerance);
        length = feature.length;
        return pieceOf(feature, owner.record->centroid);
    }

    // Those of the finest tolerance that are known: what has just left a face is on its edge.
    void onPieces() {
        const Vector& n = found_.normal;
        std::optional<SurfacePiece> body, support;
        double first = 0, second = 0; // lengths
        for (const double part : {10 * beyond, 0.1 * beyond, 1.0}) {
            body = bearing(body_, bodyPart_, -n, part * tolerance_, first);
            support = bearing(support_, supportPart_, n, part * tolerance_, second);
            if (body && support && physics::haveGap(body->kind, support->kind))
                break;
        }
        if (!body || !support) {
            found_.isModelled = false;
            return;
        }
        const bool areLines = body->kind == Kind::line && support->kind == Kind::line;
        if (areLines &&
            toWorld(body_, body->axis).cross(toWorld(support_, support->axis)).norm() < parallel)
            return sideBySide(*body, first, *support, second);
        if (areLines) {
            const Vector at = crossingOf(*body, *support).at.contact;
            const SurfacePiece own = upToEnd(body_, bodyPart_, *body, first, at);
            *support = upToEnd(support_, supportPart_, *support, second, at);
            *body = own;
        }
        if (!physics::haveGap(body->kind, support->kind)) {
            found_.isModelled = false;
            return;
        }
        if (body->kind == Kind::circle)
            body->foot = footOf(*body, body_.state.attitude.conjugate() * -n);
        if (support->kind == Kind::circle)
            support->foot = footOf(*support, support_.state.attitude.conjugate() * n);
        const PiecePoint point = crossingOf(*body, *support);
        if (!isThere(point)) {
            found_.isModelled = false;
            return;
        }
        found_.normal = point.at.normal;
        keep(point);
    }

    // The line, or what it has at the end beyond which it would touch: a rim, a round end, a
    // vertex. (Of axes that are next to parallel a crossing beyond an end overlaps by nothing.)
    [[nodiscard]] SurfacePiece upToEnd(const Placed& owner, std::size_t part,
                                       const SurfacePiece& line, double length,
                                       const Vector& contact) const {
        const physics::SurfacePose& pose = &owner == &body_ ? ofBody_ : ofSupport_;
        const Vector off = pose.rotation.transpose() * Vector(contact - pose.centre) - line.place;
        const double along = line.axis.dot(off);
        if (std::abs(along) <= length / 2)
            return line;
        const Part& of = partOf(owner, part);
        const double end = along > 0 ? 1 : -1;
        if (!of.curved)
            return pointAt(line.place + end * length / 2 * line.axis, line.radius);
        const double sign = of.curved->axis().dot(line.axis) > 0 ? end : -end;
        return rimOf(*of.curved, owner.record->centroid, sign);
    }

    // Of both ends of the common stretch, whosever they are.
    void sideBySide(const SurfacePiece& body, double first, const SurfacePiece& support,
                    double second) {
        const Vector middle = ofBody_.rotation * body.place + ofBody_.centre;
        const Vector axis = ofBody_.rotation * body.axis;
        const Vector apart = ofSupport_.rotation * support.place + ofSupport_.centre - middle;
        const double other = axis.dot(apart);
        const bool isAlike = axis.dot(ofSupport_.rotation * support.axis) > 0;
        for (const double end : {-1.0, 1.0}) {
            const double own = end * first / 2, its = other + end * second / 2;
            const bool isOwn = end * own <= end * its;
            if (isOwn) {
                const Vector place = body.place + own * body.axis;
                keep(pointOf({pointAt(place, body.radius), support, false}));
            } else {
                const double way = (isAlike ? end : -end) * second / 2;
                const Vector place = support.place + way * support.axis;
                keep(pointOf({body, pointAt(place, support.radius), false}));
            }
        }
        found_.normal = found_.points[0].at.normal;
    }

    const Placed& body_;
    const Placed& support_;
    std::size_t bodyPart_, supportPart_;
    double tolerance_;
    physics::SurfacePose ofBody_, ofSupport_;
    PieceTouch found_;
};

} // namespace

std::vector<SurfacePiece> extremesOf(const Placed& owner, std::size_t part) {
    const Part& of = partOf(owner, part);
    const Vector& centroid = owner.record->centroid;
    std::vector<SurfacePiece> pieces;
    if (of.isSphere() || of.isCapsule())
        for (const Vector& end : of.core.vertices)
            pieces.push_back(pointAt(end - centroid, of.radius));
    if (!of.curved)
        return pieces;
    switch (of.curved->kind) {
    case Curved::Kind::bowl: // what of it is lowest: its outside, or the edge
        return {pointAt(of.curved->center - centroid, of.curved->radius()),
                rimOf(*of.curved, centroid, 1)};
    case Curved::Kind::cylinder:
    case Curved::Kind::tube:
        if (!(of.curved->half() > 0)) // a disc
            return {rimOf(*of.curved, centroid, 1)};
        return {rimOf(*of.curved, centroid, -1), rimOf(*of.curved, centroid, 1)};
    case Curved::Kind::cone:
        return {rimOf(*of.curved, centroid, -1),
                pointAt(of.curved->center + of.curved->half() * of.curved->axis() - centroid, 0)};
    case Curved::Kind::ellipsoid:
        return {{.kind = Kind::ellipsoid,
                 .place = of.curved->center - centroid,
                 .axis = of.curved->axis(),
                 .axes = of.curved->frame * of.curved->sizes.asDiagonal()}};
    case Curved::Kind::plane:
        break;
    }
    return pieces;
}

PieceTouch pieceTouch(const Placed& body, std::size_t bodyPart, const Placed& support,
                      std::size_t supportPart, const Vector& normal, double tolerance) {
    return Pieces(body, bodyPart, support, supportPart, tolerance).find(normal);
}

std::vector<PiecePoint> crossingsOfBorders(const Placed& body, std::size_t bodyPart,
                                           const Placed& support, std::size_t supportPart,
                                           const Vector& normal, double tolerance) {
    return Pieces(body, bodyPart, support, supportPart, tolerance).crossings(normal);
}

bool isOnePiece(const SurfacePiece& a, const SurfacePiece& b, double size) {
    constexpr double near = 1e-6;
    if (a.kind != b.kind || (a.axis - b.axis).norm() > near)
        return false;
    const bool isEndless = a.kind == Kind::plane || a.kind == Kind::line;
    return isEndless || (a.place - b.place).norm() <= near * size;
}

} // namespace simulation
