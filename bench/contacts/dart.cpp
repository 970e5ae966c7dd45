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
        for (const Plane& plane : scene.planes)
            add(plane);
        for (std::size_t b = 0; b < scene.bodies.size(); ++b)
            add(b);
        for (const dynamics::SkeletonPtr& skeleton : skeletons_)
            world_->addSkeleton(skeleton);
        for (const std::size_t loop : loopJoints(scene)) {
            const Joint& joint = scene.joints[loop];
            for (const Place& at : closingPoints(scene, joint))
                world_->getConstraintSolver()->addConstraint(closing(joint, at));
        }
    }
    void advance(double span) override {
        const long steps = stepsIn(span, h_);
        world_->setTimeStep(span / static_cast<double>(steps));
        for (long i = 0; i < steps; ++i) {
            for (const auto& [joint, described] : driven_)
                if (described->speed)
                    joint->setCommand(0, *described->speed);
                else
                    joint->setForce(0, described->couple);
            world_->step(); // forgets them
        }
        count(steps);
    }
    [[nodiscard]] Place centre(std::size_t body) const override {
        const Eigen::Vector3d p = bodies_[body]->getCOM();
        return {p.x(), p.y(), p.z()};
    }

private:
    dart::constraint::ConstraintBasePtr closing(const Joint& joint, const Place& at) const {
        dynamics::BodyNode* one = bodies_[static_cast<std::size_t>(joint.body1)];
        if (joint.body2 < 0)
            return std::make_shared<dart::constraint::BallJointConstraint>(one, vector(at));
        return std::make_shared<dart::constraint::BallJointConstraint>(
            one, bodies_[static_cast<std::size_t>(joint.body2)], vector(at));
    }
    // A pair has the smaller friction and the product of the restitutions.
    void shape(dynamics::BodyNode* node, const dynamics::ShapePtr& shape, double friction,
               const Place& at = {}) {
        auto* shown =
            node->createShapeNodeWith<dynamics::CollisionAspect, dynamics::DynamicsAspect>(shape);
        shown->setRelativeTranslation(vector(at));
        shown->getDynamicsAspect()->setFrictionCoeff(friction);
        shown->getDynamicsAspect()->setRestitutionCoeff(std::sqrt(scene_.restitution));
    }
    void add(const Plane& plane) {
        constexpr double depth = 2;
        const dynamics::SkeletonPtr skeleton = dynamics::Skeleton::create(plane.name);
        auto [joint, node] = skeleton->createJointAndBodyNodePair<dynamics::WeldJoint>();
        const Place at = {depth / 2 * std::sin(plane.slope), -depth / 2 * std::cos(plane.slope), 0};
        joint->setTransformFromParentBodyNode(poseOf(at, plane.slope));
        shape(node, std::make_shared<dynamics::BoxShape>(Eigen::Vector3d(60, depth, 20)),
              scene_.planeFriction);
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
                       ? hang<dynamics::PrismaticJoint>(skeleton, parent, index, joint, properties)
                       : hang<dynamics::RevoluteJoint>(skeleton, parent, index, joint, properties);
        }
        if (scene_.collide)
            for (const Place& at : body.balls())
                shape(node, std::make_shared<dynamics::SphereShape>(body.size[0]), scene_.friction,
                      at);
        if (scene_.collide && body.shape == Body::Shape::box)
            shape(node, std::make_shared<dynamics::BoxShape>(vector(body.size)), scene_.friction);
        bodies_.push_back(node);
    }
    template <class Type>
    dynamics::BodyNode* hang(const dynamics::SkeletonPtr& skeleton, dynamics::BodyNode* parent,
                             std::size_t index, const Joint& joint,
                             const dynamics::BodyNode::Properties& body) {
        typename Type::Properties properties;
        properties.mName = "joint of " + scene_.bodies[index].name;
        properties.mAxis = vector(joint.axis); // the frames are along the world's axes
        place(properties, index, joint);
        auto [made, node] = skeleton->createJointAndBodyNodePair<Type>(parent, properties, body);
        made->setVelocity(0, treeRate(scene_, index));
        made->setSpringStiffness(0, joint.stiffness);
        made->setRestPosition(0, joint.rest);
        made->setCoulombFriction(0, joint.dryCouple);
        if (joint.speed)
            made->setActuatorType(dynamics::Joint::VELOCITY);
        if (joint.speed || joint.couple != 0)
            driven_.emplace_back(made, &joint);
        return node;
    }

    const Case& scene_;
    double h_;
    dart::simulation::WorldPtr world_ = dart::simulation::World::create();
    std::vector<dynamics::SkeletonPtr> skeletons_;
    std::vector<dynamics::BodyNode*> bodies_;
    std::vector<std::pair<dynamics::Joint*, const Joint*>> driven_;
};

} // namespace

int main(int argc, char** argv) {
    const Measurement m("dart", argc, argv);
    const auto build = [](const Case& scene, double h) {
        return std::make_unique<DartWorld>(scene, h);
    };
    playAll(m, {{"Dantzig", usualSteps, build, {Feature::stop}}}); // its stops do not rebound
    return 0;
}
