#include "physics/carried_points.h"

#include "expression/tape.h"

#include <algorithm>

namespace physics {

void putGiven(const Graph& g, const expression::EquationSet& set, double time,
              std::span<double> values) {
    std::vector<Node> inputs{set.time}, nodes;
    std::vector<std::size_t> places;
    for (std::size_t u = 0; u < set.unknowns.size(); ++u) {
        inputs.push_back(set.unknowns[u].symbol);
        if (const auto& given = phaseAt(set.unknowns[u], time).given) {
            nodes.push_back(*given);
            places.push_back(1 + u);
        }
    }
    const expression::Tape tape(g, inputs, nodes);
    std::vector<double> found(nodes.size());
    expression::Tape::Scratch scratch;
    constexpr int depth = 3; // a point of a body that is held, of a body that is held
    for (int i = 0; i < depth && !nodes.empty(); ++i) {
        tape.evaluate(values, found, scratch);
        for (std::size_t k = 0; k < places.size(); ++k)
            values[places[k]] = found[k];
    }
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
