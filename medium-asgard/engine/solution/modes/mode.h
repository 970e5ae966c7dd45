// The mode of a component: the branch of each of its switches, and the surfaces and directions on
// which its motion is held. Modes are values: a solver of switches tries one and takes another.
//
// A mode says nothing of values and times; with the equations it says which smooth right-hand side
// holds.
#pragma once

#include "complementarity/laws.h"
#include "equations/component_model.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace solution {

struct Mode {
    static constexpr int onSurface = 0;
    struct Coincident { // a surface that lies where another does
        std::size_t surface;
        int orientation; // of its sides, as seen from those of the other
        [[nodiscard]] bool operator==(const Coincident&) const = default;
    };

    std::vector<expression::Decision> decisions; // of the model's function
    // By surface: -1, 0, 1; of those that are slid upon -1.
    std::vector<int> sides;
    // Of floors and ceilings that are slid upon, or were passed: the whole number where they were.
    std::vector<expression::Decision> levels;
    std::vector<std::vector<Coincident>> coincident; // with those that are slid upon or passed
    // The guard crosses 0 by rounding alone, or no rate beyond the surface moves the state away
    // from it.
    std::vector<char> isGrazed;
    std::vector<char> wasPassed;        // since the start or the last event
    std::vector<std::size_t> sliding;   // surfaces
    std::vector<std::size_t> sticking;  // directions whose vectors are held at 0
    std::optional<std::size_t> leaving; // of these, one that sets off
    // Of each multiplier: inside its bounds, so that its condition holds, or at one of them; or
    // released for ever.
    static constexpr complementarity::State gone = complementarity::State::edge;
    std::vector<complementarity::State> kept;
    // Of redundant conditions the shortest forces are taken. Where these break bounds, those next
    // to these, by which the laws gave the set: one of each multiplier; empty: the shortest do. A
    // distance counts in units of what its contact can bear, `rooms`: a contact that is hardly
    // pressed takes hardly a part of what changes.
    struct Share {
        std::vector<double> forces, rooms;
        [[nodiscard]] bool operator==(const Share&) const = default;
    };
    Share share;
    // Stops that touch without a force and without a rate: rounding may close them.
    std::vector<char> touches;
    struct Disc { // of friction
        // The direction in which it began to slip, while its rows are at a bound; as long as the
        // speed under which that direction counts.
        std::array<double, 3> slip{};
        std::array<double, 2> centre{}; // of its normal forces there (complementarity/laws.h)
        // The centre from which forces of slips are sought: this one, or that of a later step where
        // it was elsewhere.
        std::array<double, 2> last{};
        [[nodiscard]] bool operator==(const Disc&) const = default;
    };
    std::vector<Disc> discs;
    // A stage that lies a little beyond a surface, where the branch that holds has no value, takes
    // the branch of its values.
    bool looksBeyond = false;

    const ComponentModel* model; // whose surfaces these are

    Mode(const ComponentModel& of, std::size_t multipliers)
        : decisions(of.function().decisions()), sides(of.surfaces().size(), onSurface),
          levels(sides.size(), 0), coincident(sides.size()), isGrazed(sides.size(), 0),
          wasPassed(sides.size(), 0), kept(multipliers, complementarity::State::inside),
          touches(multipliers, 0), model(&of) {}
    [[nodiscard]] bool operator==(const Mode&) const = default;

    [[nodiscard]] bool isHeld() const { return !sliding.empty() || !sticking.empty(); }
    [[nodiscard]] bool slidesOn(std::size_t surface) const;
    // It changes together with a surface that has it as coincident.
    [[nodiscard]] bool isCoincident(std::size_t surface) const;
    // Nothing is held, and no surface is special.
    void release();
    // With all that are coincident.
    void setSide(std::size_t surface, int side);
    void setGrazed(std::size_t surface, bool grazes);
    // That surface alone.
    void setOwnSide(std::size_t surface, int side);
    // Nothing has moved it from the side on which it was put.
    [[nodiscard]] bool isOnSide(std::size_t surface) const;
    // Of floor and ceil, on a side of the whole number that is their level.
    [[nodiscard]] expression::Decision decisionBeside(std::size_t surface, int side) const;
};

// "1: +, 2: slides with -3, 4: floor 2, direction 0: sticks": the surfaces by their numbers.
[[nodiscard]] std::string print(const Mode& mode);

} // namespace solution
