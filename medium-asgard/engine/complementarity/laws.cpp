#include "complementarity/laws.h"

#include <algorithm>
#include <cmath>

namespace complementarity {

Index rowsOf(const Laws& laws) { return laws.empty() ? 0 : laws.back().first + laws.back().rows; }

void addInterval(Laws& laws, double low, double high) {
    laws.push_back({.first = rowsOf(laws), .low = low, .high = high});
}

void addEquality(Laws& laws) { addInterval(laws, -unbounded, unbounded); }

void addUnilateral(Laws& laws) { addInterval(laws, 0, unbounded); }

void addDisc(Laws& laws, Index rows, double radius) {
    laws.push_back(
        {.kind = Law::Kind::disc, .first = rowsOf(laws), .rows = rows, .radius = radius});
}

void addFriction(Laws& laws, Index rows, Index normal, double coefficient, Index normals) {
    addDisc(laws, rows, 0);
    laws.back().normal = normal;
    laws.back().normals = normals;
    laws.back().coefficient = coefficient;
}

double radiusOf(const Law& disc, const Vector& forces) {
    const double pressed =
        disc.normal < 0 ? 0 : disc.coefficient * forces.segment(disc.normal, disc.normals).sum();
    return std::max(0.0, disc.radius + pressed);
}

Vector centreOf(const Law& disc, const Vector& forces) {
    Vector centre = Vector::Zero(disc.rows - 1);
    if (disc.levers.size() == 0)
        return centre;
    const Vector normals = forces.segment(disc.normal, disc.normals);
    const double pressed = normals.sum();
    if (pressed > 0)
        centre = disc.levers * normals / pressed;
    return centre;
}

Vector ratesAt(const Vector& centre, const Vector& rates) {
    Vector at = rates;
    at.head(centre.size()) += rates[centre.size()] * centre;
    return at;
}

Vector forcesAt(const Vector& centre, const Vector& forces) {
    Vector at = forces;
    at[centre.size()] -= centre.dot(forces.head(centre.size()));
    return at;
}

Vector forcesFrom(const Vector& centre, const Vector& forces) { return forcesAt(-centre, forces); }

Vector directionAt(const Vector& centre, const Law& slip) {
    return (ratesAt(centre, slip.velocity) + slip.beside).normalized();
}

namespace {

// The rate of an interval that its state does not allow.
double wrongRate(State state, double rate) {
    switch (state) {
    case State::low:
        return std::max(0.0, -rate);
    case State::high:
        return std::max(0.0, rate);
    default:
        return std::abs(rate);
    }
}

double sizeOfRates(const Matrix& a, const Vector& b, const Laws& laws, const Answer& answer) {
    Vector fixed = Vector::Zero(b.size());
    for (std::size_t k = 0; k < laws.size(); ++k)
        if (laws[k].kind == Law::Kind::interval && answer.states[k] != State::inside)
            fixed[laws[k].first] = answer.forces[laws[k].first];
    const Vector given = a * fixed;
    return std::max({b.cwiseAbs().maxCoeff(), given.cwiseAbs().maxCoeff(), 1e-300});
}

} // namespace

double violation(const Matrix& a, const Vector& b, const Laws& laws, const Answer& answer) {
    if (b.size() == 0)
        return 0;
    if (!answer.forces.allFinite())
        return unbounded;
    const double largest = std::max(answer.forces.cwiseAbs().maxCoeff(), 1e-300);
    const double rates = sizeOfRates(a, b, laws, answer);
    // A sum of large terms errs by their last places, which is no fault of the answer.
    const Vector rounding = 1e-14 * (a.cwiseAbs() * answer.forces.cwiseAbs());
    double worst = 0;
    for (std::size_t k = 0; k < laws.size(); ++k) {
        const Law& law = laws[k];
        if (law.kind == Law::Kind::interval) {
            const double force = answer.forces[law.first];
            worst = std::max(
                {worst, (law.low - force) / largest, (force - law.high) / largest,
                 (wrongRate(answer.states[k], answer.rates[law.first]) - rounding[law.first]) /
                     rates});
            continue;
        }
        const Vector centre = centreOf(law, answer.forces);
        const Vector force = forcesAt(centre, answer.forces.segment(law.first, law.rows));
        const Vector rate = ratesAt(centre, answer.rates.segment(law.first, law.rows));
        const double radius = radiusOf(law, answer.forces), length = force.norm();
        if (law.kind == Law::Kind::slip) {
            worst = std::max(worst, (force + radius * directionAt(centre, law)).norm() / largest);
            continue;
        }
        worst = std::max(worst, (length - radius) / largest);
        const double last = rounding.segment(law.first, law.rows).norm();
        if (answer.states[k] == State::inside)
            worst = std::max(worst, (rate.norm() - last) / rates);
        else
            worst = std::max(worst, (radius - length) / std::max(radius, largest));
        if (answer.states[k] == State::edge && length > 0) { // the rate is against the force
            const double speed = rate.norm();
            const double ofRates = ((rate + speed / length * force).norm() - 2 * last) / rates;
            // Of a force that is none beside the largest any direction will do.
            const double ofForces =
                speed > 0 ? (force + length / speed * rate).norm() / largest : 0;
            worst = std::max(worst, std::min(ofRates, ofForces));
        }
    }
    return worst;
}

} // namespace complementarity
