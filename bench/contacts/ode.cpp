// ODE on the cases of contact and joints: both of its solvers.
#include "play.h"

#include <ode/ode.h>

#include <cmath>
#include <cstdarg>

namespace {

using namespace bench;
using namespace bench::contacts;

class OdeWorld : public World {
public:
    OdeWorld(const Case& scene, double h, bool fast) : scene_(scene), h_(h), fast_(fast) {
        dWorldSetGravity(world_, 0, -scene.gravity, 0);
        dWorldSetQuickStepNumIterations(world_, 50);
        for (const Plane& plane : scene.planes)
            dCreatePlane(space_, -std::sin(plane.slope), std::cos(plane.slope), 0, 0);
        for (const Body& body : scene.bodies)
            add(body);
        for (const Joint& joint : scene.joints)
            join(joint);
    }
    ~OdeWorld() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    OdeWorld(const OdeWorld&) = delete;
    OdeWorld& operator=(const OdeWorld&) = delete;

    void advance(double span) override {
        const long steps = stepsIn(span, h_);
        for (long i = 0; i < steps; ++i) {
            if (scene_.collide)
                dSpaceCollide(space_, this, meet);
            for (const auto& [id, joint] : driven_)
                dJointAddHingeTorque(id,
                                     joint->couple + springCouple(*joint, dJointGetHingeAngle(id)));
            if (fast_)
                dWorldQuickStep(world_, span / static_cast<double>(steps));
            else
                dWorldStep(world_, span / static_cast<double>(steps));
            dJointGroupEmpty(contacts_);
        }
        count(steps);
    }
    [[nodiscard]] Place centre(std::size_t body) const override {
        const dReal* p = dBodyGetPosition(bodies_[body]);
        return {p[0], p[1], p[2]};
    }

private:
    static void meet(void* data, dGeomID a, dGeomID b) {
        OdeWorld& self = *static_cast<OdeWorld*>(data);
        const dBodyID bodyA = dGeomGetBody(a), bodyB = dGeomGetBody(b);
        if (bodyA && bodyB && dAreConnectedExcluding(bodyA, bodyB, dJointTypeContact))
            return;
        dContact contacts[8] = {};
        const int found = dCollide(a, b, 8, &contacts[0].geom, sizeof contacts[0]);
        for (int i = 0; i < found; ++i) {
            contacts[i].surface.mode = dContactApprox1;
            contacts[i].surface.mu =
                bodyA && bodyB ? self.scene_.friction : self.scene_.planeFriction;
            if (self.scene_.restitution > 0) {
                contacts[i].surface.mode |= dContactBounce;
                contacts[i].surface.bounce = self.scene_.restitution;
            }
            dJointAttach(dJointCreateContact(self.world_, self.contacts_, &contacts[i]), bodyA,
                         bodyB);
        }
    }
    void add(const Body& body) {
        const dBodyID id = dBodyCreate(world_);
        dMass mass;
        const Place inertia = body.inertia();
        dMassSetParameters(&mass, body.mass, 0, 0, 0, inertia[0], inertia[1], inertia[2], 0, 0, 0);
        dBodySetMass(id, &mass);
        dBodySetPosition(id, body.at[0], body.at[1], body.at[2]);
        const dQuaternion turn = {std::cos(body.angle / 2), 0, 0, std::sin(body.angle / 2)};
        dBodySetQuaternion(id, turn);
        dBodySetLinearVel(id, body.velocity[0], body.velocity[1], body.velocity[2]);
        dBodySetAngularVel(id, 0, 0, body.spin);
        bodies_.push_back(id);
        if (!scene_.collide)
            return;
        if (body.shape == Body::Shape::box)
            dGeomSetBody(dCreateBox(space_, body.size[0], body.size[1], body.size[2]), id);
        for (const Place& at : body.balls()) {
            const dGeomID ball = dCreateSphere(space_, body.size[0]);
            dGeomSetBody(ball, id);
            dGeomSetOffsetPosition(ball, at[0], at[1], at[2]);
        }
    }
    void join(const Joint& joint) {
        const bool slides = joint.type == Joint::Type::slider;
        const dJointID id =
            slides ? dJointCreateSlider(world_, nullptr) : dJointCreateHinge(world_, nullptr);
        dJointAttach(id, bodies_[static_cast<std::size_t>(joint.body1)],
                     joint.body2 < 0 ? nullptr : bodies_[static_cast<std::size_t>(joint.body2)]);
        const auto [x, y, z] = joint.axis;
        if (slides) {
            dJointSetSliderAxis(id, x, y, z);
            return;
        }
        dJointSetHingeAnchor(id, joint.at[0], joint.at[1], joint.at[2]);
        dJointSetHingeAxis(id, x, y, z);
        if (joint.couple != 0 || joint.stiffness != 0)
            driven_.emplace_back(id, &joint);
        if (joint.speed || joint.dryCouple > 0) {
            dJointSetHingeParam(id, dParamVel, joint.speed.value_or(0));
            dJointSetHingeParam(id, dParamFMax, joint.speed ? dInfinity : joint.dryCouple);
        }
        if (joint.least) {
            dJointSetHingeParam(id, dParamLoStop, *joint.least);
            dJointSetHingeParam(id, dParamBounce, scene_.restitution);
        }
    }

    const Case& scene_;
    double h_;
    bool fast_; // QuickStep instead of the exact solver
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    dJointGroupID contacts_ = dJointGroupCreate(0);
    std::vector<dBodyID> bodies_;
    std::vector<std::pair<dJointID, const Joint*>> driven_; // by couples of our own
};

Build with(bool fast) {
    return [fast](const Case& scene, double h) -> std::unique_ptr<World> {
        // The exact solver keeps its dense matrix on the stack.
        if (!fast && scene.bodies.size() > 50)
            return nullptr;
        return std::make_unique<OdeWorld>(scene, h, fast);
    };
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("ode", argc, argv);
    dInitODE2(0);
    dSetMessageHandler([](int, const char*, va_list) {}); // of its solver, at every step
    playAll(m, {{"dWorldStep", usualSteps, with(false)}, {"QuickStep 50", usualSteps, with(true)}});
    dCloseODE();
    return 0;
}
