#include "modes/closing_impulses.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

Eigen::Index toIndex(std::size_t i) { return static_cast<Eigen::Index>(i); }

// The forces of discs that slip, by forces of 1 of the rows.
Eigen::MatrixXd frictionOf(const DiscFriction& friction, const ClosingRows& of,
                           Eigen::Index slipping) {
    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(slipping, toIndex(of.rows.size()));
    Eigen::Index first = 0;
    for (const std::size_t k : of.slipping) {
        const BoundModel::Disc& disc = friction.disc(k);
        const DiscFriction::InDisc way = friction.lastWay(k);
        for (std::size_t n = 0; n < disc.normals.size(); ++n) {
            const auto row = std::ranges::find(of.rows, disc.normals[n]);
            if (row == of.rows.end())
                continue;
            const DiscFriction::Change one{.pressed = 1,
                                           .slip = {},
                                           .moment = disc.hasLevers ? friction.leversOf(k, n)
                                                                    : DiscFriction::Centre()};
            forces.col(row - of.rows.begin()).segment(first, way.size()) =
                friction.forceAgainst(k, way, one);
        }
        first += toIndex(disc.rows.size());
    }
    return forces;
}

} // namespace

ClosingRows rowsToClose(const ModelFunctions& functions, const Mode& mode,
                        const Multipliers& multipliers, std::span<const std::size_t> closing) {
    const BoundModel& bound = *functions.bound();
    const DiscFriction& friction = multipliers.friction();
    ClosingRows of;
    of.closing.assign(closing.begin(), closing.end());
    std::vector<char> isPart(mode.kept.size(), 0);
    for (std::size_t row = 0; row < mode.kept.size(); ++row) {
        const BoundModel::Law& law = bound.laws[row];
        const bool holds =
            mode.kept[row] == complementarity::State::inside && law.isOnSecondRates && !law.disc;
        if (!holds && std::ranges::find(closing, row) == closing.end())
            continue;
        isPart[row] = 1;
        of.rows.push_back(row);
    }
    for (std::size_t k = 0; k < bound.discs.size(); ++k) {
        const BoundModel::Disc& disc = bound.discs[k];
        if (mode.kept[disc.rows[0]] == Mode::gone ||
            std::ranges::none_of(disc.normals, [&](std::size_t row) { return isPart[row] != 0; }))
            continue;
        double closes = 0;
        for (const std::size_t row : disc.normals)
            if (std::ranges::find(closing, row) != closing.end())
                closes = std::max(closes, std::abs(multipliers.rate(row)));
        const bool slips = friction.slips(k);
        const bool isSlow = !friction.acts(k) && friction.slipOf(k).norm() <= closes;
        if (slips && disc.sliding == 0)
            continue;
        if (!slips || isSlow)
            of.rows.insert(of.rows.end(), disc.rows.begin(), disc.rows.end());
        else
            of.slipping.push_back(k);
    }
    return of;
}

bool close(Multipliers& multipliers, const ClosingRows& of, std::span<double> y) {
    constexpr double redundant = 1e-9, left = 1e-4;
    const DiscFriction& friction = multipliers.friction();
    std::vector<std::size_t> all = of.rows;
    for (const std::size_t k : of.slipping)
        all.insert(all.end(), friction.disc(k).rows.begin(), friction.disc(k).rows.end());
    const Eigen::Index held = toIndex(of.rows.size()), slipping = toIndex(all.size()) - held;
    const Eigen::MatrixXd given = multipliers.systemOf(all).matrix.topRows(held);
    const Eigen::MatrixXd forces = frictionOf(friction, of, slipping);
    Eigen::MatrixXd matrix = given.leftCols(held) + given.rightCols(slipping) * forces;
    Eigen::VectorXd rates = Eigen::VectorXd::Zero(held);
    for (std::size_t i = 0; i < of.rows.size(); ++i)
        if (std::ranges::find(of.closing, of.rows[i]) != of.closing.end())
            rates[toIndex(i)] = -multipliers.rate(of.rows[i]);
    const Eigen::VectorXd scale = given.diagonal().unaryExpr(
        [](double value) { return value > 0 ? 1 / std::sqrt(value) : 1.0; });
    matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
    rates = scale.cwiseProduct(rates);
    if (!matrix.allFinite() || !rates.allFinite())
        return false;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least;
    least.setThreshold(redundant);
    least.compute(matrix);
    const Eigen::VectorXd scaled = least.solve(rates);
    const bool isClosed = (matrix * scaled - rates).norm() <= left * rates.norm();
    if (!isClosed || !(rates.dot(scaled) >= 0)) // what approaches would be pulled: friction jams
        return false;
    Eigen::VectorXd impulses(toIndex(all.size()));
    impulses.head(held) = scale.cwiseProduct(scaled);
    impulses.tail(slipping) = forces * impulses.head(held);
    multipliers.push(all, impulses, y);
    return true;
}

} // namespace solution
