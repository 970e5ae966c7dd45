// A hand that pulls a point of a body, whose joints, gears and ropes hold: where it and the bodies
// that they connect with it go.
//
// The point goes as near to the hand as the conditions allow. Of all such movements the one is
// taken that turns or slides the joints least, those nearest to the body before those that are
// further from it: what holds it follows only where it must, and what hangs on it goes along as it
// is. Where nothing holds all of them to the world they are moved together, without a turn.
//
// Coordinates of joints count from the start, wherever that is, so limits and positions of drives
// are no conditions; nor is a rope without -length, which is as long as it measures then.
//
// LIMIT: more than 40 bodies that hang together are not pulled.
#pragma once

#include "physics/assembly.h"
#include "physics/linkage.h"

#include <memory>

namespace physics {

class Pulling {
public:
    // `point`: of the world, where the body is at the start; the body carries it. A body that is
    // fixed is free for the hand.
    Pulling(const scene::Scene& scene, std::size_t body, const Vector& point);

    // False: nothing connects it with others or with the world, or the joints are open.
    [[nodiscard]] bool isJoined() const { return isJoined_; }
    // They are loose, or no joint lets the point go anywhere.
    [[nodiscard]] bool movesAsOne() const { return movesAsOne_; }
    [[nodiscard]] bool isLoose() const { return isLoose_; } // no joint gives way when all move
    [[nodiscard]] bool turns() const { return turns_; }     // the body, where the point goes on
    [[nodiscard]] const std::vector<std::size_t>& bodies() const { return linkage_->bodies(); }

    // Places as near as they come: from those that the last call gave.
    void pullTo(const Vector& place);
    // The body turned by exactly that angle, where one way to go is left. False: there are others.
    bool turnTo(double angle);
    [[nodiscard]] double turned() const; // radians: of the body, from where it was at first
    [[nodiscard]] std::vector<Assembly::Moved> moved() const { return linkage_->moved(); }

    struct Velocity {
        std::size_t body = 0;
        Vector linear, angular; // of the centre of mass; world
    };
    // The velocities that the conditions allow where the bodies are: the point has that of the hand
    // as far as they do. `before`: those that they had otherwise, in the order of bodies().
    [[nodiscard]] std::vector<Velocity> velocities(const std::vector<Velocity>& before,
                                                   const std::optional<Vector>& ofHand);

private:
    void findCosts();
    [[nodiscard]] Vector point() const;
    [[nodiscard]] Eigen::MatrixXd pointBy() const; // its way by a movement
    [[nodiscard]] Eigen::MatrixXd allowed() const; // movements that open nothing, as columns
    [[nodiscard]] Eigen::VectorXd towards(const Vector& way) const; // the cheapest movement
    [[nodiscard]] bool nearer(const Vector& place);
    void refine(const Vector& place);

    scene::Scene scene_; // without what is no condition
    std::unique_ptr<EquationsOfMotion> equations_;
    std::unique_ptr<Linkage> linkage_;
    std::size_t place_ = 0;       // of the body among those of the linkage
    Vector arm_ = Vector::Zero(); // of the point from the centre of mass, along the body's axes
    struct Cost {                 // of a joint that turns or slides between two bodies
        std::optional<std::size_t> first, second; // places; none: what does not move
        Vector arm1, arm2; // to the joint's point, from the centres of mass, along the bodies' axes
        double radius, weight;
    };
    std::vector<Cost> costs_;
    bool isJoined_ = false, isLoose_ = false, movesAsOne_ = false, turns_ = false;
};

} // namespace physics
