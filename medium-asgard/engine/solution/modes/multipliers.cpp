#include "modes/multipliers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace solution {

using complementarity::State;

namespace {

// Of the size of what a condition joins: its resolution; one without any is of a thing of size 1.
constexpr double resolvedOfSize = 1e-9;

Eigen::Index indexOf(std::size_t i) { return static_cast<Eigen::Index>(i); }

} // namespace

// All conditions at the point.
void Multipliers::evaluate() {
    const std::size_t entries = conditions_.matrix.size();
    second_.resize(entries + size());
    if (composed_)
        composed_->second(second_);
    else if (mode_.sticking.empty())
        f_.evaluate(conditions_.second, second_);
    else
        f_.evaluate(model_.directions().second, f_.inHeld(), second_);
    rest_ = Eigen::Map<const Eigen::VectorXd>(second_.data() + entries, indexOf(size()));
}

double Multipliers::bound(std::size_t row) const {
    if (mode_.kept[row] == Mode::gone)
        return 0;
    const BoundModel::Law& law = f_.bound()->laws[row];
    if (law.disc)
        return 0; // it follows normal forces (slip_forces.h)
    return mode_.kept[row] == State::high ? law.high : law.low;
}

// Places of the point off the conditions that hold, over the sizes of what these join.
double Multipliers::placesOff() {
    evaluateGaps();
    return resolvedOfSize * largestGap();
}

// The most of the second rates of redundant conditions, scaled, that is left because places and
// velocities are off the conditions, as within a step. No forces change it, and at the step's end,
// which is on the conditions, it is none.
double Multipliers::leftOff() {
    constexpr double caution = 10;
    const double places = placesOff();
    double rates = 0;
    for (std::size_t i = 0; i < held_.rows().size(); ++i)
        rates = std::max(rates, held_.scale(i) * std::abs(rate(held_.rows()[i])));
    return caution * (places * held_.right().cwiseAbs().maxCoeff() +
                      rates * fastest(std::span(f_.in()).subspan(1)));
}

// The last solution keeps all conditions that hold.
bool Multipliers::isSolved() {
    constexpr double rounding = 1e-7;
    if (held_.isRegular() || held_.rows().empty())
        return true;
    const Eigen::VectorXd errors = held_.left().cwiseAbs();
    double most = rounding * std::max(held_.right().cwiseAbs().maxCoeff(), 1e-100);
    if (errors.maxCoeff() > most)
        most = std::max(most, leftOff());
    unheld_.contradictory.clear();
    for (std::size_t i = 0; i < held_.rows().size(); ++i)
        if (!(errors[indexOf(i)] <= most))
            unheld_.contradictory.push_back(held_.rows()[i]);
    return unheld_.contradictory.empty();
}

void Multipliers::findApart() {
    constexpr double few = 1e3, many = 1e7; // of the resolution
    for (std::size_t row = 0; row < size(); ++row) {
        const BoundModel::Law& law = f_.bound()->laws[row];
        if (!holds(row))
            continue;
        const double gap = law.isBounded() ? 0 : std::abs(gaps_[row]);
        for (const auto& [most, list] :
             {std::pair(few, &unheld_.apart), std::pair(many, &unheld_.farApart)})
            if (gap > most * law.resolution && std::ranges::find(*list, row) == list->end())
                list->push_back(row);
    }
}

// What is left of rates after the velocities that were just solved for, where it is more than a
// resolution in the unit of time and than what a contact's tilt makes of the velocities: its points
// keep gaps of up to a resolution, a billionth of the size, and are as near as a thirtieth of it.
// Conditions that are next to redundant multiply rounding: rates that are none before are no
// contradiction. False: these velocities are worse than those of before.
bool Multipliers::findContradictory(std::span<const double> y) {
    constexpr double tilt = 3e-8;
    if (held_.isRegular() || held_.rows().empty())
        return true;
    double fastest = 0;
    for (const ComponentModel::Entry& push : conditions_.pushes)
        fastest = std::max(fastest, std::abs(y[push.row]));
    const Eigen::VectorXd left = held_.left();
    bool areNone = true;
    for (std::size_t i = 0; i < held_.rows().size(); ++i) {
        const std::size_t row = held_.rows()[i];
        const double most = std::max(f_.bound()->laws[row].resolution, tilt * fastest);
        areNone = areNone && std::abs(rate(row)) <= most;
        if (std::abs(left[indexOf(i)] / held_.scale(i)) > most)
            unheld_.contradictory.push_back(row);
    }
    const bool isWorse = areNone && !unheld_.contradictory.empty();
    if (isWorse)
        unheld_.contradictory.clear();
    return !isWorse;
}

// To second rates, of what stands at a bound.
void Multipliers::addBounds() {
    if (std::ranges::all_of(mode_.kept, [](State kept) { return kept == State::inside; }))
        return;
    const auto& matrix = conditions_.matrix;
    for (std::size_t k = 0; k < matrix.size(); ++k)
        if (mode_.kept[matrix[k].column] != State::inside)
            rest_[matrix[k].row] += bound(matrix[k].column) * second_[k];
}

bool Multipliers::holdAlways() const {
    return std::ranges::none_of(f_.bound()->laws, [](const BoundModel::Law& law) {
        return law.isBounded() || law.isStop || law.release || law.leaving;
    });
}

// Conditions that are redundant at the first point are so everywhere, as a rule; the same holds of
// a matrix that is not symmetric there. For these the code would be made and evaluated in vain.
bool Multipliers::areSolvedAtOnceHere() {
    if (!atOnce_.isDecided && mode_.sticking.empty()) {
        atOnce_.isDecided = true;
        if (size() > 0 && !composed_ && holdAlways()) {
            evaluate();
            if (factorise() && held_.isEliminated())
                atOnce_.model = model_.solved();
        }
    }
    return areSolvedAtOnce();
}

bool Multipliers::solveWith(std::span<double> outputs) {
    atOnce_.isLast = false;
    if (!areSolvedAtOnceHere())
        return false;
    atOnce_.values.resize(atOnce_.model->all.tape().outputs());
    atOnce_.model->all.evaluate(f_.in(), atOnce_.values, f_.scratch());
    const double* const values = atOnce_.values.data();
    const std::size_t forces = model_.outputs().size();
    if (!atOnce_.isPositive(forces + size()))
        return false;
    std::copy_n(values, outputs.size(), outputs.begin());
    std::copy_n(values + forces, size(), std::span(f_.in()).last(size()).begin());
    areFound_ = true;
    atOnce_.isLast = true;
    return true;
}

std::string Multipliers::how() const {
    return atOnce_.isLast ? howEliminated(atOnce_.model->rows, atOnce_.model->multiplications)
                          : held_.how();
}

bool Multipliers::solve() {
    areFound_ = true;
    atOnce_.isLast = false;
    if (size() == 0)
        return true;
    evaluate();
    addBounds();
    if (!factorise())
        return false;
    const Eigen::VectorXd rest = rest_;
    if (solveHeld())
        return true;
    if (held_.isRegular() || !held_.factoriseClosely(matrix()))
        return false;
    unheld_.contradictory.clear();
    rest_ = rest;
    return solveHeld();
}

bool Multipliers::solveHeld() {
    slips_.find(f_.bound()->discs.size());
    areFound_ = true;
    if (!slips_.empty()) {
        evaluateGaps();
        found_ = rest_;
        held_.solve(found_, mode_.share.forces);
        areFound_ = slips_.solve(matrix(), held_, found_);
        slips_.addTo(rest_, matrix());
    }
    found_ = rest_;
    held_.solve(found_, mode_.share.forces);
    areFound_ = areFound_ && found_.allFinite() && isSolved();
    const std::span<double> into = std::span(f_.in()).last(size());
    for (std::size_t row = 0; row < size(); ++row)
        into[row] = holds(row) ? found_[indexOf(row)] : bound(row);
    if (!slips_.empty())
        slips_.putInto(into);
    return areFound_;
}

void Multipliers::take(const Solution& solution) {
    second_ = solution.second;
    for (std::size_t row = 0; row < size(); ++row)
        put(row, solution.values[row]);
}

void Multipliers::linearise() {
    if (!slips_.empty())
        slips_.linearise(values());
}

void Multipliers::change(std::span<const double> gaps, Eigen::Ref<Eigen::VectorXd> change) {
    if (slips_.empty())
        held_.solve(change);
    else
        slips_.change(values(), gaps, held_, change);
}

double Multipliers::secondRate(std::size_t row) const {
    const auto& matrix = conditions_.matrix;
    double rate = second_[matrix.size() + row];
    for (auto entry = std::ranges::lower_bound(matrix, row, {}, &ComponentModel::Entry::row);
         entry != matrix.end() && entry->row == row; ++entry)
        rate += second_[static_cast<std::size_t>(entry - matrix.begin())] * values()[entry->column];
    return rate;
}

Multipliers::Turns Multipliers::turns() {
    constexpr double often = 10; // times on the way to rest
    if (f_.bound()->discs.empty())
        return {};
    evaluateGaps();
    const std::vector<ComponentModel::Entry>& entries = conditions_.matrix;
    std::vector<double> ofRow(size(), 0);
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (entries[i].row == entries[i].column)
            ofRow[entries[i].row] = std::abs(second_[i]);
    Turns turns;
    for (std::size_t k = 0; k < f_.bound()->discs.size(); ++k) {
        if (!friction_.acts(k))
            continue;
        double most = 0;
        for (const std::size_t row : friction_.disc(k).rows)
            most = std::max(most, ofRow[row]);
        const DiscFriction::Slope slope = friction_.slopeOf(k, friction_.velocityOf(k), values());
        const double rate =
            most * friction_.disc(k).sliding * slope.all.pressed * std::abs(slope.turning);
        turns.fastest = std::max(turns.fastest, rate);
        const auto duration = rate > 0 ? stopOf(k) : std::nullopt;
        if (duration && rate * *duration > often &&
            !(turns.stop && turns.stop->duration <= *duration))
            turns.stop = {k, *duration};
    }
    return turns;
}

// How long until little is left of a slip that comes to rest straight along its rates: the larger
// of ten times what it has across its way then, and of some times the speed under which the
// direction counts in which it began. It keeps its direction up to there.
std::optional<double> Multipliers::stopOf(std::size_t disc) const {
    constexpr double straight = 0.01, ofAcross = 10, ofBegan = 4, little = 0.1;
    const DiscFriction::InDisc slip = friction_.slipOf(disc);
    const DiscFriction::InDisc rate =
        friction_.slipBy(disc, [this](std::size_t row) { return secondRate(row); });
    const double braked = -slip.dot(rate), speed = slip.norm();
    if (!(braked > 0))
        return std::nullopt;
    const double duration = speed * speed / braked;
    const double across = (slip + duration * rate).norm();
    const double left = std::max(ofAcross * across, ofBegan * friction_.beganOf(disc).norm());
    if (!(across < straight * speed && left < little * speed))
        return std::nullopt;
    return duration * (1 - left / speed);
}

double Multipliers::weight() const {
    const auto& matrix = conditions_.matrix;
    double largest = 0;
    for (std::size_t k = 0; k < matrix.size(); ++k)
        if (const auto [row, column] = matrix[k];
            row == column && holds(row) && f_.bound()->laws[row].leaving)
            largest = std::max(largest, second_[k] * values()[row]);
    return largest;
}

Multipliers::System Multipliers::systemOf(std::span<const std::size_t> rows) {
    evaluate();
    const auto& matrix = conditions_.matrix;
    constexpr Eigen::Index none = -1;
    std::vector<Eigen::Index> placeOf(size(), none);
    for (std::size_t i = 0; i < rows.size(); ++i)
        placeOf[rows[i]] = indexOf(i);
    std::vector<double> others(size(), 0); // values of those that are not among the rows
    for (std::size_t row = 0; row < size(); ++row)
        if (placeOf[row] == none && mode_.kept[row] != State::inside)
            others[row] = bound(row);
    for (std::size_t k = 0; k < matrix.size(); ++k)
        if (const auto [row, column] = matrix[k]; row == column && placeOf[row] == none &&
                                                  mode_.kept[row] == State::inside &&
                                                  !f_.bound()->laws[row].isOnSecondRates)
            others[row] = -rest_[indexOf(row)] / second_[k];
    System system{Eigen::MatrixXd::Zero(indexOf(rows.size()), indexOf(rows.size())),
                  Eigen::VectorXd(indexOf(rows.size()))};
    for (std::size_t i = 0; i < rows.size(); ++i)
        system.rest[indexOf(i)] = rest_[indexOf(rows[i])];
    for (std::size_t k = 0; k < matrix.size(); ++k) {
        const Eigen::Index row = placeOf[matrix[k].row], column = placeOf[matrix[k].column];
        if (row == none)
            continue;
        if (column != none)
            system.matrix(row, column) += second_[k];
        else if (others[matrix[k].column] != 0)
            system.rest[row] += others[matrix[k].column] * second_[k];
    }
    return system;
}

void Multipliers::push(std::span<const std::size_t> rows, const Eigen::VectorXd& impulses,
                       std::span<double> y) {
    Eigen::VectorXd by = Eigen::VectorXd::Zero(indexOf(size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        by[indexOf(rows[i])] = impulses[indexOf(i)];
    evaluateMoves();
    move(conditions_.pushes, 0, by, y);
}

void Multipliers::rest(double none, std::span<double> y) const {
    const auto& pushes = conditions_.pushes;
    if (std::ranges::all_of(pushes,
                            [&](const auto& push) { return std::abs(y[push.row]) <= none; }))
        for (const ComponentModel::Entry& push : pushes)
            y[push.row] = 0;
}

// The gaps of stops of joints and ropes read angles, which their ties put back: with the tie of an
// angle off, such a stop would be found open that holds.
bool Multipliers::isOff(std::span<const double> y) const {
    constexpr double ofResolution = 0.1, ofVelocities = 1e-9;
    const double slow = ofVelocities * fastest(y);
    bool isStopHeld = false, isTieOff = false;
    for (std::size_t row = 0; row < size(); ++row) {
        const BoundModel::Law& law = f_.bound()->laws[row];
        if (!holds(row))
            continue;
        const bool isApart = std::abs(gap(row)) > ofResolution * law.resolution;
        isStopHeld = isStopHeld || (law.isStop && !law.leaving);
        isTieOff = isTieOff || (!law.isOnSecondRates && isApart);
        if ((law.isStop && isApart) || ((law.isStop || law.disc) && std::abs(rate(row)) > slow))
            return true;
    }
    return isStopHeld && isTieOff;
}

bool Multipliers::areOffPlaces() const { return largestGap() > 1; }

double Multipliers::fastest(std::span<const double> y) const {
    double most = 0;
    for (const ComponentModel::Entry& push : conditions_.pushes)
        most = std::max(most, std::abs(y[push.row]));
    return most;
}

void Multipliers::balance(std::span<const double> y, std::span<double> rates) {
    constexpr double rounding = 1e-13; // of the forces
    const auto& pushes = conditions_.pushes;
    if (std::ranges::any_of(pushes, [&](const auto& push) { return y[push.row] != 0; }))
        return;
    evaluateMoves();
    double force = 0;
    for (std::size_t k = 0; k < pushes.size(); ++k)
        force = std::max(force, std::abs(moves_[k] * values()[pushes[k].column]));
    if (std::ranges::all_of(pushes, [&](const auto& push) {
            return std::abs(rates[push.row]) <= rounding * force;
        }))
        for (const ComponentModel::Entry& push : pushes)
            rates[push.row] = 0;
}

void Multipliers::evaluateGaps() {
    gaps_.resize(2 * size() + conditions_.firstLever.back());
    if (composed_)
        composed_->gaps(gaps_);
    else
        f_.evaluate(conditions_.gaps, gaps_);
}

void Multipliers::evaluateMoves() {
    moves_.resize(conditions_.pushes.size() + conditions_.shifts.size());
    if (composed_)
        composed_->moves(moves_);
    else
        f_.evaluate(conditions_.moves, moves_);
}

// Adds entries times `by` to the states.
void Multipliers::move(std::span<const ComponentModel::Entry> entries, std::size_t first,
                       const Eigen::VectorXd& by, std::span<double> y) const {
    for (std::size_t k = 0; k < entries.size(); ++k)
        y[entries[k].row] += moves_[first + k] * by(entries[k].column);
}

// The largest over the resolution of its condition.
double Multipliers::largestGap() const {
    double largest = 0;
    for (std::size_t row = 0; row < size(); ++row) {
        if (!holds(row))
            continue;
        const double resolution = f_.bound()->laws[row].resolution;
        const double gap = std::abs(gaps_[row]) / (resolution > 0 ? resolution : resolvedOfSize);
        if (!(gap <= largest)) // no number stays
            largest = gap;
    }
    return largest;
}

bool Multipliers::factorise() {
    return held_.factorise(matrix(), [this] { return placesOff(); });
}

bool Multipliers::factoriseMoves() {
    ties_.resize(conditions_.ofTies.size());
    if (!ties_.empty())
        f_.evaluate(conditions_.ties, ties_);
    if (atOnce_.projects) {
        atOnce_.in = f_.in();
    } else {
        evaluate();
        if (!factorise())
            return false;
    }
    evaluateMoves();
    return true;
}

// Of these rates, in found_, the multipliers that keep them, in their place; by the matrix of the
// point where factoriseMoves() was called.
bool Multipliers::solveRates() {
    if (!atOnce_.projects) {
        held_.solve(found_);
        return true;
    }
    const expression::Function& given = atOnce_.model->given;
    atOnce_.in.resize(f_.in().size());
    atOnce_.in.insert(atOnce_.in.end(), found_.data(), found_.data() + found_.size());
    atOnce_.values.resize(given.tape().outputs());
    given.evaluate(atOnce_.in, atOnce_.values, f_.scratch());
    std::copy_n(atOnce_.values.data(), size(), found_.data());
    return atOnce_.isPositive(size());
}

// Multipliers that move states onto their gaps. A tie moves an angle of its own, which others read.
bool Multipliers::solveForGaps() {
    const std::vector<ComponentModel::Entry>& entries = conditions_.ofTies;
    const auto putTies = [&] {
        for (std::size_t k = 0; k < entries.size(); ++k)
            if (const auto [row, column] = entries[k]; row == column)
                found_[indexOf(row)] = holds(row) ? -gaps_[row] / ties_[k] : 0;
    };
    found_ = Eigen::Map<const Eigen::VectorXd>(gaps_.data(), indexOf(size()));
    putTies();
    for (std::size_t k = 0; k < entries.size(); ++k)
        if (const auto [row, column] = entries[k]; row != column)
            found_[indexOf(row)] += ties_[k] * found_[indexOf(column)];
    if (!solveRates())
        return false;
    putTies();
    return true;
}

// Newton's method, with the matrix of before where that lets gaps shrink fast enough. At its end
// gaps and their rates are those of the states, and so is the matrix but for what a move by a
// resolution changes. False: there is none.
bool Multipliers::moveOntoGaps(double t, std::span<double> y) {
    constexpr int most = 8;
    constexpr double rounding = 1e-6, near = 1; // of resolutions
    constexpr double slow = 1e-3;
    f_.fill(t, y);
    evaluateGaps();
    if (!factoriseMoves())
        return false;
    findApart();
    double last = std::numeric_limits<double>::infinity();
    bool isFar = false;
    for (int round = 0; round < most; ++round) { // until rounding lets it shrink no more
        const double gap = largestGap();
        if (gap <= rounding || !(gap < 0.5 * last))
            break;
        if (isFar && gap > slow * last) {
            if (!factoriseMoves())
                return false;
            isFar = false;
        }
        isFar = isFar || gap > near;
        if (!solveForGaps())
            return false;
        if (!found_.allFinite())
            break;
        move(conditions_.shifts, conditions_.pushes.size(), found_, y);
        last = gap;
        f_.fill(t, y);
        evaluateGaps();
    }
    return !isFar || factoriseMoves();
}

void Multipliers::project(double t, std::span<double> y) {
    if (size() == 0)
        return;
    unheld_.contradictory.clear();
    if (!atOnce_.isDecided)
        f_.fill(t, y);
    atOnce_.projects = areSolvedAtOnceHere();
    if (atOnce_.projects)
        atOnce_.before.assign(y.begin(), y.end());
    if (!moveOntoConditions(t, y) && atOnce_.projects) {
        std::ranges::copy(atOnce_.before, y.begin());
        atOnce_.projects = false;
        (void)moveOntoConditions(t, y);
    }
}

// False: there is no solution, or not by machine code.
bool Multipliers::moveOntoConditions(double t, std::span<double> y) {
    if (!moveOntoGaps(t, y))
        return false;
    found_ = Eigen::Map<const Eigen::VectorXd>(gaps_.data() + size(), indexOf(size()));
    if (!solveRates())
        return false;
    if ((atOnce_.projects || findContradictory(y)) && found_.allFinite())
        move(conditions_.pushes, 0, found_, y);
    return true;
}

} // namespace solution
