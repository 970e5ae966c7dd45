// A hand that pulls a point of a body, whose joints, gears and ropes hold: where it and the bodies
// that they connect with it go, and how fast.
//
// At first the body alone moves, with what hangs on it; what holds it stands. Where that leaves the
// point aside of the hand, by more than half of the hand's way, the next bodies move, too, and the
// more of the rest is made up for the more is left (permitted()). Of the movements that remain the
// one is taken that turns or slides the joints least, those nearest to the body before those that
// are further from it: what hangs on it goes along as it is. Where nothing holds all of them to the
// world they are moved together, without a turn.
//
// A hand gives velocities by the same rule, on top of those that paths and drives give. A way of
// the point along which some body would move more than three times as fast as the hand is given in
// part, the less the faster that would be (share()): nothing of it where a chain is stretched, or
// where the hand is on an axle.
//
// Coordinates of joints count from the start, wherever that is, so limits and positions of drives
// are no conditions; nor is a rope without -length, which is as long as it measures then.
//
// LIMIT: more than 40 bodies that hang together are not pulled.
#pragma once

#include "physics/assembly.h"
#include "physics/linkage.h"

#include <Eigen/SparseCore>

#include <memory>

namespace physics {

class Pulling {
public:
    static constexpr std::size_t most = 40; // bodies
    // `point`: of the world, where the body is at the start; the body carries it. A body that is
    // fixed is free for the hand.
    Pulling(const scene::Scene& scene, std::size_t body, const Vector& point);

    enum class State {
        free, // nothing connects it with others or with the world, or the joints are open
        joined,
        tooMany // bodies: it is not pulled
    };
    [[nodiscard]] State state() const { return state_; }
    [[nodiscard]] bool isJoined() const { return state_ == State::joined; }
    [[nodiscard]] bool isStuck() const { return isStuck_; } // none of them can go anywhere
    // They are loose, or no joint lets the point go anywhere.
    [[nodiscard]] bool movesAsOne() const { return movesAsOne_; }
    [[nodiscard]] bool isLoose() const { return isLoose_; } // no joint gives way when all move
    [[nodiscard]] bool turns() const { return turns_; }     // the body, where the point goes on
    [[nodiscard]] const std::vector<std::size_t>& bodies() const { return linkage_->bodies(); }

    // Of a body, from its reference point along its axes.
    [[nodiscard]] Vector centreOf(const std::string& body) const;

    // Places as near as they come: from those that the last call gave. Where that takes long, a
    // call comes a part of the way only, and the next ones go on from there.
    void pullTo(const Vector& place);
    // The body turned by exactly that angle about what stands. False: there are other ways to go,
    // or what holds it has moved, too.
    bool turnTo(double angle);
    [[nodiscard]] double turned() const; // radians: of the body, from where it was at first
    // The body turned by that angle about an axis of the world, from its attitude at first. What
    // moves with it is as little as joints allow. False: they do not; all stays where it was.
    bool turnAbout(const Vector& axis, double angle);
    // Places at which conditions were worked out: the work so far.
    [[nodiscard]] std::size_t places() const { return linkage_->places(); }
    [[nodiscard]] std::vector<Assembly::Moved> moved() const { return linkage_->moved(); }

    struct Velocity {
        std::size_t body = 0;
        Vector linear, angular; // of the centre of mass; world
    };
    // The velocities that the conditions allow where the bodies are: the point has that of the hand
    // as far as they do. `atFirst`: those that they had where they were, in the order of bodies().
    // They turn with the bodies, but for what comes from what leads them.
    [[nodiscard]] std::vector<Velocity> velocities(const std::vector<Velocity>& atFirst,
                                                   const std::optional<Vector>& ofHand);

private:
    using Held = std::vector<char>; // columns of movements that are none
    [[nodiscard]] static Eigen::Index columnOf(std::size_t place) {
        return static_cast<Eigen::Index>(6 * place);
    }
    void findCosts();
    void findStages();
    [[nodiscard]] bool isGone(const std::string& joint) const;
    [[nodiscard]] Vector point() const;
    [[nodiscard]] Eigen::MatrixXd pointBy() const; // its way by a movement
    [[nodiscard]] Eigen::MatrixXd allowed() const; // movements that open nothing, as columns
    [[nodiscard]] Eigen::MatrixXd turnBy() const;  // the body's turn by a movement
    [[nodiscard]] Eigen::SparseMatrix<double> cost() const; // of a movement
    [[nodiscard]] Eigen::MatrixXd
    cheapest(const Eigen::MatrixXd& by, const Eigen::MatrixXd& conditions, const Held& held) const;
    // The cheapest movement that changes so what a movement changes like that.
    [[nodiscard]] Eigen::VectorXd towards(const Vector& way, const Eigen::MatrixXd& by) const;
    [[nodiscard]] Eigen::VectorXd given(const Vector& velocity, const Eigen::MatrixXd& conditions,
                                        const Held& held) const;
    // The body and all that goes with it by the same way; empty: something that stands holds it.
    [[nodiscard]] std::vector<std::size_t> loose(const Eigen::MatrixXd& conditions) const;
    [[nodiscard]] Eigen::VectorXd addHand(Eigen::VectorXd rates, const Eigen::MatrixXd& conditions,
                                          const Vector& ofHand) const;
    [[nodiscard]] bool nearer(const Vector& place);
    void refine(const Vector& place);
    void approach(const Vector& place);
    void allow(); // the work of one pull
    [[nodiscard]] bool isSpent() const;
    void follow(const Vector& place);
    [[nodiscard]] bool turnsTo(double angle);
    [[nodiscard]] std::vector<Held> stagesOfTurns() const;
    [[nodiscard]] bool reach(const geometry::Quaternion& attitude);

    scene::Scene scene_; // without what is no condition
    std::unique_ptr<EquationsOfMotion> equations_;
    std::unique_ptr<Linkage> linkage_;
    struct Grasp {                   // what is pulled
        std::size_t place = 0;       // of the body among those of the linkage
        Vector arm = Vector::Zero(); // of the point from the centre of mass, along the body's axes
        bool isOnGround = false;     // what stands holds the body itself
    } grasp_;
    struct Cost { // of a joint that turns or slides between two bodies
        std::optional<std::size_t> first, second; // places; none: what does not move
        Vector arm1, arm2; // to the joint's point, from the centres of mass, along the bodies' axes
        double radius, weight;
    };
    std::vector<Cost> costs_;
    std::vector<Held> stages_;  // each with fewer of them than the one before
    std::size_t stage_ = 0;     // of the last pull
    Held held_;                 // columns of movements that are none now
    std::vector<double> first_; // values of the linkage
    struct Effort {             // of a pull
        std::size_t until = 0;  // so many places of the linkage were looked at
        bool goesOn = false;    // one was cut short: from where it is
        double share = 1;       // of the last step, as far as it came nearer
    } effort_;
    State state_ = State::free;
    bool isLoose_ = false, movesAsOne_ = false, turns_ = false, isStuck_ = false;
};

} // namespace physics
