#include "physics/carried_points.h"

#include <algorithm>

namespace physics {

const expression::Phase& phaseAt(const expression::Unknown& unknown, double time) {
    const auto after = std::ranges::upper_bound(unknown.phases, time, {}, &expression::Phase::from);
    return after == unknown.phases.begin() ? unknown.phases.front() : *(after - 1);
}

BodyRates CarriedPoints::ratesOf(const CarriedPoint& point, const Along& along) const {
    const NodeVector zero = constant(g_, Vector::Zero());
    BodyRates rates{zero, zero};
    if (!along.set || !point.body || bodies_[*point.body].isFixed)
        return rates;
    const BodyMotion& body = bodies_[*point.body];
    const auto rateOfUnknown = [&](std::size_t unknown) {
        return phaseAt(along.set->unknowns[unknown], along.time).derivative;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        rates.acceleration[i] = rateOfUnknown(body.unknown(dx) + i);
        rates.spinRate[i] = rateOfUnknown(body.unknown(w1) + i);
    }
    return rates;
}

JetVector CarriedPoints::carried(const CarriedPoint& point, const Vector& v, const Along& along) {
    return carriedJet(g_, bodyOf(point), ratesOf(point, along), v);
}

JetVector CarriedPoints::apart(const CarriedPoint& first, const CarriedPoint& second,
                               const Along& along) {
    const JetVector centres = difference(g_, centreJet(bodyOf(first), ratesOf(first, along)),
                                         centreJet(bodyOf(second), ratesOf(second, along)));
    return sum(
        g_, centres,
        difference(g_, carried(first, first.arm, along), carried(second, second.arm, along)));
}

JetVector CarriedPoints::turning(const CarriedPoint& first, const CarriedPoint& second,
                                 const Along& along) {
    return difference(g_, spinJet(g_, bodyOf(first), ratesOf(first, along)),
                      spinJet(g_, bodyOf(second), ratesOf(second, along)));
}

NodeVector CarriedPoints::placeOf(const CarriedPoint& point) {
    const BodySymbols& body = bodyOf(point);
    return add(g_, body.position, body.toWorld(g_, constant(g_, point.arm)));
}

} // namespace physics
