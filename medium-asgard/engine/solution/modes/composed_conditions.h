// The conditions of a component at one point, where they are put together from blocks
// (equations/composition.h): the values that a model with conditions has as functions. Nothing
// switches there: such a component keeps one expression.
#pragma once

#include "modes/model_functions.h"

#include <Eigen/Core>

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
    // By states, with the point's multipliers as they are, at the point of second(): of the rates,
    // in the order of Composition::jacobian; of second rates; and of the values of gaps().
    void differentiate(std::span<double> ofRates, Eigen::MatrixXd& ofConditions,
                       Eigen::MatrixXd& ofGaps);

private:
    struct Block {
        const Composition::Block* of;
        std::vector<double> in;
    };
    void fill(Block& block) const;
    void evaluate();

    ModelFunctions& f_;
    const Composition& of_;
    std::vector<Block> blocks_;
    std::vector<double> values_; // of all blocks
    std::vector<double> rates_, ofBlock_, slopes_;
};

} // namespace solution
