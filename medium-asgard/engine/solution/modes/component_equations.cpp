#include "modes/component_equations.h"

#include <algorithm>
#include <cmath>

namespace solution {

ComponentEquations::ComponentEquations(std::shared_ptr<const BoundModel> bound,
                                       const Histories& histories)
    : mode_(modelOf(*bound), bound->laws.size()), functions_(std::move(bound), histories, mode_),
      field_(functions_, mode_), stick_(functions_, field_, mode_),
      active_(functions_, field_.multipliers(), mode_),
      guards_(functions_, field_, stick_, active_, mode_),
      solver_(functions_, field_, stick_, active_, guards_, mode_),
      isPlain_(mode_.decisions.empty() && held().empty() && loop().empty() && !hasDirections() &&
               multipliers().empty()),
      readsInputs_(!functions_.bound()->inputs.empty()) {}

static_assert(1 + static_cast<int>(Mode::gone) == static_cast<int>(releasedMode));
static_assert(releasedMode == expression::goneFromStart);
static_assert(1 + static_cast<int>(complementarity::State::inside) == static_cast<int>(heldMode));

namespace {

bool areFinite(std::span<const double> values) {
    // No number as soon as one of them is not finite; in four sums, which need not wait for
    // another.
    double a = 0, b = 0, c = 0, d = 0;
    std::size_t i = 0;
    for (; i + 4 <= values.size(); i += 4) {
        a += 0 * values[i];
        b += 0 * values[i + 1];
        c += 0 * values[i + 2];
        d += 0 * values[i + 3];
    }
    for (; i < values.size(); ++i)
        a += 0 * values[i];
    return a + b + c + d == 0;
}

} // namespace

ComponentEquations::Turns ComponentEquations::turns(double t, std::span<const double> y) {
    std::vector<double> slopes(states().size());
    return rates(t, y, slopes) ? field_.multipliers().turns() : Turns{};
}

bool ComponentEquations::rates(double t, std::span<const double> y, std::span<double> out) {
    if (isPlain_) {
        functions_.plainRates(t, y, out);
        return areFinite(out);
    }
    functions_.fill(t, y);
    if (field_.findRatesAtOnce(out)) {
        slidingFailed_ = false;
        return areFinite(out);
    }
    if (sliding()) {
        slidingFailed_ = !field_.weigh();
        if (slidingFailed_)
            return false;
    } else {
        slidingFailed_ = false;
        field_.find();
        if (field_.isContradictory())
            return false;
        if (mode_.looksBeyond && !areFinite(field_.values()))
            field_.findBeyond();
    }
    std::copy_n(field_.values().begin(), states().size(), out.begin());
    if (active_.hasContacts())
        field_.multipliers().balance(y, out);
    return areFinite(field_.values());
}

void ComponentEquations::project(double t, std::span<double> y) {
    constexpr double none = 1e-12; // of velocities
    field_.multipliers().project(t, y);
    if (active_.hasContacts())
        field_.multipliers().rest(none, y);
}

bool ComponentEquations::lookBeyond(double t, std::span<const double> y) {
    if (mode_.looksBeyond || sliding())
        return false;
    functions_.fill(t, y);
    functions_.evaluateGuards();
    for (std::size_t s = 0; s < model().surfaces().size(); ++s)
        mode_.looksBeyond =
            mode_.looksBeyond ||
            (mode_.isOnSide(s) && std::abs(functions_.guard(s)) <= ModelFunctions::standing);
    return mode_.looksBeyond;
}

bool ComponentEquations::heldValues(double t, std::span<const double> y, std::span<double> out) {
    functions_.fill(t, y);
    field_.find();
    const std::span<const double> values = field_.values();
    std::ranges::copy(values.subspan(states().size()), out.begin());
    return std::all_of(out.begin(), out.end(), [](double x) { return std::isfinite(x); });
}

std::vector<std::size_t> ComponentEquations::notFinite(double t, std::span<const double> y) {
    functions_.fill(t, y);
    std::vector<double> values(field_.size());
    field_.outputs(values);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            found.push_back(i < states().size() ? states()[i] : held()[i - states().size()]);
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<double> ComponentEquations::kept() const {
    std::vector<double> modes;
    for (std::size_t k = 0; k < mode_.kept.size(); ++k)
        modes.push_back(!active_.hasJammed(k) ? 1 + static_cast<double>(mode_.kept[k])
                        : mode_.kept[k] == complementarity::State::inside ? jammedMode
                                                                          : jammedLooseMode);
    return modes;
}

void ComponentEquations::takeKept(std::span<const double> states) {
    using enum complementarity::State;
    for (std::size_t k = 0; k < states.size(); ++k) {
        const int mode =
            static_cast<int>(states[k] == jammedLooseMode ? releasedMode : states[k]) - 1;
        const bool isOpen = mode < 0 && bound()->laws[k].isStop; // nothing moves
        const bool holds = mode < 0 || states[k] == jammedMode;
        mode_.kept[k] = isOpen ? low : holds ? inside : static_cast<complementarity::State>(mode);
    }
    guards_.refresh();
}

bool ComponentEquations::isOff(double t, std::span<const double> y, std::span<const double> kept,
                               Conditions asked) {
    const std::vector<complementarity::State> now = mode_.kept;
    takeKept(kept);
    functions_.fill(t, y);
    field_.multipliers().evaluateGaps();
    const Multipliers& multipliers = field_.multipliers();
    const bool isOff =
        multipliers.isOff(y) || (asked == Conditions::all && multipliers.areOffPlaces());
    mode_.kept = now;
    guards_.refresh();
    return isOff;
}

bool ComponentEquations::movesContacts(const Violation& violation, std::span<const double> y) {
    if (!guards_.isOfPlaces(violation))
        return false;
    fillProjected(violation.time, y);
    return guards_.isOffPlaces(violation);
}

bool ComponentEquations::hasMovedContacts(const Violation& violation, double t,
                                          std::span<const double> y) {
    fillProjected(t, y);
    return guards_.isBeyondPlaces(violation);
}

void ComponentEquations::fillProjected(double t, std::span<const double> y) {
    std::vector<double> projected(y.begin(), y.end());
    project(t, projected);
    functions_.fill(t, projected);
}

void ComponentEquations::takeGone(std::span<const double> values) {
    for (std::size_t k = 0; k < multipliers().size(); ++k) {
        complementarity::State& kept = mode_.kept[k];
        const double mode = values[multipliers()[k]];
        if (mode == releasedMode || mode == jammedLooseMode)
            kept = Mode::gone;
        else if (kept == Mode::gone)
            kept = complementarity::State::inside;
    }
}

bool ComponentEquations::release(std::span<const double> values) {
    bool isAny = false;
    for (std::size_t k = 0; k < multipliers().size(); ++k) {
        const auto& place = bound()->laws[k].release;
        if (place && mode_.kept[k] != Mode::gone && values[*place] != 0) {
            mode_.kept[k] = Mode::gone;
            isAny = true;
        }
    }
    if (isAny)
        guards_.refresh();
    return isAny;
}

bool ComponentEquations::rest(std::span<const std::size_t> directions, double t,
                              std::span<double> y) {
    const bool isDone = stick_.rest(directions, t, y);
    guards_.refresh();
    return isDone;
}

// ---------------------------------------------------------------------------------------------
// The Jacobian

const Pattern& ComponentEquations::jacobianPattern() {
    if (const Composition* const composed = bound()->composed.get())
        return composed->jacobian;
    return model().jacobian().pattern;
}

bool ComponentEquations::jacobian(double t, std::span<const double> y, std::span<double> entries) {
    if (sliding())
        return differences(t, y, entries);
    functions_.fill(t, y);
    if (multipliers().empty()) {
        functions_.evaluate(model().jacobian().entries, entries);
    } else {
        if (!field_.multipliers().solve())
            return false;
        const auto m = static_cast<Eigen::Index>(multipliers().size());
        const auto n = static_cast<Eigen::Index>(states().size());
        MultiplierSlopes slopes{
            Eigen::MatrixXd::Zero(m, n),
            Eigen::MatrixXd::Zero(2 * m + conditionsOf(*bound()).firstLever.back(), n)};
        if (ComposedConditions* const composed = field_.multipliers().composed())
            composed->differentiate(entries, slopes.second, slopes.gaps);
        else
            differentiate(entries, slopes);
        addMultipliers(slopes, entries);
    }
    return std::ranges::all_of(entries, [](double x) { return std::isfinite(x); }) ||
           differences(t, y, entries);
}

void ComponentEquations::differentiate(std::span<double> entries, MultiplierSlopes& slopes) {
    const ComponentModel::Jacobian& jacobian = model().jacobian();
    std::vector<double> all(entries.size() + jacobian.ofConditions.size() + jacobian.ofGaps.size());
    functions_.evaluate(jacobian.entries, all);
    std::copy_n(all.begin(), entries.size(), entries.begin());
    std::size_t next = entries.size();
    for (const ComponentModel::Entry& entry : jacobian.ofConditions)
        slopes.second(entry.row, entry.column) = all[next++];
    for (const ComponentModel::Entry& entry : jacobian.ofGaps)
        slopes.gaps(entry.row, entry.column) = all[next++];
}

// With A m + b = 0:  df/dy + df/dm dm/dy,  and  A dm/dy = -d(A m + b)/dy. Friction that slips
// follows gaps, their rates and levers, too.
void ComponentEquations::addMultipliers(MultiplierSlopes& slopes, std::span<double> entries) {
    const std::vector<ComponentModel::Entry>& pushed = conditionsOf(*bound()).pushes;
    const std::span<const double> moves = field_.multipliers().moves();
    Eigen::MatrixXd pushes = Eigen::MatrixXd::Zero(slopes.second.cols(), slopes.second.rows());
    for (std::size_t k = 0; k < pushed.size(); ++k)
        pushes(pushed[k].row, pushed[k].column) = moves[k];
    field_.multipliers().linearise();
    const Pattern& pattern = jacobianPattern();
    for (Eigen::Index column = 0; column < slopes.second.cols(); ++column) {
        auto change = slopes.second.col(column);
        auto gaps = slopes.gaps.col(column);
        if (change.isZero(0) && gaps.isZero(0))
            continue;
        field_.multipliers().change({gaps.data(), static_cast<std::size_t>(gaps.rows())}, change);
        const auto first = static_cast<std::size_t>(column);
        for (int k = pattern.columnStarts[first]; k < pattern.columnStarts[first + 1]; ++k)
            entries[static_cast<std::size_t>(k)] +=
                pushes.row(pattern.rows[static_cast<std::size_t>(k)]).dot(change);
    }
}

// While sliding f is a mixture whose weights depend on y too; few unknowns slide, so differences
// do; so they do where derivatives overflow (of 1/cosh(x)^2, far out) while rates do not. What
// stays on its surface exactly moves nothing, and may have no value beside it.
bool ComponentEquations::differences(double t, std::span<const double> y,
                                     std::span<double> entries) {
    std::vector<double> at(y.begin(), y.end()), low(states().size()), high(states().size());
    const Pattern& pattern = jacobianPattern();
    for (std::size_t column = 0; column < states().size(); ++column) {
        if (std::ranges::any_of(field_.columns(), [&](const HeldField::Column& c) {
                return field_.gradientOf(c).state == column;
            })) {
            for (int k = pattern.columnStarts[column]; k < pattern.columnStarts[column + 1]; ++k)
                entries[static_cast<std::size_t>(k)] = 0;
            continue;
        }
        const double step = 6e-6 * std::max(1e-3, std::abs(y[column]));
        at[column] = y[column] + step;
        if (!rates(t, at, high))
            return false;
        at[column] = y[column] - step;
        if (!rates(t, at, low))
            return false;
        at[column] = y[column];
        for (int k = pattern.columnStarts[column]; k < pattern.columnStarts[column + 1]; ++k) {
            const auto row = static_cast<std::size_t>(pattern.rows[static_cast<std::size_t>(k)]);
            entries[static_cast<std::size_t>(k)] = (high[row] - low[row]) / (2 * step);
        }
    }
    return true;
}

} // namespace solution
