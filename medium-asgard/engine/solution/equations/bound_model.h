// The equations of one component while no phase of its unknowns begins or ends: a model, and what
// is the component's own, which is where its inputs come from and its constants.
#pragma once

#include "dense/polynomial.h"
#include "equations/component_model.h"
#include "equations/composition.h"
#include "equations/partition.h"
#include "expression/equations.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace solution {

struct BoundModel {
    std::shared_ptr<const ComponentModel> model; // none when there is a loop
    // Places in the component's unknowns of the differential ones and of the held ones, in order
    // of evaluation; and of held ones that are defined by each other.
    std::vector<std::size_t> states, held, loop;
    std::vector<std::size_t> multipliers; // places of those, too
    struct Law {                          // of each multiplier (expression/equations.h, Condition)
        double low = -infinity, high = infinity, restitution = 0, resolution = 0;
        bool isStop = false;
        // Its condition is one on second rates; others say their multiplier without the rest.
        bool isOnSecondRates = true;
        std::optional<std::size_t> release = {}; // place of an unknown: not 0: gone
        std::optional<double> leaving = {};      // of a contact
        double hop = 0;                          // of a contact: as Condition::hop
        std::optional<std::uint32_t> patch = {}; // of a contact: the same for all of its points
        std::optional<std::size_t> disc = {};    // of friction
        [[nodiscard]] bool isBounded() const {
            return low > -infinity || high < infinity || disc.has_value();
        }
    };
    std::vector<Law> laws;
    struct Disc { // of friction, by multipliers in their order
        std::vector<std::size_t> rows, normals;
        double sticking = 0, sliding = 0;
        bool hasLevers = false; // of its normals, for the rows but the last
        [[nodiscard]] bool operator==(const Disc&) const = default;
    };
    std::vector<Disc> discs;
    std::vector<std::size_t> inputs; // unknowns of other components, in the model's order
    std::vector<double> constants;
    bool canPeak = false;                        // peaks.h
    std::shared_ptr<const Composition> composed; // none: the model has the conditions
};

// `phases[i]` is the phase of unknowns[i] that is in force; unknowns are in order. What stays 0 is
// put in as a 0. Linear in the size of the component's expressions, whatever else the set has.
[[nodiscard]] BoundModel boundModel(const expression::EquationSet& set, const UnknownIndex& index,
                                    const ZeroStates& zero, std::span<const std::size_t> unknowns,
                                    std::span<const std::size_t> phases, ComponentModels& models);

} // namespace solution
