// The quantities of named contacts (scene language, "Friction") among the equations.
//
// Their symbols stand in the scope of expressions. No unknown has them: they are readings of the
// equations (expression/equations.h), 0 while nothing touches. Where a -release reads them, that
// which they are now is put in.
#pragma once

#include "physics/equations_of_motion.h"

#include <array>
#include <vector>

namespace physics {

// The forces of contacts of one pair; nodes as ContactNodes has them.
struct ContactForces {
    Node normal;
    NodeVector force, couple, moment, slip;

    static constexpr std::size_t firstOfForce = 1, firstOfMoment = 7, firstOfSlip = 10, count = 13;
    using Nodes = std::array<Node, count>;
    [[nodiscard]] Nodes nodes() const;
};

// The readings of a scene's contacts that have names; their symbols are in the scope.
void addContactReadings(expression::EquationSet& set, const scene::Scene& scene, Scope& scope);
// Given unknowns that read such symbols have 0 in their places from now on; answers with what they
// were.
[[nodiscard]] std::vector<ContactReader> withoutContacts(expression::EquationSet& set);
// The place of a contact's first reading; the others follow it.
[[nodiscard]] std::size_t firstReadingOf(const expression::EquationSet& set,
                                         const ContactNodes& contact);

} // namespace physics
