// Motion on surfaces, between the branches of their sides; see component_equations.h.
#include "modes/component_equations.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

// Where several will do, as at rest on the surface of a place and on that of its velocity, those
// that are nearest to the middle; what then lies beyond [0, 1] is put to its end, one after the
// other.
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

// Rates while sliding, into out_.
bool ComponentEquations::weigh() {
    if (!mode_.sticking.empty())
        return weighWithDirections();
    const auto m = static_cast<Eigen::Index>(mode_.sliding.size());
    for (const std::size_t s : mode_.sliding)
        setSide(s, -1);
    evaluate(base_);
    Eigen::MatrixXd change(m, m);
    Eigen::VectorXd wanted(m);
    std::vector<std::vector<double>> fields;
    for (Eigen::Index j = 0; j < m; ++j) {
        const std::size_t s = mode_.sliding[static_cast<std::size_t>(j)];
        setSide(s, +1);
        evaluate(other_);
        setSide(s, -1);
        fields.push_back(other_);
    }
    for (Eigen::Index i = 0; i < m; ++i) {
        const std::size_t s = mode_.sliding[static_cast<std::size_t>(i)];
        wanted(i) = -guardRate(s, base_).rate;
        for (Eigen::Index j = 0; j < m; ++j)
            change(i, j) = guardRate(s, fields[static_cast<std::size_t>(j)]).rate + wanted(i);
    }
    // Where neither side moves off the surface, any weight will do.
    const bool rests = wanted.isZero(0) && change.isZero(0);
    const Eigen::VectorXd w = rests    ? Eigen::VectorXd(Eigen::VectorXd::Constant(m, 0.5))
                              : m == 1 ? Eigen::VectorXd(wanted / change(0, 0))
                                       : weightsFor(change, wanted);
    if (!w.allFinite() || (m > 1 && !(change * w).isApprox(wanted, 1e-9) && wanted.norm() > 0))
        return false;
    out_ = base_;
    for (Eigen::Index j = 0; j < m; ++j)
        for (std::size_t n = 0; n < out_.size(); ++n)
            out_[n] += w(j) * (fields[static_cast<std::size_t>(j)][n] - base_[n]);
    for (const std::size_t s : mode_.sliding)
        if (const auto state = model_.gradient(s).state)
            out_[*state] = 0;
    weights_.assign(w.data(), w.data() + m);
    return true;
}

// Surfaces whose weight lies outside [0, 1] are left; false when that does not settle.
bool ComponentEquations::settleWeights(double t, std::span<const double> y) {
    const std::size_t most = 2 * mode_.sliding.size();
    fill(t, y);
    for (std::size_t round = 0; round <= most; ++round) {
        if (mode_.sliding.empty())
            return true;
        if (!weigh())
            return false;
        const auto outside = std::find_if(weights_.begin(), weights_.end(),
                                          [](double w) { return w < -1e-12 || w > 1 + 1e-12; });
        if (outside == weights_.end())
            return true;
        const auto place = outside - weights_.begin();
        const std::size_t s = mode_.sliding[static_cast<std::size_t>(place)];
        const int side = *outside < 0 ? -1 : +1;
        mode_.sliding.erase(mode_.sliding.begin() + place);
        setSide(s, side);
    }
    return false;
}

// Onto the surfaces of sliding, along the difference of their fields; exactly where the guard is a
// state.
void ComponentEquations::project(double t, std::span<double> y) {
    for (const std::size_t s : mode_.sliding) {
        const ComponentModel::Gradient& g = model_.gradient(s);
        const double level = model_.surfaces()[s].whole ? static_cast<double>(mode_.levels[s]) : 0;
        if (g.state) {
            y[*g.state] = level;
            continue;
        }
        fill(t, y);
        const double off = valueOf(s) - level;
        setSide(s, +1);
        evaluate(other_);
        setSide(s, -1);
        evaluate(base_);
        std::vector<double> direction(states().size());
        for (std::size_t i = 0; i < direction.size(); ++i)
            direction[i] = other_[i] - base_[i];
        const double along = guardRate(s, other_).rate - guardRate(s, base_).rate;
        if (along != 0 && std::isfinite(off / along))
            for (std::size_t i = 0; i < direction.size(); ++i)
                y[i] -= off / along * direction[i];
    }
}

// Of a guard; of floor and ceil their argument.
double ComponentEquations::valueOf(std::size_t surface) {
    if (model_.surfaces()[surface].whole)
        return guardRate(surface, out_).value;
    model_.function().guards(in_, guards_, scratch_, mode_.decisions);
    return guard(surface);
}

// From the surfaces of sliding, by surface.
std::vector<double> ComponentEquations::distancesOfSliding() {
    std::vector<double> distances(model_.surfaces().size());
    if (!mode_.sliding.empty())
        field();
    for (const std::size_t s : mode_.sliding)
        distances[s] = distance(s);
    return distances;
}

// Where the guard itself has jumped since, as that of a belt's friction when the belt turns back,
// the motion is not on the surface any more: the value says on which side it is. True: it left one.
bool ComponentEquations::leaveWhereJumped(std::span<const double> before) {
    const std::vector<std::size_t> slid = mode_.sliding;
    for (const std::size_t s : slid) {
        field();
        const std::vector<double> now = out_;
        const double near = guardRate(s, now).near + std::abs(before[s]);
        const double off = distance(s);
        if (!(std::abs(off - before[s]) > near))
            continue;
        std::erase(mode_.sliding, s);
        mode_.coincident[s].clear();
        if (model_.surfaces()[s].whole)
            mode_.decisions[model_.surfaces()[s].members[0].decision] = wholeBranch(s, now);
        else
            setOwnSide(s, off > 0 ? +1 : -1);
        return true;
    }
    return false;
}

bool ComponentEquations::standsOn(const std::vector<std::size_t>& surfaces, double t,
                                  std::span<const double> y) {
    fill(t, y);
    return std::ranges::all_of(surfaces, [this](std::size_t s) {
        const double value = valueOf(s);
        const double level = model_.surfaces()[s].whole ? std::round(value) : 0;
        return std::abs(value - level) <= 2 * standing;
    });
}

// On those that are left for one of their sides it stays too.
bool ComponentEquations::holdsOn(const std::vector<std::size_t>& surfaces) {
    field();
    const std::vector<double> rates = out_;
    return std::ranges::all_of(surfaces, [&](std::size_t s) {
        const Slope slope = guardRate(s, rates);
        return mode_.slidesOn(s) || std::abs(slope.rate) <= slope.noise;
    });
}

bool ComponentEquations::holdOn(const std::vector<std::size_t>& surfaces, double t,
                                std::span<const double> reach, std::span<double> y) {
    const Mode before = mode_;
    fill(t, y);
    for (const std::size_t s : surfaces) {
        if (mode_.slidesOn(s) || mode_.isCoincident(s))
            continue;
        if (model_.surfaces()[s].whole)
            mode_.levels[s] = std::llround(valueOf(s));
        join(s);
        mode_.sliding.push_back(s);
    }
    std::vector<double> at(y.begin(), y.end());
    project(t, at);
    bool isHeld = settleWeights(t, at) && holdsOn(surfaces);
    for (std::size_t i = 0; i < at.size(); ++i)
        isHeld = isHeld && std::abs(at[i] - y[i]) <= reach[i];
    if (!isHeld) {
        mode_ = before;
        return false;
    }
    std::ranges::copy(at, y.begin());
    refreshWatches();
    return true;
}

} // namespace solution
