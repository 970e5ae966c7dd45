// Siconos on the cases of contact and joints: the scheme of Moreau and Jean with theta = 1/2, exact
// laws of contact and friction in each step; Bullet finds the contacts.
#include "play.h"

#include <BulletR.hpp>
#include <EqualityConditionNSL.hpp>
#include <JointStopR.hpp>
#include <PivotJointR.hpp>
#include <PrismaticJointR.hpp>
#include <RigidBodyDS.hpp>
#include <SiconosBulletCollisionManager.hpp>
#include <SiconosContactor.hpp>
#include <SiconosKernel.hpp>
#include <SiconosShape.hpp>
#include <SolverOptions.h>

#include <cmath>
#include <iostream>

namespace {

using namespace bench;
using namespace bench::contacts;

SP::SiconosVector vector(const std::vector<double>& values) {
    return std::make_shared<SiconosVector>(values);
}
SP::SiconosVector placed(const Place& p) { return vector({p[0], p[1], p[2]}); }
SP::SiconosVector poseOf(const Place& at, double angle) {
    return vector({at[0], at[1], at[2], std::cos(angle / 2), 0, 0, std::sin(angle / 2)});
}

class SiconosWorld : public World {
public:
    SiconosWorld(const Case& scene, double h, double tolerance) : scene_(scene) {
        const double piece = scene.times.back() / piecesOfRun; // all steps are equal
        h_ = piece / static_cast<double>(stepsIn(piece, h));
        system_ = std::make_shared<NonSmoothDynamicalSystem>(0, 10 * scene.times.back());
        const auto scheme = std::make_shared<MoreauJeanOSI>(0.5);
        const auto grid = std::make_shared<TimeDiscretisation>(0, h_);
        simulation_ = std::make_shared<TimeStepping>(system_, grid);
        simulation_->insertIntegrator(scheme);
        simulation_->insertNonSmoothProblem(problem(tolerance));
        for (const Body& body : scene.bodies)
            add(body);
        for (const Joint& joint : scene.joints)
            join(joint);
        if (scene.collide)
            findContacts();
    }
    void advance(double span) override {
        const long steps = std::lround(span / h_);
        for (long i = 0; i < steps; ++i) {
            simulation_->computeOneStep();
            simulation_->nextStep();
        }
        count(steps);
    }
    [[nodiscard]] Place centre(std::size_t body) const override {
        const SiconosVector& q = *bodies_[body]->q();
        return {q(0), q(1), q(2)};
    }

private:
    [[nodiscard]] SP::OneStepNSProblem problem(double tolerance) const {
        if (!scene_.joints.empty()) {
            const auto all =
                std::make_shared<GenericMechanical>(SICONOS_FRICTION_3D_ONECONTACT_NSN);
            all->numericsSolverOptions()->dparam[SICONOS_DPARAM_TOL] = tolerance;
            all->numericsSolverOptions()->iparam[SICONOS_IPARAM_MAX_ITER] = 10000;
            return all;
        }
        const auto contacts = std::make_shared<FrictionContact>(3, SICONOS_FRICTION_3D_NSGS);
        contacts->numericsSolverOptions()->dparam[SICONOS_DPARAM_TOL] = tolerance;
        contacts->numericsSolverOptions()->iparam[SICONOS_IPARAM_MAX_ITER] = 1000;
        contacts->setMaxSize(10000);
        contacts->setMStorageType(NM_SPARSE_BLOCK);
        contacts->setNumericsVerboseMode(false);
        contacts->setKeepLambdaAndYState(true);
        return contacts;
    }
    void add(const Body& body) {
        const Place inertia = body.inertia();
        const auto matrix = std::make_shared<SimpleMatrix>(3, 3);
        for (unsigned a = 0; a < 3; ++a)
            (*matrix)(a, a) = inertia[a];
        const auto added = std::make_shared<RigidBodyDS>(
            poseOf(body.at, body.angle),
            vector({body.velocity[0], body.velocity[1], body.velocity[2], 0, 0, body.spin}),
            body.mass, matrix);
        added->setUseContactorInertia(false);
        added->setAllowSelfCollide(false);
        added->setFExtPtr(vector({0, -body.mass * scene_.gravity, 0}));
        const auto contactors = std::make_shared<SiconosContactorSet>();
        for (const Place& at : body.balls())
            contactors->append(std::make_shared<SiconosContactor>(
                still(std::make_shared<SiconosSphere>(body.size[0])), poseOf(at, 0)));
        if (body.shape == Body::Shape::box)
            contactors->append(std::make_shared<SiconosContactor>(
                still(std::make_shared<SiconosBox>(body.size[0], body.size[1], body.size[2]))));
        if (scene_.collide)
            added->setContactors(contactors);
        system_->insertDynamicalSystem(added);
        bodies_.push_back(added);
    }
    // A shape without the margins that would hold bodies apart.
    static SP::SiconosShape still(const SP::SiconosShape& shape) {
        shape->setOutsideMargin(0);
        shape->setInsideMargin(0);
        return shape;
    }
    void join(const Joint& joint) {
        const SP::NewtonEulerDS one = bodies_[static_cast<std::size_t>(joint.body1)];
        SP::NewtonEulerDS other;
        if (joint.body2 >= 0)
            other = bodies_[static_cast<std::size_t>(joint.body2)];
        std::shared_ptr<NewtonEulerJointR> relation;
        if (joint.type == Joint::Type::slider)
            relation = std::make_shared<PrismaticJointR>(placed(joint.axis), true, one, other);
        else
            relation = std::make_shared<PivotJointR>(placed(joint.at), placed(joint.axis), true,
                                                     one, other);
        const auto link = [&](const SP::NonSmoothLaw& law, const std::shared_ptr<NewtonEulerR>& r) {
            system_->link(std::make_shared<Interaction>(law, r), one, other);
        };
        link(std::make_shared<EqualityConditionNSL>(relation->numberOfConstraints()), relation);
        if (joint.least) // its angle is that of the second body against the first
            link(std::make_shared<NewtonImpactNSL>(scene_.restitution),
                 std::make_shared<JointStopR>(relation, -*joint.least, true));
        if (joint.speed) { // the crank hangs on the world: its own spin is that of the joint
            const auto which = std::make_shared<std::vector<unsigned>>(1, 5U); // about z
            one->setBoundaryConditions(std::make_shared<BoundaryCondition>(
                which, vector(std::vector<double>{*joint.speed})));
        }
        if (joint.couple == 0)
            return;
        one->setMExtPtr(vector({0, 0, joint.couple}));
        if (other)
            other->setMExtPtr(vector({0, 0, -joint.couple}));
    }
    void findContacts() {
        SiconosBulletOptions options;
        options.contactBreakingThreshold = 0.02;
        options.worldScale = 1;
        const auto manager = std::make_shared<SiconosBulletCollisionManager>(options);
        const auto law = [&](double friction) {
            return std::make_shared<NewtonImpactFrictionNSL>(scene_.restitution, 0, friction, 3);
        };
        manager->insertNonSmoothLaw(law(scene_.friction), ofBodies, ofBodies);
        manager->insertNonSmoothLaw(law(scene_.planeFriction), ofBodies, ofPlanes);
        constexpr double depth = 2;
        for (const Plane& plane : scene_.planes) {
            const auto contactors = std::make_shared<SiconosContactorSet>();
            contactors->append(std::make_shared<SiconosContactor>(
                still(std::make_shared<SiconosBox>(60, depth, 20)), SP::SiconosVector(), ofPlanes));
            manager->insertStaticContactorSet(
                contactors,
                poseOf({depth / 2 * std::sin(plane.slope), -depth / 2 * std::cos(plane.slope), 0},
                       plane.slope));
        }
        simulation_->insertInteractionManager(manager);
    }

    static constexpr int ofBodies = 0, ofPlanes = 1; // groups of contactors

    const Case& scene_;
    double h_ = 0;
    std::shared_ptr<NonSmoothDynamicalSystem> system_;
    std::shared_ptr<TimeStepping> simulation_;
    std::vector<std::shared_ptr<RigidBodyDS>> bodies_;
};

Build with(double tolerance) {
    return [tolerance](const Case& scene, double h) {
        return std::make_unique<SiconosWorld>(scene, h, tolerance);
    };
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("siconos", argc, argv);
    std::cout.setstate(std::ios::failbit); // its warnings; rows do not go this way
    const std::vector<Feature> lacks{Feature::dryCouple};
    playAll(m, {{"Moreau-Jean;1e-4", usualSteps, with(1e-4), lacks},
                {"Moreau-Jean;1e-10", usualSteps, with(1e-10), lacks}});
    return 0;
}
