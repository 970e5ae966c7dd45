// Bullet, in single and in double precision (two programs of this file): point-to-point joints,
// bounces with restitution 1, settings that keep energy best.
#include "equations.h"
#include "gas.h"
#include "measurement.h"
#include "truth.h"

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace bench;

#ifdef BT_USE_DOUBLE_PRECISION
const char* const program = "bullet_double";
#else
const char* const program = "bullet";
#endif

btScalar scalar(double value) { return static_cast<btScalar>(value); }
btVector3 vector(double x, double y, double z) { return {scalar(x), scalar(y), scalar(z)}; }

class World {
public:
    World() {
        world_.setGravity(vector(0, 0, 0));
        btContactSolverInfo& info = world_.getSolverInfo();
        info.m_restitutionVelocityThreshold = 0;
        info.m_splitImpulse = 1;
        info.m_splitImpulsePenetrationThreshold = 0;
    }
    ~World() {
        for (const auto& joint : joints_)
            world_.removeConstraint(joint.get());
        for (const auto& body : bodies_)
            world_.removeRigidBody(body.get());
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    // Mass 0: fixed.
    btRigidBody& add(std::unique_ptr<btCollisionShape> shape, double mass, const btVector3& place) {
        btVector3 inertia(0, 0, 0);
        if (mass > 0)
            shape->calculateLocalInertia(scalar(mass), inertia);
        btRigidBody::btRigidBodyConstructionInfo info(scalar(mass), nullptr, shape.get(), inertia);
        info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), place);
        info.m_restitution = 1;
        info.m_friction = 0;
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        btRigidBody& body = *bodies_.back();
        body.setActivationState(DISABLE_DEACTIVATION);
        body.setContactProcessingThreshold(0);
        world_.addRigidBody(&body);
        shapes_.push_back(std::move(shape));
        return body;
    }
    btRigidBody& ball(double mass, double x, double y, double z, double radius) {
        return add(std::make_unique<btSphereShape>(scalar(radius)), mass, vector(x, y, z));
    }
    void plane(const btVector3& normal, double distance) {
        add(std::make_unique<btStaticPlaneShape>(normal, scalar(distance)), 0, vector(0, 0, 0));
    }
    void join(std::unique_ptr<btTypedConstraint> joint) {
        world_.addConstraint(joint.get(), true);
        joints_.push_back(std::move(joint));
    }
    void gravity(double g) {
        world_.setGravity(vector(0, g, 0));
        for (const auto& body : bodies_)
            body->setGravity(vector(0, g, 0));
    }
    void iterations(int count) { world_.getSolverInfo().m_numIterations = count; }
    void step(double h) { world_.stepSimulation(scalar(h), 0); }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadPhase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadPhase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

void pinnedRods(const Measurement& m) {
    const RodSamples right = s2bCentres();
    const auto box = [] { return std::make_unique<btBoxShape>(vector(5, 0.55, 0.55)); };
    for (const double h : m.sweep({0.005, 0.001, 0.00025})) {
        RodSamples samples;
        const Time time = m.timeOf([&] {
            samples.clear();
            World world;
            btRigidBody& a = world.add(box(), rods::mass, vector(-5, 0, 0));
            btRigidBody& b = world.add(box(), rods::mass, vector(-15, 0, 0));
            world.join(std::make_unique<btPoint2PointConstraint>(a, vector(5, 0, 0)));
            world.join(
                std::make_unique<btPoint2PointConstraint>(a, b, vector(-5, 0, 0), vector(5, 0, 0)));
            a.setIgnoreCollisionCheck(&b, true);
            world.gravity(-rods::gravity);
            world.iterations(50);
            double taken = 0;
            for (int i = 0; i < s2Samples; ++i) {
                taken += seconds([&] {
                    for (long s = 0; s < std::lround(0.5 / h); ++s)
                        world.step(h);
                });
                const btVector3 p = a.getCenterOfMassPosition(), q = b.getCenterOfMassPosition();
                samples.push_back({p.x(), p.y(), q.x(), q.y()});
            }
            return taken;
        });
        m.add({"S2b", "point2point", h, rodError(samples, right), time, ""});
    }
}

void gas(const Measurement& m) {
    const std::vector<GasStart> balls = gasOf(m.smoke() ? 3 : 8);
    Gas exact(balls, 8);
    exact.runTo(0.25);
    const auto right = exact.positions(0.25);
    for (const double h : m.sweep({1.0 / 60, 1.0 / 240, 0.001})) {
        std::vector<std::array<double, 3>> early;
        double energy = 0;
        const Time time = m.timeOf([&] {
            World world;
            std::vector<btRigidBody*> bodies;
            for (const GasStart& ball : balls) {
                const auto& p = ball.position;
                bodies.push_back(&world.ball(1, p[0], p[1], p[2], gasRadius));
                const auto& v = ball.velocity;
                bodies.back()->setLinearVelocity(vector(v[0], v[1], v[2]));
            }
            for (int a = 0; a < 3; ++a)
                for (const int side : {-1, 1}) {
                    btVector3 normal(0, 0, 0);
                    normal[a] = scalar(-side);
                    world.plane(normal, -1);
                }
            early.clear();
            double taken = seconds([&] {
                for (long i = 0; i < std::lround(0.25 / h); ++i)
                    world.step(h);
            });
            for (const btRigidBody* body : bodies) {
                const btVector3 p = body->getCenterOfMassPosition();
                early.push_back({p.x(), p.y(), p.z()});
            }
            taken += seconds([&] {
                for (long i = 0; i < std::lround((m.smoke() ? 0.1 : s4Span - 0.25) / h); ++i)
                    world.step(h);
            });
            energy = 0;
            for (const btRigidBody* body : bodies)
                energy += static_cast<double>(body->getLinearVelocity().length2()) / 2;
            return taken;
        });
        const char* name = "SI;restThr0;splitThr0;procThr0";
        m.add({"S4", name, h, medianDistance(early, right), time, ""});
        m.add({"S4 energy", name, h, std::abs(energy / exact.energy() - 1), time, ""});
    }
}

// A change of the heavy ball's velocity is a hit of the two, one of the sum of momenta the wall's.
long hitsOf(double heavyMass, double span, double h, double& taken) {
    World world;
    world.plane(vector(1, 0, 0), 0);
    btRigidBody& light = world.ball(1, 1.1, 0, 0, 0.1);
    btRigidBody& heavy = world.ball(heavyMass, 2.3, 0, 0, 0.1);
    heavy.setLinearVelocity(vector(-1, 0, 0));
    long hits = 0;
    double v = 0, u = -1;
    taken = seconds([&] {
        for (long i = 0; i < std::lround(span / h); ++i) {
            world.step(h);
            const double v2 = static_cast<double>(light.getLinearVelocity().x()),
                         u2 = static_cast<double>(heavy.getLinearVelocity().x());
            const double push = v2 - v + heavyMass * (u2 - u);
            const bool met = std::abs(u2 - u) * heavyMass > 1e-3;
            hits += met;
            hits += std::abs(push) > 1e-3 && std::abs(push) > 1e-6 * heavyMass * std::abs(u2 - u);
            v = v2;
            u = u2;
        }
    });
    return hits;
}

void billiard(const Measurement& m) {
    const double steps[] = {0.01, 0.01, 0.001, 1e-4, 1e-5};
    for (int n = 0; n <= (m.smoke() ? 0 : 4); ++n) {
        long hits = 0;
        const Time time = m.timeOf([&] {
            double taken = 0;
            hits = hitsOf(std::pow(100.0, n), s5Spans[n], steps[n], taken);
            return taken;
        });
        const double exact = std::floor(pi<double> * std::pow(10, n));
        m.add({"S5 n=" + std::to_string(n), "SI;restThr0;splitThr0;procThr0", steps[n],
               std::abs(static_cast<double>(hits) - exact), time, std::to_string(hits) + " hits"});
    }
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m(program, argc, argv);
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    if (m.wants("S2b"))
        pinnedRods(m);
    if (m.wants("S4"))
        gas(m);
    if (m.wants("S5"))
        billiard(m);
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
    return 0;
}
