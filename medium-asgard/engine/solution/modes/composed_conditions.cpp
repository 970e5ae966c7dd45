#include "modes/composed_conditions.h"

#include <algorithm>

namespace solution {

ComposedConditions::ComposedConditions(ModelFunctions& functions)
    : f_(functions), of_(*functions.bound()->composed), values_(of_.values),
      rates_(functions.bound()->model->outputs().size()) {
    for (const Composition::Block& block : of_.blocks) {
        std::vector<double> in(block.model->symbols().size());
        std::ranges::copy(block.constants,
                          in.begin() + static_cast<std::ptrdiff_t>(block.model->variables()));
        blocks_.push_back({&block, std::move(in)});
    }
}

void ComposedConditions::fill(Block& block) const {
    block.in[0] = f_.in()[0];
    for (const auto& [place, of] : block.of->read)
        block.in[place] = f_.in()[of];
}

void ComposedConditions::evaluate() {
    std::size_t first = 0;
    for (Block& block : blocks_) {
        fill(block);
        const ComponentModel& model = *block.of->model;
        const std::size_t count = model.outputs().size();
        model.function().evaluate(block.in, std::span(values_).subspan(first, count), f_.scratch());
        first += count;
    }
}

void ComposedConditions::second(std::span<double> out) {
    evaluate();
    std::ranges::fill(out, 0);
    for (const auto& [into, factor, push] : of_.matrix)
        out[into] += values_[factor] * values_[push];
    const std::span<double> rest = out.subspan(of_.conditions.matrix.size());
    for (const auto& [row, value] : of_.steady)
        rest[row] = values_[value];
    f_.bound()->model->function().evaluate(f_.symbols(), rates_, f_.scratch());
    for (const Composition::Term& term : of_.by)
        rest[term.row] += values_[term.value] * rates_[term.state];
}

void ComposedConditions::gaps(std::span<double> out) {
    std::ranges::fill(out, 0);
    for (Block& block : blocks_) {
        fill(block);
        ofBlock_.resize(block.of->gaps.size());
        block.of->model->conditions().gaps.function.evaluate(block.in, ofBlock_, f_.scratch());
        for (std::size_t k = 0; k < ofBlock_.size(); ++k)
            out[block.of->gaps[k]] = ofBlock_[k];
    }
}

void ComposedConditions::moves(std::span<double> out) {
    evaluate();
    const std::size_t pushes = of_.pushes.size();
    for (std::size_t k = 0; k < pushes; ++k)
        out[k] = values_[of_.pushes[k].value];
    const ComponentModel::Kinematics& kinematics = f_.bound()->model->kinematics();
    slopes_.resize(kinematics.entries.size());
    f_.evaluate(kinematics.slopes, slopes_);
    const std::span<double> shifts = out.subspan(pushes);
    std::ranges::fill(shifts, 0);
    for (const auto& [into, factor, push] : of_.shifts)
        shifts[into] += slopes_[factor] * values_[push];
}

void ComposedConditions::addForces(std::span<double> rates) const {
    const std::size_t first = f_.in().size() - of_.conditions.isTie.size();
    for (const Composition::Term& push : of_.pushes)
        rates[push.state] += values_[push.value] * f_.in()[first + push.row];
}

// With a the rates of states and F what they are without multipliers:
//
//     d(a) = dF + d(P m)      d(g'') = d(steady + by a at these rates) + by d(a)
void ComposedConditions::differentiate(std::span<double> ofRates, Eigen::MatrixXd& ofConditions,
                                       Eigen::MatrixXd& ofGaps) {
    const ComponentModel& model = *f_.bound()->model;
    const auto states = static_cast<Eigen::Index>(model.states());
    std::ranges::fill(ofRates, 0);
    Eigen::Map<Eigen::MatrixXd> rates(ofRates.data(), states, states);
    const auto add = [&](const Pattern& pattern, auto&& stateAt) {
        for (std::size_t column = 0; column < pattern.size(); ++column)
            for (auto k = static_cast<std::size_t>(pattern.columnStarts[column]);
                 k < static_cast<std::size_t>(pattern.columnStarts[column + 1]); ++k)
                rates(stateAt(static_cast<std::size_t>(pattern.rows[k])), stateAt(column)) +=
                    slopes_[k];
    };
    slopes_.resize(model.jacobian().pattern.entries());
    f_.evaluate(model.jacobian().entries, slopes_);
    add(model.jacobian().pattern, [](std::size_t i) { return static_cast<Eigen::Index>(i); });
    model.function().evaluate(f_.symbols(), rates_, f_.scratch());
    addForces(rates_);
    const std::size_t first = f_.in().size() - of_.conditions.isTie.size();
    for (Block& block : blocks_) {
        fill(block);
        for (const auto& [place, state] : block.of->rates)
            block.in[place] = rates_[state];
        const std::vector<std::uint32_t>& rows = block.of->rows;
        for (std::size_t k = 0; k < rows.size(); ++k)
            block.in[block.in.size() - rows.size() + k] = f_.in()[first + rows[k]];
        const ComponentModel::Jacobian& jacobian = block.of->model->jacobian();
        const std::size_t entries = jacobian.pattern.entries();
        slopes_.resize(entries + jacobian.ofConditions.size() + jacobian.ofGaps.size());
        jacobian.entries.function.evaluate(block.in, slopes_, f_.scratch());
        const std::vector<std::uint32_t>& at = block.of->states;
        add(jacobian.pattern, [&](std::size_t i) { return static_cast<Eigen::Index>(at[i]); });
        auto slope = slopes_.begin() + static_cast<std::ptrdiff_t>(entries);
        for (const auto& [row, column] : jacobian.ofConditions)
            ofConditions(rows[row], at[column]) += *slope++;
        for (const auto& [row, column] : jacobian.ofGaps)
            ofGaps(block.of->gaps[row], at[column]) += *slope++;
    }
    for (Eigen::Index column = 0; column < states; ++column)
        for (const Composition::Term& by : of_.by)
            ofConditions(by.row, column) += values_[by.value] * rates(by.state, column);
}

} // namespace solution
