// The friction of contacts at one point: how discs slip, about which centre, and with which forces.
//
// A disc that slips has the force  f = -mu N d : N is the sum of its normal forces, d the direction
// of its velocity at their centre (complementarity/laws.h). The force acts at that centre, and its
// last row has the couple that this gives about the point of the disc.
//
// Near rest the direction in which the slip began counts, so that the rates of states have no jump
// there.
#pragma once

#include "equations/bound_model.h"
#include "modes/mode.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace solution {

class DiscFriction {
public:
    // Of the rows of a disc.
    using InDisc = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
    // The levers of a point, for the rows but the last; none where the disc has no levers.
    using Centre = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2, 1>;

    // All outlive it. `gaps`: of Conditions::gaps, evaluated at the point.
    DiscFriction(const BoundModel& bound, const Mode& mode, const std::vector<double>& gaps);

    [[nodiscard]] const BoundModel::Disc& disc(std::size_t k) const { return bound_.discs[k]; }
    [[nodiscard]] bool slips(std::size_t disc) const;
    // It slips, and has a force.
    [[nodiscard]] bool acts(std::size_t disc) const;

    // The velocities of its rows at the centre of the mode.
    [[nodiscard]] InDisc slipOf(std::size_t disc) const;
    // The same of other rates, by multiplier.
    template <class Rate> [[nodiscard]] InDisc slipBy(std::size_t k, const Rate& rateOf) const {
        const std::vector<std::size_t>& rows = disc(k).rows;
        InDisc rates(static_cast<Eigen::Index>(rows.size()));
        for (std::size_t i = 0; i < rows.size(); ++i)
            rates[static_cast<Eigen::Index>(i)] = rateOf(rows[i]);
        return atCentre(k, rates);
    }
    // The direction in which a slip began, as long as the speed below which that direction counts.
    [[nodiscard]] InDisc beganOf(std::size_t disc) const;
    // How far a slip is from the turn that ends it: behind rest by half of the speed under which
    // the direction counts in which it began.
    [[nodiscard]] double aheadOf(std::size_t disc) const;
    // By forces, one for each multiplier: how far the force of a disc is from its bound, and the
    // centre of its normal forces.
    [[nodiscard]] double leewayOf(std::size_t disc, std::span<const double> forces) const;
    [[nodiscard]] Centre centreOf(std::size_t disc, std::span<const double> forces) const;
    [[nodiscard]] Centre leversOf(std::size_t disc, std::size_t normal) const {
        return leversAmong(gaps_, disc, normal);
    }

    // Of one that slips, whatever its forces: the velocity of its rows that gives its direction,
    // and what this has besides at every centre: the direction in which it began, less and less as
    // it grows. -1 behind the turn of a slip that comes back, within 45 degrees of its way, so that
    // its friction goes on there. Else +1: a slip that goes round passes its turn with the friction
    // of its own direction.
    struct Velocity {
        InDisc rows, beside;
        double sense = 1;
    };
    [[nodiscard]] Velocity velocityOf(std::size_t disc) const;
    // That velocity at the centre from which forces are sought (Mode::Disc::last).
    [[nodiscard]] InDisc lastWay(std::size_t disc) const;
    // The centre of these forces becomes that one, if it has moved and the disc slips another way.
    void follow(std::size_t disc, std::span<const double> forces,
                std::array<double, 2>& last) const;

    // The force of a disc follows from these, and changes with them.
    struct Change {
        double pressed = 0; // of the sum of normal forces
        InDisc slip = {};   // of the velocities of the rows
        Centre moment = {}; // of the sum of normal forces times their levers
    };
    [[nodiscard]] Change noChange(std::size_t disc) const;
    // By these normal forces.
    [[nodiscard]] Change changeBy(std::size_t disc, std::span<const double> forces) const;
    // Of one that slips, by these normal forces; and against a velocity: linear in what presses.
    [[nodiscard]] InDisc forceOf(std::size_t disc, const Velocity& velocity,
                                 std::span<const double> forces) const;
    [[nodiscard]] InDisc forceAgainst(std::size_t disc, const InDisc& way, const Change& all) const;
    // Adds what these changes of gaps, of their rates and of levers bring.
    void addGaps(std::size_t disc, std::span<const double> forces, std::span<const double> gaps,
                 Change& change) const;
    // About these normal forces: what all changes have in common.
    struct Slope {
        Change all;
        Centre centre;
        InDisc way, direction;
        double turning = 0; // part of a change of slip that turns the direction
        double spin = 0;    // the rate of the last row
    };
    [[nodiscard]] Slope slopeOf(std::size_t disc, const Velocity& velocity,
                                std::span<const double> forces) const;
    [[nodiscard]] InDisc changeOf(std::size_t disc, const Slope& slope, const Change& change) const;

private:
    using Levers = Eigen::Map<const Eigen::VectorXd>;
    [[nodiscard]] Levers leversAmong(std::span<const double> gaps, std::size_t disc,
                                     std::size_t normal) const;
    [[nodiscard]] InDisc ratesAmong(std::span<const double> gaps, std::size_t disc) const;
    [[nodiscard]] Centre centreIn(std::size_t disc) const;                      // the mode
    [[nodiscard]] InDisc atCentre(std::size_t disc, const InDisc& rates) const; // of the mode
    [[nodiscard]] Centre centreFrom(std::size_t disc, const std::array<double, 2>& levers) const;
    [[nodiscard]] double pressedBy(std::size_t disc, std::span<const double> forces) const;
    [[nodiscard]] static Centre centreBy(const Change& all) {
        return all.pressed > 0 ? Centre(all.moment / all.pressed) : Centre(0 * all.moment);
    }

    const BoundModel& bound_;
    const Mode& mode_;
    const std::vector<double>& gaps_;
};

} // namespace solution
