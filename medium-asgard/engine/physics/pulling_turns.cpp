// Turns of a body that joints, gears and ropes hold.
#include "physics/pulling.h"

#include "physics/independent_rows.h"

#include <algorithm>
#include <cmath>

namespace physics {

double Pulling::turned() const {
    const geometry::Quaternion turn = linkage_->poseOf(grasp_.place).attitude *
                                      linkage_->firstPoseOf(grasp_.place).attitude.conjugate();
    return geometry::toRotationVector(turn.normalized()).norm();
}

bool Pulling::turnTo(double angle) {
    const bool isAboutWhatStands = grasp_.isOnGround || stage_ + 1 < stages_.size();
    if (!isAboutWhatStands)
        return false;
    held_ = stages_[stage_];
    linkage_->hold(held_);
    const bool is = turnsTo(angle);
    held_ = stages_.back();
    linkage_->hold(held_);
    return is;
}

bool Pulling::turnsTo(double angle) {
    const std::vector<double> before = linkage_->values();
    for (int k = 0; k < 20; ++k) {
        if (const IndependentRows independent(linkage_->jacobian(), held_);
            independent.are() && independent.free() != 1)
            break;
        const Eigen::MatrixXd free = allowed();
        const geometry::Quaternion turn = linkage_->poseOf(grasp_.place).attitude *
                                          linkage_->firstPoseOf(grasp_.place).attitude.conjugate();
        const Vector about = geometry::toRotationVector(turn.normalized());
        const double missing = angle - about.norm();
        if (free.cols() == 1 && std::abs(missing) <= 1e-13)
            return true;
        const double rate =
            free.cols() != 1 || !(about.norm() > 0)
                ? 0
                : about.normalized().dot(free.col(0).segment<3>(columnOf(grasp_.place) + 3)) /
                      linkage_->radiusOf(grasp_.place);
        if (!(std::abs(rate) > 1e-6))
            break;
        linkage_->step(missing / rate * free.col(0));
        if (!linkage_->close())
            break;
    }
    linkage_->setValues(before);
    return false;
}

Eigen::MatrixXd Pulling::turnBy() const {
    Eigen::MatrixXd by = Eigen::MatrixXd::Zero(3, columnOf(bodies().size()));
    by.block<3, 3>(0, columnOf(grasp_.place) + 3) =
        Eigen::Matrix3d::Identity() / linkage_->radiusOf(grasp_.place);
    return by;
}

// First the body alone turns, then what hangs on it, too, and then what holds it.
std::vector<Pulling::Held> Pulling::stagesOfTurns() const {
    std::vector<Held> all = stages_;
    all.insert(all.begin(), Held(6 * bodies().size(), 1));
    std::fill_n(all.front().begin() + columnOf(grasp_.place), 3, 0);
    for (Held& held : all) // a fixed body, too
        std::fill_n(held.begin() + columnOf(grasp_.place) + 3, 3, 0);
    return all;
}

bool Pulling::turnAbout(const Vector& axis, double angle) {
    constexpr double stride = 0.6; // radians: more than half a turn is none by itself
    const std::vector<double> before = linkage_->values();
    if (first_.empty())
        first_ = before;
    const geometry::Pose from = linkage_->firstPoseOf(grasp_.place);
    const int strides = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / stride)));
    const std::vector<Held> stages = stagesOfTurns();
    std::size_t stage = 0;
    for (bool is = false; !is && stage < stages.size(); stage += is ? 0 : 1) {
        held_ = stages[stage];
        linkage_->hold(held_);
        linkage_->setValues(first_);
        is = linkage_->close();
        for (int k = 1; k <= strides && is; ++k)
            is = reach(geometry::Quaternion(Eigen::AngleAxisd(angle * k / strides, axis)) *
                       from.attitude);
    }
    const bool is = stage < stages.size();
    if (is && isLoose_ && stage > 0) { // all together go nowhere
        Eigen::VectorXd by = Eigen::VectorXd::Zero(columnOf(bodies().size()));
        const Vector back = from.position - linkage_->poseOf(grasp_.place).position;
        for (std::size_t i = 0; i < bodies().size(); ++i)
            by.segment<3>(columnOf(i)) = back;
        linkage_->step(by);
    }
    held_ = stages_.back();
    linkage_->hold(held_);
    if (!is)
        linkage_->setValues(before);
    return is;
}

bool Pulling::reach(const geometry::Quaternion& attitude) {
    constexpr int steps = 20;
    constexpr double reached = 1e-12; // radians
    const auto left = [&] {
        const geometry::Quaternion turn =
            attitude * linkage_->poseOf(grasp_.place).attitude.conjugate();
        return geometry::toRotationVector(turn.normalized());
    };
    for (int k = 0; k < steps; ++k) {
        const Vector way = left();
        if (way.norm() <= reached)
            return true;
        linkage_->step(towards(way, turnBy()));
        if (!linkage_->close() || !(left().norm() < 0.9 * way.norm()))
            return false;
    }
    return false;
}

} // namespace physics
