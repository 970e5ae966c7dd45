#include "complementarity/widened.h"

#include "complementarity/interior.h"

#include <algorithm>

namespace complementarity {

Widened::Widened(const Matrix& a, const Vector& b, const Laws& laws, const Vector& slips)
    : a_(a), b_(b), laws_(laws),
      slips_(slips.size() > 0 ? slips : Vector(Vector::Zero(static_cast<Index>(laws.size())))) {}

namespace {

// A law is at its bound if its rate is larger than the room of its force, beside the largest ones.
State stateOf(const Law& law, const Answer& answer, double force, double rate) {
    const Vector rates = answer.rates.segment(law.first, law.rows) / rate;
    if (law.kind != Law::Kind::interval) {
        const double length = answer.forces.segment(law.first, law.rows).norm();
        const double room = (radiusOf(law, answer.forces) - length) / force;
        return rates.norm() > room ? State::edge : State::inside;
    }
    const double at = answer.forces[law.first];
    if (rates[0] > (at - law.low) / force)
        return State::low;
    return -rates[0] > (law.high - at) / force ? State::high : State::inside;
}

} // namespace

void Widened::advance() {
    const Approach inside = approachConvex(a_, b_, laws_, slips_.at().cwiseMax(0));
    answer_ = {inside.forces, a_ * inside.forces + b_, {}};
    constexpr double none = 1e-300;
    const double force = std::max(answer_.forces.cwiseAbs().maxCoeff(), none);
    const double rate = std::max(b_.cwiseAbs().maxCoeff(), none);
    for (const Law& law : laws_)
        answer_.states.push_back(stateOf(law, answer_, force, rate));
    Vector slips = Vector::Zero(slips_.at().size());
    for (std::size_t k = 0; k < laws_.size(); ++k)
        if (const Law& law = laws_[k]; law.kind != Law::Kind::interval)
            slips[static_cast<Index>(k)] = answer_.rates.segment(law.first, law.rows).norm();
    change_ = (slips - slips_.at()).cwiseAbs().maxCoeff() / rate;
    slips_.moveFrom(slips, Vector::Ones(slips.size()));
}

} // namespace complementarity
