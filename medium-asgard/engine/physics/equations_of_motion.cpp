#include "physics/equations_of_motion.h"

#include "physics/body_phases.h"
#include "physics/contact_readings.h"
#include "physics/forces.h"
#include "physics/joints.h"
#include "physics/ropes.h"

#include <algorithm>
#include <limits>
#include <set>

namespace physics {
namespace {

// --- Euler's equations ----------------------------------------------------------------------

// -w x I w as a quadratic form for each component, multiplied by the inverse of I: numbers, so that
// what cancels (equal moments) leaves no term at all.
NodeVector gyroscopicRate(Graph& g, const Matrix& inertia, const Matrix& inverse,
                          const NodeVector& w) {
    NodeVector rate = constant(g, Vector::Zero());
    const auto momentum = [&](int i, int j) { // the part of (w x I w) along i, of w_i' I_.j w_j
        Matrix part = Matrix::Zero();
        for (int d = 0; d < 3; ++d)
            part(i, d) = inertia(j, d);
        return part;
    };
    std::array<Matrix, 3> forms; // (w x I w)_a = w' forms[a] w
    for (int a = 0; a < 3; ++a)
        forms[static_cast<std::size_t>(a)] =
            momentum((a + 1) % 3, (a + 2) % 3) - momentum((a + 2) % 3, (a + 1) % 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const int row = static_cast<int>(i);
        const Matrix form =
            -(inverse(row, 0) * forms[0] + inverse(row, 1) * forms[1] + inverse(row, 2) * forms[2]);
        for (std::size_t b = 0; b < 3; ++b)
            for (std::size_t d = b; d < 3; ++d) {
                const int p = static_cast<int>(b), q = static_cast<int>(d);
                const double factor = b == d ? form(p, p) : form(p, q) + form(q, p);
                rate[i] = g.add(rate[i], g.multiply(g.constant(factor), g.multiply(w[b], w[d])));
            }
    }
    return rate;
}

NodeVector spinRate(Graph& g, const BodyMass& mass, const NodeVector& w, const NodeVector& torque) {
    const Matrix& inertia = mass.inertia;
    NodeVector rate;
    if (mass.isPrincipal()) {
        const Matrix inverse = inertia.diagonal().cwiseInverse().asDiagonal();
        const NodeVector gyroscopic = gyroscopicRate(g, inertia, inverse, w);
        for (std::size_t i = 0; i < 3; ++i) {
            const int d = static_cast<int>(i);
            const Node driven = g.divide(torque[i], g.constant(inertia(d, d)));
            rate[i] = mass.isIsotropic() ? driven : g.add(gyroscopic[i], driven);
        }
        return rate;
    }
    const Matrix inverse = inertia.inverse();
    NodeMatrix rows;
    for (int i = 0; i < 3; ++i)
        rows[static_cast<std::size_t>(i)] = constant(g, inverse.row(i));
    return add(g, gyroscopicRate(g, inertia, inverse, w), times(g, rows, torque));
}

// --- bodies ---------------------------------------------------------------------------------

BodyMotion bodyMotion(Graph& g, const scene::Body& body, const BodyMass& mass) {
    BodyMotion motion;
    motion.name = body.name;
    motion.isFixed = body.fixed;
    motion.mass = mass;
    const Quaternion attitude = body.initialAttitude.normalized();
    motion.start = {body.initialPosition + attitude * mass.centroid, attitude};
    motion.symbols =
        body.fixed ? fixedBody(g, motion.start) : movingBody(g, body.name, mass.isIsotropic());
    motion.acceleration = motion.spinRate = constant(g, Vector::Zero());
    return motion;
}

// Newton and Euler with all that acts. A weight is an acceleration as it stands: dividing the mass
// out of it again would round.
void setRates(Graph& g, const scene::Scene& scene, BodyMotion& body,
              std::span<const Contribution* const> contributions) {
    NodeVector force = constant(g, Vector::Zero()), torque = force;
    Vector gravity = Vector::Zero();
    for (const Contribution* contribution : contributions) {
        const Contribution& c = *contribution;
        torque = add(g, torque, c.torque);
        const auto* weight =
            c.kind == Contribution::Kind::force
                ? std::get_if<scene::GravitationalForce>(&scene.forces[c.element].kind)
                : nullptr;
        if (weight && !scene.forces[c.element].couple)
            gravity += weight->acceleration;
        else
            force = add(g, force, c.force);
    }
    for (std::size_t i = 0; i < 3; ++i)
        body.acceleration[i] = g.add(g.divide(force[i], g.constant(body.mass.mass)),
                                     g.constant(gravity[static_cast<int>(i)]));
    body.spinRate = spinRate(g, body.mass, body.symbols.spin, torque);
}

std::vector<Held> heldTimes(std::span<const HoldSegment> segments) {
    std::vector<Held> held;
    for (const HoldSegment& segment : segments) {
        const Held now{segment.from,
                       {segment.linear[0].has_value(), segment.linear[1].has_value(),
                        segment.linear[2].has_value()},
                       segment.angular.has_value()};
        if (held.empty() || held.back().position != now.position ||
            held.back().attitude != now.attitude)
            held.push_back(now);
    }
    return held;
}

std::vector<std::size_t> trajectoriesReadBy(const Graph& g, const Scope& scope,
                                            const BodyMotion& body) {
    std::vector<Node> rates(body.acceleration.begin(), body.acceleration.end());
    rates.insert(rates.end(), body.spinRate.begin(), body.spinRate.end());
    return scope.trajectoriesReadBy(g, rates);
}

std::vector<double> cutsOf(const Scope& scope, std::span<const std::size_t> trajectories) {
    std::vector<double> cuts;
    for (const std::size_t index : trajectories)
        for (const TrajectoryPiece& piece : std::span(scope.trajectory(index).pieces).subspan(1))
            cuts.push_back(piece.from);
    return cuts;
}

// --- unknowns -------------------------------------------------------------------------------

std::array<Node, bodyUnknowns> symbolsOfBody(const BodySymbols& s) {
    return {s.position[0], s.position[1], s.position[2], s.velocity[0], s.velocity[1],
            s.velocity[2], s.attitude[0], s.attitude[1], s.attitude[2], s.attitude[3],
            s.spin[0],     s.spin[1],     s.spin[2]};
}

void addUnknowns(expression::EquationSet& set, const scene::Body& body, BodyMotion& motion,
                 std::array<std::vector<expression::Phase>, bodyUnknowns> phases) {
    motion.firstUnknown = set.unknowns.size();
    const auto symbols = symbolsOfBody(motion.symbols);
    const auto initial = motion.unknownsOf({motion.start.position, body.initialVelocity,
                                            motion.start.attitude, body.initialAngularVelocity});
    for (std::size_t i = 0; i < bodyUnknowns; ++i) {
        expression::Unknown unknown;
        unknown.name = set.graph.name(symbols[i]);
        unknown.symbol = symbols[i];
        unknown.initial = initial[i];
        unknown.phases = std::move(phases[i]);
        // A quaternion's entry that changes by e turns the body by the angle 2 e.
        unknown.lengthPerUnit = i < dx ? 1 : i >= qw && i < w1 ? 2 * motion.mass.radius : 0;
        if (i >= dx && i < qw)
            unknown.integralOf = motion.firstUnknown + i - dx;
        set.unknowns.push_back(std::move(unknown));
    }
    const std::size_t q = motion.unknown(qw);
    set.quaternions.push_back({q, q + 1, q + 2, q + 3});
}

} // namespace

const Held& BodyMotion::heldAt(double time) const {
    const auto after = std::ranges::upper_bound(held, time, {}, &Held::from);
    return after == held.begin() ? held.front() : *(after - 1);
}

BodyValues BodyMotion::valuesOf(std::span<const double, bodyUnknowns> u) const {
    const Quaternion attitude = Quaternion(u[qw], u[qx], u[qy], u[qz]).normalized();
    const Vector spin(u[w1], u[w2], u[w3]);
    return {Vector(u[x], u[y], u[z]), Vector(u[dx], u[dy], u[dz]), attitude,
            symbols.isSpinInWorldAxes ? spin : Vector(attitude * spin)};
}

std::array<double, bodyUnknowns> BodyMotion::unknownsOf(const BodyValues& v) const {
    const Quaternion& q = v.attitude;
    const Vector spin =
        symbols.isSpinInWorldAxes ? v.angularVelocity : Vector(q.conjugate() * v.angularVelocity);
    return {v.position[0], v.position[1], v.position[2], v.velocity[0], v.velocity[1],
            v.velocity[2], q.w(),         q.x(),         q.y(),         q.z(),
            spin[0],       spin[1],       spin[2]};
}

EquationsOfMotion::EquationsOfMotion(const scene::Scene& scene,
                                     const std::function<void()>& meanwhile,
                                     scene::ShapeReader* shapes, Start start) {
    const auto pause = [&meanwhile](std::size_t done) {
        if (done % 64 == 63 && meanwhile)
            meanwhile();
    };
    Graph& g = set.graph;
    set.time = g.symbol("t");
    std::vector<BodyMass> masses;
    std::vector<BodySymbols> symbols;
    scene::ShapeReader own(meanwhile);
    MassReader reader(scene, shapes ? *shapes : own);
    for (const scene::Body& body : scene.bodies) {
        pause(bodies.size());
        const auto mass = reader.massOf(body);
        if (const auto* sentence = std::get_if<std::string>(&mass)) {
            faults.push_back(*sentence);
            continue;
        }
        bodies.push_back(bodyMotion(g, body, std::get<BodyMass>(mass)));
        masses.push_back(bodies.back().mass);
        symbols.push_back(bodies.back().symbols);
    }
    if (!faults.empty())
        return;
    scope.emplace(g, scene, std::move(masses), std::move(symbols));
    JointMultipliers multipliers(g, scene, *scope, bodies, faults);
    JointReader joints(g, scene, *scope, bodies, multipliers, faults);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (const auto& turns = scope->turns(b); turns && !bodies[b].isFixed)
            for (std::size_t i = 0; i < 3; ++i)
                multipliers.addAngle((*turns)[i], bodies[b].symbols.worldSpin(g)[i],
                                     bodies[b].mass.radius, b);
    RopeReader ropes(g, scene, *scope, bodies, multipliers, faults);
    if (!faults.empty()) {
        scope.reset();
        return;
    }
    addContactReadings(set, scene, *scope);
    ForceReader(g, scene, *scope, multipliers, faults).read(contributions, links);
    joints.contribute(contributions);
    joints.addArms(bodies);
    ropes.contribute(contributions);
    multipliers.readReleases();
    jointEnergies = joints.energies();
    notes = ropes.notes();

    std::vector<std::vector<const Contribution*>> acting(bodies.size());
    for (const Contribution& c : contributions)
        acting[c.body].push_back(&c);
    std::set<double> times;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        pause(b);
        setRates(g, scene, bodies[b], acting[b]);
        const auto read = trajectoriesReadBy(g, *scope, bodies[b]);
        const auto segments = segmentsOf(scene, *scope, b, cutsOf(*scope, read), faults);
        bodies[b].held = heldTimes(segments);
        if (bodies[b].isFixed)
            continue;
        addUnknowns(set, scene.bodies[b], bodies[b],
                    phasesOf(g, *scope, bodies[b], segments, read, scene.simulator.start));
        owners.resize(set.unknowns.size(), b);
        for (const HoldSegment& segment : segments)
            times.insert(segment.from);
    }
    jointRows = multipliers.addUnknowns(set, owners, notes, start == Start::closes);
    ropeWraps = ropes.wraps(set);
    ropeLeans = ropes.leans();
    contactReaders = multipliers.contactReaders();
    times.erase(-std::numeric_limits<double>::infinity());
    breakpoints.assign(times.begin(), times.end());
    if (!faults.empty())
        scope.reset();
}

const expression::Phase& phaseAt(const expression::Unknown& unknown, double time) {
    const auto after = std::ranges::upper_bound(unknown.phases, time, {}, &expression::Phase::from);
    return after == unknown.phases.begin() ? unknown.phases.front() : *(after - 1);
}

Held unyieldingAt(const EquationsOfMotion& equations, std::size_t body, double time) {
    constexpr double rounding = 1e-12; // of the radius, in the centre of mass
    const BodyMotion& motion = equations.bodies[body];
    Held held = motion.heldAt(time);
    if (motion.mass.centroid.norm() <= rounding * motion.mass.radius)
        return held;
    for (std::size_t i = 0; i < 3; ++i) { // else its velocity is held, that of the centre
        const expression::Unknown& place = equations.set.unknowns[motion.unknown(x) + i];
        held.attitude =
            held.attitude || (held.position[i] && phaseAt(place, time).given.has_value());
    }
    return held;
}

} // namespace physics
