// The laws on second rates: which rows take part, and the set that their answer gives.
#include "complementarity/fixed_point.h"
#include "complementarity/solve.h"
#include "modes/active_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace solution {

using complementarity::State;

// It is at its bound without a rate, or holds: the laws on second rates decide.
bool ActiveSet::isCandidate(std::size_t row, double fastest) const {
    if (!law(row).isBounded() || isGone(row))
        return false;
    const double none = std::max(rateOf * law(row).resolution, atRest * fastest);
    const bool isSlow = std::abs(multipliers_.rate(row)) <= none;
    return mode_.kept[row] == State::inside ||
           (isSlow && (!isStop(row) || multipliers_.gap(row) <= law(row).resolution));
}

bool ActiveSet::mayHold(std::size_t disc, std::span<const std::size_t> fallen,
                        double fastest) const {
    const BoundModel::Disc& of = discs()[disc];
    if (isGone(of.rows[0]))
        return false;
    const double none = std::max(rateOf * law(of.rows[0]).resolution, atRest * fastest);
    const bool hasFallen = isIn(fallen, of.rows[0]);
    return mode_.kept[of.rows[0]] == State::inside || hasFallen ||
           multipliers_.slipOf(disc).norm() <= none;
}

ActiveSet::Rows ActiveSet::rowsFor(std::span<const std::size_t> fallen, double fastest,
                                   const std::vector<char>& slipping) {
    Rows found;
    std::vector<char> takesPart(mode_.kept.size(), 0);
    for (std::size_t row = 0; row < mode_.kept.size(); ++row) {
        const bool isBounded = law(row).isBounded();
        if (law(row).disc || isGone(row))
            continue;
        const bool isClosed = isContact(row) && isIn(fallen, row);
        // Rates round with the velocities, however slow the blow was.
        const double none = std::max(rateOf * law(row).resolution, atRest * fastest);
        const bool leaves =
            isStop(row) && !isClosed && fastest > 0 && multipliers_.rate(row) > none;
        if (isBounded && (leaves || multipliers_.gap(row) > law(row).resolution))
            mode_.touches[row] = 0;
        if (isBounded && leaves)
            mode_.kept[row] = State::low;
        else
            takesPart[row] = isIn(fallen, row) || isCandidate(row, fastest) ||
                                     (!isBounded && law(row).isOnSecondRates)
                                 ? 1
                                 : 0;
    }
    std::vector<char> isOfDisc(mode_.kept.size(), 0);
    for (const BoundModel::Disc& disc : discs())
        for (const std::size_t row : disc.normals)
            isOfDisc[row] = 1;
    const auto add = [&](std::size_t row) {
        found.rows.push_back(row);
        if (law(row).isBounded())
            complementarity::addInterval(found.laws, law(row).low, law(row).high);
        else
            complementarity::addEquality(found.laws);
        found.hasBounds = found.hasBounds || law(row).isBounded();
    };
    for (std::size_t row = 0; row < mode_.kept.size(); ++row)
        if (takesPart[row] && !isOfDisc[row])
            add(row);
    Eigen::Index first = 0, normals = 0;
    for (std::size_t disc = 0; disc < discs().size(); ++disc) {
        const BoundModel::Disc& of = discs()[disc];
        // Friction and rolling friction have the same normal forces.
        const bool isKnown = disc > 0 && of.normals == discs()[disc - 1].normals;
        if (!isKnown) {
            first = static_cast<Eigen::Index>(found.rows.size());
            for (const std::size_t row : of.normals)
                if (takesPart[row])
                    add(row);
            normals = static_cast<Eigen::Index>(found.rows.size()) - first;
        }
        const bool holds = !slipping[disc] && mayHold(disc, fallen, fastest);
        if (!holds && !slipping[disc])
            setSlip(disc, multipliers_.slipOf(disc));
        if (!holds || normals == 0)
            continue;
        setDisc(disc, State::inside); // while the laws are asked, it adds no friction of slip
        complementarity::addFriction(found.laws, static_cast<Eigen::Index>(of.rows.size()), first,
                                     of.sticking, normals);
        if (of.hasLevers) {
            complementarity::Matrix& levers = found.laws.back().levers;
            levers.resize(static_cast<Eigen::Index>(of.rows.size()) - 1, normals);
            Eigen::Index column = 0;
            for (std::size_t n = 0; n < of.normals.size(); ++n)
                if (takesPart[of.normals[n]])
                    levers.col(column++) = multipliers_.leversOf(disc, n);
        }
        found.rows.insert(found.rows.end(), of.rows.begin(), of.rows.end());
        found.discs.push_back(disc);
    }
    return found;
}

bool ActiveSet::settle(std::span<const std::size_t> fallen, double fastest, double t,
                       std::span<const double> y) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    mode_.forces.clear();
    std::vector<char> slipping(discs().size(), 0);
    for (bool isOther = true; isOther;) {
        const Rows rows = rowsFor(fallen, fastest, slipping);
        if (!rows.hasBounds || !solveLaws(rows)) {
            openUnpressed();
            return !rows.hasBounds;
        }
        isOther = false;
        for (const std::size_t disc : rows.discs) // these have the friction of slip from here on
            if (discs()[disc].sticking != discs()[disc].sliding &&
                multipliers_.slips(discs()[disc]))
                slipping[disc] = 1, isOther = true;
    }
    openUnpressed();
    takeForces();
    for (std::size_t row = 0; row < mode_.kept.size(); ++row)
        mode_.jumps[row] = multipliers_.jumpOf(row);
    return true;
}

// The laws' where the shortest that keep redundant conditions break a bound.
void ActiveSet::takeForces() {
    std::vector<double> ofLaws = std::exchange(mode_.forces, {});
    if (!multipliers_.solve() || !multipliers_.isRedundant() || areWithinBounds())
        return;
    mode_.forces = std::move(ofLaws);
    (void)multipliers_.solve();
    if (!areWithinBounds()) // nor are they, so that they tell no more than the shortest
        mode_.forces.clear();
}

bool ActiveSet::areWithinBounds() const {
    constexpr double rounding = 1e-9;
    double largest = 0;
    for (const double m : multipliers_.values())
        largest = std::max(largest, std::abs(m));
    const double most = rounding * largest;
    for (const std::size_t row : bounded_)
        if (!law(row).disc && mode_.kept[row] == State::inside &&
            (multipliers_.values()[row] < law(row).low - most ||
             multipliers_.values()[row] > law(row).high + most))
            return false;
    for (std::size_t disc = 0; disc < discs().size(); ++disc)
        if (mode_.kept[discs()[disc].rows[0]] == State::inside &&
            multipliers_.leewayOf(disc) < -most)
            return false;
    return true;
}

// Friction without a normal force holds nothing.
void ActiveSet::openUnpressed() {
    for (std::size_t disc = 0; disc < discs().size(); ++disc)
        if (std::ranges::none_of(discs()[disc].normals, [this](std::size_t row) {
                return mode_.kept[row] == State::inside;
            }))
            setDisc(disc, State::low);
}

// With discs that slip and turn about the centres of their normal forces. None: no forces keep the
// laws, or no centres were found.
std::optional<complementarity::Answer> ActiveSet::answerOf(const Rows& rows) {
    constexpr int most = 40; // rounds
    std::vector<std::size_t> slipping;
    for (std::size_t disc = 0; disc < discs().size(); ++disc)
        if (multipliers_.slips(discs()[disc]))
            slipping.push_back(disc);
    Eigen::VectorXd next = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(slipping.size()));
    const auto collect = [&](const auto& centreOf) {
        for (std::size_t i = 0; i < slipping.size(); ++i) {
            const Multipliers::Centre centre = centreOf(slipping[i]);
            next.segment(2 * static_cast<Eigen::Index>(i), centre.size()) = centre;
        }
    };
    collect([this](std::size_t disc) { return multipliers_.centreIn(disc); });
    complementarity::FixedPoint<> centres(next);
    std::optional<complementarity::Answer> answer;
    std::vector<double> forces(mode_.kept.size(), 0);
    for (int round = 0; round < most; ++round) {
        const auto [a, b] = multipliers_.systemOf(rows.rows, Multipliers::Friction::ofSlip);
        // The guess: all that may rest does.
        complementarity::Answer rest{.forces = Eigen::VectorXd::Zero(b.size()),
                                     .rates = b,
                                     .states =
                                         complementarity::States(rows.laws.size(), State::inside)};
        if (answer)
            rest = std::move(*answer);
        else if (rows.discs.empty())
            rest = {};
        answer = complementarity::solve(a, b, rows.laws, rest);
        if (!answer)
            return answer;
        for (std::size_t i = 0; i < rows.rows.size(); ++i)
            forces[rows.rows[i]] = answer->forces[static_cast<Eigen::Index>(i)];
        if (std::ranges::none_of(slipping, [&](std::size_t disc) {
                return multipliers_.turns(disc, multipliers_.centreIn(disc), forces);
            })) {
            for (std::size_t disc = 0; disc < discs().size(); ++disc)
                setCentre(disc, multipliers_.centreOf(disc, forces));
            return answer;
        }
        collect([&](std::size_t disc) { return multipliers_.centreOf(disc, forces); });
        centres.moveFrom(next);
        for (std::size_t i = 0; i < slipping.size(); ++i)
            setCentre(slipping[i], centres.at().segment<2>(2 * static_cast<Eigen::Index>(i)));
    }
    return std::nullopt;
}

bool ActiveSet::solveLaws(const Rows& rows) {
    const auto answer = answerOf(rows);
    if (!answer)
        return false;
    const double largest = answer->forces.cwiseAbs().maxCoeff();
    mode_.forces.assign(mode_.kept.size(), 0);
    for (std::size_t i = 0; i < rows.rows.size(); ++i)
        mode_.forces[rows.rows[i]] = answer->forces[static_cast<Eigen::Index>(i)];
    std::size_t disc = 0;
    for (std::size_t k = 0; k < rows.laws.size(); ++k) {
        const complementarity::Law& of = rows.laws[k];
        const std::size_t row = rows.rows[static_cast<std::size_t>(of.first)];
        if (of.kind == complementarity::Law::Kind::disc) {
            const Multipliers::InDisc force =
                complementarity::forcesAt(complementarity::centreOf(of, answer->forces),
                                          answer->forces.segment(of.first, of.rows));
            if (answer->states[k] == State::inside)
                setDisc(rows.discs[disc], State::inside);
            else
                setSlip(rows.discs[disc], -force);
            ++disc;
        } else if (law(row).isBounded()) {
            const double none = hasContacts_ ? noForce * largest : 0;
            const bool isNothing = isStop(row) && answer->forces[of.first] <= law(row).low + none;
            mode_.kept[row] = isNothing ? State::low : answer->states[k];
            mode_.touches[row] = isNothing ? 1 : 0;
        }
    }
    return true;
}

} // namespace solution
