// Bodies that joints, gears and ropes hold, as places that one may change: how far the conditions
// gape, and how the bodies move so that they close, or so that they stay closed.
//
// A movement has six numbers for each free body: a way, and an arc about each of the world's axes,
// the turn times the body's radius. Angles of joints and what drums have wound follow the bodies
// at no cost. Bodies that are fixed, or that a trajectory holds at the start, stay.
#pragma once

#include "expression/tape.h"
#include "geometry/pose.h"
#include "physics/assembly.h"
#include "physics/equations_of_motion.h"

#include <Eigen/QR>

#include <functional>
#include <utility>
#include <vector>

namespace physics {

class Linkage {
public:
    // `about`: of the bodies that conditions connect with this one only; none: of all.
    Linkage(const scene::Scene& scene, EquationsOfMotion& equations,
            std::optional<std::size_t> about = std::nullopt);

    [[nodiscard]] const std::vector<std::size_t>& bodies() const { return free_; }
    [[nodiscard]] double size() const { return size_; }
    // Of a body by its place in bodies(): its centre of mass.
    [[nodiscard]] geometry::Pose poseOf(std::size_t place) const;
    [[nodiscard]] geometry::Pose firstPoseOf(std::size_t place) const { return first_[place]; }
    [[nodiscard]] double radiusOf(std::size_t place) const {
        return equations_.bodies[free_[place]].mass.radius;
    }

    // By Newton's method with the least step. False: it does not close, or was cancelled.
    [[nodiscard]] bool close(const std::function<bool()>& cancelled = nullptr);
    // Ropes that have become too short are conditions from now on. True: there are new ones.
    bool tighten();
    void slacken(); // all but those that were too short at first
    [[nodiscard]] bool hasConditions() const;
    // No gap and no rope changes when all bodies are moved by the same way.
    [[nodiscard]] bool staysWhenAllMove();
    [[nodiscard]] double largestGap() { return largest(gapsNow()); }
    // How the gaps change with a movement, where the bodies are now.
    [[nodiscard]] const Eigen::MatrixXd& jacobian();
    [[nodiscard]] Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver() const;
    void step(const Eigen::VectorXd& by); // as shortened() has it
    // No turn in it is longer than a part of a radian.
    [[nodiscard]] Eigen::VectorXd shortened(const Eigen::VectorXd& by) const;
    [[nodiscard]] Eigen::VectorXd movement() const;           // from where the bodies were
    [[nodiscard]] std::vector<Assembly::Moved> moved() const; // those that are elsewhere
    [[nodiscard]] const std::vector<double>& values() const { return values_; }
    void setValues(std::vector<double> values) { values_ = std::move(values); }

private:
    struct Conditions {
        std::vector<Node> ties; // make an unknown the angle of a joint, or what a drum has wound
        std::vector<Node> gaps, ropes;
        std::size_t lasting = 0; // gaps that hold whatever the ropes do
    };
    [[nodiscard]] bool isHeld(const BodyMotion& body) const;
    [[nodiscard]] double largest(const Eigen::VectorXd& gaps) const;
    [[nodiscard]] Conditions conditions();
    void keepTo(std::size_t body, Conditions& all);
    void takeFirstGaps();
    void makeTape();
    [[nodiscard]] std::size_t afterBodies() const;
    [[nodiscard]] expression::Graph& graph() { return equations_.set.graph; }
    [[nodiscard]] std::vector<double> valuesOf(const expression::Tape& tape, std::size_t count);
    Eigen::VectorXd gapsNow();
    void addDerivative(Eigen::MatrixXd& by, std::size_t row, std::size_t symbol, double derivative);

    EquationsOfMotion& equations_;
    double start_, size_ = 0;
    std::vector<std::size_t> free_; // bodies
    std::vector<geometry::Pose> first_;
    std::vector<Node> inputs_;
    std::vector<double> values_;
    Conditions conditions_;
    struct Angles {
        std::vector<std::size_t> places; // in values_
        Eigen::VectorXd missed, off;     // by the ties; of the angles, as the bodies are
        Eigen::MatrixXd by;              // how they follow the bodies
    } angles_;
    std::vector<std::pair<std::size_t, std::uint32_t>> entries_; // row, symbol
    expression::Tape tape_;                                      // gaps, then derivatives
    Eigen::MatrixXd jacobian_;
};

} // namespace physics
