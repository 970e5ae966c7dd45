// ODE: ball joints as springs with its error reduction and softness, bounces with restitution 1.
#include "equations.h"
#include "gas.h"
#include "measurement.h"
#include "truth.h"

#include <ode/ode.h>

#include <cmath>
#include <functional>
#include <string>

namespace {

using namespace bench;

struct World {
    dWorldID world = dWorldCreate();
    dSpaceID space;
    dJointGroupID contacts = dJointGroupCreate(0);
    bool fast; // QuickStep instead of the exact solver
    bool hard; // contacts correct no depth
    long hits = 0;

    World(const dSpaceID s, bool isFast, bool isHard) : space(s), fast(isFast), hard(isHard) {
        dWorldSetContactSurfaceLayer(world, 0);
    }
    ~World() {
        dJointGroupDestroy(contacts);
        dSpaceDestroy(space);
        dWorldDestroy(world);
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    void step(double h) {
        dSpaceCollide(space, this, meet);
        if (fast)
            dWorldQuickStep(world, h);
        else
            dWorldStep(world, h);
        dJointGroupEmpty(contacts);
    }
    static void meet(void* data, dGeomID a, dGeomID b) {
        World& self = *static_cast<World*>(data);
        dContact contact{};
        if (dCollide(a, b, 1, &contact.geom, sizeof contact) == 0)
            return;
        ++self.hits;
        contact.surface.mode = dContactBounce;
        contact.surface.bounce = 1;
        contact.surface.bounce_vel = 0;
        if (self.hard) {
            contact.surface.mode |= dContactSoftERP | dContactSoftCFM;
            contact.surface.soft_erp = 0;
            contact.surface.soft_cfm = 0;
        }
        dJointAttach(dJointCreateContact(self.world, self.contacts, &contact), dGeomGetBody(a),
                     dGeomGetBody(b));
    }
    dBodyID ball(double radius, double mass, double x, double y, double z) {
        const dBodyID body = dBodyCreate(world);
        dMass inertia;
        dMassSetSphereTotal(&inertia, mass, radius);
        dBodySetMass(body, &inertia);
        dBodySetPosition(body, x, y, z);
        dGeomSetBody(dCreateSphere(space, radius), body);
        return body;
    }
};

void freeBody(const Measurement& m) {
    for (const double h : m.sweep({0.01, 0.001})) {
        std::array<double, 4> q{};
        const Time time = m.timeOf([&] {
            const World world(dSimpleSpaceCreate(nullptr), false, true);
            const dBodyID body = dBodyCreate(world.world);
            dMass inertia;
            dMassSetParameters(&inertia, 1, 0, 0, 0, 1, 2, 3, 0, 0, 0);
            dBodySetMass(body, &inertia);
            dBodySetGyroscopicMode(body, 1);
            dBodySetAngularVel(body, 0.01, 1, 0);
            const double taken = seconds([&] {
                for (long i = 0; i < std::lround(s1Span / h); ++i)
                    dWorldStep(world.world, h);
            });
            std::copy_n(dBodyGetQuaternion(body), 4, q.begin());
            return taken;
        });
        m.add({"S1", "dWorldStep;gyroscopic", h, s1Error(q), time, ""});
    }
}

dBodyID rod(dWorldID world, double x) {
    const dBodyID body = dBodyCreate(world);
    dMass inertia;
    dMassSetBoxTotal(&inertia, rods::mass, 10, 1.1, 1.1);
    dBodySetMass(body, &inertia);
    dBodySetPosition(body, x, 0, 0);
    return body;
}

void linkedRods(const Measurement& m, bool soft) {
    const RodSamples right = soft ? s2aCentres() : s2bCentres();
    for (const double h : m.sweep({0.01, 0.005, 0.001, 0.00025, 0.0001})) {
        RodSamples samples;
        const Time time = m.timeOf([&] {
            samples.clear();
            const World world(dSimpleSpaceCreate(nullptr), false, true);
            dWorldSetGravity(world.world, 0, -rods::gravity, 0);
            const dBodyID a = rod(world.world, -5), b = rod(world.world, -15);
            const dJointID first = dJointCreateBall(world.world, nullptr),
                           second = dJointCreateBall(world.world, nullptr);
            dJointAttach(first, a, nullptr);
            dJointSetBallAnchor(first, 0, 0, 0);
            dJointAttach(second, a, b);
            dJointSetBallAnchor(second, -10, 0, 0);
            if (soft) {
                const double k = rods::tightness, c = 2 * std::sqrt(k * rods::mass);
                for (const dJointID joint : {first, second}) {
                    dJointSetBallParam(joint, dParamERP, h * k / (h * k + c));
                    dJointSetBallParam(joint, dParamCFM, 1 / (h * k + c));
                }
            }
            double taken = 0;
            for (int i = 0; i < s2Samples; ++i) {
                taken += seconds([&] {
                    for (long s = 0; s < std::lround(0.5 / h); ++s)
                        dWorldStep(world.world, h);
                });
                const dReal *p = dBodyGetPosition(a), *q = dBodyGetPosition(b);
                samples.push_back({p[0], p[1], q[0], q[1]});
            }
            return taken;
        });
        m.add({soft ? "S2a" : "S2b", soft ? "ball ERP/CFM=k;c" : "ball;dWorldStep", h,
               rodError(samples, right), time, ""});
    }
}

void gas(const Measurement& m) {
    const std::vector<GasStart> balls = gasOf(m.smoke() ? 3 : 8);
    Gas exact(balls, 8);
    exact.runTo(0.25);
    const auto right = exact.positions(0.25);
    for (const bool hard : {false, true})
        for (const double h : m.sweep({1.0 / 60, 1.0 / 240, 0.001, 0.00025})) {
            std::vector<std::array<double, 3>> early;
            double energy = 0;
            const Time time = m.timeOf([&] {
                World world(dHashSpaceCreate(nullptr), true, hard);
                dHashSpaceSetLevels(world.space, -4, 2);
                std::vector<dBodyID> bodies;
                for (const GasStart& ball : balls) {
                    bodies.push_back(world.ball(gasRadius, 1, ball.position[0], ball.position[1],
                                                ball.position[2]));
                    dBodySetLinearVel(bodies.back(), ball.velocity[0], ball.velocity[1],
                                      ball.velocity[2]);
                }
                for (int a = 0; a < 3; ++a)
                    for (const int side : {-1, 1})
                        dCreatePlane(world.space, a == 0 ? -side : 0, a == 1 ? -side : 0,
                                     a == 2 ? -side : 0, -1);
                early.clear();
                double taken = seconds([&] {
                    for (long i = 0; i < std::lround(0.25 / h); ++i)
                        world.step(h);
                });
                for (const dBodyID body : bodies) {
                    const dReal* p = dBodyGetPosition(body);
                    early.push_back({p[0], p[1], p[2]});
                }
                const double rest = m.smoke() ? 0.1 : s4Span - 0.25;
                taken += seconds([&] {
                    for (long i = 0; i < std::lround(rest / h); ++i)
                        world.step(h);
                });
                energy = 0;
                for (const dBodyID body : bodies)
                    for (int a = 0; a < 3; ++a)
                        energy += dBodyGetLinearVel(body)[a] * dBodyGetLinearVel(body)[a] / 2;
                return taken;
            });
            const char* name = hard ? "QuickStep;bounce1;soft_erp0;cfm0" : "QuickStep;bounce1";
            m.add({"S4", name, h, medianDistance(early, right), time, ""});
            m.add({"S4 energy", name, h, std::abs(energy / exact.energy() - 1), time, ""});
        }
}

void billiard(const Measurement& m) {
    const double steps[] = {0.01, 0.01, 0.001, 1e-4, 1e-5};
    for (int n = 0; n <= (m.smoke() ? 0 : 4); ++n) {
        long hits = 0;
        const Time time = m.timeOf([&] {
            World world(dSimpleSpaceCreate(nullptr), false, true);
            dCreatePlane(world.space, 1, 0, 0, 0);
            world.ball(0.1, 1, 1.1, 0, 0);
            const dBodyID heavy = world.ball(0.1, std::pow(100.0, n), 2.3, 0, 0);
            dBodySetLinearVel(heavy, -1, 0, 0);
            const double taken = seconds([&] {
                for (long i = 0; i < std::lround(s5Spans[n] / steps[n]); ++i)
                    world.step(steps[n]);
            });
            hits = world.hits;
            return taken;
        });
        const double exact = std::floor(pi<double> * std::pow(10, n));
        m.add({"S5 n=" + std::to_string(n), "dWorldStep;bounce1;soft_erp0;cfm0", steps[n],
               std::abs(static_cast<double>(hits) - exact), time,
               std::to_string(hits) + " contacts"});
    }
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("ode", argc, argv);
    dInitODE2(0);
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    if (m.wants("S1"))
        freeBody(m);
    if (m.wants("S2a"))
        linkedRods(m, true);
    if (m.wants("S2b"))
        linkedRods(m, false);
    if (m.wants("S4"))
        gas(m);
    if (m.wants("S5"))
        billiard(m);
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
    dCloseODE();
    return 0;
}
