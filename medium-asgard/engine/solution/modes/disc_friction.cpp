#include "modes/disc_friction.h"

#include "modes/model_functions.h"

#include <algorithm>

namespace solution {

using complementarity::State;

namespace {

Eigen::Index indexOf(std::size_t i) { return static_cast<Eigen::Index>(i); }

DiscFriction::InDisc at(const DiscFriction::Centre& centre, DiscFriction::InDisc rates) {
    rates.head(centre.size()) += rates[rates.size() - 1] * centre;
    return rates;
}

// The force is against it.
DiscFriction::InDisc wayAt(const DiscFriction::Centre& centre,
                           const DiscFriction::Velocity& velocity) {
    return at(centre, velocity.rows) + velocity.beside;
}

} // namespace

DiscFriction::DiscFriction(const BoundModel& bound, const Mode& mode,
                           const std::vector<double>& gaps)
    : bound_(bound), mode_(mode), gaps_(gaps) {}

bool DiscFriction::slips(std::size_t k) const { return mode_.kept[disc(k).rows[0]] == State::low; }

bool DiscFriction::acts(std::size_t k) const {
    return slips(k) && disc(k).sliding != 0 &&
           std::ranges::any_of(disc(k).normals, [this](std::size_t row) {
               return mode_.kept[row] == State::inside;
           });
}

double DiscFriction::pressedBy(std::size_t k, std::span<const double> forces) const {
    double pressed = 0;
    for (const std::size_t row : disc(k).normals)
        pressed += forces[row];
    return pressed;
}

// --------------------------------------------------------------------------- centres and slips

DiscFriction::Levers DiscFriction::leversAmong(std::span<const double> gaps, std::size_t k,
                                               std::size_t normal) const {
    const BoundModel::Disc& of = disc(k);
    const std::size_t first = conditionsOf(bound_).firstLever[of.normals[normal]];
    return {gaps.data() + 2 * mode_.kept.size() + first, indexOf(of.rows.size()) - 1};
}

DiscFriction::InDisc DiscFriction::ratesAmong(std::span<const double> gaps, std::size_t k) const {
    const std::vector<std::size_t>& rows = disc(k).rows;
    InDisc rates(indexOf(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        rates[indexOf(i)] = gaps[mode_.kept.size() + rows[i]];
    return rates;
}

DiscFriction::Change DiscFriction::noChange(std::size_t k) const {
    const Eigen::Index rows = indexOf(disc(k).rows.size());
    return {.slip = InDisc::Zero(rows), .moment = Centre::Zero(disc(k).hasLevers ? rows - 1 : 0)};
}

DiscFriction::Change DiscFriction::changeBy(std::size_t k, std::span<const double> forces) const {
    Change change = noChange(k);
    const BoundModel::Disc& of = disc(k);
    change.pressed = pressedBy(k, forces);
    for (std::size_t n = 0; n < of.normals.size() && of.hasLevers; ++n)
        change.moment += forces[of.normals[n]] * leversOf(k, n);
    return change;
}

DiscFriction::Centre DiscFriction::centreOf(std::size_t k, std::span<const double> forces) const {
    return centreBy(changeBy(k, forces));
}

DiscFriction::Centre DiscFriction::centreFrom(std::size_t k,
                                              const std::array<double, 2>& levers) const {
    return Eigen::Map<const Eigen::Vector2d>(levers.data()).head(noChange(k).moment.size());
}

DiscFriction::Centre DiscFriction::centreIn(std::size_t k) const {
    return centreFrom(k, mode_.discs[k].centre);
}

DiscFriction::InDisc DiscFriction::lastWay(std::size_t k) const {
    return wayAt(centreFrom(k, mode_.discs[k].last), velocityOf(k));
}

void DiscFriction::follow(std::size_t k, std::span<const double> forces,
                          std::array<double, 2>& last) const {
    constexpr double elsewhere = 0.1; // of the length by which levers are divided
    constexpr double another = 1e-3;  // of an angle
    const Centre now = centreOf(k, forces);
    if ((now - centreFrom(k, last)).norm() > elsewhere &&
        (wayAt(now, velocityOf(k)).normalized() - lastWay(k).normalized()).norm() > another)
        std::ranges::copy(now, last.begin());
}

DiscFriction::InDisc DiscFriction::beganOf(std::size_t k) const {
    return Eigen::Map<const Eigen::Vector3d>(mode_.discs[k].slip.data())
        .head(indexOf(disc(k).rows.size()));
}

DiscFriction::InDisc DiscFriction::atCentre(std::size_t k, const InDisc& rates) const {
    return at(centreIn(k), rates);
}

DiscFriction::InDisc DiscFriction::slipOf(std::size_t k) const {
    return atCentre(k, ratesAmong(gaps_, k));
}

double DiscFriction::aheadOf(std::size_t k) const {
    const InDisc began = beganOf(k);
    return slipOf(k).dot(began.normalized()) + 0.5 * began.norm();
}

DiscFriction::Velocity DiscFriction::velocityOf(std::size_t k) const {
    const InDisc began = beganOf(k), direction = began.normalized();
    if (began.size() == 1)
        return {InDisc::Zero(1), direction};
    // It is whole below a hundred times the slow speed, and fades beyond: so little of it is left
    // there that changeOf() may take it as constant.
    constexpr double fast = 100; // times the speed of a slow slip
    const InDisc rates = ratesAmong(gaps_, k), slip = at(centreIn(k), rates);
    const double along = slip.dot(direction), square = slip.squaredNorm();
    const double length = began.norm();
    const bool hasTurnedBack = along + 0.5 * length < 0 && 2 * along * along > square;
    const double sense = hasTurnedBack ? -1 : 1;
    return {sense * rates, began / (1 + square / (fast * fast * length * length)), sense};
}

double DiscFriction::leewayOf(std::size_t k, std::span<const double> forces) const {
    const BoundModel::Disc& of = disc(k);
    const Centre centre = centreOf(k, forces);
    InDisc force(indexOf(of.rows.size()));
    for (std::size_t i = 0; i < of.rows.size(); ++i)
        force[indexOf(i)] = forces[of.rows[i]];
    force[force.size() - 1] -= centre.dot(force.head(centre.size()));
    return of.sticking * pressedBy(k, forces) - force.norm();
}

// ------------------------------------------------------------------------------------- forces

// The friction of each normal force at its own point: its couples go through 0 with the forces.
DiscFriction::InDisc DiscFriction::forceAgainst(std::size_t k, const InDisc& way,
                                                const Change& all) const {
    const InDisc direction = way.normalized();
    InDisc force = all.pressed * direction;
    force[force.size() - 1] += all.moment.dot(direction.head(all.moment.size()));
    return -disc(k).sliding * force;
}

DiscFriction::InDisc DiscFriction::forceOf(std::size_t k, const Velocity& velocity,
                                           std::span<const double> forces) const {
    const Change all = changeBy(k, forces);
    return forceAgainst(k, wayAt(centreBy(all), velocity), all);
}

void DiscFriction::addGaps(std::size_t k, std::span<const double> forces,
                           std::span<const double> gaps, Change& change) const {
    const BoundModel::Disc& of = disc(k);
    change.slip += ratesAmong(gaps, k);
    for (std::size_t n = 0; n < of.normals.size() && of.hasLevers; ++n)
        change.moment += forces[of.normals[n]] * leversAmong(gaps, k, n);
}

DiscFriction::Slope DiscFriction::slopeOf(std::size_t k, const Velocity& velocity,
                                          std::span<const double> forces) const {
    Slope slope{.all = changeBy(k, forces), .centre = {}, .way = {}, .direction = {}};
    slope.centre = centreBy(slope.all);
    slope.way = wayAt(slope.centre, velocity);
    slope.direction = slope.way.normalized();
    if (slope.way.size() > 1) {
        slope.turning = velocity.sense / slope.way.norm();
        slope.spin = velocity.sense * velocity.rows[slope.way.size() - 1];
    }
    return slope;
}

DiscFriction::InDisc DiscFriction::changeOf(std::size_t k, const Slope& slope,
                                            const Change& change) const {
    const auto& [all, centre, way, direction, turning, spin] = slope;
    const Centre moved = all.pressed > 0
                             ? Centre((change.moment - change.pressed * centre) / all.pressed)
                             : Centre(0 * centre);
    InDisc turned = InDisc::Zero(way.size());
    if (way.size() > 1) {
        InDisc slip = at(centre, change.slip);
        slip.head(centre.size()) += spin * moved;
        turned = turning * (slip - direction.dot(slip) * direction);
    }
    InDisc by = change.pressed * direction + all.pressed * turned;
    by[by.size() - 1] += change.moment.dot(direction.head(centre.size())) +
                         all.moment.dot(turned.head(centre.size()));
    return -disc(k).sliding * by;
}

} // namespace solution
