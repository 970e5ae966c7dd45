// States on the conditions that multipliers keep, the multipliers, and what follows from them, at
// any time of a motion.
//
// A solution stands on its conditions at the ends of steps; between them its polynomials leave them
// by what a step may err. A reader moves states onto them as a step does, and solves for the
// multipliers, which no history keeps. So bodies on joints and in contact meet at every time that
// is looked at, and the forces of joints, ropes and contacts belong to each other.
//
// It reads the equations that are in force then, with what events made of them. Of unknowns that
// rest it leaves every bit as it is.
#pragma once

#include "dense/histories.h"
#include "equations/component_model.h"
#include "expression/equations.h"
#include "expression/tape.h"

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>

namespace solution {

class ComponentEquations;
class UnknownIndex;

// Any thread may ask.
class ConditionReader {
public:
    // `set`: as events left it, each phase with its time.
    ConditionReader(std::shared_ptr<const expression::EquationSet> set, double start,
                    std::shared_ptr<ComponentModels> models,
                    std::shared_ptr<const Histories> histories);
    ~ConditionReader();
    ConditionReader(const ConditionReader&) = delete;
    ConditionReader& operator=(const ConditionReader&) = delete;
    // There is something to read.
    [[nodiscard]] static bool isWanted(const expression::EquationSet& set);

    // Unknowns in a row, from this one on; nothing where no multiplier moves the first.
    [[nodiscard]] bool values(std::size_t unknown, double time, std::span<double> out) const;
    // One of the set's readings, by the name of its symbol; none: there is no such.
    [[nodiscard]] std::optional<double> reading(std::string_view name, double time) const;

private:
    struct Group {                         // unknowns that share multipliers
        std::vector<std::size_t> unknowns; // in order
        std::unique_ptr<ComponentEquations> equations;
        std::vector<double> values; // by place in `unknowns`, at `time`
        double time = 0;
        bool hasStates = false, hasForces = false; // are they those of `time`?
    };
    struct Interval { // in which all equations stay as they are
        double from = 0;
        std::unordered_map<std::size_t, std::vector<std::size_t>> multipliersOf; // by unknown
        std::unordered_map<std::size_t, std::shared_ptr<Group>> groupOf;         // null: none
        std::size_t lastUse = 0;
    };
    struct Reading { // as it is in force from some time on
        std::vector<std::size_t> unknowns;
        expression::Tape tape;
    };
    [[nodiscard]] Interval& intervalAt(double time) const;
    [[nodiscard]] std::vector<std::size_t> readsOf(const Interval& interval,
                                                   std::size_t unknown) const;
    [[nodiscard]] Group* groupOf(Interval& interval, std::size_t unknown) const;
    void findGroups(Interval& interval, std::size_t unknown) const;
    [[nodiscard]] std::vector<double> prepared(const Group& group, double time) const;
    void readStates(Group& group, double time) const;
    void readForces(Group& group, double time) const;
    [[nodiscard]] double valueOf(Interval& interval, std::size_t unknown, double time) const;
    [[nodiscard]] double inGroup(Group& group, std::size_t place, double time) const;

    std::shared_ptr<const expression::EquationSet> set_;
    std::shared_ptr<ComponentModels> models_;
    std::shared_ptr<const Histories> histories_;
    std::unique_ptr<const UnknownIndex> index_;
    std::vector<double> times_; // at which equations become others, in order
    mutable std::mutex mutex_;
    mutable std::vector<Interval> intervals_; // that were read last
    mutable std::size_t uses_ = 0;
    mutable std::unordered_map<std::uint32_t, Reading> readings_; // by node
};

} // namespace solution
