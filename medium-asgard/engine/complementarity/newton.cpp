#include "complementarity/newton.h"

#include "complementarity/at_centre.h"
#include "complementarity/least.h"

#include <algorithm>
#include <cmath>

namespace complementarity {

namespace {

// Unknown: the forces of the laws inside and at edges, then for each edge s times its radius. Those
// of slips follow from their normal forces.
class Equations {
public:
    Equations(const Matrix& a, const Vector& b, const Laws& laws, const States& states,
              const Vector& near, Aim aim)
        : aim_(aim), a_(a), b_(b), laws_(laws), states_(states), forces_(near),
          placeOf_(static_cast<std::size_t>(b.size()), -1) {
        for (std::size_t k = 0; k < laws.size(); ++k)
            place(k);
        for (std::size_t i = 0; i < rows_.size(); ++i)
            placeOf_[static_cast<std::size_t>(rows_[i])] = static_cast<Index>(i);
        unknowns_ = static_cast<Index>(rows_.size() + edges_.size());
        if (isLinear() && aim == Aim::shortest) // from anywhere
            forces_(rows_).setZero();
        followSlips();
        const Vector rates = a_ * forces_ + b_;
        for (const std::size_t k : edges_) {
            const AtCentre at(laws[k], forces_);
            const Vector rate = ratesAt(at.centre, rates.segment(laws[k].first, laws[k].rows));
            const double length = std::max(at.force.norm(), 1e-300);
            speeds_.push_back(std::max(0.0, -rate.dot(at.force) / length));
        }
    }

    // False: no solution was met.
    bool solve() {
        if (unknowns_ == 0)
            return true;
        constexpr double small = 1e-13; // Newton's steps shrink from here on until rounding is left
        constexpr double apart = 1e-4;  // a last step over this leads nowhere
        // Rounds, and those since the best one.
        const int most = edges_.empty() ? 20 : 50, patience = edges_.empty() ? 4 : 8;
        double last = 1, least = unbounded;
        for (int round = 0, inVain = 0; round < most && inVain < patience; ++round, ++inVain) {
            const double change = step();
            if (!std::isfinite(change))
                return false;
            if (change <= 1e-15 || (last <= small && change >= 0.25 * last))
                return true;
            last = change;
            if (change < 0.5 * least) {
                least = change;
                inVain = 0;
            }
        }
        return !edges_.empty() || last <= apart; // of edges the caller judges what was met
    }

    [[nodiscard]] Answer answer() const {
        Answer answer{forces_, a_ * forces_ + b_, states_};
        return answer;
    }

private:
    void place(std::size_t k) {
        const Law& law = laws_[k];
        const bool isEdge = states_[k] == State::edge && !isClosed(law);
        if (isEdge && law.kind == Law::Kind::slip) {
            slips_.push_back(k);
        } else if (isEdge || states_[k] == State::inside) {
            if (isEdge)
                edges_.push_back(k);
            for (Index i = 0; i < law.rows; ++i)
                rows_.push_back(law.first + i);
        } else if (law.kind == Law::Kind::interval) {
            forces_[law.first] = states_[k] == State::low ? law.low : law.high;
        } else {
            forces_.segment(law.first, law.rows).setZero();
        }
    }

    // One matrix for all steps.
    [[nodiscard]] bool isLinear() const { return edges_.empty() && slips_.empty(); }

    // A disc without radius: of a contact that is open.
    [[nodiscard]] bool isClosed(const Law& disc) const {
        if (disc.radius > 0 || disc.normal < 0 || disc.coefficient <= 0)
            return disc.radius <= 0;
        for (std::size_t k = 0; k < laws_.size(); ++k)
            if (laws_[k].first >= disc.normal && laws_[k].first < disc.normal + disc.normals &&
                !(states_[k] == State::low && laws_[k].low <= 0))
                return false;
        return true;
    }

    double step() {
        Vector wrong(unknowns_), now(unknowns_);
        const Vector rates = a_ * forces_ + b_;
        const auto forces = static_cast<Index>(rows_.size());
        wrong.head(forces) = rates(rows_);
        now.head(forces) = forces_(rows_);
        if (!isLinear() || !least_) {
            Matrix change = Matrix::Zero(unknowns_, unknowns_);
            change.topLeftCorner(forces, forces) = a_(rows_, rows_);
            for (const std::size_t k : slips_)
                addSlip(laws_[k], change.topRows(forces));
            for (std::size_t e = 0; e < edges_.size(); ++e)
                addEdge(e, forces + static_cast<Index>(e), rates, change, wrong, now);
            least_.emplace(std::move(change));
        }
        const Vector to = aim_ == Aim::shortest ? least_->solve(least_->matrix() * now - wrong)
                                                : Vector(now - least_->solve(wrong));
        forces_(rows_) = to.head(forces);
        followSlips();
        for (std::size_t e = 0; e < edges_.size(); ++e)
            speeds_[e] = to[forces + static_cast<Index>(e)];
        const double size = std::max(to.cwiseAbs().maxCoeff(), 1e-300);
        return (to - now).cwiseAbs().maxCoeff() / size;
    }

    // At the centre: in its rows w + slip f/r = 0, and in that of the slip (|f|^2/r - r)/2 = 0.
    void addEdge(std::size_t e, Index last, const Vector& rates, Matrix& change, Vector& wrong,
                 Vector& now) const {
        const Law& law = laws_[edges_[e]];
        const AtCentre at(law, forces_);
        const double radius = std::max(radiusOf(law, forces_), 1e-300);
        const double slip = speeds_[e] / radius;
        const Index first = placeOf(law.first), turn = law.first + law.rows - 1;
        const auto forces = static_cast<Index>(rows_.size());
        const double square = at.force.squaredNorm();
        now[last] = speeds_[e];
        for (Index i = 0; i + 1 < law.rows && law.levers.size() > 0; ++i) {
            wrong[first + i] += at.centre[i] * rates[turn];
            change.row(first + i).head(forces) +=
                at.centre[i] * change.row(first + law.rows - 1).head(forces);
        }
        wrong.segment(first, law.rows) += slip * at.force;
        change.block(first, first, law.rows, law.rows) += slip * at.byRows;
        change.col(last).segment(first, law.rows) = at.force / radius;
        change.row(last).segment(first, law.rows) = at.force.transpose() / radius * at.byRows;
        wrong[last] = (square / radius - radius) / 2;
        const double grows = law.coefficient; // the radius, with the normal force
        eachNormal(law, [&](Index n, Index normal) {
            change(last, normal) += at.force.dot(at.byNormals.col(n)) / radius -
                                    (square / (radius * radius) + 1) / 2 * grows;
            auto rows = change.col(normal).segment(first, law.rows);
            rows += slip * (at.byNormals.col(n) - grows / radius * at.force);
            rows.head(law.rows - 1) += rates[turn] * at.moves.col(n);
        });
    }

    void followSlips() {
        for (const std::size_t k : slips_)
            forces_.segment(laws_[k].first, laws_[k].rows) = forceOf(laws_[k], forces_);
    }

    // Adds to the changes of rates with each normal force what the force of a slip brings.
    void addSlip(const Law& law, Eigen::Ref<Matrix> rates) const {
        const Matrix columns = a_.middleCols(law.first, law.rows)(rows_, Eigen::all);
        const Matrix changes = changesOf(law, forces_);
        eachNormal(law,
                   [&](Index n, Index normal) { rates.col(normal) += columns * changes.col(n); });
    }

    template <class Visit> void eachNormal(const Law& law, const Visit& visit) const {
        for (Index n = 0; law.normal >= 0 && n < law.normals; ++n)
            if (const Index normal = placeOf(law.normal + n); normal >= 0)
                visit(n, normal);
    }
    [[nodiscard]] Index placeOf(Index row) const { return placeOf_[static_cast<std::size_t>(row)]; }

    Aim aim_;
    const Matrix& a_;
    const Vector& b_;
    const Laws& laws_;
    const States& states_;
    Vector forces_;
    std::vector<Index> rows_, placeOf_; // and the place of each row among them; -1: none
    std::vector<std::size_t> edges_, slips_;
    std::vector<double> speeds_; // of each edge: the speed, or acceleration, against its force
    Index unknowns_ = 0;
    std::optional<Least> least_;
};

} // namespace

std::optional<Answer> solveStates(const Matrix& a, const Vector& b, const Laws& laws,
                                  const States& states, const Vector& near, Aim aim) {
    Equations equations(a, b, laws, states, near, aim);
    if (!equations.solve())
        return std::nullopt;
    return equations.answer();
}

States opened(const Laws& laws, const Answer& answer) {
    States states = answer.states;
    double most = 0;
    std::optional<std::size_t> first;
    const auto leaves = [&](std::size_t k) {
        const Law& law = laws[k];
        const double rate = law.kind == Law::Kind::interval ? answer.rates[law.first] : 0;
        return (rate > 0 && law.low > -unbounded) || (rate < 0 && law.high < unbounded)
                   ? std::abs(rate)
                   : 0;
    };
    for (std::size_t k = 0; k < laws.size(); ++k)
        if (states[k] == State::inside && leaves(k) > most) {
            most = leaves(k);
            first = k;
        }
    if (first)
        states[*first] = answer.rates[laws[*first].first] > 0 ? State::low : State::high;
    return states;
}

States improved(const Laws& laws, const Answer& answer) {
    States states = answer.states;
    for (std::size_t k = 0; k < laws.size(); ++k) {
        const Law& law = laws[k];
        if (law.kind == Law::Kind::slip)
            continue;
        if (law.kind == Law::Kind::disc) {
            const Vector centre = centreOf(law, answer.forces);
            const Vector force = forcesAt(centre, answer.forces.segment(law.first, law.rows));
            const Vector rate = ratesAt(centre, answer.rates.segment(law.first, law.rows));
            if (states[k] == State::inside && force.norm() > radiusOf(law, answer.forces))
                states[k] = State::edge;
            else if (states[k] == State::edge && rate.dot(force) > 0)
                states[k] = State::inside;
            continue;
        }
        const double force = answer.forces[law.first], rate = answer.rates[law.first];
        if (states[k] == State::inside && force < law.low)
            states[k] = State::low;
        else if (states[k] == State::inside && force > law.high)
            states[k] = State::high;
        else if ((states[k] == State::low && rate < 0) || (states[k] == State::high && rate > 0))
            states[k] = law.low < law.high ? State::inside : states[k];
    }
    return states;
}

} // namespace complementarity
