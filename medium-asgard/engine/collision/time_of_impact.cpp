#include "collision/time_of_impact.h"

#include "collision/advancement.h"
#include "collision/part_motion.h"
#include "collision/spheres.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision {

namespace {

bool centredSphere(const PartMotion& p) {
    return p.part->isSphere() && p.part->center() == p.pivot;
}

Encounter meetAsSpheres(const PartPair& pair, Interval during, double depth) {
    const RelativePath path = relativePath(pair.first.piece, pair.second.piece, during.from);
    const SphereEncounter met = spheresMeet(
        path, pair.first.part->radius + pair.second.part->radius - depth, during.to - during.from,
        pair.roundOff(during.from), pair.leastApproach(during.from));
    Encounter result;
    result.overlap = met.overlap;
    result.evaluations = 1;
    if (!met.hit)
        return result;
    Hit hit;
    hit.time = std::min(during.from + met.hit->after, during.to);
    hit.pressing = met.hit->pressing;
    WarmStart cold;
    hit.contact = contactOf(pair, hit.time, pair.separationAt(hit.time, cold));
    result.hit = hit;
    return result;
}

// Their bounding spheres stay apart throughout.
bool neverNear(const PartPair& pair, Interval during) {
    const RelativePath path = relativePath(pair.first.piece, pair.second.piece, during.from);
    const Polynomial g = squaredDistance(path, (pair.first.reach + pair.second.reach) * (1 + 1e-9));
    return g.terms[0] > 0 && !firstDescent(g, during.to - during.from);
}

Encounter meetInPiece(const PartPair& pair, Interval during, double depth) {
    if (centredSphere(pair.first) && centredSphere(pair.second))
        return meetAsSpheres(pair, during, depth);
    if (pair.areHalfSpaces() || (!pair.hasPlane() && neverNear(pair, during)))
        return {};
    return advance(pair, during);
}

double endOfPieces(const MovingShape& first, const MovingShape& second, double t, double to) {
    double end = to;
    for (const MovingShape* m : {&first, &second})
        if (const double until = m->pieceAt(t).until; until > t)
            end = std::min(end, until);
    return end;
}

void note(Encounter& all, const Encounter& one, std::size_t i, std::size_t j, bool atStart) {
    all.evaluations += one.evaluations;
    if (atStart)
        all.overlap = std::max(all.overlap, one.overlap);
    if (one.hit && (!all.hit || one.hit->time < all.hit->time)) {
        all.hit = one.hit;
        all.hit->contact.firstPart = i;
        all.hit->contact.secondPart = j;
    }
}

} // namespace

Encounter timeOfImpact(const MovingShape& first, const MovingShape& second, Interval during,
                       const PartFilter& leaveOut, Slack slack, double depth) {
    Encounter all;
    for (double t = during.from; !all.hit;) {
        const double end = endOfPieces(first, second, t, during.to);
        for (std::size_t i = 0; i < first.shape().parts.size(); ++i)
            for (std::size_t j = 0; j < second.shape().parts.size(); ++j) {
                if (leaveOut && leaveOut(i, j))
                    continue;
                const double until = all.hit ? all.hit->time : end;
                note(all, meetInPiece(partPair(first, i, second, j, t, slack), {t, until}, depth),
                     i, j, t == during.from);
            }
        if (!(end < during.to))
            break;
        t = end;
    }
    return all;
}

} // namespace collision
