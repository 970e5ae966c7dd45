#include "contacts/touching.h"

#include "geometry/patch_middle.h"

#include "collision/hollow_separation.h"
#include "collision/nearest_feature.h"
#include "collision/patch.h"
#include "collision/separation.h"
#include "geometry/outline.h"
#include "surfaces/hollow_walls.h"
#include "surfaces/posed_parts.h"
#include "surfaces/surface_pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace simulation {
namespace {

using collision::Posed;
using geometry::besideOutline;
using geometry::Part;
using FeatureKind = Corner::Features::Kind;

bool isCurved(const Part& part) { return part.isCapsule() || (part.curved && !part.isPlane()); }

double sizeOf(const Part& part) {
    if (part.isPlane()) // never the smaller one
        return HUGE_VAL;
    return geometry::radiusAbout(part, part.core.vertices[0]) + part.radius;
}

// The pair of parts and the features in which they touch.
class Pairing {
public:
    Pairing(const Placed& body, std::size_t bodyPart, const Placed& support,
            std::size_t supportPart, double tolerance)
        : body_(body), support_(support), origin_(body.state.position),
          first_(posed(body, bodyPart, origin_)), second_(posed(support, supportPart, origin_)) {
        touch.bodyPart = bodyPart;
        touch.supportPart = supportPart;
        touch.round.isBall = first_.part->isSphere() || second_.part->isSphere();
        touch.round.isCurved = isCurved(*first_.part) || isCurved(*second_.part);
        hasPlane_ = first_.part->isPlane() || second_.part->isPlane();
        touch.size = std::min(sizeOf(*first_.part), sizeOf(*second_.part));
        tolerance_ = tolerance * touch.size;
    }

    bool find() {
        collision::WarmStart cold;
        const collision::Separation separation = collision::separate(first_, second_, cold);
        touch.gap = separation.gap;
        touch.normal = separation.normal;
        if (std::abs(touch.gap) > 10 * tolerance_ || touch.gap > tolerance_)
            return false;
        if (touch.round.isCurved) {
            addCurved();
            return true;
        }
        if (!touch.round.isBall && !hasPlane_)
            preferFaces();
        addCorners();
        // A patch with an area, what is round, and what is on a half space, has one normal.
        if (touch.corners.size() < 3 && !touch.round.isBall && !hasPlane_)
            addOthers();
        return true;
    }

    // In a hollow each vertex touches for itself, and so does each edge at the rim.
    [[nodiscard]] std::vector<Touch> atWall() const {
        std::vector<Touch> found;
        for (const collision::BallAtWall& ball :
             collision::ballsAtWall(first_, second_, 10 * tolerance_)) {
            if (ball.separation.gap > tolerance_)
                continue;
            Pairing one = *this;
            one.touch.gap = ball.separation.gap;
            one.touch.normal = ball.separation.normal;
            one.touch.vertex = ball.vertex;
            if (ball.vertex)
                one.addPieces(
                    vertexAtWall(body_, touch.bodyPart, support_, touch.supportPart, *ball.vertex));
            else
                one.addUnmodelled(*ball.separation.touch);
            found.push_back(std::move(one.touch));
        }
        return found;
    }
    [[nodiscard]] bool isHollow() const {
        return collision::isHollowPair(*first_.part, *second_.part);
    }

    Touch touch;

private:
    void addUnmodelled(const Vector& point) {
        touch.isModelled = false;
        add(FeatureKind::onSupportPlane, point, point, point, 0);
        touch.corners.back().gap = touch.gap;
    }
    // Two faces that are next to parallel, at whose corner two corners touch, are one axis. LIMIT:
    // so are two faces of one body that an edge bends by less than 5.7 degrees.
    void addOthers() {
        constexpr double another = 0.995; // cosine
        std::vector<Vector> known{touch.normal};
        for (const collision::Separation& axis :
             collision::axesOfTouch(first_, second_, tolerance_)) {
            const Vector& normal = axis.normal;
            const bool isNew = std::ranges::none_of(
                known, [&](const Vector& k) { return k.dot(normal) > another; });
            if (!isNew)
                continue;
            known.push_back(normal);
            Pairing other = *this;
            other.touch.others.clear();
            other.touch.corners.clear();
            other.touch.bodyFace.clear();
            other.touch.supportFace.clear();
            other.touch.normal = normal;
            other.touch.gap = axis.gap;
            other.addCorners();
            touch.others.push_back(std::move(other.touch));
        }
    }

    void addCorners() {
        if (first_.part->isSphere())
            return addRound();
        if (second_.part->isSphere())
            return addOnRound();
        auto facing = collision::facingFeatures(first_, second_, touch.normal, tolerance_);
        ofBody_ = std::move(facing.first);
        ofSupport_ = std::move(facing.second);
        addPatch();
    }

    // A round end that lies flat is a face with many corners. All else touches with pieces.
    void addCurved() {
        auto facing = collision::facingFeatures(first_, second_, touch.normal, tolerance_);
        ofBody_ = std::move(facing.first);
        ofSupport_ = std::move(facing.second);
        if (ofBody_.size() > 2 && ofSupport_.size() > 2) {
            addPatch();
            if (touch.corners.size() >= 2 * enough && !carryAcrossBorder())
                thinOut();
            return;
        }
        keepFaces();
        addPieces(pieceTouch(body_, touch.bodyPart, support_, touch.supportPart, touch.normal,
                             tolerance_));
        if (touch.hasPieces)
            return;
        touch.corners.clear();
        touch.isModelled = false;
        for (const Vector& corner :
             collision::patchOf(first_, second_, touch.normal, tolerance_, tolerance_).corners)
            add(FeatureKind::onSupportPlane, corner, corner, corner, 0);
    }

    static constexpr std::size_t enough = 16; // corners of a round patch

    // Of many corners of a round end that lies on a face in part, some of its rim carry, the
    // vertices of the other face, and where the borders cross. False: it lies on it as a whole, or
    // borders all but touch.
    bool carryAcrossBorder() {
        const std::vector<PiecePoint> crossings = crossingsOfBorders(
            body_, touch.bodyPart, support_, touch.supportPart, touch.normal, tolerance_);
        if (crossings.empty())
            return false;
        touch.corners.clear();
        addWithin(body_, touch.bodyPart, ofBody_, support_, touch.supportPart);
        addWithin(support_, touch.supportPart, ofSupport_, body_, touch.bodyPart);
        for (const PiecePoint& point : crossings) {
            const Vector& at = point.at.contact;
            add(FeatureKind::onSupportPlane, at, at, ofSupport_[0], 0);
            touch.corners.back().gap = point.at.gap;
            touch.corners.back().pieces = point.gap;
        }
        touch.round.isPatch = true;
        return true;
    }
    // Corners of an outline within the border of the other's face; of a round one every fourth.
    void addWithin(const Placed& owner, std::size_t part, const std::vector<Vector>& outline,
                   const Placed& other, std::size_t otherPart) {
        const bool isBodys = &owner == &body_;
        const auto face =
            faceTowards(other, otherPart, isBodys ? touch.normal : Vector(-touch.normal));
        const std::size_t step = isCurved(owner.shape->parts[part]) ? 4 : 1;
        for (std::size_t i = 0; face && i < outline.size(); i += step) {
            const Vector& corner = outline[i];
            if (depthIn(*face, intoFrame(other, origin_ + corner)) < 0)
                continue;
            const Vector under =
                onto(isBodys ? second_ : first_, isBodys ? ofSupport_ : ofBody_, corner);
            add(FeatureKind::onSupportPlane, corner, isBodys ? corner : under,
                isBodys ? under : corner, 0);
        }
    }

    void addPieces(const PieceTouch& found) {
        touch.hasPieces = found.isModelled;
        if (!found.isModelled)
            return;
        touch.normal = found.normal;
        for (const PiecePoint& point : found.points) {
            const Vector& at = point.at.contact;
            add(FeatureKind::onSupportPlane, at, at, at, 0);
            touch.corners.back().gap = point.at.gap;
            touch.corners.back().pieces = point.gap;
        }
    }

    // Of many corners of a round patch some carry as well, from one on that lies along an axis of
    // the world, as those of a scene in a plane do.
    void thinOut() {
        const std::size_t step = touch.corners.size() / enough;
        touch.round.reach = reachOfRound();
        std::vector<Corner> kept;
        const auto first = std::ranges::max_element(
            touch.corners, {}, [](const Corner& corner) { return corner.point.x(); });
        const auto start = static_cast<std::size_t>(first - touch.corners.begin());
        for (std::size_t i = 0; i < touch.corners.size(); i += step)
            kept.push_back(touch.corners[(start + i) % touch.corners.size()]);
        touch.corners = std::move(kept);
        touch.round.isPatch = true;
    }

    // Two thirds of the radius where its corners lie on a circle.
    [[nodiscard]] double reachOfRound() const {
        constexpr double ofRadius = 1e-9;
        std::vector<Vector> corners;
        for (const Corner& corner : touch.corners)
            corners.push_back(corner.point);
        const geometry::PatchMiddle middle = geometry::middleOf(corners, touch.normal);
        const double radius = (corners[0] - middle.centre).norm();
        const double rounding = ofRadius * radius + resolution::ofPlaces * middle.centre.norm();
        const bool isCircle = std::ranges::all_of(corners, [&](const Vector& corner) {
            return std::abs((corner - middle.centre).norm() - radius) <= rounding;
        });
        return isCircle ? 2 * radius / 3 : middle.reach;
    }

    // Of a polyhedron, that in whose cell the sphere's centre lies; the normal away from it.
    [[nodiscard]] collision::NearestFeature under(const Posed& centre, const Posed& polyhedron) {
        const Vector place = centre.world(0);
        const double coordinates = origin_.cwiseAbs().maxCoeff() +
                                   polyhedron.offset.cwiseAbs().maxCoeff() +
                                   (hasPlane_ ? 0 : sizeOf(*polyhedron.part));
        touch.round.border = resolution::ofPlaces * coordinates;
        collision::NearestFeature feature =
            collision::nearestFeature(polyhedron, place, touch.round.border);
        touch.gap = feature.distance - centre.part->radius;
        return feature;
    }

    // How far what lies furthest against a face of one of the two, within the tolerance, lies
    // beside that face.
    [[nodiscard]] double besideFace(const Vector& normal, bool isSupports, double tolerance) const {
        const collision::FacingFeatures facing =
            collision::facingFeatures(first_, second_, normal, tolerance);
        return isSupports ? besideOutline(facing.first, facing.second, normal)
                          : besideOutline(facing.second, facing.first, normal);
    }

    // The gap is along one normal; where a face has all but that gap, its own normal is the
    // contact's. Of two faces the one along which the gap is larger: along the other it is that
    // of a vertex beside the face. Where faces all but lie on each other, gaps do not tell, and the
    // vertex itself does. The support's comes first where both are as good: it is the larger one,
    // mostly. A face is not touched by vertices that lie beside it, however near its plane they
    // are.
    void preferFaces() {
        const auto gapAlong = [this](const Vector& n) {
            return n.dot(first_.world(first_.support(-n)) - second_.world(second_.support(n))) -
                   first_.part->radius - second_.part->radius;
        };
        const Vector ofSupport = faceNormal(second_, touch.normal);
        const Vector ofBody = -faceNormal(first_, -touch.normal);
        const double alongSupport = gapAlong(ofSupport), alongBody = gapAlong(ofBody);
        const double same = asGood * touch.size;
        const bool isSupports =
            std::abs(alongSupport - alongBody) > same
                ? alongSupport > alongBody
                : besideFace(ofSupport, true, same) <= besideFace(ofBody, false, same);
        const double gap = isSupports ? alongSupport : alongBody;
        const Vector& normal = isSupports ? ofSupport : ofBody;
        if (gap >= touch.gap - tolerance_ &&
            besideFace(normal, isSupports, tolerance_) <= tolerance_) {
            touch.normal = normal;
            touch.gap = gap;
        }
    }

    // Places here are relative to the origin, near both.
    void add(FeatureKind kind, const Vector& point, const Vector& bodyPoint,
             const Vector& supportPoint, double radius) {
        Corner corner;
        corner.point = origin_ + point;
        Corner::Features& of = corner.features;
        of.kind = kind;
        of.bodyPoint = intoFrame(body_, origin_ + bodyPoint);
        of.supportPoint = intoFrame(support_, origin_ + supportPoint);
        of.normal = turnedInto(kind == FeatureKind::onBodyPlane ? body_ : support_, touch.normal);
        if (kind == FeatureKind::onLine)
            of.edge = turnedInto(support_, Vector(ofSupport_[1] - ofSupport_[0]).normalized());
        const bool isOnPlane =
            kind == FeatureKind::onSupportPlane || kind == FeatureKind::onBodyPlane;
        corner.gap = isOnPlane ? touch.normal.dot(bodyPoint - supportPoint) - radius : touch.gap;
        corner.rate = touch.normal.dot(body_.state.velocityAt(corner.point) -
                                       support_.state.velocityAt(corner.point));
        touch.corners.push_back(corner);
    }

    // A corner of a patch lies halfway between the surfaces: the point of a feature that is over or
    // under it.
    [[nodiscard]] Vector onto(const Posed& owner, const std::vector<Vector>& feature,
                              const Vector& corner) const {
        const Vector& n = touch.normal;
        if (feature.size() == 1)
            return feature[0];
        if (feature.size() == 2) {
            const Vector along = feature[1] - feature[0];
            const Vector flat = along - n * n.dot(along);
            return feature[0] + along * (flat.dot(corner - feature[0]) / flat.squaredNorm());
        }
        const bool isBodys = &owner == &first_;
        const Vector face = faceNormal(owner, isBodys ? Vector(-n) : n);
        return corner + n * (face.dot(feature[0] - corner) / face.dot(n));
    }

    // A sphere of the body.
    void addRound() {
        const Vector centre = first_.world(0);
        const double radius = first_.part->radius;
        if (second_.part->isSphere())
            return add(FeatureKind::onPoint, centre - radius * touch.normal, centre,
                       second_.world(0), radius + second_.part->radius);
        collision::NearestFeature feature = under(first_, second_);
        touch.normal = feature.normal;
        ofSupport_ = std::move(feature.corners);
        const Vector place = centre - radius * touch.normal;
        if (ofSupport_.size() > 2) {
            add(FeatureKind::onSupportPlane, place, centre, ofSupport_[0], radius);
        } else if (ofSupport_.size() == 2) {
            add(FeatureKind::onLine, place, centre, ofSupport_[0], radius);
        } else {
            add(FeatureKind::onPoint, place, centre, ofSupport_[0], radius);
        }
    }

    // A polyhedron on a sphere of the support.
    void addOnRound() {
        const Vector centre = second_.world(0);
        const double radius = second_.part->radius;
        collision::NearestFeature feature = under(second_, first_);
        touch.normal = -feature.normal;
        ofBody_ = std::move(feature.corners);
        const Vector place = centre + radius * touch.normal;
        if (ofBody_.size() > 2) {
            add(FeatureKind::onBodyPlane, place, ofBody_[0], centre, radius);
        } else {
            add(FeatureKind::onPoint, place, ofBody_[0], centre, radius);
        }
    }

    void keepFaces() {
        for (const auto& [from, to] :
             {std::pair(&ofBody_, &touch.bodyFace), {&ofSupport_, &touch.supportFace}})
            for (const Vector& vertex : *from)
                to->push_back(origin_ + vertex);
    }

    void addPatch() {
        const bool onFace = ofSupport_.size() > 2, byFace = ofBody_.size() > 2;
        const auto corners =
            collision::patchOf(first_, second_, touch.normal, tolerance_, tolerance_).corners;
        touch.isFlat = onFace && byFace && corners.size() > 2;
        keepFaces();
        if (onFace || byFace) {
            for (const Vector& corner : corners)
                if (onFace)
                    add(FeatureKind::onSupportPlane, corner, onto(first_, ofBody_, corner),
                        ofSupport_[0], 0);
                else
                    add(FeatureKind::onBodyPlane, corner, ofBody_[0],
                        onto(second_, ofSupport_, corner), 0);
        } else if (ofBody_.size() == 2 && ofSupport_.size() == 2 && corners.size() == 1) {
            add(FeatureKind::onPoint, corners[0], corners[0], corners[0], 0);
        } else {
            touch.isModelled = false;
            add(FeatureKind::onSupportPlane, corners[0], corners[0], corners[0], 0);
        }
    }

    static constexpr double asGood = 1e-9; // of the parts' size: gaps that count as the same
    const Placed& body_;
    const Placed& support_;
    Vector origin_;
    Posed first_, second_;
    double tolerance_ = 0;
    bool hasPlane_ = false;
    std::vector<Vector> ofBody_, ofSupport_;
};

} // namespace

double Touch::rate() const {
    double least = HUGE_VAL;
    for (const Corner& corner : corners)
        least = std::min(least, corner.rate);
    return least;
}

const Touch* Touch::lasting(double speed) const {
    const Touch* found = nullptr; // the one along which they do not approach
    const auto look = [&](const Touch& touch) {
        if (touch.rate() < -speed)
            return true;
        const bool isOnly = found == nullptr && touch.rate() <= speed;
        found = &touch;
        return isOnly;
    };
    if (others.empty())
        return this;
    if (!look(*this) || !std::ranges::all_of(others, look))
        return nullptr;
    return found == nullptr ? this : found;
}

std::vector<Touch> touchesOf(const Placed& body, const Placed& support, double tolerance) {
    std::vector<Touch> touches;
    for (std::size_t i = 0; i < body.shape->parts.size(); ++i)
        for (std::size_t j = 0; j < support.shape->parts.size(); ++j) {
            if (body.shape->parts[i].isPlane() && support.shape->parts[j].isPlane())
                continue; // each is everywhere
            Pairing pairing(body, i, support, j, tolerance);
            if (pairing.isHollow())
                if (std::vector<Touch> found = pairing.atWall(); !found.empty()) {
                    std::ranges::move(found, std::back_inserter(touches));
                    continue;
                }
            if (pairing.find())
                touches.push_back(std::move(pairing.touch));
        }
    return touches;
}

} // namespace simulation
