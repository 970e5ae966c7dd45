// The work on a set of equations before anything moves: done once, for all runs over it.
//
// Linear in the size of the equations. Nothing here changes afterwards; solvers on any thread share
// it. A solver keeps changes by events for itself.
#pragma once

#include "equations/bound_model.h"
#include "equations/partition.h"
#include "equations/zero_states.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace solution {

struct Preparation {
    double start = 0;
    bool whole = false;      // one component of everything
    bool everyState = false; // also those that are 0 and stay 0, and unread ones
    // All that will be read; none: every unknown.
    std::optional<std::vector<std::size_t>> asked = std::nullopt;
    std::shared_ptr<ComponentModels> models; // where models are found again; none: an own place
};

struct PreparedEquations {
    // `meanwhile` is called now and then, and may throw to end it.
    PreparedEquations(std::shared_ptr<const expression::EquationSet> equations, Preparation how,
                      const std::function<void()>& meanwhile = {});

    std::shared_ptr<const expression::EquationSet> set;
    Preparation how;
    UnknownIndex index;
    ZeroStates zero;
    std::vector<bool> unread; // by unknown; none when all are asked for
    Partition partition;      // without what stays 0 and what nobody reads
    struct Component {
        std::vector<std::size_t> phases; // in force at the start, by place in its unknowns
        std::shared_ptr<const BoundModel> bound;
    };
    std::vector<Component> components; // as in the partition
};

// The phase of an unknown that is in force at a time.
[[nodiscard]] std::size_t phaseAt(const expression::Unknown& unknown, double time);

} // namespace solution
