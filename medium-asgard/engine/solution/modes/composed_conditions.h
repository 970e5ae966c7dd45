// The conditions of a component at one point, where they are put together from blocks
// (equations/composition.h): the values that a model with conditions has as functions. Nothing
// switches there: such a component keeps one expression.
#pragma once

#include "modes/model_functions.h"

#include <span>
#include <vector>

namespace solution {

class ComposedConditions {
public:
    explicit ComposedConditions(ModelFunctions& functions);

    // At the point of the functions. As Conditions::second: the matrix, then the rest.
    void second(std::span<double> out);
    // As Conditions::gaps.
    void gaps(std::span<double> out);
    // As Conditions::moves.
    void moves(std::span<double> out);
    // To rates without multipliers, at the point of second(), what the point's multipliers add.
    void addForces(std::span<double> rates) const;

private:
    struct Block {
        const Composition::Values* values;
        std::vector<double> in;
    };
    [[nodiscard]] static std::vector<Block> blocksOf(const std::vector<Composition::Values>& all);
    void evaluate(std::vector<Block>& blocks, std::span<double> out);

    ModelFunctions& f_;
    const Composition& of_;
    std::vector<Block> motion_, places_;
    std::vector<double> values_; // of motion
    std::vector<double> rates_, beside_, slopes_;
};

} // namespace solution
