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
#include <unordered_map>
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
    // Of all bodies of the scene: their centres of mass.
    [[nodiscard]] std::vector<geometry::Pose> poses() const;
    [[nodiscard]] geometry::Pose firstPoseOf(std::size_t place) const { return first_[place]; }
    [[nodiscard]] double radiusOf(std::size_t place) const {
        return equations_.bodies[free_[place]].mass.radius;
    }

    // By Newton's method with the least step. False: it does not close, or was cancelled.
    [[nodiscard]] bool close(const std::function<bool()>& cancelled = nullptr);
    // Ropes that have become too short are conditions from now on. True: there are new ones.
    bool tighten();
    void slacken(); // ropes are no conditions until they are too short
    // Columns of movements that are none for now; empty: all are.
    void hold(std::vector<char> columns) {
        held_ = std::move(columns);
        now_.isKnown = false;
    }
    [[nodiscard]] const std::vector<char>& held() const { return held_; }
    // A joint's condition, a gear or a rope, taut or slack.
    struct Reads {
        std::vector<std::size_t> places; // of bodies
        bool isLoose = false;            // it stays when all of them are moved by the same way
        bool isSlack = false;            // a rope
    };
    [[nodiscard]] std::vector<Reads> reads();
    [[nodiscard]] double largestGap() { return largest(gapsNow()); }
    [[nodiscard]] bool isClosed(); // but for rounding
    [[nodiscard]] const Eigen::VectorXd& gaps() { return gapsNow(); }
    // How they change with a movement, where the bodies are now.
    [[nodiscard]] const Eigen::MatrixXd& jacobian();
    // The work so far: places at which that was worked out.
    [[nodiscard]] std::size_t places() const { return now_.places; }
    // The conditions on velocities where the bodies are, those of drives, too: by * v + led = 0,
    // with v like a movement. What holds the bodies may move: that is `led`.
    struct Rates {
        Eigen::MatrixXd by;
        Eigen::VectorXd led;
        std::vector<char> isRope; // a taut one: its rate may be more than 0
    };
    [[nodiscard]] Rates rates();
    using Solver = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
    [[nodiscard]] static Solver solverOf(const Eigen::MatrixXd& matrix); // of rows like these
    [[nodiscard]] Solver solver() { return solverOf(jacobian()); }
    void step(const Eigen::VectorXd& by); // as shortened() has it
    // No turn in it is longer than a part of a radian.
    [[nodiscard]] Eigen::VectorXd shortened(const Eigen::VectorXd& by) const;
    [[nodiscard]] Eigen::VectorXd movement() const;           // from where the bodies were
    [[nodiscard]] std::vector<Assembly::Moved> moved() const; // those that are elsewhere
    [[nodiscard]] const std::vector<double>& values() const { return values_; }
    void setValues(std::vector<double> values) {
        values_ = std::move(values);
        now_.isKnown = false;
    }

private:
    struct Conditions {
        std::vector<Node> ties; // make an unknown the angle of a joint, or what a drum has wound
        std::vector<Node> gaps, ropes;
        std::vector<Node> drives;                      // rates of coordinates, without a gap
        std::unordered_map<std::uint32_t, Node> rates; // by the gap's index
        std::size_t lasting = 0;                       // gaps that hold whatever the ropes do
    };
    [[nodiscard]] bool isHeld(const BodyMotion& body) const;
    [[nodiscard]] geometry::Pose poseOf(const BodyMotion& body) const;
    [[nodiscard]] double largest(const Eigen::VectorXd& gaps) const;
    [[nodiscard]] Conditions conditions();
    void keepTo(std::size_t body, Conditions& all);
    void makeTape();
    [[nodiscard]] std::size_t afterBodies() const;
    [[nodiscard]] expression::Graph& graph() { return equations_.set.graph; }
    [[nodiscard]] std::vector<double> valuesOf(const expression::Tape& tape, std::size_t count);
    const Eigen::VectorXd& gapsNow();
    void findGaps();
    void leaveOutHeld();
    [[nodiscard]] Eigen::VectorXd leastStep(const Eigen::VectorXd& gaps) const;
    // By entries of an attitude: how they change with an arc about each axis, for each body.
    using Turning = Eigen::Matrix<double, 4, 3>;
    [[nodiscard]] std::vector<Turning> turning() const;

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
    struct Now {                                                 // where the bodies are
        bool isKnown = false;
        std::size_t places = 0;
        Eigen::VectorXd gaps;
        Eigen::MatrixXd jacobian;
    } now_;
    std::vector<char> held_; // by column
};

} // namespace physics
