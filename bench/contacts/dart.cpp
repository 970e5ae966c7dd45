// DART on the cases of contact and joints: joint coordinates, and its own collision detector, for
// which the floor is a large box.
#include "play.h"
#include "tree.h"

// Not dart/dart.hpp, which wants a package of its own (ikfast).
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/BallJointConstraint.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include <cmath>

namespace {

using namespace bench;
using namespace bench::contacts;
namespace dynamics = dart::dynamics;

Eigen::Vector3d vector(const Place& p) { return {p[0], p[1], p[2]}; }

Eigen::Isometry3d poseOf(const Place& at, double angle) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = vector(at);
    pose.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    return pose;
}

class DartWorld : public World {
public:
    DartWorld(const Case& scene, double h) : scene_(scene), h_(h) {
        world_->setGravity({0, -scene.gravity, 0});
        world_->getConstraintSolver()->setCollisionDetector(
            dart::collision::DARTCollisionDetector::create());
        if (scene.floor)
            addFloor();
        for (std::size_t b = 0; b < scene.bodies.size(); ++b)
            add(b);
        for (const dynamics::SkeletonPtr& skeleton : skeletons_)
            world_->addSkeleton(skeleton);
        for (const std::size_t loop : loopJoints(scene)) {
            const Joint& joint = scene.joints[loop];
            world_->getConstraintSolver()->addConstraint(
                std::make_shared<dart::constraint::BallJointConstraint>(
                    bodies_[static_cast<std::size_t>(joint.body1)],
                    bodies_[static_cast<std::size_t>(joint.body2)], vector(joint.at)));
        }
    }
    void advance(double span) override {
        const long steps = stepsIn(span, h_);
        world_->setTimeStep(span / static_cast<double>(steps));
        for (long i = 0; i < steps; ++i) {
            for (std::size_t b = 0; b < bodies_.size(); ++b)
                if (const auto joint = treeJoint(scene_, b); joint && scene_.joints[*joint].couple)
                    bodies_[b]->getParentJoint()->setForce(0, scene_.joints[*joint].couple);
            world_->step(); // forgets it
        }
        count(steps);
    }
    [[nodiscard]] Place centre(std::size_t body) const override {
        const Eigen::Vector3d p = bodies_[body]->getCOM();
        return {p.x(), p.y(), p.z()};
    }

private:
    void shape(dynamics::BodyNode* node, const dynamics::ShapePtr& shape, const Place& at = {}) {
        auto* shown =
            node->createShapeNodeWith<dynamics::CollisionAspect, dynamics::DynamicsAspect>(shape);
        shown->setRelativeTranslation(vector(at));
        shown->getDynamicsAspect()->setFrictionCoeff(scene_.friction);
        shown->getDynamicsAspect()->setRestitutionCoeff(0);
    }
    void addFloor() {
        constexpr double depth = 2;
        const dynamics::SkeletonPtr skeleton = dynamics::Skeleton::create("floor");
        auto [joint, node] = skeleton->createJointAndBodyNodePair<dynamics::WeldJoint>();
        const Place at = {depth / 2 * std::sin(scene_.slope), -depth / 2 * std::cos(scene_.slope),
                          0};
        joint->setTransformFromParentBodyNode(poseOf(at, scene_.slope));
        shape(node, std::make_shared<dynamics::BoxShape>(Eigen::Vector3d(60, depth, 20)));
        skeletons_.push_back(skeleton);
    }
    // Frames of a joint's ends, in the bodies that it connects.
    template <class Properties>
    void place(Properties& properties, std::size_t body, const Joint& joint) const {
        const Eigen::Isometry3d world = poseOf(joint.at, 0);
        const auto poseOfBody = [&](std::size_t b) {
            return poseOf(scene_.bodies[b].at, scene_.bodies[b].angle);
        };
        properties.mT_ChildBodyToJoint = poseOfBody(body).inverse() * world;
        // The joint's coordinate is 0 at the start: the child's frame has its angle there.
        properties.mT_ParentBodyToJoint =
            joint.body2 < 0 ? world
                            : poseOfBody(static_cast<std::size_t>(joint.body2)).inverse() * world;
    }
    void add(std::size_t index) {
        const Body& body = scene_.bodies[index];
        dynamics::BodyNode::AspectProperties aspect;
        aspect.mName = body.name;
        aspect.mInertia = dynamics::Inertia(body.mass, Eigen::Vector3d::Zero(),
                                            vector(body.inertia()).asDiagonal());
        const dynamics::BodyNode::Properties properties(aspect);
        const auto found = treeJoint(scene_, index);
        dynamics::BodyNode* node = nullptr;
        if (!found) {
            const dynamics::SkeletonPtr skeleton = dynamics::Skeleton::create(body.name);
            auto [joint, made] = skeleton->createJointAndBodyNodePair<dynamics::FreeJoint>(
                nullptr, dynamics::FreeJoint::Properties(), properties);
            joint->setTransform(poseOf(body.at, body.angle));
            joint->setLinearVelocity(vector(body.velocity));
            joint->setAngularVelocity({0, 0, body.spin});
            skeletons_.push_back(skeleton);
            node = made;
        } else {
            const Joint& joint = scene_.joints[*found];
            dynamics::BodyNode* parent =
                joint.body2 < 0 ? nullptr : bodies_[static_cast<std::size_t>(joint.body2)];
            if (!parent)
                skeletons_.push_back(dynamics::Skeleton::create(body.name));
            const dynamics::SkeletonPtr skeleton =
                parent ? parent->getSkeleton() : skeletons_.back();
            node = joint.type == Joint::Type::slider
                       ? hang<dynamics::PrismaticJoint>(skeleton, parent, index, joint, properties,
                                                        Eigen::Vector3d::UnitX())
                       : hang<dynamics::RevoluteJoint>(skeleton, parent, index, joint, properties,
                                                       Eigen::Vector3d::UnitZ());
        }
        if (scene_.collide)
            for (const Place& at : body.balls())
                shape(node, std::make_shared<dynamics::SphereShape>(body.size[0]), at);
        if (scene_.collide && body.shape == Body::Shape::box)
            shape(node, std::make_shared<dynamics::BoxShape>(vector(body.size)));
        bodies_.push_back(node);
    }
    template <class Type>
    dynamics::BodyNode* hang(const dynamics::SkeletonPtr& skeleton, dynamics::BodyNode* parent,
                             std::size_t index, const Joint& joint,
                             const dynamics::BodyNode::Properties& body,
                             const Eigen::Vector3d& axis) const {
        typename Type::Properties properties;
        properties.mName = "joint of " + scene_.bodies[index].name;
        properties.mAxis = axis;
        place(properties, index, joint);
        auto [made, node] = skeleton->createJointAndBodyNodePair<Type>(parent, properties, body);
        made->setVelocity(0, treeRate(scene_, index));
        return node;
    }

    const Case& scene_;
    double h_;
    dart::simulation::WorldPtr world_ = dart::simulation::World::create();
    std::vector<dynamics::SkeletonPtr> skeletons_;
    std::vector<dynamics::BodyNode*> bodies_;
};

} // namespace

int main(int argc, char** argv) {
    const Measurement m("dart", argc, argv);
    playAll(m, {{"Dantzig", usualSteps, [](const Case& scene, double h) {
                     return std::make_unique<DartWorld>(scene, h);
                 }}});
    return 0;
}
