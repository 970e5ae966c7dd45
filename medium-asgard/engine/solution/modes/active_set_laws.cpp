// The laws on second rates: which rows take part, the set that their answer gives, and what goes on
// where they have none.
#include "complementarity/solve.h"
#include "modes/active_set.h"
#include "modes/closing_impulses.h"
#include "modes/forces_within.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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
        const DiscFriction::Velocity velocity = friction.velocityOf(disc);
        law.velocity = velocity.rows;
        law.beside = velocity.beside;
    } else {
        rows.discs.push_back(disc);
    }
}

bool ActiveSet::settle(std::span<const std::size_t> fallen, double fastest, double t,
                       std::span<const double> y, const Known* guess) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    mode_.share = {};
    std::vector<char> slipping(discs().size(), 0);
    for (bool isOther = true; isOther;) {
        const Rows rows = rowsFor(fallen, fastest, slipping);
        if (!rows.hasBounds || !solveLaws(rows, guess)) {
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

bool ActiveSet::slipsSlowly() const {
    constexpr double more = 1.5; // than the least: rounding is no more
    for (std::size_t disc = 0; disc < discs().size(); ++disc)
        if (multipliers_.friction().slips(disc) &&
            multipliers_.friction().beganOf(disc).norm() > more * leastOf(discs()[disc]))
            return true;
    return false;
}

void ActiveSet::takeSlips(double t, std::span<const double> y) {
    if (!slips())
        return;
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    for (std::size_t disc = 0; disc < discs().size(); ++disc)
        if (multipliers_.friction().slips(disc)) {
            mode_.discs[disc].centre = mode_.discs[disc].last = {};
            setSlip(disc);
        }
}

bool ActiveSet::hasForces(double t, std::span<const double> y) {
    f_.fill(t, y);
    return solve();
}

void ActiveSet::followCentres(double t, std::span<const double> y) {
    const auto follows = [this](std::size_t disc) {
        return discs()[disc].hasLevers && multipliers_.friction().acts(disc);
    };
    std::size_t disc = 0;
    while (disc < discs().size() && !follows(disc))
        ++disc;
    if (disc == discs().size() || !hasForces(t, y))
        return;
    for (; disc < discs().size(); ++disc)
        if (follows(disc))
            multipliers_.friction().follow(disc, multipliers_.values(), mode_.discs[disc].last);
}

bool ActiveSet::solveLaws(const Rows& rows, const Known* guess) {
    const auto [a, b] = systemOf(rows.rows);
    Answer known; // without forces all that may rest does
    if (!rows.discs.empty() || guess) {
        known.forces.setZero(b.size());
        known.states.assign(rows.laws.size(), State::inside);
    }
    if (guess) {
        for (std::size_t i = 0; i < rows.rows.size(); ++i)
            known.forces[static_cast<Eigen::Index>(i)] = guess->forces[rows.rows[i]];
        for (std::size_t k = 0; k < rows.laws.size(); ++k) {
            const Law& of = rows.laws[k];
            const State kept = guess->kept[rows.rows[static_cast<std::size_t>(of.first)]];
            const bool isEdge = of.kind != Law::Kind::interval && kept != State::inside;
            known.states[k] = isEdge || of.kind == Law::Kind::slip ? State::edge : kept;
        }
    }
    auto answer = complementarity::solve(a, b, rows.laws, known);
    if (!answer)
        return false;
    holdWithin(a, b, rows.laws, *answer);
    for (Eigen::Index i = 0; i < b.size(); ++i)
        if (isContact(rows.rows[static_cast<std::size_t>(i)]))
            slowest_ = std::max(slowest_, fallenSlow(a(i, i) * answer->forces[i]));
    take(rows, *answer, complementarity::violation(a, b, rows.laws, *answer));
    return true;
}

// `faulty`: by how much the answer breaks the laws.
void ActiveSet::take(const Rows& rows, const Answer& answer, double faulty) {
    const double largest = answer.forces.cwiseAbs().maxCoeff();
    // A force that is smaller than what the answer errs by is none.
    constexpr double more = 10;
    const double none = hasContacts_ ? std::max(noForce, more * faulty) * largest : 0;
    mode_.share.forces.assign(mode_.kept.size(), 0);
    for (std::size_t i = 0; i < rows.rows.size(); ++i)
        mode_.share.forces[rows.rows[i]] = answer.forces[static_cast<Eigen::Index>(i)];
    for (std::size_t k = 0; k < rows.laws.size(); ++k) {
        const Law& of = rows.laws[k];
        const std::size_t row = rows.rows[static_cast<std::size_t>(of.first)];
        if (of.kind == Law::Kind::slip)
            continue;
        if (of.kind == Law::Kind::disc) {
            const DiscFriction::InDisc force =
                complementarity::forcesAt(complementarity::centreOf(of, answer.forces),
                                          answer.forces.segment(of.first, of.rows));
            if (answer.states[k] == State::inside)
                setDisc(*law(row).disc, State::inside);
            else
                setSlip(*law(row).disc, -force, 0);
        } else if (law(row).isBounded()) {
            const bool isNothing = isStop(row) && answer.forces[of.first] <= law(row).low + none;
            mode_.kept[row] = isNothing ? State::low : answer.states[k];
            mode_.touches[row] = isNothing ? 1 : 0;
        }
    }
    for (std::size_t k = 0; k < discs().size(); ++k)
        setCentre(k, multipliers_.friction().centreOf(k, mode_.share.forces));
}

// ---------------------------------------------------------------------------------------------
// Low hops

bool ActiveSet::isOpenContact(std::size_t row) const {
    return isContact(row) && !isGone(row) && mode_.kept[row] == State::low &&
           multipliers_.gap(row) <= law(row).resolution;
}

// Of contacts that close, and of those that this drives into each other: they join `closing`.
bool ActiveSet::endDriven(std::vector<std::size_t>& closing, double none, double t,
                          std::span<double> y) {
    for (std::size_t before = 0; before != closing.size();) {
        before = closing.size();
        if (!endRates(closing, t, y))
            return false;
        for (const std::size_t row : bounded_)
            if (isOpenContact(row) && multipliers_.rate(row) < -none && !isIn(closing, row))
                closing.push_back(row);
    }
    return true;
}

// A contact that touches and parts for a low hop closes at once, and so do contacts that its
// impulse drives into each other, as long as there are forces behind it.
void ActiveSet::closeLow(std::vector<std::size_t> closed, double none, double fastest, double t,
                         std::span<double> y) {
    for (std::size_t round = 0; round < bounded_.size() && hasForces(t, y); ++round) {
        multipliers_.evaluateGaps();
        std::vector<std::size_t> low;
        for (const std::size_t row : bounded_)
            if (const double rate = multipliers_.rate(row), second = multipliers_.secondRate(row);
                isOpenContact(row) && rate > none && hopOf(rate, second) < law(row).hop)
                low.push_back(row);
        if (low.empty())
            return;
        const Mode before = mode_;
        const std::vector<double> moving(y.begin(), y.end());
        const bool isDone = endDriven(low, none, t, y);
        closed.insert(closed.end(), low.begin(), low.end());
        if (!isDone || !settle(closed, fastest, t, y)) {
            mode_ = before;
            std::ranges::copy(moving, y.begin());
            return;
        }
    }
}

// Of contacts that have fallen from low.
void ActiveSet::land(std::span<const std::size_t> fallen, double t, std::span<double> y) {
    std::vector<std::size_t> closing;
    for (const std::size_t k : fallen)
        if (const auto [row, kind, confine] = watches_[k];
            kind == Kind::gap && isContact(row) && !isGone(row))
            closing.push_back(row);
    if (!closing.empty())
        (void)endRates(closing, t, y); // where it cannot, the next projection does
}

bool ActiveSet::endRates(std::span<const std::size_t> closing, double t, std::span<double> y) {
    const std::vector<Mode::Disc> before = mode_.discs;
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    for (std::size_t disc = 0; disc < discs().size(); ++disc)
        if (multipliers_.friction().slips(disc) && !multipliers_.friction().acts(disc))
            setSlip(disc); // it may have a force now, against the way that it goes
    if (!close(multipliers_, rowsToClose(f_, mode_, multipliers_, closing), y)) {
        mode_.discs = before;
        return false;
    }
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    return true;
}

// ---------------------------------------------------------------------------------------------
// Jams: the laws have no answer

namespace {

// From these rates to those of the answer.
bool isTurned(const Law& disc, const Eigen::VectorXd& from, const Answer& answer) {
    constexpr double another = 1e-2; // of an angle
    const auto centre = complementarity::centreOf(disc, answer.forces);
    const Eigen::VectorXd was =
        complementarity::ratesAt(centre, from.segment(disc.first, disc.rows));
    const Eigen::VectorXd is =
        complementarity::ratesAt(centre, answer.rates.segment(disc.first, disc.rows));
    return !((is.normalized() - was.normalized()).norm() < another);
}

} // namespace

// Painleve's rod: its friction turns it into the floor faster than any force of the floor can push
// it away. The limit of ever stiffer contacts is an impact without a collision (Genot, Brogliato
// 1999, "New results on Painleve paradoxes"). Bodies may jam by each other's friction, too, as a
// tower on a corner of its lowest block.
//
// The laws of a next to empty step have an answer: impulses of contacts, with friction against the
// velocities at its end (Moreau 1988, "Unilateral contact and dry friction in finite freedom
// dynamics"). Where there are forces, the impulses are theirs, and change next to nothing; where
// there are none, they are those of the impact. Behind an impact bodies may jam again. Slips that
// are next to none may have no forces on their ways where a longer step takes them to rest.
bool ActiveSet::endJam(std::span<const std::size_t> candidates, double t, std::span<double> y,
                       std::span<const double> rates) {
    constexpr int mostBlows = 8;
    constexpr double shortest = 1e-6, longest = 1e-3, longer = 10;
    const Mode before = mode_;
    const std::vector<double> moving(y.begin(), y.end());
    std::vector<std::size_t> held(candidates.begin(), candidates.end()), slipped;
    bool isDone = false;
    double part = shortest;
    for (int blows = 0; blows < mostBlows && part < 2 * longest && !isDone;) {
        const Mode from = mode_;
        const std::vector<double> behind(y.begin(), y.end());
        const std::optional<JamStep> step = jamStep(held, part, t, y);
        if (!step)
            break;
        if (!step->isImpact) {
            isDone = settle(held, 0, t, y, &step->known) && hasForces(t, y);
            if (!isDone) {
                mode_ = from;
                std::ranges::copy(behind, y.begin());
                part *= longer;
            }
            continue;
        }
        ++blows;
        held.assign(candidates.begin(), candidates.end());
        held.insert(held.end(), step->held.begin(), step->held.end());
        std::ranges::copy_if(step->slipped, std::back_inserter(slipped), [&](std::size_t disc) {
            return std::ranges::any_of(discs()[disc].normals, [&](std::size_t normal) {
                return isIn(step->held, normal); // the impact presses there
            });
        });
        isDone = settleWith({}, held, {}, t, y, rates) && hasForces(t, y);
    }
    if (!isDone) {
        mode_ = before;
        std::ranges::copy(moving, y.begin());
        return false;
    }
    for (const std::size_t disc : slipped)
        for (const std::size_t row : discs()[disc].rows)
            jammed_[row] = 1;
    return true;
}

// Behind an event without forces. A contact that has just closed took its rate away, and slow slips
// go another way; else bodies jam.
void ActiveSet::settleAgain(std::span<const std::size_t> candidates, double t, std::span<double> y,
                            std::span<const double> rates) {
    Mode settled = mode_;
    if (settleWith({}, {candidates.begin(), candidates.end()}, {}, t, y, rates))
        multipliers_.project(t, y);
    else
        mode_ = std::move(settled);
    if (!hasForces(t, y) && endJam(candidates, t, y, rates))
        multipliers_.project(t, y);
}

// With an impact, y and the rows that it holds; else the forces, and slips on the way that they
// give.
std::optional<ActiveSet::JamStep> ActiveSet::jamStep(std::span<const std::size_t> candidates,
                                                     double part, double t, std::span<double> y) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    Rows rows = rowsFor(candidates, 0, std::vector<char>(discs().size(), 0));
    auto [a, b] = systemOf(rows.rows);
    Eigen::VectorXd speeds(b.size());
    for (Eigen::Index i = 0; i < b.size(); ++i)
        speeds[i] = multipliers_.rate(rows.rows[static_cast<std::size_t>(i)]);
    const double fastest = speeds.size() > 0 ? speeds.cwiseAbs().maxCoeff() : 0;
    const double strongest = b.size() > 0 ? b.cwiseAbs().maxCoeff() : 0;
    if (!(fastest > 0 && strongest > 0))
        return std::nullopt;
    const double step = part * fastest / strongest;
    JamStep jam;
    for (Law& of : rows.laws) {
        if (of.kind == Law::Kind::slip) {
            jam.slipped.push_back(*law(rows.rows[static_cast<std::size_t>(of.first)]).disc);
            of.kind = Law::Kind::disc;
        }
        of.low *= step;
        of.high *= step;
        of.radius *= step;
    }
    auto answer = complementarity::solve(a, speeds + step * b, rows.laws);
    if (!answer)
        return std::nullopt;
    constexpr double more = 10; // than loads make of it in the step
    jam.isImpact = (a * answer->forces).cwiseAbs().maxCoeff() > more * step * strongest;
    if (jam.isImpact) {
        multipliers_.push(rows.rows, answer->forces, y);
        for (std::size_t k = 0; k < rows.laws.size(); ++k)
            if (answer->states[k] == State::inside)
                jam.held.push_back(rows.rows[static_cast<std::size_t>(rows.laws[k].first)]);
        return jam;
    }
    answer->forces /= step;
    take(rows, *answer, 0);
    jam.known.forces = std::exchange(mode_.share.forces, {});
    // A slip that the step turns or ends is next to none: it goes on the way of its end, or rests.
    std::vector<std::size_t> turned;
    for (const Law& of : rows.laws)
        if (const auto disc = law(rows.rows[static_cast<std::size_t>(of.first)]).disc;
            disc && isIn(jam.slipped, *disc) && multipliers_.friction().slips(*disc)) {
            if (isTurned(of, speeds, *answer))
                turned.push_back(*disc);
            else
                setSlip(*disc);
        }
    halt(turned, t, y);
    multipliers_.project(t, y);
    jam.known.kept = mode_.kept;
    return jam;
}

} // namespace solution
