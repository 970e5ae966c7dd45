// Simbody: its adaptive integrators; free bodies with link forces, or pins in reduced coordinates.
#include "equations.h"
#include "measurement.h"
#include "truth.h"

#include <Simbody.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

namespace {

using namespace bench;
using SimTK::Vec3;

struct Model {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    std::vector<SimTK::MobilizedBody> bodies;
};

enum class Method { merson, fehlberg, rk3, bdf };
const char* nameOf(Method method) {
    switch (method) {
    case Method::merson:
        return "RKMerson";
    case Method::fehlberg:
        return "RKFehlberg";
    case Method::rk3:
        return "RK3";
    case Method::bdf:
        break;
    }
    return "CPodes-BDF";
}

std::unique_ptr<SimTK::Integrator> integratorOf(Method method, const SimTK::System& system) {
    switch (method) {
    case Method::merson:
        return std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
    case Method::fehlberg:
        return std::make_unique<SimTK::RungeKuttaFeldbergIntegrator>(system);
    case Method::rk3:
        return std::make_unique<SimTK::RungeKutta3Integrator>(system);
    case Method::bdf:
        break;
    }
    return std::make_unique<SimTK::CPodesIntegrator>(system, SimTK::CPodes::BDF);
}

// The time of stepping alone; infinite when it failed.
double visit(const Model& model, const SimTK::State& start, Method method, double accuracy,
             const std::vector<double>& times, const std::function<void(const SimTK::State&)>& at) {
    const auto integrator = integratorOf(method, model.system);
    integrator->setAccuracy(accuracy);
    integrator->setFinalTime(times.back());
    integrator->initialize(start);
    double taken = 0;
    try {
        for (const double time : times) {
            taken += seconds([&] {
                while (integrator->getTime() < time)
                    if (integrator->stepTo(time) == SimTK::Integrator::EndOfSimulation)
                        break;
            });
            at(integrator->getState());
        }
    } catch (const std::exception&) {
        return std::numeric_limits<double>::infinity();
    }
    return taken;
}

void sweep(const Measurement& m, const std::string& scene, const Model& model,
           const SimTK::State& start, const std::vector<Method>& methods,
           const std::vector<double>& accuracies, const std::vector<double>& times,
           const std::function<void(const SimTK::State&)>& at,
           const std::function<double()>& takeError) {
    for (const Method method : methods)
        for (const double accuracy : m.sweep(accuracies)) {
            double error = 0;
            const Time time = m.timeOf([&] {
                const double taken = visit(model, start, method, accuracy, times, at);
                error = takeError();
                return taken;
            });
            m.add({scene, nameOf(method), accuracy, error, time, ""});
        }
}

void freeBody(const Measurement& m) {
    Model model;
    const SimTK::Body::Rigid body(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(1, 2, 3)));
    SimTK::MobilizedBody::Free one(model.matter.Ground(), SimTK::Transform(), body,
                                   SimTK::Transform());
    model.system.realizeTopology();
    SimTK::State start = model.system.getDefaultState();
    one.setUToFitAngularVelocity(start, Vec3(0.01, 1, 0));
    std::array<double, 4> q{};
    sweep(
        m, "S1", model, start, {Method::merson, Method::fehlberg, Method::rk3},
        {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}, {s1Span},
        [&](const SimTK::State& state) {
            model.system.realize(state, SimTK::Stage::Position);
            const SimTK::Quaternion r = one.getBodyRotation(state).convertRotationToQuaternion();
            q = {r[0], r[1], r[2], r[3]};
        },
        [&] { return s1Error(q); });
}

SimTK::Body::Rigid rodBody() {
    const double around = rods::mass / 12 * 2 * 1.1 * 1.1;
    return SimTK::Body::Rigid(SimTK::MassProperties(
        rods::mass, Vec3(0), SimTK::Inertia(around, rods::inertia, rods::inertia)));
}

std::vector<double> rodTimes() {
    std::vector<double> times;
    for (int i = 1; i <= s2Samples; ++i)
        times.push_back(0.5 * i);
    return times;
}

void sweepRods(const Measurement& m, const std::string& scene, const Model& model,
               const SimTK::State& start, const RodSamples& right) {
    RodSamples samples;
    sweep(
        m, scene, model, start, {Method::merson, Method::fehlberg, Method::bdf},
        {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}, rodTimes(),
        [&](const SimTK::State& state) {
            model.system.realize(state, SimTK::Stage::Position);
            const Vec3 a = model.bodies[0].getBodyOriginLocation(state),
                       b = model.bodies[1].getBodyOriginLocation(state);
            samples.push_back({a[0], a[1], b[0], b[1]});
        },
        [&] { return rodError(std::exchange(samples, {}), right); });
}

// F = -k d - c v at the ends; Simbody's own bushings act along axes, its springs along lines.
class Links : public SimTK::Force::Custom::Implementation {
public:
    Links(SimTK::MobilizedBody a, SimTK::MobilizedBody b) : a_(std::move(a)), b_(std::move(b)) {}

    void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& bodyForces,
                   SimTK::Vector_<Vec3>&, SimTK::Vector&) const override {
        const Vec3 right(rods::half, 0, 0), left(-rods::half, 0, 0);
        const double c = 2 * std::sqrt(rods::tightness * rods::mass);
        const Vec3 first = -rods::tightness * a_.findStationLocationInGround(state, right) -
                           c * a_.findStationVelocityInGround(state, right);
        const Vec3 second = -rods::tightness * (a_.findStationLocationInGround(state, left) -
                                                b_.findStationLocationInGround(state, right)) -
                            c * (a_.findStationVelocityInGround(state, left) -
                                 b_.findStationVelocityInGround(state, right));
        a_.applyForceToBodyPoint(state, right, first, bodyForces);
        a_.applyForceToBodyPoint(state, left, second, bodyForces);
        b_.applyForceToBodyPoint(state, right, -second, bodyForces);
    }
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

private:
    SimTK::MobilizedBody a_, b_;
};

void softRods(const Measurement& m) {
    Model model;
    const SimTK::Force::UniformGravity gravity(model.forces, model.matter,
                                               Vec3(0, -rods::gravity, 0));
    for (int i = 0; i < 2; ++i)
        model.bodies.push_back(SimTK::MobilizedBody::Free(model.matter.Ground(), SimTK::Transform(),
                                                          rodBody(), SimTK::Transform()));
    const SimTK::Force::Custom links(model.forces, new Links(model.bodies[0], model.bodies[1]));
    model.system.realizeTopology();
    SimTK::State start = model.system.getDefaultState();
    model.bodies[0].setQToFitTransform(start, SimTK::Transform(Vec3(-5, 0, 0)));
    model.bodies[1].setQToFitTransform(start, SimTK::Transform(Vec3(-15, 0, 0)));
    sweepRods(m, "S2a", model, start, s2aCentres());
}

void pinnedRods(const Measurement& m) {
    Model model;
    const SimTK::Force::UniformGravity gravity(model.forces, model.matter,
                                               Vec3(0, -rods::gravity, 0));
    SimTK::MobilizedBody::Pin first(model.matter.Ground(), SimTK::Transform(), rodBody(),
                                    SimTK::Transform(Vec3(rods::half, 0, 0)));
    SimTK::MobilizedBody::Pin second(first, SimTK::Transform(Vec3(-rods::half, 0, 0)), rodBody(),
                                     SimTK::Transform(Vec3(rods::half, 0, 0)));
    model.bodies = {first, second};
    model.system.realizeTopology();
    const SimTK::State start = model.system.getDefaultState();
    sweepRods(m, "S2b", model, start, s2bCentres());
}

class FastGravity : public SimTK::Force::Custom::Implementation {
public:
    FastGravity(SimTK::MobilizedBody body, double more) : body_(std::move(body)), more_(more) {}
    void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& bodyForces,
                   SimTK::Vector_<Vec3>&, SimTK::Vector&) const override {
        body_.applyForceToBodyPoint(state, Vec3(0), Vec3(0, -more_, 0), bodyForces);
    }
    SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

private:
    SimTK::MobilizedBody body_;
    double more_;
};

void pendulums(const Measurement& m, int count, double ratio) {
    Model model;
    const SimTK::Force::UniformGravity gravity(model.forces, model.matter, Vec3(0, -10, 0));
    const SimTK::Body::Rigid point(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(1e-9)));
    for (int p = 0; p < count; ++p)
        model.bodies.push_back(SimTK::MobilizedBody::Pin(model.matter.Ground(), SimTK::Transform(),
                                                         point, SimTK::Transform(Vec3(0, 1, 0))));
    const SimTK::Force::Custom more(model.forces,
                                    new FastGravity(model.bodies[0], gravityOf(0, ratio) - 10));
    model.system.realizeTopology();
    SimTK::State start = model.system.getDefaultState();
    for (int p = 0; p < count; ++p)
        model.bodies[static_cast<std::size_t>(p)].setOneQ(start, 0, amplitudeOf(p, count));
    const std::vector<double> right = s3Angles(count, ratio);
    double error = 0;
    std::size_t sample = 0;
    std::vector<double> times;
    for (int i = 1; i <= s3Samples; ++i)
        times.push_back(i);
    sweep(
        m, "S3 N=" + std::to_string(count) + " ratio " + std::to_string(static_cast<int>(ratio)),
        model, start, {Method::merson, Method::fehlberg}, {1e-4, 1e-5, 1e-6}, times,
        [&](const SimTK::State& state) {
            for (std::size_t p = 0; p < model.bodies.size(); ++p)
                error = std::max(error, std::abs(model.bodies[p].getOneQ(state, 0) -
                                                 right[p * s3Samples + sample]));
            ++sample;
        },
        [&] {
            sample = 0;
            return std::exchange(error, 0);
        });
}

void linkedMass(const Measurement& m) {
    for (const double tightness : {1e2, 1e6, 1e12}) {
        char name[20];
        std::snprintf(name, sizeof name, "S6 k=%.0e", tightness);
        Model model;
        SimTK::MobilizedBody::Slider mass(
            model.matter.Ground(), SimTK::Transform(),
            SimTK::Body::Rigid(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(1))),
            SimTK::Transform());
        const SimTK::Force::MobilityLinearSpring spring(model.forces, mass, 0, tightness, 0);
        const SimTK::Force::MobilityLinearDamper damper(model.forces, mass, 0,
                                                        2 * std::sqrt(tightness));
        model.system.realizeTopology();
        SimTK::State start = model.system.getDefaultState();
        mass.setOneQ(start, 0, 1);
        std::vector<double> places;
        sweep(
            m, name, model, start,
            tightness > 1e6 ? std::vector{Method::bdf} : std::vector{Method::bdf, Method::merson},
            {1e-6, 1e-7, 1e-8}, s6Times(tightness),
            [&](const SimTK::State& state) { places.push_back(mass.getOneQ(state, 0)); },
            [&] { return worstDifference(std::exchange(places, {}), s6Places(tightness)); });
    }
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("simbody", argc, argv);
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    if (m.wants("S1"))
        freeBody(m);
    if (m.wants("S2a"))
        softRods(m);
    if (m.wants("S2b"))
        pinnedRods(m);
    if (m.wants("S3"))
        for (const int count : {10, 100})
            for (const double ratio : {1.0, 10.0})
                if (!m.smoke() || (count == 10 && ratio == 1))
                    pendulums(m, count, ratio);
    if (m.wants("S6"))
        linkedMass(m);
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
    return 0;
}
