#include "physics/pulling.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <utility>

namespace physics {
namespace {

constexpr std::size_t most = 40;  // bodies
constexpr double farther = 10;    // a joint that is one body further away costs so much more
constexpr double absolute = 1e-3; // movements cost so much beside those of joints
constexpr double noWay = 0.15;    // of the body's radius: an arm so short turns nothing
constexpr double damping = 1e-7;
constexpr double converged = 1e-9; // of the size and the way: refine() does the rest

Eigen::Matrix3d crossed(const Vector& v) {
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

Eigen::Index columnOf(std::size_t place) { return static_cast<Eigen::Index>(6 * place); }

scene::Scene withoutWhatCounts(scene::Scene scene, std::size_t body) {
    constexpr double anyLength = 1e9;
    for (scene::Joint& joint : scene.joints)
        for (scene::JointCoordinate& coordinate : joint.coordinates) {
            coordinate.position.reset();
            coordinate.lower.reset();
            coordinate.upper.reset();
        }
    for (scene::Rope& rope : scene.ropes)
        rope.length = rope.length.value_or(anyLength);
    scene.bodies[body].fixed = false;
    return scene;
}

} // namespace

Pulling::Pulling(const scene::Scene& scene, std::size_t body, const Vector& point)
    : scene_(withoutWhatCounts(scene, body)),
      equations_(std::make_unique<EquationsOfMotion>(scene_, std::function<void()>(), nullptr,
                                                     EquationsOfMotion::Start::mayMiss)) {
    if (!equations_->faults.empty())
        return;
    linkage_ = std::make_unique<Linkage>(scene_, *equations_, body);
    const auto& bodies = linkage_->bodies();
    const auto found = std::ranges::find(bodies, body);
    if (found == bodies.end() || bodies.size() > most || !linkage_->hasConditions() ||
        !linkage_->close())
        return;
    isJoined_ = true;
    place_ = static_cast<std::size_t>(found - bodies.begin());
    const geometry::Pose pose = linkage_->firstPoseOf(place_);
    arm_ = pose.attitude.conjugate() * (point - pose.position);
    findCosts();
    isLoose_ = linkage_->staysWhenAllMove();
    const Eigen::MatrixXd own = allowed().middleRows(columnOf(place_), 6);
    const Eigen::JacobiSVD<Eigen::MatrixXd> ways(own, Eigen::ComputeThinU);
    turns_ = own.bottomRows(3).norm() > 1e-9;
    Eigen::MatrixXd reached(3, 0);
    const auto independent = (ways.singularValues().array() > 1e-9).count();
    if (independent > 0)
        reached = pointBy().middleCols(columnOf(place_), 6) * ways.matrixU().leftCols(independent);
    movesAsOne_ = isLoose_ || !(independent > 0 && reached.jacobiSvd().singularValues()[0] > noWay);
}

Vector Pulling::point() const {
    const geometry::Pose pose = linkage_->poseOf(place_);
    return pose.position + pose.attitude * arm_;
}

Eigen::MatrixXd Pulling::pointBy() const {
    const auto columns = static_cast<Eigen::Index>(6 * bodies().size());
    Eigen::MatrixXd by = Eigen::MatrixXd::Zero(3, columns);
    by.block<3, 3>(0, columnOf(place_)).setIdentity();
    by.block<3, 3>(0, columnOf(place_) + 3) =
        -crossed(linkage_->poseOf(place_).attitude * arm_) / linkage_->radiusOf(place_);
    return by;
}

// Each of length 1 and across the others.
Eigen::MatrixXd Pulling::allowed() const {
    const Eigen::MatrixXd& jacobian = linkage_->jacobian();
    const Eigen::Index columns = jacobian.cols();
    if (jacobian.rows() == 0)
        return Eigen::MatrixXd::Identity(columns, columns);
    const auto solver = linkage_->solver();
    const Eigen::Index rank = solver.rank();
    return solver.colsPermutation() *
           Eigen::MatrixXd(solver.matrixZ().adjoint().rightCols(columns - rank));
}

void Pulling::findCosts() {
    const auto placeOf = [&](const std::string& name) -> std::optional<std::size_t> {
        for (std::size_t i = 0; i < bodies().size(); ++i)
            if (scene_.bodies[bodies()[i]].name == name)
                return i;
        return std::nullopt;
    };
    for (const scene::Joint& joint : scene_.joints) {
        const auto first = placeOf(joint.body1);
        const auto second = joint.body2 ? placeOf(*joint.body2) : std::nullopt;
        if (!first && !second)
            continue;
        Cost cost{first, second, Vector::Zero(), Vector::Zero(), 0, 1};
        const scene::Body* body1 = scene::findBody(scene_, joint.body1);
        const auto at = static_cast<std::size_t>(body1 - scene_.bodies.data());
        const BodyMotion& motion = equations_->bodies[at];
        if (joint.offset1)
            cost.arm1 = *joint.offset1 - motion.mass.centroid;
        const Vector place = motion.start.position + motion.start.attitude * cost.arm1;
        if (second) {
            const geometry::Pose pose = linkage_->firstPoseOf(*second);
            cost.arm2 = pose.attitude.conjugate() * (place - pose.position);
        }
        cost.radius = std::min(first ? linkage_->radiusOf(*first) : HUGE_VAL,
                               second ? linkage_->radiusOf(*second) : HUGE_VAL);
        costs_.push_back(cost);
    }
    std::vector<int> away(bodies().size(), 3); // joints from the body, at most
    away[place_] = 0;
    for (int round = 1; round < 3; ++round)
        for (const Cost& cost : costs_)
            if (cost.first && cost.second) {
                const int near = std::min(away[*cost.first], away[*cost.second]) + 1;
                away[*cost.first] = std::min(away[*cost.first], near);
                away[*cost.second] = std::min(away[*cost.second], near);
            }
    for (Cost& cost : costs_)
        cost.weight = std::pow(farther, std::min(cost.first ? away[*cost.first] : 3,
                                                 cost.second ? away[*cost.second] : 3));
}

Eigen::VectorXd Pulling::towards(const Vector& way) const {
    const Eigen::MatrixXd free = allowed();
    const auto columns = free.rows();
    Eigen::VectorXd each = Eigen::VectorXd::Constant(columns, absolute * absolute);
    for (Eigen::Index i = 0; i < columns; i += 6) // a turn rather than none costs much
        each.segment<3>(i + 3) *= 1e2;
    Eigen::MatrixXd cost = free.transpose() * each.asDiagonal() * free;
    for (const Cost& one : costs_) {
        Eigen::MatrixXd slides = Eigen::MatrixXd::Zero(3, columns), turns = slides;
        const auto add = [&](std::size_t place, const Vector& arm, double sign) {
            const Eigen::Index at = columnOf(place);
            const double radius = linkage_->radiusOf(place);
            slides.middleCols<3>(at) += sign * Eigen::Matrix3d::Identity();
            slides.middleCols<3>(at + 3) -=
                sign * crossed(linkage_->poseOf(place).attitude * arm) / radius;
            turns.middleCols<3>(at + 3) += sign * one.radius / radius * Eigen::Matrix3d::Identity();
        };
        if (one.first)
            add(*one.first, one.arm1, 1);
        if (one.second)
            add(*one.second, one.arm2, -1);
        slides = slides * free;
        turns = turns * free;
        cost += one.weight * one.weight * (slides.transpose() * slides + turns.transpose() * turns);
    }
    const Eigen::MatrixXd reaches = pointBy() * free;
    const Eigen::MatrixXd cheaply = cost.ldlt().solve(reaches.transpose());
    Eigen::Matrix3d compliance = reaches * cheaply;
    compliance.diagonal().array() += damping * compliance.trace();
    const Vector pull = compliance.ldlt().solve(way);
    const Eigen::VectorXd shares = cheaply * pull;
    return free * shares;
}

bool Pulling::nearer(const Vector& place) {
    const Vector way = place - point();
    Eigen::VectorXd by;
    if (linkage_->jacobian().rows() == 0) { // nothing holds it here
        by = Eigen::VectorXd::Zero(linkage_->jacobian().cols());
        for (Eigen::Index i = 0; i < by.size(); i += 6)
            by.segment<3>(i) = way;
    } else {
        by = towards(way);
    }
    by = linkage_->shortened(by);
    constexpr double enough = 0.25; // of what the way would get shorter along a straight line
    const double least = converged * (linkage_->size() + way.norm());
    const double straight = 2 * way.dot(pointBy() * by);
    const std::vector<double> before = linkage_->values();
    for (double share = 1; share > 1e-3 && share * by.norm() > least; share /= 2) {
        linkage_->step(share * by);
        if (linkage_->close() &&
            way.squaredNorm() - (place - point()).squaredNorm() > enough * share * straight)
            return true;
        linkage_->setValues(before);
    }
    return false;
}

// Beside the hand the way to it hardly tells the last steps from none.
void Pulling::refine(const Vector& place) {
    constexpr double small = 1e-4;
    double last = small * linkage_->size();
    for (int k = 0; k < 4 && linkage_->jacobian().rows() > 0; ++k) {
        const Eigen::VectorXd by = towards(place - point());
        const std::vector<double> before = linkage_->values();
        if (!(by.norm() < last))
            return;
        last = by.norm();
        linkage_->step(by);
        if (!linkage_->close())
            return linkage_->setValues(before);
    }
}

void Pulling::pullTo(const Vector& place) {
    constexpr int steps = 60, rounds = 4;
    linkage_->slacken();
    const std::vector<double> before = linkage_->values();
    for (int round = 0; round < rounds; ++round) {
        for (int k = 0; k < steps && nearer(place); ++k)
            ;
        refine(place);
        if (!linkage_->tighten())
            return;
        if (!linkage_->close())
            break;
    }
    linkage_->setValues(before);
}

double Pulling::turned() const {
    const geometry::Quaternion turn =
        linkage_->poseOf(place_).attitude * linkage_->firstPoseOf(place_).attitude.conjugate();
    return geometry::toRotationVector(turn.normalized()).norm();
}

bool Pulling::turnTo(double angle) {
    const std::vector<double> before = linkage_->values();
    for (int k = 0; k < 20; ++k) {
        const Eigen::MatrixXd free = allowed();
        const geometry::Quaternion turn =
            linkage_->poseOf(place_).attitude * linkage_->firstPoseOf(place_).attitude.conjugate();
        const Vector about = geometry::toRotationVector(turn.normalized());
        const double missing = angle - about.norm();
        if (free.cols() == 1 && std::abs(missing) <= 1e-13)
            return true;
        const double rate =
            free.cols() != 1 || !(about.norm() > 0)
                ? 0
                : about.normalized().dot(free.col(0).segment<3>(columnOf(place_) + 3)) /
                      linkage_->radiusOf(place_);
        if (!(std::abs(rate) > 1e-6))
            break;
        linkage_->step(missing / rate * free.col(0));
        if (!linkage_->close())
            break;
    }
    linkage_->setValues(before);
    return false;
}

std::vector<Pulling::Velocity> Pulling::velocities(const std::vector<Velocity>& before,
                                                   const std::optional<Vector>& ofHand) {
    Eigen::VectorXd rates(static_cast<Eigen::Index>(6 * before.size()));
    for (std::size_t i = 0; i < before.size(); ++i) {
        rates.segment<3>(columnOf(i)) = before[i].linear;
        rates.segment<3>(columnOf(i) + 3) = linkage_->radiusOf(i) * before[i].angular;
    }
    const Eigen::MatrixXd free = allowed();
    rates = free * Eigen::VectorXd(free.transpose() * rates);
    if (ofHand) {
        const Vector more = *ofHand - pointBy() * rates;
        if (isLoose_)
            for (Eigen::Index i = 0; i < rates.size(); i += 6)
                rates.segment<3>(i) += more;
        else
            rates += towards(more);
    }
    std::vector<Velocity> after;
    for (std::size_t i = 0; i < before.size(); ++i)
        after.push_back({bodies()[i], rates.segment<3>(columnOf(i)),
                         rates.segment<3>(columnOf(i) + 3) / linkage_->radiusOf(i)});
    return after;
}

} // namespace physics
