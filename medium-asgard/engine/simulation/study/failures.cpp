#include "study/failures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace simulation {
namespace {

constexpr std::size_t alternations = 12;
constexpr double kept = 0.5; // of the first increment that the last one has at least
constexpr std::size_t mostSteps = 200'000;

std::vector<double> stepEnds(const ComputedMotion& motion, std::size_t unknown) {
    std::vector<double> times = {motion.start()};
    while (times.back() < motion.computed() && times.size() < mostSteps) {
        const double next = motion.histories().piece(unknown, times.back()).until;
        if (!(next > times.back()) || next > motion.computed())
            break;
        times.push_back(next);
    }
    return times;
}

double component(const BodyState& state, std::size_t axis) {
    return axis < 3 ? state.velocity[static_cast<Eigen::Index>(axis)]
                    : state.angularVelocity[static_cast<Eigen::Index>(axis - 3)];
}

// Of what a velocity is off at the ends of steps: what moves to and fro by itself, and long steps
// that sample it, are no fault of the method.
bool ringsAlong(const ComputedMotion& motion, const Motion& reference, std::size_t body,
                std::size_t axis, std::size_t unknown, double visible) {
    const std::vector<double> times = stepEnds(motion, unknown);
    if (times.size() <= alternations)
        return false;
    std::vector<double> errors;
    double largest = 0;
    for (const double t : times) {
        const BodyState state = motion.at(body, t);
        errors.push_back(component(state, axis) - component(reference.at(body, t), axis));
        largest = std::max(largest, (axis < 3 ? state.velocity : state.angularVelocity).norm());
    }
    std::vector<double> increments;
    for (std::size_t i = 1; i < errors.size(); ++i)
        increments.push_back(errors[i] - errors[i - 1]);
    std::size_t run = 1;
    for (std::size_t i = 1; i < increments.size(); ++i) {
        run = increments[i] * increments[i - 1] < 0 ? run + 1 : 1;
        if (run >= alternations && std::abs(increments[i]) > visible * largest &&
            std::abs(increments[i]) >= kept * std::abs(increments[i + 1 - alternations]))
            return true;
    }
    return false;
}

double kineticEnergy(const Motion& motion, const std::vector<BodyRecord>& bodies, double t) {
    double sum = 0;
    for (std::size_t b = 0; b < motion.bodies(); ++b) {
        const double mass = motion.mass(b);
        if (!std::isfinite(mass))
            continue;
        const BodyState state = motion.at(b, t);
        sum += 0.5 * mass *
               (state.velocity.squaredNorm() +
                0.4 * bodies[b].radius * bodies[b].radius * state.angularVelocity.squaredNorm());
    }
    return sum;
}

} // namespace

bool rings(const ComputedMotion& motion, const Motion& reference,
           const std::vector<BodyRecord>& bodies, double visible) {
    constexpr std::array<std::size_t, 6> velocities = {physics::dx, physics::dy, physics::dz,
                                                       physics::w1, physics::w2, physics::w3};
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (std::size_t axis = 0; axis < velocities.size() && !bodies[b].isFixed; ++axis)
            if (ringsAlong(motion, reference, b, axis, bodies[b].firstUnknown + velocities[axis],
                           visible))
                return true;
    return false;
}

std::optional<EnergyCourse> energyCourse(const scene::Scene& scene, const Options& options,
                                         const MotionPointer& motion,
                                         const std::vector<BodyRecord>& bodies) {
    constexpr std::size_t samples = 64;
    std::vector<std::string> faults;
    const Quantities quantities(scene, options, motion, {"scene.energy"}, faults);
    if (!faults.empty())
        return std::nullopt;
    std::vector<double> energies;
    double kinetic = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        const double part = static_cast<double>(i) / (samples - 1);
        const double t = motion->start() + part * (motion->computed() - motion->start());
        energies.push_back(quantities.at(t)[0]);
        kinetic = std::max(kinetic, kineticEnergy(*motion, bodies, t));
    }
    if (!(kinetic > 0) || !std::isfinite(kinetic))
        return std::nullopt;
    constexpr std::size_t quarter = samples / 4;
    const auto mean = [&](std::size_t from) {
        double sum = 0;
        for (std::size_t i = from; i < from + quarter; ++i)
            sum += energies[i] / quarter;
        return sum;
    };
    const auto [low, high] = std::ranges::minmax(energies);
    return EnergyCourse{.range = (high - low) / kinetic,
                        .drift = (mean(samples - quarter) - mean(0)) / kinetic};
}

} // namespace simulation
