// Which functions end a mode when they fall below 0?
//
// Of each surface that is read its guard, on the side that holds; of one that is slid upon its
// weight, at both ends; of each direction that is held at 0 how far its unit vector is from 1; of
// multipliers with bounds what active_set.h says.
#pragma once

#include "dense/first_violation.h"
#include "modes/active_set.h"
#include "modes/stick_slip.h"

#include <optional>
#include <span>
#include <vector>

namespace solution {

class Guards {
public:
    struct Watch {
        enum class Kind { side, least, most } kind; // least, most: of a weight
        std::size_t surface;
    };
    Guards(ModelFunctions& functions, HeldField& field, StickSlip& stick, ActiveSet& active,
           Mode& mode)
        : f_(functions), field_(field), stick_(stick), active_(active), model_(*mode.model),
          mode_(mode) {}

    // The mode is another.
    void refresh();
    [[nodiscard]] const std::vector<Watch>& watches() const { return watches_; }
    [[nodiscard]] std::size_t size() const {
        return watches_.size() + mode_.sticking.size() + active_.size();
    }
    void watch(double t, std::span<const double> y, std::span<double> values);
    // One of them, where it follows from places and velocities alone: no forces are solved for.
    [[nodiscard]] std::optional<double> watchOfPlaces(std::size_t k, double t,
                                                      std::span<const double> y);
    // At its time the rates lead away from all its surfaces, to the sides that hold: only an error
    // of polynomials crosses them, where a guard is smaller than that.
    [[nodiscard]] bool contradicts(const Violation& violation, double t, std::span<const double> y);
    // There the rates lead away from the one surface of the violation, to the side that holds, and
    // its guard is no more than what rounding leaves of a difference: the motion, which started on
    // the surface, has just left it, and goes on where it is. From then on crossings back count
    // beyond ModelFunctions::standing only, and of a contact beyond its gap there. A surface that
    // was passed is not grazed so: swings that become ever shorter would never end.
    [[nodiscard]] bool grazesByRounding(const Violation& violation, double t,
                                        std::span<const double> y);
    [[nodiscard]] std::vector<std::size_t> surfacesOf(const Violation& violation) const;
    // That the slip of a disc of friction turns.
    [[nodiscard]] std::size_t turnOf(std::size_t disc) const {
        return watches_.size() + mode_.sticking.size() + active_.turnOf(disc);
    }
    // Watches of the active set that are violated, as it counts them.
    [[nodiscard]] std::vector<std::size_t> activeOf(const Violation& violation) const;
    // All of them are of the active set, and read forces.
    [[nodiscard]] bool readForces(const Violation& violation) const;
    // Forces were found at the last watch().
    [[nodiscard]] bool knowForces() const { return field_.multipliers().areFound(); }
    // A contact has closed, or lost its place.
    [[nodiscard]] bool isOfPlaces(const Violation& violation) const;
    // It does not do so at the point of the functions.
    [[nodiscard]] bool isOffPlaces(const Violation& violation);
    // It has done so there, or before.
    [[nodiscard]] bool isBeyondPlaces(const Violation& violation);
    // Multipliers whose bounds are violated.
    [[nodiscard]] std::vector<std::size_t> multipliersOf(const Violation& violation) const;
    // Directions whose watches are violated.
    [[nodiscard]] std::vector<std::size_t> directionsOf(const Violation& violation) const;
    // Unknowns (places) that the guards of its watches read, and those of other components.
    [[nodiscard]] std::vector<std::size_t> unknownsOf(const Violation& violation) const;
    [[nodiscard]] std::vector<std::size_t> inputsOf(const Violation& violation) const;

private:
    [[nodiscard]] bool leadsInside(const Watch& watch, std::span<const double> rates);
    [[nodiscard]] std::vector<std::size_t> symbolsOf(const Violation& violation) const;

    ModelFunctions& f_;
    HeldField& field_;
    StickSlip& stick_;
    ActiveSet& active_;
    const ComponentModel& model_;
    Mode& mode_;
    std::vector<Watch> watches_;
};

} // namespace solution
