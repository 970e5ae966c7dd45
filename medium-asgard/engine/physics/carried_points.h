// Points and directions that bodies carry, as expressions with their rates along the equations.
#pragma once

#include "physics/equations_of_motion.h"
#include "physics/jets.h"

namespace physics {

// The equations along which rates are taken, and when; none: with accelerations of 0.
struct Along {
    const expression::EquationSet* set = nullptr;
    double time = 0;
};

// Values of the time and of all unknowns, in this order: those that trajectories give at a time,
// which may be made of others that are given (a place that turns with an attitude that is held).
void putGiven(const Graph& g, const expression::EquationSet& set, double time,
              std::span<double> values);

// A point of a body, from its centre of mass along its axes, or of the world.
struct CarriedPoint {
    std::optional<std::size_t> body; // none: the world
    Vector arm = Vector::Zero();
};

class CarriedPoints {
public:
    CarriedPoints(Graph& g, std::span<const BodyMotion> bodies)
        : g_(g), bodies_(bodies), world_(fixedBody(g, {Vector::Zero(), Quaternion::Identity()})) {}

    [[nodiscard]] const BodySymbols& bodyOf(const CarriedPoint& point) const {
        return point.body ? bodies_[*point.body].symbols : world_;
    }
    // A direction along the axes of the point's body.
    [[nodiscard]] JetVector carried(const CarriedPoint& point, const Vector& v, const Along& along);
    // The first point less the second. Places first: far from the origin their difference is small
    // and exact.
    [[nodiscard]] JetVector apart(const CarriedPoint& first, const CarriedPoint& second,
                                  const Along& along);
    // The angular velocity of the first body less that of the second.
    [[nodiscard]] JetVector turning(const CarriedPoint& first, const CarriedPoint& second,
                                    const Along& along);
    [[nodiscard]] NodeVector placeOf(const CarriedPoint& point); // in the world

private:
    [[nodiscard]] BodyRates ratesOf(const CarriedPoint& point, const Along& along) const;

    Graph& g_;
    std::span<const BodyMotion> bodies_;
    BodySymbols world_;
};

} // namespace physics
