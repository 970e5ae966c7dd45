// Small scenes for tests: a floor, things that fall on it, and the engine run on them.
#pragma once

#include "physics/testing.h"
#include "simulation/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace simulation::testing {

inline constexpr double g = 9.81;

class SceneBuilder {
public:
    scene::Scene scene;

    explicit SceneBuilder(double finish, double accuracy = 1e-6) {
        scene.simulator.finish = finish;
        scene.simulator.accuracy = accuracy;
    }
    scene::Body& ball(const std::string& name, const Vector& position, double radius = 0.1) {
        scene.shapeSets.push_back(physics::testing::sphere(name, radius));
        return place(name, position);
    }
    scene::Body& box(const std::string& name, const Vector& position, const Vector& edges) {
        scene.shapeSets.push_back(physics::testing::box(name, edges));
        return place(name, position);
    }
    // Its upper side is y = 0.
    scene::Body& floor(double edge = 20) {
        scene::Body& made = box("floor", {0, -0.1, 0}, {edge, 0.2, edge});
        made.fixed = true;
        return made;
    }
    // Six walls about the origin, two units from each other: the first six bodies.
    void room() {
        for (const double side : {-1.5, 1.5})
            for (int axis = 0; axis < 3; ++axis) {
                Vector where = Vector::Zero(), edges = Vector::Constant(4);
                where[axis] = side;
                edges[axis] = 1;
                box("wall" + std::to_string(scene.bodies.size()), where, edges).fixed = true;
            }
    }
    void weight(const std::string& body, const Vector& acceleration = {0, -g, 0}) {
        scene::Force force;
        force.body = body;
        force.kind = scene::GravitationalForce{acceleration};
        scene.forces.push_back(force);
    }
    scene::Force& force(const std::string& body, const std::string& fx, const std::string& fy,
                        const std::string& fz) {
        scene.forces.push_back(physics::testing::force(body, fx, fy, fz));
        return scene.forces.back();
    }
    // Holds the body's reference point on one Bezier curve.
    void hold(const std::string& body, double from, double to, std::vector<Vector> control) {
        scene::Trajectory trajectory;
        trajectory.name = "path of " + body;
        trajectory.curves.push_back({.from = from, .to = to, .control = std::move(control)});
        scene.trajectories.push_back(trajectory);
        scene::Constraint constraint;
        constraint.body = body;
        constraint.trajectory = trajectory.name;
        scene.constraints.push_back(constraint);
    }

private:
    scene::Body& place(const std::string& name, const Vector& position) {
        scene.bodies.push_back(physics::testing::body(name, name, 1));
        scene.bodies.back().initialPosition = position;
        return scene.bodies.back();
    }
};

// How far a point is from where it should be.
inline double distance(const Vector& a, const Vector& b) { return (a - b).norm(); }

inline std::vector<double> rows(const Motion& motion, std::size_t body, int samples = 50) {
    std::vector<double> numbers;
    for (int i = 0; i <= samples; ++i) {
        const double t = motion.start() + (motion.finish() - motion.start()) * i / samples;
        const BodyState s = motion.at(body, t);
        for (const double x : {s.position.x(), s.position.y(), s.position.z(), s.attitude.w(),
                               s.attitude.x(), s.attitude.y(), s.attitude.z(), s.velocity.x()})
            numbers.push_back(x);
    }
    return numbers;
}

} // namespace simulation::testing
