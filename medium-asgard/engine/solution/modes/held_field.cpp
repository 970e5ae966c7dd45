#include "modes/held_field.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace solution {

HeldField::HeldField(ModelFunctions& functions, Mode& mode)
    : f_(functions), model_(*mode.model), mode_(mode), multipliers_(functions, mode),
      values_(model_.outputs().size()) {}

// A state that lies on a surface of its own is moved off it, to its side, by next to nothing: what
// is written v/abs(v) is then the sign that it means, and v abs(v) is still 0.
void HeldField::outputs(std::span<double> out) {
    bool isMoved = false;
    if (!mode_.decisions.empty())
        for (const auto& [surface, state] : model_.ownGuards())
            if (f_.in()[1 + state] == 0 && mode_.sides[surface] != Mode::onSurface) {
                f_.in()[1 + state] = mode_.sides[surface] * ModelFunctions::nextToNothing;
                isMoved = true;
            }
    evaluateOutputs(out);
    if (!isMoved)
        return;
    for (const auto& [surface, state] : model_.ownGuards())
        if (std::abs(f_.in()[1 + state]) == ModelFunctions::nextToNothing)
            f_.in()[1 + state] = 0;
    for (double& rate : out)
        if (std::abs(rate) <= vanishing)
            rate = 0;
}

void HeldField::findBeyond() {
    const std::vector<expression::Decision> held = mode_.decisions;
    f_.decide(mode_.decisions);
    if (mode_.decisions != held)
        evaluateOutputs(values_);
    mode_.decisions = held;
}

void HeldField::find() {
    if (!mode_.isHeld() || !weigh())
        outputs(values_);
}

namespace {

// Of several solutions, as at rest on the surface of a place and on that of its velocity, the one
// that is nearest to the middle; weights beyond [0, 1] are put to their ends, one after the other.
Eigen::VectorXd weightsFor(const Eigen::MatrixXd& change, const Eigen::VectorXd& wanted) {
    const Eigen::FullPivLU<Eigen::MatrixXd> lu = change.fullPivLu();
    if (lu.isInvertible())
        return lu.solve(wanted);
    Eigen::MatrixXd open = change; // columns of those that are not at an end
    Eigen::VectorXd w = Eigen::VectorXd::Constant(wanted.size(), 0.5);
    for (Eigen::Index round = 0; round < wanted.size(); ++round) {
        w += open.completeOrthogonalDecomposition().solve(wanted - change * w);
        Eigen::Index farthest = 0;
        const double beyond = (w.array() - 0.5).abs().maxCoeff(&farthest);
        if (beyond <= 0.5 + 1e-12)
            break;
        w(farthest) = w(farthest) > 0.5 ? 1 : 0;
        open.col(farthest).setZero();
    }
    return w;
}

} // namespace

bool HeldField::weigh() {
    f_.weights().clear();
    if (!mode_.sticking.empty())
        return weighWithDirections();
    const std::size_t count = mode_.sliding.size();
    for (const std::size_t s : mode_.sliding)
        mode_.setSide(s, -1);
    outputsAndForces(base_);
    if (fields_.size() < count)
        fields_.resize(count);
    for (std::size_t j = 0; j < count; ++j) {
        mode_.setSide(mode_.sliding[j], +1);
        outputsAndForces(fields_[j]);
        mode_.setSide(mode_.sliding[j], -1);
    }
    // Where neither side moves off the surface, any weight will do.
    if (count == 1) {
        const std::size_t s = mode_.sliding[0];
        const double wanted = -f_.guardRate(s, base_).rate;
        const double change = f_.guardRate(s, fields_[0]).rate + wanted;
        const double weight = wanted == 0 && change == 0 ? 0.5 : wanted / change;
        return std::isfinite(weight) && mix(std::span(&weight, 1));
    }
    const auto m = static_cast<Eigen::Index>(count);
    Eigen::MatrixXd change(m, m);
    Eigen::VectorXd wanted(m);
    for (Eigen::Index i = 0; i < m; ++i) {
        const std::size_t s = mode_.sliding[static_cast<std::size_t>(i)];
        wanted(i) = -f_.guardRate(s, base_).rate;
        for (Eigen::Index j = 0; j < m; ++j)
            change(i, j) = f_.guardRate(s, fields_[static_cast<std::size_t>(j)]).rate + wanted(i);
    }
    const bool rests = wanted.isZero(0) && change.isZero(0);
    const Eigen::VectorXd w =
        rests ? Eigen::VectorXd(Eigen::VectorXd::Constant(m, 0.5)) : weightsFor(change, wanted);
    if (!w.allFinite() || (!(change * w).isApprox(wanted, 1e-9) && wanted.norm() > 0))
        return false;
    return mix({w.data(), count});
}

void HeldField::outputsAndForces(std::vector<double>& out) {
    out.resize(values_.size() + multipliers_.size());
    outputs(std::span(out).first(values_.size()));
    std::ranges::copy(multipliers_.values(),
                      out.begin() + static_cast<std::ptrdiff_t>(values_.size()));
}

void HeldField::mixFields(std::span<const double> weights) {
    const auto at = [&](std::size_t n) {
        double value = base_[n];
        for (std::size_t j = 0; j < weights.size(); ++j)
            value += weights[j] * (fields_[j][n] - base_[n]);
        return value;
    };
    for (std::size_t n = 0; n < values_.size(); ++n)
        values_[n] = at(n);
    for (std::size_t row = 0; row < multipliers_.size(); ++row)
        multipliers_.put(row, at(values_.size() + row));
}

// The fields of all surfaces by these weights.
bool HeldField::mix(std::span<const double> weights) {
    mixFields(weights);
    for (const std::size_t s : mode_.sliding)
        if (const auto state = model_.gradient(s).state)
            values_[*state] = 0;
    f_.weights().assign(weights.begin(), weights.end());
    return true;
}

} // namespace solution
