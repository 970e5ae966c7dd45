#include "physics/crushing.h"

#include "complementarity/convex.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <map>
#include <utility>

namespace physics {
namespace {

// In coordinates in which the kinetic energy is half the square of the velocities.
class Rates {
public:
    Rates(std::span<const ImpactBody> bodies, std::size_t rows)
        : bodies_(bodies), j_(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows),
                                                    6 * static_cast<Eigen::Index>(bodies.size()))),
          u_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows))) {}

    void add(Eigen::Index row, std::size_t body, const Vector& linear, const Vector& angular) {
        const ImpactBody& b = bodies_[body];
        const auto at = 6 * static_cast<Eigen::Index>(body);
        j_.block<1, 3>(row, at) +=
            (std::sqrt(b.inverseMass) * linear.cwiseProduct(b.moves)).transpose();
        const Eigen::LDLT<Matrix> root(b.inverseInertia);
        const Vector turned = root.matrixL().transpose() * (root.transpositionsP() * angular);
        j_.block<1, 3>(row, at + 3) +=
            root.vectorD().cwiseMax(0).cwiseSqrt().cwiseProduct(turned).transpose();
        u_[row] += linear.dot(b.velocity) + angular.dot(b.angularVelocity);
    }
    [[nodiscard]] Eigen::MatrixXd mobility() const { return j_ * j_.transpose(); }
    [[nodiscard]] const Eigen::VectorXd& speeds() const { return u_; }

private:
    std::span<const ImpactBody> bodies_;
    Eigen::MatrixXd j_;
    Eigen::VectorXd u_;
};

// Bodies by whether these impulses at contacts are in balance on them.
void divide(std::span<const ImpactBody> bodies, std::span<const ImpactContact> contacts,
            const Eigen::VectorXd& impulses, Crushing& crushing) {
    constexpr double none = 1e-4; // of all that act on a body
    struct Sum {
        Vector force = Vector::Zero(), couple = Vector::Zero();
        double forces = 0, couples = 0; // added up
    };
    std::map<std::size_t, Sum> sums;
    for (const std::size_t c : crushing.contacts)
        for (const auto& [body, sign] :
             {std::pair(contacts[c].first, 1.0), std::pair(contacts[c].second, -1.0)}) {
            const Vector lever = contacts[c].point - bodies[body].centre;
            const double impulse = impulses[static_cast<Eigen::Index>(c)];
            Sum& sum = sums[body];
            sum.force += sign * impulse * contacts[c].normal;
            sum.couple += sign * impulse * lever.cross(contacts[c].normal);
            sum.forces += impulse;
            sum.couples += impulse * lever.norm();
        }
    for (const auto& [body, sum] : sums) {
        const bool isBalanced =
            sum.force.norm() <= none * sum.forces && sum.couple.norm() <= none * sum.couples;
        (isBalanced ? crushing.pressed : crushing.between).push_back(body);
    }
}

} // namespace

Crushing crushingOf(std::span<const ImpactBody> bodies, std::span<const ImpactContact> contacts,
                    std::span<const ImpactRow> joints) {
    const std::size_t count = contacts.size() + joints.size();
    Rates rates(bodies, count);
    for (std::size_t c = 0; c < contacts.size(); ++c)
        for (const auto& [body, sign] :
             {std::pair(contacts[c].first, 1.0), std::pair(contacts[c].second, -1.0)})
            rates.add(static_cast<Eigen::Index>(c), body, sign * contacts[c].normal,
                      sign * (contacts[c].point - bodies[body].centre).cross(contacts[c].normal));
    for (std::size_t k = 0; k < joints.size(); ++k)
        for (const ImpactRow::Part& part : joints[k].parts)
            rates.add(static_cast<Eigen::Index>(contacts.size() + k), part.body, part.linear,
                      part.angular);
    Eigen::MatrixXd a = rates.mobility();
    const auto n = static_cast<Eigen::Index>(count);
    Eigen::VectorXd scale = Eigen::VectorXd::Zero(n), speeds = rates.speeds();
    complementarity::Laws laws;
    for (Eigen::Index i = 0; i < n; ++i) {
        const bool isContact = i < static_cast<Eigen::Index>(contacts.size());
        if (a(i, i) > 0) // else neither side gives way: they pass through each other
            scale[i] = 1 / std::sqrt(a(i, i));
        if (isContact || joints[static_cast<std::size_t>(i) - contacts.size()].isStop)
            complementarity::addUnilateral(laws);
        else
            complementarity::addEquality(laws);
        if (!isContact)
            speeds[i] = 0; // they are kept
    }
    constexpr double stiffness = 1e-9; // of breaches
    a = scale.asDiagonal() * a * scale.asDiagonal();
    a.diagonal().array() += stiffness;
    speeds = scale.asDiagonal() * speeds;
    Crushing found;
    const auto answer = complementarity::solveConvex(a, speeds, laws);
    if (!answer)
        return found;
    constexpr double none = 1e-4; // of the fastest
    const double least = none * speeds.lpNorm<Eigen::Infinity>();
    for (Eigen::Index i = 0; i < n; ++i) {
        if (!(std::abs(stiffness * answer->forces[i]) > least))
            continue;
        const auto row = static_cast<std::size_t>(i);
        if (row < contacts.size())
            found.contacts.push_back(row);
        else
            found.joints.push_back(row - contacts.size());
    }
    divide(bodies, contacts, scale.cwiseProduct(answer->forces), found);
    return found;
}

} // namespace physics
