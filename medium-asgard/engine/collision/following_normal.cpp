#include "collision/following_normal.h"

#include "collision/feature.h"

#include <array>
#include <cmath>

namespace collision {
namespace {

constexpr double asFar = 1e-9;      // of the part's size: points that are as far out as each other
constexpr double aligned = 1e-6;    // sine of an angle: a face that looks along the direction
constexpr double linesCross = 1e-3; // the same: lines that are nearer to parallel do not cross

struct Condition { // normal' . line = (spin x normal) . line
    Vector line, spin;
};

struct Wishes {
    std::optional<Vector> ofFace; // its spin
    std::optional<Condition> ofLine;
};

Wishes wishesOf(const PartMotion& motion, const Vector& outward, double t) {
    Wishes wishes;
    const Vector spin = velocityAt(motion.piece, t).angular;
    const Posed posed = motion.posedAt(t, positionAt(motion.piece, t));
    const Vector local = posed.rotation.transpose() * outward;
    for (const Feature& of : featuresAlong(*motion.part, local, asFar * motion.reach)) {
        const Feature feature = placed(of, posed);
        const double along = feature.axis.dot(outward);
        if (feature.kind == Feature::Kind::face && along > 0 &&
            feature.axis.cross(outward).norm() <= aligned)
            wishes.ofFace = spin;
        else if (feature.kind == Feature::Kind::segment ||
                 (feature.kind == Feature::Kind::cone && std::abs(along - feature.sine) <= aligned))
            wishes.ofLine = {(feature.axis - along * outward).normalized(), spin};
    }
    return wishes;
}

} // namespace

std::optional<Vector> followingTurn(const PartPair& pair, const Vector& normal, double t) {
    const std::array<Wishes, 2> wishes{wishesOf(pair.first, -normal, t),
                                       wishesOf(pair.second, normal, t)};
    for (const Wishes& of : wishes)
        if (of.ofFace)
            return of.ofFace;
    Vector change = Vector::Zero(); // of the normal
    const auto &a = wishes[0].ofLine, &b = wishes[1].ofLine;
    const auto rateOf = [&](const Condition& of) { return of.spin.cross(normal).dot(of.line); };
    if (!a && !b)
        return std::nullopt;
    const double cross = a && b ? normal.dot(a->line.cross(b->line)) : 0;
    if (std::abs(cross) > linesCross)
        change = (rateOf(*a) * b->line.cross(normal) + rateOf(*b) * normal.cross(a->line)) / cross;
    else
        change = rateOf(a ? *a : *b) * (a ? a->line : b->line);
    return normal.cross(change);
}

} // namespace collision
