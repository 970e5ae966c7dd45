// States on the conditions that multipliers keep, and the multipliers, at any time of a motion.
//
// A solution stands on its conditions at the ends of steps; between them its polynomials leave them
// by what a step may err. A reader moves states onto them as a step does, and solves for the
// multipliers, which no history keeps. So bodies on joints meet at every time that is looked at.
//
// LIMIT: equations that events replaced are read as they were at the start of their phases.
#pragma once

#include "dense/histories.h"
#include "equations/prepared_equations.h"

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace solution {

class ComponentEquations;

// What all readers of one set of equations share: unknowns that share multipliers, and their
// equations by time.
class ConditionGroups {
public:
    explicit ConditionGroups(const PreparedEquations& prepared);
    [[nodiscard]] bool empty() const { return groups_.empty(); }

private:
    friend class ConditionReader;
    struct Group {
        std::vector<std::size_t> unknowns;                                        // in order
        std::vector<std::pair<double, std::shared_ptr<const BoundModel>>> models; // from when on
    };
    std::vector<Group> groups_;
    std::vector<std::size_t> groupOf_; // by unknown
};

// Any thread may ask.
class ConditionReader {
public:
    ConditionReader(std::shared_ptr<const ConditionGroups> groups,
                    std::shared_ptr<const Histories> histories);
    ~ConditionReader();

    // Unknowns in a row, from this one on; nothing where no multiplier moves the first.
    [[nodiscard]] bool values(std::size_t unknown, double time, std::span<double> out) const;

private:
    struct Place {
        std::size_t model = 0; // whose equations they are
        double time = 0;
        std::unique_ptr<ComponentEquations> equations;
        std::vector<double> values; // by place in the group's unknowns, at `time`
    };
    void find(std::size_t group, double time) const;

    std::shared_ptr<const ConditionGroups> groups_;
    std::shared_ptr<const Histories> histories_;
    mutable std::mutex mutex_;
    mutable std::vector<Place> places_; // by group
};

} // namespace solution
