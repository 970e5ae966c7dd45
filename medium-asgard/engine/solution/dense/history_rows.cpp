// In what numbers a step is kept; see histories.h.
#include "dense/histories.h"
#include "dense/weighted_sum.h"

namespace solution {

bool History::takePairs(const Pairs& pairs) {
    if (order_)
        return order_->pairs == pairs;
    std::vector<char> isPaired(columns_, 0);
    auto order = std::make_shared<Order>(Order{pairs, std::vector<Order::Column>(columns_)});
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto [place, velocity] = pairs[i];
        if (isPaired[place]++ != 0 || isPaired[velocity]++ != 0)
            return false;
        order->columns[place] = {Order::Kind::place, i};
        order->columns[velocity] = {Order::Kind::velocity, i};
    }
    std::size_t others = 0;
    for (Order::Column& column : order->columns)
        if (column.kind == Order::Kind::other)
            column.which = others++;
    order_ = std::move(order);
    return true;
}

namespace {

// From the first power on, as formulas::differentiate() makes them.
template <std::size_t... I>
bool areDerivatives(const Coefficients& place, const Coefficients& velocity, double scale,
                    std::index_sequence<I...>) {
    const double inverse = 1 / scale;
    const Pair both = {inverse, inverse};
    const auto differs = [&](std::size_t power) {
        const Pair factors = {static_cast<double>(power + 1), static_cast<double>(power + 2)};
        return pairAt(&velocity[power]) != factors * pairAt(&place[power + 1]) * both;
    };
    const auto any = (differs(2 * I + 1) | ...);
    return (any[0] | any[1]) == 0 &&
           velocity[maximumDegree - 1] == maximumDegree * place[maximumDegree] * inverse;
}

} // namespace

bool History::tells(const Coefficients& place, const Coefficients& velocity, double scale) {
    static_assert(maximumDegree % 2 == 0);
    return place[1] == scale * velocity[0] && velocity[maximumDegree] == 0 &&
           areDerivatives(place, velocity, scale,
                          std::make_index_sequence<maximumDegree / 2 - 1>());
}

History::Form History::otherOf(const Step& step, std::size_t which) const {
    return {order_->pairs.size() * step.coefficients + which * step.others, step.others};
}

std::size_t History::sizeOf(const Step& step) const {
    if (step.others == 0)
        return columns_ * step.coefficients;
    return otherOf(step, columns_ - 2 * order_->pairs.size()).first;
}

void History::append(const Step& step, std::span<const Coefficients* const> columns) {
    double* const row = append(step).data();
    if (step.others == 0) {
        for (std::size_t c = 0; c < columns.size(); ++c)
            placeOf(step, c).write(row, *columns[c]);
        return;
    }
    for (std::size_t i = 0; i < order_->pairs.size(); ++i) {
        const auto [place, velocity] = order_->pairs[i];
        const Form form = placeOf(step, i);
        form.write(row, *columns[place]);
        row[form.first + 1] = (*columns[velocity])[0];
    }
    for (std::size_t c = 0; c < columns.size(); ++c)
        if (const auto& [kind, which] = order_->columns[c]; kind == Order::Kind::other)
            otherOf(step, which).write(row, *columns[c]);
}

CoefficientList History::read(const Step& step, const double* row, std::size_t column) const {
    if (step.others == 0)
        return placeOf(step, column).read(row);
    const auto& [kind, which] = order_->columns[column];
    if (kind == Order::Kind::other)
        return otherOf(step, which).read(row);
    CoefficientList place = placeOf(step, which).read(row);
    if (kind == Order::Kind::place) {
        place[1] *= step.scale;
        return place;
    }
    const double inverse = 1 / step.scale;
    CoefficientList velocity(place.size() - 1);
    velocity[0] = place[1];
    for (std::size_t power = 1; power < velocity.size(); ++power)
        velocity[power] = static_cast<double>(power + 1) * place[power + 1] * inverse;
    return velocity;
}

} // namespace solution
