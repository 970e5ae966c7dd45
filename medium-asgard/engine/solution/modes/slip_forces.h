// The forces of discs that slip, with those of the conditions that hold:
//
//     A m + S f + b = 0,   f = F(m)      (disc_friction.h)
//
// A body that slips and turns does so about the centre of its normal forces, which its own friction
// shifts, so that F is not linear. A is factorised once, and the forces f, one to three for each
// disc, are found by Newton's method:  m = m0 + G f  with the responses G = -A^-1 S. It begins with
// directions held at the centres of an event or of a step behind it, where F is linear: friction
// that lifts a tipping body is far from none.
//
// Guards see to it that normal forces press: of friction that jams (Painleve) they may pull here.
#pragma once

#include "modes/disc_friction.h"
#include "modes/held_conditions.h"

#include <Eigen/Core>
#include <Eigen/LU>

#include <span>
#include <vector>

namespace solution {

class SlipForces {
public:
    // `friction` outlives it.
    SlipForces(const ComponentModel::Conditions& conditions, const DiscFriction& friction)
        : conditions_(conditions), friction_(friction) {}

    // The discs that slip with a force at this point, out of so many.
    void find(std::size_t discs);
    [[nodiscard]] bool empty() const { return discs_.empty(); }
    // Once gaps are evaluated. `entries`: of Conditions::matrix at the point, for which `held` is
    // factorised. `without`: what holds, by multiplier, where there is no friction of slip. False:
    // none were found; then they are those that err least.
    [[nodiscard]] bool solve(std::span<const double> entries, HeldConditions& held,
                             const Eigen::VectorXd& without);
    // To second rates, what the forces give.
    void addTo(Eigen::VectorXd& rates, std::span<const double> entries) const;
    // Into multipliers.
    void putInto(std::span<double> multipliers) const;

    // About these multipliers, at the point that was solved for last, how they all change.
    // `change`: of second rates with multipliers as they are; then of the multipliers. `gaps`: of
    // the values of Conditions::gaps.
    void linearise(std::span<const double> multipliers);
    void change(std::span<const double> multipliers, std::span<const double> gaps,
                HeldConditions& held, Eigen::Ref<Eigen::VectorXd> change) const;

private:
    struct Place { // of a disc: of its first force, and of its first row of effects
        Eigen::Index force, effect;
    };
    template <class Visit> void each(const Visit& visit) const;
    void findEffects();
    template <class Force> void setSlopes(std::size_t disc, const Place& at, const Force& force);
    void beginAtLast(const Eigen::VectorXd& without);
    [[nodiscard]] bool improve(const Eigen::VectorXd& without);
    [[nodiscard]] Eigen::VectorXd errors(const Eigen::VectorXd& multipliers) const;

    const ComponentModel::Conditions& conditions_;
    const DiscFriction& friction_;
    std::vector<std::size_t> discs_;
    std::vector<DiscFriction::Velocity> velocities_; // by disc, of these
    Eigen::Index rows_ = 0;
    std::vector<Eigen::Index> placeOf_; // of a multiplier among the forces, or none
    // By force: the changes of multipliers, and of each disc's sum of normal forces and its moments
    // (effects). Newton's matrix.
    Eigen::MatrixXd responses_, effects_, slopes_;
    Eigen::VectorXd forces_;
    Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

} // namespace solution
