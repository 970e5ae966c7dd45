// Simbody on the cases of contact and joints: joint coordinates, and compliant contact of balls
// and boxes with the floor, as stiff as its integrator bears. It has no contact of box with box.
#include "play.h"
#include "tree.h"

#include <Simbody.h>

#include <cmath>

namespace {

using namespace bench;
using namespace bench::contacts;
using SimTK::MobilizedBody;
using SimTK::Vec3;

Vec3 vector(const Place& p) { return Vec3(p[0], p[1], p[2]); }

SimTK::Transform poseOf(const Place& at, double angle) {
    return SimTK::Transform(SimTK::Rotation(angle, SimTK::ZAxis), vector(at));
}

struct Material {
    double stiffness, transition; // Pa, m/s
};

SimTK::ContactMaterial materialOf(const Material& material, double friction) {
    return SimTK::ContactMaterial(material.stiffness, 1, friction, friction, 0);
}

class SimbodyWorld : public bench::contacts::World {
public:
    SimbodyWorld(const Case& scene, double accuracy, const Material& material, bool stiff)
        : scene_(scene), surface_(materialOf(material, scene.friction)) {
        contact_.setTransitionVelocity(material.transition);
        const SimTK::Force::UniformGravity gravity(forces_, matter_, Vec3(0, -scene.gravity, 0));
        // A pair has the harmonic mean of the frictions.
        const double planes =
            scene.planeFriction > 0
                ? scene.planeFriction * scene.friction / (2 * scene.friction - scene.planeFriction)
                : 0;
        for (const Plane& plane : scene.planes) // a half space lies behind its own +x
            matter_.updGround().updBody().addContactSurface(
                SimTK::Transform(SimTK::Rotation(plane.slope - SimTK::Pi / 2, SimTK::ZAxis),
                                 Vec3(0)),
                SimTK::ContactSurface(SimTK::ContactGeometry::HalfSpace(),
                                      materialOf(material, planes)));
        for (std::size_t b = 0; b < scene.bodies.size(); ++b)
            add(b);
        for (const std::size_t loop : loopJoints(scene)) {
            const Joint& joint = scene.joints[loop];
            for (const Place& at : closingPoints(scene, joint)) {
                MobilizedBody other = matter_.updGround();
                if (joint.body2 >= 0)
                    other = bodies_[static_cast<std::size_t>(joint.body2)];
                const auto one = static_cast<std::size_t>(joint.body1);
                const SimTK::Constraint::Ball ball(
                    bodies_[one], inBody(one, at), other,
                    joint.body2 < 0 ? vector(at)
                                    : inBody(static_cast<std::size_t>(joint.body2), at));
            }
        }
        start();
        if (stiff)
            integrator_ = std::make_unique<SimTK::CPodesIntegrator>(system_, SimTK::CPodes::BDF);
        else
            integrator_ = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system_);
        integrator_->setAccuracy(accuracy);
        integrator_->setFinalTime(2 * scene.times.back());
        integrator_->initialize(state_);
    }
    void advance(double span) override {
        time_ += span;
        const int before = integrator_->getNumStepsTaken();
        while (integrator_->getTime() < time_)
            if (integrator_->stepTo(time_) == SimTK::Integrator::EndOfSimulation)
                break;
        count(integrator_->getNumStepsTaken() - before);
    }
    [[nodiscard]] Place centre(std::size_t body) const override {
        const SimTK::State& state = integrator_->getState();
        system_.realize(state, SimTK::Stage::Position);
        const Vec3 p = bodies_[body].getBodyOriginLocation(state);
        return {p[0], p[1], p[2]};
    }

private:
    [[nodiscard]] SimTK::Transform poseOfBody(std::size_t b) const {
        return poseOf(scene_.bodies[b].at, scene_.bodies[b].angle);
    }
    [[nodiscard]] Vec3 inBody(std::size_t b, const Place& place) const {
        return ~poseOfBody(b) * vector(place);
    }
    void add(std::size_t index) {
        const Body& body = scene_.bodies[index];
        const Place inertia = body.inertia();
        SimTK::Body::Rigid rigid(SimTK::MassProperties(
            body.mass, Vec3(0), SimTK::Inertia(inertia[0], inertia[1], inertia[2])));
        if (scene_.collide)
            for (const Place& at : body.balls())
                rigid.addContactSurface(
                    SimTK::Transform(vector(at)),
                    SimTK::ContactSurface(SimTK::ContactGeometry::Sphere(body.size[0]), surface_));
        // A chassis touches nothing; only a free box can.
        if (scene_.collide && body.shape == Body::Shape::box && scene_.joints.empty())
            rigid.addContactSurface(
                SimTK::Transform(),
                SimTK::ContactSurface(SimTK::ContactGeometry::Brick(vector(body.size) / 2),
                                      surface_));
        const auto found = treeJoint(scene_, index);
        if (!found) {
            bodies_.push_back(MobilizedBody::Free(matter_.Ground(), SimTK::Transform(), rigid,
                                                  SimTK::Transform()));
            return;
        }
        const Joint& joint = scene_.joints[*found];
        const bool slides = joint.type == Joint::Type::slider;
        // A slider slides along the x of its frame, a hinge turns about the z.
        const SimTK::CoordinateAxis own(slides ? 0 : 2);
        const SimTK::Transform at(SimTK::Rotation(SimTK::UnitVec3(vector(joint.axis)), own),
                                  vector(joint.at));
        const SimTK::Transform here = ~poseOfBody(index) * at;
        MobilizedBody parent = matter_.updGround();
        SimTK::Transform there = at;
        if (joint.body2 >= 0) {
            parent = bodies_[static_cast<std::size_t>(joint.body2)];
            there = ~poseOfBody(static_cast<std::size_t>(joint.body2)) * at;
        }
        if (slides)
            bodies_.push_back(MobilizedBody::Slider(parent, there, rigid, here));
        else
            bodies_.push_back(MobilizedBody::Pin(parent, there, rigid, here));
        if (joint.couple != 0)
            const SimTK::Force::MobilityConstantForce motor(forces_, bodies_.back(), 0,
                                                            joint.couple);
        if (joint.speed)
            const SimTK::Motion::Steady held(bodies_.back(), *joint.speed);
    }
    void start() {
        system_.realizeTopology();
        state_ = system_.getDefaultState();
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            if (treeJoint(scene_, b)) {
                bodies_[b].setOneU(state_, 0, treeRate(scene_, b));
                continue;
            }
            bodies_[b].setQToFitTransform(state_, poseOfBody(b));
            const Body& body = scene_.bodies[b];
            bodies_[b].setUToFitVelocity(
                state_, SimTK::SpatialVec(Vec3(0, 0, body.spin), vector(body.velocity)));
        }
    }

    const Case& scene_;
    SimTK::ContactMaterial surface_;
    SimTK::MultibodySystem system_;
    SimTK::SimbodyMatterSubsystem matter_{system_};
    SimTK::GeneralForceSubsystem forces_{system_};
    SimTK::ContactTrackerSubsystem tracker_{system_};
    SimTK::CompliantContactSubsystem contact_{system_, tracker_};
    std::vector<MobilizedBody> bodies_;
    SimTK::State state_;
    std::unique_ptr<SimTK::Integrator> integrator_;
    double time_ = 0;
};

Build with(const Material& material, bool stiff) {
    return [=](const Case& scene, double accuracy) -> std::unique_ptr<bench::contacts::World> {
        if (!scene.collide && material.stiffness > 1e7)
            return nullptr; // the same once more
        return std::make_unique<SimbodyWorld>(scene, accuracy, material, stiff);
    };
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("simbody", argc, argv);
    const std::vector<double> accuracies = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8};
    const Material soft{1e7, 1e-2}, hard{1e9, 1e-4};
    const std::vector<Feature> lacks{Feature::boxOnBox, Feature::rebound, Feature::stop,
                                     Feature::dryCouple};
    playAll(m, {{"RKMerson;1e7 Pa;1e-2 m/s", accuracies, with(soft, false), lacks},
                {"RKMerson;1e9 Pa;1e-4 m/s", accuracies, with(hard, false), lacks},
                {"CPodes-BDF;1e7 Pa;1e-2 m/s", accuracies, with(soft, true), lacks},
                {"CPodes-BDF;1e9 Pa;1e-4 m/s", accuracies, with(hard, true), lacks}});
    return 0;
}
