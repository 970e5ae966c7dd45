#include "physics/crushing.h"

#include "complementarity/convex.h"
#include "physics/contact_press.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace physics {
namespace {

struct Push { // an impulse that a contact may give
    std::size_t contact = 0;
    Vector direction = Vector::UnitX(); // 1 along the normal
};

std::vector<Push> pushesOf(std::span<const ImpactContact> contacts, Sides sides) {
    constexpr int edges = 8;
    std::vector<Push> pushes;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const ImpactContact& of = contacts[c];
        if (sides == Sides::slip || !(of.friction > 0)) {
            pushes.push_back({c, of.normal});
            continue;
        }
        const Vector across = acrossAxis(of.normal);
        const Vector second = (across - of.normal * of.normal.dot(across)).normalized(),
                     first = of.normal.cross(second);
        for (int k = 0; k < edges; ++k) {
            const double angle = 2 * std::numbers::pi * k / edges;
            pushes.push_back({c, of.normal + of.friction * (std::cos(angle) * first +
                                                            std::sin(angle) * second)});
        }
    }
    return pushes;
}

// At which the contact's points part.
double speedOf(std::span<const ImpactBody> bodies, const ImpactContact& contact) {
    const auto velocityOf = [&](std::size_t b) -> Vector {
        const ImpactBody& body = bodies[b];
        return body.velocity + body.angularVelocity.cross(contact.point - body.centre);
    };
    return contact.normal.dot(velocityOf(contact.first) - velocityOf(contact.second));
}

// In coordinates in which the kinetic energy is half the square of the velocities.
class Rates {
public:
    Rates(std::span<const ImpactBody> bodies, std::size_t rows)
        : bodies_(bodies), j_(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows),
                                                    6 * static_cast<Eigen::Index>(bodies.size()))) {
    }

    void add(Eigen::Index row, std::size_t body, const Vector& linear, const Vector& angular) {
        const ImpactBody& b = bodies_[body];
        const auto at = 6 * static_cast<Eigen::Index>(body);
        j_.block<1, 3>(row, at) +=
            (std::sqrt(b.inverseMass) * linear.cwiseProduct(b.moves)).transpose();
        const Eigen::LDLT<Matrix> root(b.inverseInertia);
        const Vector turned = root.matrixL().transpose() * (root.transpositionsP() * angular);
        j_.block<1, 3>(row, at + 3) +=
            root.vectorD().cwiseMax(0).cwiseSqrt().cwiseProduct(turned).transpose();
    }
    [[nodiscard]] Eigen::MatrixXd mobility() const { return j_ * j_.transpose(); }

private:
    std::span<const ImpactBody> bodies_;
    Eigen::MatrixXd j_;
};

// Bodies by whether these impulses at contacts are in balance on them.
void divide(std::span<const ImpactBody> bodies, std::span<const ImpactContact> contacts,
            std::span<const Push> pushes, const Eigen::VectorXd& impulses, Crushing& crushing) {
    constexpr double none = 1e-4; // of all that act on a body
    struct Sum {
        Vector force = Vector::Zero(), couple = Vector::Zero();
        double forces = 0, couples = 0; // added up
    };
    std::map<std::size_t, Sum> sums;
    for (std::size_t k = 0; k < pushes.size(); ++k) {
        const auto& [c, direction] = pushes[k];
        if (std::ranges::find(crushing.contacts, c) == crushing.contacts.end())
            continue;
        for (const auto& [body, sign] :
             {std::pair(contacts[c].first, 1.0), std::pair(contacts[c].second, -1.0)}) {
            const Vector lever = contacts[c].point - bodies[body].centre;
            const double impulse = impulses[static_cast<Eigen::Index>(k)];
            Sum& sum = sums[body];
            sum.force += sign * impulse * direction;
            sum.couple += sign * impulse * lever.cross(direction);
            sum.forces += impulse;
            sum.couples += impulse * lever.norm();
        }
    }
    for (const auto& [body, sum] : sums) {
        const bool isBalanced =
            sum.force.norm() <= none * sum.forces && sum.couple.norm() <= none * sum.couples;
        (isBalanced ? crushing.pressed : crushing.between).push_back(body);
    }
}

} // namespace

Crushing crushingOf(std::span<const ImpactBody> bodies, std::span<const ImpactContact> contacts,
                    std::span<const ImpactRow> joints, Sides sides) {
    const std::vector<Push> pushes = pushesOf(contacts, sides);
    const std::size_t count = pushes.size() + joints.size();
    const auto n = static_cast<Eigen::Index>(count);
    Rates rates(bodies, count);
    Eigen::VectorXd scale = Eigen::VectorXd::Zero(n),
                    speeds = Eigen::VectorXd::Zero(n); // those of joints are kept
    for (std::size_t k = 0; k < pushes.size(); ++k) {
        const auto& [c, direction] = pushes[k];
        speeds[static_cast<Eigen::Index>(k)] = speedOf(bodies, contacts[c]);
        for (const auto& [body, sign] :
             {std::pair(contacts[c].first, 1.0), std::pair(contacts[c].second, -1.0)})
            rates.add(static_cast<Eigen::Index>(k), body, sign * direction,
                      sign * (contacts[c].point - bodies[body].centre).cross(direction));
    }
    for (std::size_t k = 0; k < joints.size(); ++k)
        for (const ImpactRow::Part& part : joints[k].parts)
            rates.add(static_cast<Eigen::Index>(pushes.size() + k), part.body, part.linear,
                      part.angular);
    Eigen::MatrixXd a = rates.mobility();
    complementarity::Laws laws;
    for (Eigen::Index i = 0; i < n; ++i) {
        const bool isContact = i < static_cast<Eigen::Index>(pushes.size());
        if (a(i, i) > 0) // else neither side gives way: they pass through each other
            scale[i] = 1 / std::sqrt(a(i, i));
        if (isContact || joints[static_cast<std::size_t>(i) - pushes.size()].isStop)
            complementarity::addUnilateral(laws);
        else
            complementarity::addEquality(laws);
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
        if (row >= pushes.size())
            found.joints.push_back(row - pushes.size());
        else if (found.contacts.empty() || found.contacts.back() != pushes[row].contact)
            found.contacts.push_back(pushes[row].contact);
    }
    divide(bodies, contacts, pushes, scale.cwiseProduct(answer->forces), found);
    return found;
}

} // namespace physics
