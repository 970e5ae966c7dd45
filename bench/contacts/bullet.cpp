// Bullet on the cases of contact and joints, in single and in double precision (two programs of
// this file): sequential impulses, with the usual 10 rounds for a step and with 200.
#include "play.h"

#include <btBulletDynamicsCommon.h>

#include <cmath>

namespace {

using namespace bench;
using namespace bench::contacts;

#ifdef BT_USE_DOUBLE_PRECISION
const char* const program = "bullet_double";
#else
const char* const program = "bullet";
#endif

btScalar scalar(double value) { return static_cast<btScalar>(value); }
btVector3 vector(const Place& p) { return {scalar(p[0]), scalar(p[1]), scalar(p[2])}; }

class BulletWorld : public World {
public:
    BulletWorld(const Case& scene, double h, int iterations) : scene_(scene), h_(h) {
        world_.setGravity(vector({0, -scene.gravity, 0}));
        world_.getSolverInfo().m_numIterations = iterations;
        // A pair has the product of the values, of friction and of restitution.
        const double friction = std::sqrt(scene.friction);
        for (const Plane& plane : scene.planes)
            add(std::make_unique<btStaticPlaneShape>(
                    vector({-std::sin(plane.slope), std::cos(plane.slope), 0}), scalar(0)),
                {.name = plane.name, .mass = 0},
                scene.friction > 0 ? scene.planeFriction / friction : 0);
        for (const Body& body : scene.bodies)
            addBody(body, friction);
        for (const Joint& joint : scene.joints)
            join(joint);
    }
    ~BulletWorld() override {
        for (const auto& joint : joints_)
            world_.removeConstraint(joint.get());
        for (const auto& body : bodies_)
            world_.removeRigidBody(body.get());
    }
    BulletWorld(const BulletWorld&) = delete;
    BulletWorld& operator=(const BulletWorld&) = delete;

    void advance(double span) override {
        const long steps = stepsIn(span, h_);
        for (long i = 0; i < steps; ++i) {
            for (std::size_t j = 0; j < joints_.size(); ++j)
                drive(scene_.joints[j], *joints_[j], span / static_cast<double>(steps));
            world_.stepSimulation(scalar(span / static_cast<double>(steps)), 0);
        }
        count(steps);
    }
    [[nodiscard]] Place centre(std::size_t body) const override {
        const btVector3& p = of(static_cast<int>(body)).getWorldTransform().getOrigin();
        return {p.x(), p.y(), p.z()};
    }

private:
    // The engine forgets couples after each step, and knows of impulses of a motor, not couples.
    void drive(const Joint& joint, btTypedConstraint& constraint, double step) {
        if (joint.type != Joint::Type::hinge)
            return;
        auto& hinge = static_cast<btHingeConstraint&>(constraint);
        if (joint.dryCouple > 0)
            hinge.enableAngularMotor(true, 0, scalar(joint.dryCouple * step));
        const double couple = joint.couple + springCouple(joint, hinge.getHingeAngle());
        if (couple == 0)
            return;
        const btVector3 about = scalar(couple) * vector(joint.axis); // which stays where it is
        of(joint.body1).applyTorque(about);
        if (joint.body2 >= 0)
            of(joint.body2).applyTorque(-about);
    }
    void addBody(const Body& body, double friction) {
        if (body.shape == Body::Shape::box)
            return add(std::make_unique<btBoxShape>(vector(body.size) / 2), body, friction);
        auto ball = std::make_unique<btSphereShape>(scalar(body.size[0]));
        if (body.shape == Body::Shape::ball)
            return add(std::move(ball), body, friction);
        auto all = std::make_unique<btCompoundShape>();
        for (const Place& at : body.balls())
            all->addChildShape(btTransform(btQuaternion::getIdentity(), vector(at)), ball.get());
        shapes_.push_back(std::move(ball));
        add(std::move(all), body, friction);
    }
    void add(std::unique_ptr<btCollisionShape> shape, const Body& body, double friction) {
        btVector3 inertia(0, 0, 0);
        if (body.mass > 0)
            inertia = vector(body.inertia());
        btRigidBody::btRigidBodyConstructionInfo info(scalar(body.mass), nullptr, shape.get(),
                                                      inertia);
        info.m_startWorldTransform =
            btTransform(btQuaternion(vector({0, 0, 1}), scalar(body.angle)), vector(body.at));
        info.m_friction = scalar(friction);
        info.m_restitution = scalar(std::sqrt(scene_.restitution));
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        btRigidBody& added = *bodies_.back();
        added.setActivationState(DISABLE_DEACTIVATION);
        added.setLinearVelocity(vector(body.velocity));
        added.setAngularVelocity(vector({0, 0, body.spin}));
        if (scene_.collide)
            world_.addRigidBody(&added);
        else
            world_.addRigidBody(&added, 0, 0);
        shapes_.push_back(std::move(shape));
    }
    [[nodiscard]] btRigidBody& of(int body) const {
        return *bodies_[static_cast<std::size_t>(body) + scene_.planes.size()];
    }
    void join(const Joint& joint) {
        // A slider's frame has its x along the axis, a hinge's its z.
        const bool slides = joint.type == Joint::Type::slider;
        const btVector3 own = slides ? btVector3(1, 0, 0) : btVector3(0, 0, 1);
        const btTransform frame(shortestArcQuat(own, vector(joint.axis)), vector(joint.at));
        const auto in = [&](const btRigidBody& body) {
            return body.getWorldTransform().inverse() * frame;
        };
        btRigidBody& one = of(joint.body1);
        if (slides) {
            auto slider = std::make_unique<btSliderConstraint>(one, in(one), true);
            slider->setLowerLinLimit(1); // above the upper one: free
            slider->setUpperLinLimit(-1);
            slider->setLowerAngLimit(0);
            slider->setUpperAngLimit(0);
            joints_.push_back(std::move(slider));
        } else {
            btRigidBody& other =
                joint.body2 < 0 ? btTypedConstraint::getFixedBody() : of(joint.body2);
            auto hinge = std::make_unique<btHingeConstraint>(one, other, in(one), in(other));
            if (joint.speed)
                hinge->enableAngularMotor(true, scalar(*joint.speed), scalar(1e10));
            if (joint.least) {
                // With its other frames, and with less than all of the error put right at once, it
                // does not rebound as it is told.
                hinge->setUseFrameOffset(false);
                hinge->setLimit(scalar(*joint.least), scalar(*joint.least + 3), scalar(1),
                                scalar(1), scalar(scene_.restitution));
            }
            joints_.push_back(std::move(hinge));
        }
        world_.addConstraint(joints_.back().get(), true);
    }

    const Case& scene_;
    double h_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadPhase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadPhase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

Build with(int iterations) {
    return [iterations](const Case& scene, double h) {
        return std::make_unique<BulletWorld>(scene, h, iterations);
    };
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m(program, argc, argv);
    playAll(m, {{"10 rounds", usualSteps, with(10)}, {"200 rounds", usualSteps, with(200)}});
    return 0;
}
