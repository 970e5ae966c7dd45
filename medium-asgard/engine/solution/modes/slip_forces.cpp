#include "modes/slip_forces.h"

namespace solution {

namespace {

constexpr Eigen::Index none = -1;

std::span<const double> spanOf(const Eigen::Ref<const Eigen::VectorXd>& values) {
    return {values.data(), static_cast<std::size_t>(values.size())};
}

// Their number for a disc: the force that presses it, and the moments of that force.
Eigen::Index effectsOf(const BoundModel::Disc& disc) {
    return disc.hasLevers ? static_cast<Eigen::Index>(disc.rows.size()) : 1;
}

} // namespace

void SlipForces::find(std::size_t discs) {
    discs_.clear();
    for (std::size_t disc = 0; disc < discs; ++disc)
        if (friction_.acts(disc))
            discs_.push_back(disc);
    rows_ = 0;
    if (empty())
        return;
    placeOf_.assign(conditions_.isTie.size(), none);
    velocities_.resize(discs);
    for (const std::size_t disc : discs_)
        for (const std::size_t row : friction_.disc(disc).rows)
            placeOf_[row] = rows_++;
}

// Of each disc, where its forces begin.
template <class Visit> void SlipForces::each(const Visit& visit) const {
    Eigen::Index effect = 0;
    for (const std::size_t disc : discs_) {
        const BoundModel::Disc& of = friction_.disc(disc);
        visit(disc, Place{placeOf_[of.rows[0]], effect});
        effect += effectsOf(of);
    }
}

bool SlipForces::solve(std::span<const double> entries, HeldConditions& held,
                       const Eigen::VectorXd& without) {
    responses_.setZero(without.size(), rows_);
    for (std::size_t k = 0; k < entries.size(); ++k)
        if (const auto [row, column] = conditions_.matrix[k]; placeOf_[column] != none)
            responses_(row, placeOf_[column]) = entries[k];
    held.solveEach(responses_);
    for (const std::size_t disc : discs_)
        velocities_[disc] = friction_.velocityOf(disc);
    findEffects();
    beginAtLast(without);
    if (forces_.allFinite() && improve(without))
        return true;
    forces_.setZero(rows_);
    return improve(without);
}

// The force and the moments that press a disc are linear in all forces.
void SlipForces::findEffects() {
    Eigen::Index effects = 0;
    for (const std::size_t disc : discs_)
        effects += effectsOf(friction_.disc(disc));
    effects_.setZero(effects, rows_);
    each([&](std::size_t disc, const Place& at) {
        const std::vector<std::size_t>& normals = friction_.disc(disc).normals;
        const Eigen::Index moments = effectsOf(friction_.disc(disc)) - 1;
        for (std::size_t n = 0; n < normals.size(); ++n) {
            const auto response = responses_.row(static_cast<Eigen::Index>(normals[n]));
            effects_.row(at.effect) += response;
            if (moments > 0)
                effects_.middleRows(at.effect + 1, moments) +=
                    friction_.leversOf(disc, n) * response;
        }
    });
}

// Of Newton's matrix the rows of a disc: its own forces less those that follow from all others.
// `force`: that of the disc by a change of its effects, linear in it.
template <class Force>
void SlipForces::setSlopes(std::size_t disc, const Place& at, const Force& force) {
    const auto rows = static_cast<Eigen::Index>(friction_.disc(disc).rows.size());
    const Eigen::Index effects = effectsOf(friction_.disc(disc));
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> by(rows, effects);
    for (Eigen::Index i = 0; i < effects; ++i) {
        DiscFriction::Change one = friction_.noChange(disc);
        (i == 0 ? one.pressed : one.moment[i - 1]) = 1;
        by.col(i) = force(one);
    }
    slopes_.middleRows(at.force, rows).noalias() -= by * effects_.middleRows(at.effect, effects);
}

void SlipForces::beginAtLast(const Eigen::VectorXd& without) {
    slopes_.setIdentity(rows_, rows_);
    forces_.resize(rows_);
    each([&](std::size_t disc, const Place& at) {
        const DiscFriction::InDisc way = friction_.lastWay(disc);
        const auto force = [&](const DiscFriction::Change& all) {
            return friction_.forceAgainst(disc, way, all);
        };
        forces_.segment(at.force, way.size()) = force(friction_.changeBy(disc, spanOf(without)));
        setSlopes(disc, at, force);
    });
    lu_.compute(slopes_);
    forces_ = lu_.solve(forces_);
}

// By Newton's method, from the forces that there are.
bool SlipForces::improve(const Eigen::VectorXd& without) {
    constexpr int most = 40, halvings = 10;
    constexpr double rounding = 1e-15, close = 1e-12; // of the forces
    Eigen::VectorXd multipliers = without + responses_ * forces_, error = errors(multipliers);
    for (int round = 0; round < most; ++round) {
        const double size = error.norm();
        if (size <= rounding * multipliers.norm())
            return true;
        linearise(spanOf(multipliers));
        Eigen::VectorXd step = lu_.solve(error);
        const Eigen::VectorXd from = forces_, ofFrom = multipliers;
        bool isLess = false;
        const int tries = size <= close * multipliers.norm() ? 1 : halvings;
        for (int halving = 0; halving < tries && !isLess; ++halving, step /= 2) {
            forces_ = from + step;
            multipliers = without + responses_ * forces_;
            error = errors(multipliers);
            isLess = error.norm() < size;
        }
        if (!isLess) { // rounding is left, or there is none
            forces_ = from;
            return size <= close * ofFrom.norm();
        }
    }
    return error.norm() <= close * multipliers.norm();
}

// By how much the laws' forces differ.
Eigen::VectorXd SlipForces::errors(const Eigen::VectorXd& multipliers) const {
    Eigen::VectorXd errors = -forces_;
    each([&](std::size_t disc, const Place& at) {
        const DiscFriction::InDisc force =
            friction_.forceOf(disc, velocities_[disc], spanOf(multipliers));
        errors.segment(at.force, force.size()) += force;
    });
    return errors;
}

void SlipForces::linearise(std::span<const double> multipliers) {
    slopes_.setIdentity(rows_, rows_);
    each([&](std::size_t disc, const Place& at) {
        const DiscFriction::Slope slope = friction_.slopeOf(disc, velocities_[disc], multipliers);
        setSlopes(disc, at, [&](const DiscFriction::Change& by) {
            return friction_.changeOf(disc, slope, by);
        });
    });
    lu_.compute(slopes_);
}

void SlipForces::change(std::span<const double> multipliers, std::span<const double> gaps,
                        HeldConditions& held, Eigen::Ref<Eigen::VectorXd> change) const {
    held.solve(change);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(rows_);
    each([&](std::size_t disc, const Place& at) {
        DiscFriction::Change by = friction_.changeBy(disc, spanOf(change));
        friction_.addGaps(disc, multipliers, gaps, by);
        const DiscFriction::InDisc of =
            friction_.changeOf(disc, friction_.slopeOf(disc, velocities_[disc], multipliers), by);
        forces.segment(at.force, of.size()) = of;
    });
    forces = lu_.solve(forces);
    change += responses_ * forces;
    for (Eigen::Index row = 0; row < change.size(); ++row)
        if (const Eigen::Index place = placeOf_[static_cast<std::size_t>(row)]; place != none)
            change[row] = forces[place];
}

void SlipForces::addTo(Eigen::VectorXd& rates, std::span<const double> entries) const {
    for (std::size_t k = 0; k < entries.size(); ++k)
        if (const auto [row, column] = conditions_.matrix[k]; placeOf_[column] != none)
            rates[row] += entries[k] * forces_[placeOf_[column]];
}

void SlipForces::putInto(std::span<double> multipliers) const {
    for (std::size_t row = 0; row < multipliers.size(); ++row)
        if (placeOf_[row] != none)
            multipliers[row] = forces_[placeOf_[row]];
}

} // namespace solution
