// The laws on second rates: which rows take part, the set that their answer gives, and what goes on
// where they have none.
#include "complementarity/solve.h"
#include "modes/active_set.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace solution {

using complementarity::Answer;
using complementarity::Law;
using complementarity::Laws;
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
           multipliers_.friction().slipOf(disc).norm() <= none;
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
    std::vector<std::size_t> normals;
    for (std::size_t disc = 0; disc < discs().size(); ++disc) {
        const BoundModel::Disc& of = discs()[disc];
        // Friction and rolling friction have the same normal forces.
        const bool isKnown = disc > 0 && of.normals == discs()[disc - 1].normals;
        if (!isKnown) {
            normals.clear();
            for (const std::size_t row : of.normals)
                if (takesPart[row]) {
                    add(row);
                    normals.push_back(row);
                }
        }
        const bool holds = !slipping[disc] && mayHold(disc, fallen, fastest);
        if (!holds && !slipping[disc])
            setSlip(disc);
        if (holds && !normals.empty())
            setDisc(disc, State::inside);
        if (!normals.empty() && !isGone(of.rows[0]))
            addLaw(found, disc, normals);
    }
    return found;
}

// The law of a disc that may hold, or slips. Its normal forces are among the rows.
void ActiveSet::addLaw(Rows& rows, std::size_t disc, std::span<const std::size_t> normals) {
    const BoundModel::Disc& of = discs()[disc];
    const DiscFriction& friction = multipliers_.friction();
    const bool slips = friction.slips(disc);
    const auto first = std::ranges::find(rows.rows, normals[0]) - rows.rows.begin();
    complementarity::addFriction(rows.laws, static_cast<Eigen::Index>(of.rows.size()), first,
                                 slips ? of.sliding : of.sticking,
                                 static_cast<Eigen::Index>(normals.size()));
    rows.rows.insert(rows.rows.end(), of.rows.begin(), of.rows.end());
    Law& law = rows.laws.back();
    if (of.hasLevers) {
        law.levers.resize(law.rows - 1, law.normals);
        for (Eigen::Index n = 0; n < law.normals; ++n) {
            const auto place = std::ranges::find(of.normals, normals[static_cast<std::size_t>(n)]);
            law.levers.col(n) =
                friction.leversOf(disc, static_cast<std::size_t>(place - of.normals.begin()));
        }
    }
    if (slips) {
        law.kind = Law::Kind::slip;
        std::tie(law.velocity, law.beside) = friction.velocityOf(disc);
    } else {
        rows.discs.push_back(disc);
    }
}

bool ActiveSet::settle(std::span<const std::size_t> fallen, double fastest, double t,
                       std::span<const double> y) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    mode_.share = {};
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
                multipliers_.friction().slips(disc))
                slipping[disc] = 1, isOther = true;
    }
    openUnpressed();
    takeForces();
    return true;
}

// The laws' where the shortest that keep redundant conditions break a bound.
void ActiveSet::takeForces() {
    std::vector<double> ofLaws = std::exchange(mode_.share.forces, {});
    if (!solve() || !multipliers_.isRedundant() || areWithinBounds())
        return;
    mode_.share.forces = std::move(ofLaws);
    mode_.share.rooms = roomsOf(mode_.share.forces);
    (void)solve();
    if (areWithinBounds())
        return;
    mode_.share = {}; // it tells no more than the shortest
}

std::vector<double> ActiveSet::roomsOf(std::span<const double> forces) const {
    constexpr double least = 1e-4; // of the largest
    double largest = 0;
    for (const double m : forces)
        largest = std::max(largest, std::abs(m));
    std::vector<double> rooms(forces.size(), largest > 0 ? largest : 1);
    if (!(largest > 0))
        return rooms;
    for (std::size_t row = 0; row < forces.size(); ++row)
        if (isContact(row))
            rooms[row] = std::max(least * largest, forces[row]);
    for (const BoundModel::Disc& disc : discs()) {
        double pressed = 0;
        for (const std::size_t row : disc.normals)
            pressed += forces[row];
        for (const std::size_t row : disc.rows)
            rooms[row] = std::max(least * largest, pressed);
    }
    return rooms;
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
            multipliers_.friction().leewayOf(disc, multipliers_.values()) < -most)
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

namespace {

bool isHeldAtEdge(const Law& disc, const Answer& answer, std::size_t k, double none) {
    return disc.kind == Law::Kind::disc && answer.states[k] == State::edge &&
           answer.rates.segment(disc.first, disc.rows).norm() <= none;
}

// Redundant forces may hold a disc in many ways, of which the answer has one at the edge. Forces
// within it last: those of the same laws with less friction there.
void holdWithin(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const Laws& laws,
                Answer& answer) {
    constexpr double rounding = 1e-9;
    const double none = rounding * b.cwiseAbs().maxCoeff();
    std::vector<std::size_t> held;
    for (std::size_t k = 0; k < laws.size(); ++k)
        if (isHeldAtEdge(laws[k], answer, k, none))
            held.push_back(k);
    for (const double less : {0.2, 0.02}) {
        if (held.empty())
            return;
        Laws narrow = laws;
        for (const std::size_t k : held)
            narrow[k].coefficient *= 1 - less;
        const auto within = complementarity::solve(a, b, narrow, answer);
        const bool holds = within && std::ranges::all_of(held, [&](std::size_t k) {
                               return within->states[k] == State::inside ||
                                      isHeldAtEdge(narrow[k], *within, k, none);
                           });
        if (!holds)
            continue;
        answer = *within;
        for (const std::size_t k : held)
            answer.states[k] = State::inside;
        return;
    }
}

} // namespace

template <typename Visit> void ActiveSet::onUpperSides(Visit&& visit) {
    if (f_.weights().size() != mode_.sliding.size()) // they were not possible
        return;
    for (std::size_t j = 0; j < mode_.sliding.size(); ++j) {
        mode_.setSide(mode_.sliding[j], +1);
        visit(f_.weights()[j]);
        mode_.setSide(mode_.sliding[j], -1);
    }
}

// A held switch pushes by the weights with which it is held: it is on neither side of its surface.
Multipliers::System ActiveSet::systemOf(std::span<const std::size_t> rows) {
    Multipliers::System system = multipliers_.systemOf(rows);
    const Eigen::VectorXd below = system.rest;
    onUpperSides(
        [&](double weight) { system.rest += weight * (multipliers_.systemOf(rows).rest - below); });
    return system;
}

bool ActiveSet::solve() {
    bool isSolved = multipliers_.solve();
    if (mode_.sliding.empty())
        return isSolved;
    const Multipliers::Solution below = multipliers_.solution();
    Multipliers::Solution sum = below;
    const auto add = [](std::vector<double>& to, double weight, const std::vector<double>& from,
                        const std::vector<double>& base) {
        for (std::size_t i = 0; i < to.size(); ++i)
            to[i] += weight * (from[i] - base[i]);
    };
    onUpperSides([&](double weight) {
        isSolved = multipliers_.solve() && isSolved;
        const Multipliers::Solution above = multipliers_.solution();
        add(sum.values, weight, above.values, below.values);
        add(sum.second, weight, above.second, below.second);
    });
    multipliers_.take(sum);
    return isSolved;
}

bool ActiveSet::solveLaws(const Rows& rows) {
    const auto [a, b] = systemOf(rows.rows);
    Answer rest; // the guess: all that may rest does
    if (!rows.discs.empty()) {
        rest.forces.setZero(b.size());
        rest.states.assign(rows.laws.size(), State::inside);
    }
    auto answer = complementarity::solve(a, b, rows.laws, rest);
    if (!answer)
        return false;
    holdWithin(a, b, rows.laws, *answer);
    const double largest = answer->forces.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < b.size(); ++i)
        if (isContact(rows.rows[static_cast<std::size_t>(i)]))
            slowest_ = std::max(slowest_, fallenSlow(a(i, i) * answer->forces[i]));
    // A force that is smaller than what the answer errs by is none.
    constexpr double more = 10;
    const double faulty = more * complementarity::violation(a, b, rows.laws, *answer);
    const double none = hasContacts_ ? std::max(noForce, faulty) * largest : 0;
    mode_.share.forces.assign(mode_.kept.size(), 0);
    for (std::size_t i = 0; i < rows.rows.size(); ++i)
        mode_.share.forces[rows.rows[i]] = answer->forces[static_cast<Eigen::Index>(i)];
    std::size_t disc = 0;
    for (std::size_t k = 0; k < rows.laws.size(); ++k) {
        const Law& of = rows.laws[k];
        const std::size_t row = rows.rows[static_cast<std::size_t>(of.first)];
        if (of.kind == Law::Kind::slip)
            continue;
        if (of.kind == Law::Kind::disc) {
            const DiscFriction::InDisc force =
                complementarity::forcesAt(complementarity::centreOf(of, answer->forces),
                                          answer->forces.segment(of.first, of.rows));
            if (answer->states[k] == State::inside)
                setDisc(rows.discs[disc], State::inside);
            else
                setSlip(rows.discs[disc], -force, 0);
            ++disc;
        } else if (law(row).isBounded()) {
            const bool isNothing = isStop(row) && answer->forces[of.first] <= law(row).low + none;
            mode_.kept[row] = isNothing ? State::low : answer->states[k];
            mode_.touches[row] = isNothing ? 1 : 0;
        }
    }
    for (std::size_t k = 0; k < discs().size(); ++k)
        setCentre(k, multipliers_.friction().centreOf(k, mode_.share.forces));
    return true;
}

// ---------------------------------------------------------------------------------------------
// Jams: the laws have no answer

bool ActiveSet::pushesIn(std::size_t disc, std::span<const std::size_t> normals) {
    std::vector<std::size_t> rows(normals.begin(), normals.end());
    rows.insert(rows.end(), discs()[disc].rows.begin(), discs()[disc].rows.end());
    const auto pushed = static_cast<Eigen::Index>(rows.size());
    for (std::size_t row = 0; row < mode_.kept.size(); ++row) // joints, which give what it takes
        if (mode_.kept[row] == State::inside && !law(row).isBounded() && law(row).isOnSecondRates)
            rows.push_back(row);
    const auto joints = static_cast<Eigen::Index>(rows.size()) - pushed;
    const auto count = static_cast<Eigen::Index>(normals.size());
    const DiscFriction::InDisc slip = multipliers_.friction().slipOf(disc);
    const Eigen::MatrixXd matrix = multipliers_.systemOf(rows).matrix;
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(pushed + joints);
    forces.head(count).setConstant(1 / static_cast<double>(count));
    forces.segment(count, slip.size()) = -discs()[disc].sliding / slip.norm() * slip;
    if (joints > 0)
        forces.tail(joints) =
            matrix.bottomRightCorner(joints, joints)
                .completeOrthogonalDecomposition()
                .solve(-matrix.bottomLeftCorner(joints, pushed) * forces.head(pushed));
    return (matrix * forces).head(count).sum() < 0;
}

// Painleve's rod: its friction turns it into the floor faster than any force of the floor can push
// it away. The limit of ever stiffer contacts is an impact without a collision, which lasts until
// nothing slips (Genot, Brogliato 1999, "New results on Painleve paradoxes"): velocities change as
// little as stops the slip and keeps the contact closed, if the floor presses in it.
// Bodies may jam by each other's friction, as a tower on a corner of its lowest block: then the
// slowest slip stops that can, or all do.
// LIMIT: several that jam at one instant stop together.
bool ActiveSet::endJam(std::span<const std::size_t> candidates, double t, std::span<double> y,
                       std::span<const double> rates) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    std::vector<PressedSlip> alone, all;
    for (std::size_t disc = 0; disc < discs().size(); ++disc) {
        PressedSlip slip{
            .disc = disc, .speed = multipliers_.friction().slipOf(disc).norm(), .normals = {}};
        std::ranges::copy_if(discs()[disc].normals, std::back_inserter(slip.normals),
                             [&](std::size_t row) {
                                 return isContact(row) &&
                                        (isIn(candidates, row) || mode_.kept[row] == State::inside);
                             });
        if (slip.normals.empty() || !(slip.speed > leastOf(discs()[disc])))
            continue;
        if (pushesIn(disc, slip.normals))
            alone.push_back(slip);
        all.push_back(std::move(slip));
    }
    const std::vector<double> moving(y.begin(), y.end());
    const auto stops = [&](std::span<const PressedSlip> slips) {
        std::ranges::copy(moving, y.begin());
        return !slips.empty() && stopSlips(slips, candidates, t, y, rates);
    };
    if (stops(alone))
        return true;
    std::ranges::stable_sort(all, {}, &PressedSlip::speed);
    for (std::size_t k = 0; k < all.size(); ++k)
        if (stops(std::span(all).subspan(k, 1)))
            return true;
    return stops(all);
}

bool ActiveSet::stopSlips(std::span<const PressedSlip> slips,
                          std::span<const std::size_t> candidates, double t, std::span<double> y,
                          std::span<const double> rates) {
    std::vector<std::size_t> slipping, pressed;
    for (const PressedSlip& slip : slips) {
        slipping.push_back(slip.disc);
        pressed.insert(pressed.end(), slip.normals.begin(), slip.normals.end());
    }
    const Mode before = mode_;
    for (const std::size_t row : pressed)
        mode_.kept[row] = State::low;
    std::vector<double> stopped(y.begin(), y.end());
    halt(slipping, t, stopped);
    // A patch whose corners are pressed unevenly turns.
    const bool isPressed = std::ranges::all_of(slips, [this](const PressedSlip& slip) {
        double sum = 0;
        for (const std::size_t row : slip.normals)
            sum += multipliers_.rate(row);
        return sum < 0;
    });
    mode_ = before;
    if (!isPressed)
        return false;
    for (const std::size_t row : pressed)
        mode_.kept[row] = State::inside;
    std::vector<std::size_t> held(candidates.begin(), candidates.end());
    held.insert(held.end(), pressed.begin(), pressed.end());
    if (!settleWith({}, held, slipping, t, y, rates)) {
        mode_ = before;
        return false;
    }
    for (const std::size_t disc : slipping)
        for (const std::size_t row : discs()[disc].rows)
            jammed_[row] = 1;
    return true;
}

} // namespace solution
