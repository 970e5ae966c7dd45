// DART: revolute joints in reduced coordinates, elastic contacts by its complementarity solver.
#include "equations.h"
#include "gas.h"
#include "measurement.h"
#include "truth.h"

// Not dart/dart.hpp, which wants a package of its own (ikfast).
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include <cmath>
#include <string>

namespace {

using namespace bench;
using dart::dynamics::BodyNode;
using dart::dynamics::BodyNodePtr;
using dart::dynamics::FreeJoint;
using dart::dynamics::RevoluteJoint;
using dart::dynamics::ShapePtr;
using dart::dynamics::Skeleton;
using dart::dynamics::SkeletonPtr;
using dart::simulation::World;
using dart::simulation::WorldPtr;

WorldPtr worldWith(double h, double gravity) {
    WorldPtr world = World::create();
    world->setTimeStep(h);
    world->setGravity(Eigen::Vector3d(0, gravity, 0));
    return world;
}

void freeBody(const Measurement& m) {
    for (const double h : m.sweep({0.01, 0.001})) {
        std::array<double, 4> q{};
        const Time time = m.timeOf([&] {
            const WorldPtr world = worldWith(h, 0);
            const SkeletonPtr body = Skeleton::create("body");
            auto [joint, node] = body->createJointAndBodyNodePair<FreeJoint>();
            node->setInertia(dart::dynamics::Inertia(1, Eigen::Vector3d::Zero(),
                                                     Eigen::Vector3d(1, 2, 3).asDiagonal()));
            joint->setAngularVelocity(Eigen::Vector3d(0.01, 1, 0));
            world->addSkeleton(body);
            const double taken = seconds([&] {
                for (long i = 0; i < std::lround(s1Span / h); ++i)
                    world->step();
            });
            const Eigen::Quaterniond r(node->getTransform().linear());
            q = {r.w(), r.x(), r.y(), r.z()};
            return taken;
        });
        m.add({"S1", "FreeJoint", h, s1Error(q), time, ""});
    }
}

BodyNode* addRod(const SkeletonPtr& skeleton, BodyNode* parent) {
    RevoluteJoint::Properties joint;
    joint.mName = parent ? "second" : "first";
    joint.mAxis = Eigen::Vector3d::UnitZ();
    joint.mT_ParentBodyToJoint.translation() = Eigen::Vector3d(parent ? -rods::half : 0, 0, 0);
    joint.mT_ChildBodyToJoint.translation() = Eigen::Vector3d(rods::half, 0, 0);
    BodyNode::AspectProperties body;
    body.mName = joint.mName;
    const double around = rods::mass / 12 * 2 * 1.1 * 1.1;
    body.mInertia =
        dart::dynamics::Inertia(rods::mass, Eigen::Vector3d::Zero(),
                                Eigen::Vector3d(around, rods::inertia, rods::inertia).asDiagonal());
    return skeleton
        ->createJointAndBodyNodePair<RevoluteJoint>(parent, joint, BodyNode::Properties(body))
        .second;
}

void pinnedRods(const Measurement& m) {
    const RodSamples right = s2bCentres();
    for (const double h : m.sweep({0.01, 0.001, 0.0001})) {
        RodSamples samples;
        const Time time = m.timeOf([&] {
            samples.clear();
            const WorldPtr world = worldWith(h, -rods::gravity);
            const SkeletonPtr chain = Skeleton::create("chain");
            BodyNode* first = addRod(chain, nullptr);
            BodyNode* second = addRod(chain, first);
            world->addSkeleton(chain);
            double taken = 0;
            for (int i = 0; i < s2Samples; ++i) {
                taken += seconds([&] {
                    for (long s = 0; s < std::lround(0.5 / h); ++s)
                        world->step();
                });
                const Eigen::Vector3d a = first->getCOM(), b = second->getCOM();
                samples.push_back({a.x(), a.y(), b.x(), b.y()});
            }
            return taken;
        });
        m.add({"S2b", "Revolute", h, rodError(samples, right), time, ""});
    }
}

BodyNode* addBall(const WorldPtr& world, const ShapePtr& shape, double mass,
                  const Eigen::Vector3d& place, const Eigen::Vector3d& velocity) {
    const SkeletonPtr ball = Skeleton::create("ball " + std::to_string(world->getNumSkeletons()));
    auto [joint, node] = ball->createJointAndBodyNodePair<FreeJoint>();
    node->setInertia(
        dart::dynamics::Inertia(mass, Eigen::Vector3d::Zero(), shape->computeInertia(mass)));
    node->createShapeNodeWith<dart::dynamics::VisualAspect, dart::dynamics::CollisionAspect,
                              dart::dynamics::DynamicsAspect>(shape);
    node->getShapeNode(0)->getDynamicsAspect()->setRestitutionCoeff(1);
    node->getShapeNode(0)->getDynamicsAspect()->setFrictionCoeff(0);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = place;
    joint->setTransform(pose);
    joint->setLinearVelocity(velocity);
    world->addSkeleton(ball);
    return node;
}

void addWall(const WorldPtr& world, const Eigen::Vector3d& edges, const Eigen::Vector3d& place) {
    const SkeletonPtr wall = Skeleton::create("wall " + std::to_string(world->getNumSkeletons()));
    auto [joint, node] = wall->createJointAndBodyNodePair<dart::dynamics::WeldJoint>();
    node->createShapeNodeWith<dart::dynamics::VisualAspect, dart::dynamics::CollisionAspect,
                              dart::dynamics::DynamicsAspect>(
        std::make_shared<dart::dynamics::BoxShape>(edges));
    node->getShapeNode(0)->getDynamicsAspect()->setRestitutionCoeff(1);
    node->getShapeNode(0)->getDynamicsAspect()->setFrictionCoeff(0);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = place;
    joint->setTransformFromParentBodyNode(pose);
    world->addSkeleton(wall);
}

void gas(const Measurement& m) {
    const std::vector<GasStart> balls = gasOf(m.smoke() ? 3 : 8);
    Gas exact(balls, 8);
    exact.runTo(0.25);
    const auto right = exact.positions(0.25);
    for (const double h : m.sweep({1.0 / 60})) { // 25 s of CPU at 1/240
        std::vector<std::array<double, 3>> early;
        double energy = 0;
        const Time time = m.timeOf([&] {
            const WorldPtr world = worldWith(h, 0);
            const ShapePtr shape = std::make_shared<dart::dynamics::SphereShape>(gasRadius);
            std::vector<BodyNode*> nodes;
            for (const GasStart& ball : balls)
                nodes.push_back(addBall(world, shape, 1,
                                        {ball.position[0], ball.position[1], ball.position[2]},
                                        {ball.velocity[0], ball.velocity[1], ball.velocity[2]}));
            for (int a = 0; a < 3; ++a)
                for (const double side : {-1.5, 1.5}) {
                    Eigen::Vector3d edges(4, 4, 4), place(0, 0, 0);
                    edges[a] = 1;
                    place[a] = side;
                    addWall(world, edges, place);
                }
            double taken = seconds([&] {
                for (long i = 0; i < std::lround(0.25 / h); ++i)
                    world->step();
            });
            early.clear();
            for (const BodyNode* node : nodes) {
                const Eigen::Vector3d p = node->getCOM();
                early.push_back({p.x(), p.y(), p.z()});
            }
            taken += seconds([&] {
                for (long i = 0; i < std::lround((m.smoke() ? 0.1 : s4Span - 0.25) / h); ++i)
                    world->step();
            });
            energy = 0;
            for (const BodyNode* node : nodes)
                energy += node->getCOMLinearVelocity().squaredNorm() / 2;
            return taken;
        });
        m.add({"S4", "Dantzig LCP;restitution1", h, medianDistance(early, right), time, ""});
        m.add({"S4 energy", "Dantzig LCP;restitution1", h, std::abs(energy / exact.energy() - 1),
               time, ""});
    }
}

// A change of the heavy ball's velocity is a hit of the two, one of the sum of momenta the wall's.
void billiard(const Measurement& m) {
    const double steps[] = {0.01, 0.01, 0.001};
    for (int n = 0; n <= (m.smoke() ? 0 : 2); ++n) {
        const double heavyMass = std::pow(100.0, n);
        long hits = 0;
        const Time time = m.timeOf([&] {
            const WorldPtr world = worldWith(steps[n], 0);
            const ShapePtr shape = std::make_shared<dart::dynamics::SphereShape>(0.1);
            addWall(world, {1, 2, 2}, {-0.5, 0, 0});
            BodyNode* light = addBall(world, shape, 1, {1.1, 0, 0}, {0, 0, 0});
            BodyNode* heavy = addBall(world, shape, heavyMass, {2.3, 0, 0}, {-1, 0, 0});
            double v = 0, u = -1;
            hits = 0;
            return seconds([&] {
                for (long i = 0; i < std::lround(s5Spans[n] / steps[n]); ++i) {
                    world->step();
                    const double v2 = light->getCOMLinearVelocity().x(),
                                 u2 = heavy->getCOMLinearVelocity().x();
                    const double push = v2 - v + heavyMass * (u2 - u);
                    hits += std::abs(u2 - u) * heavyMass > 1e-2;
                    hits += std::abs(push) > 1e-2;
                    v = v2;
                    u = u2;
                }
            });
        });
        const double right = std::floor(pi<double> * std::pow(10, n));
        m.add({"S5 n=" + std::to_string(n), "Dantzig LCP;restitution1", steps[n],
               std::abs(static_cast<double>(hits) - right), time, std::to_string(hits) + " hits"});
    }
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("dart", argc, argv);
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    if (m.wants("S1"))
        freeBody(m);
    if (m.wants("S2b"))
        pinnedRods(m);
    if (m.wants("S4"))
        gas(m);
    if (m.wants("S5"))
        billiard(m);
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
    return 0;
}
