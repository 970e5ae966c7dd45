#include "modes/composed_conditions.h"

#include <algorithm>

namespace solution {

std::vector<ComposedConditions::Block>
ComposedConditions::blocksOf(const std::vector<Composition::Values>& all) {
    std::vector<Block> blocks;
    for (const Composition::Values& values : all) {
        std::vector<double> in(values.model->symbols().size());
        std::ranges::copy(values.constants,
                          in.end() - static_cast<std::ptrdiff_t>(values.constants.size()));
        blocks.push_back({&values, std::move(in)});
    }
    return blocks;
}

ComposedConditions::ComposedConditions(ModelFunctions& functions)
    : f_(functions), of_(*functions.bound()->composed), motion_(blocksOf(of_.motion)),
      places_(blocksOf(of_.places)), values_(of_.motionValues),
      rates_(functions.bound()->model->outputs().size()), beside_(of_.ofPlaces.size()) {}

void ComposedConditions::evaluate(std::vector<Block>& blocks, std::span<double> out) {
    const std::vector<double>& in = f_.in();
    std::size_t first = 0;
    for (auto& [values, own] : blocks) {
        own[0] = in[0];
        for (std::size_t i = 0; i < values->in.size(); ++i)
            own[1 + i] = in[values->in[i]];
        const std::size_t count = values->model->outputs().size();
        values->model->function().evaluate(own, out.subspan(first, count), f_.scratch());
        first += count;
    }
}

void ComposedConditions::second(std::span<double> out) {
    evaluate(motion_, values_);
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
    evaluate(places_, beside_);
    std::ranges::fill(out, 0);
    for (std::size_t k = 0; k < beside_.size(); ++k)
        out[of_.ofPlaces[k]] = beside_[k];
}

void ComposedConditions::moves(std::span<double> out) {
    evaluate(motion_, values_);
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

} // namespace solution
