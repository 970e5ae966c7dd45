#include "run/nudge.h"

#include "physics/equations_of_motion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace simulation {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double least = 1; // unit in the last place
constexpr double latest = 1e-5 / (least * epsilon);

bool isVelocity(std::size_t unknown) {
    const std::size_t kind = unknown % physics::bodyUnknowns;
    return (kind >= physics::dx && kind < physics::qw) || kind >= physics::w1;
}

// A number in -1 .. -1/2 or 1/2 .. 1 that looks random (splitmix64).
double signFor(double value, std::size_t kind) {
    auto x = std::bit_cast<std::uint64_t>(value) + 0x9e3779b97f4a7c15ULL * (kind + 1);
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
    x ^= x >> 31U;
    const double size = 0.5 + static_cast<double>(x >> 11U) * 0x1p-54;
    return (x & 1U) != 0 ? size : -size;
}

double nudged(double value, std::size_t unknown, double units) {
    const double sign = signFor(value, unknown % physics::bodyUnknowns);
    return value * (1 + units * epsilon * sign);
}

} // namespace

std::vector<double> nudgedStart(const expression::EquationSet& equations) {
    std::vector<double> values;
    for (const expression::Unknown& unknown : equations.unknowns)
        values.push_back(unknown.initial);
    const std::size_t ofBodies = equations.quaternions.size() * physics::bodyUnknowns;
    for (std::size_t i = 0; i < ofBodies; i += physics::bodyUnknowns) {
        const bool moves = values[i + physics::dx] != 0 || values[i + physics::dy] != 0 ||
                           values[i + physics::dz] != 0;
        for (std::size_t k = i; k < i + physics::bodyUnknowns; ++k)
            if (isVelocity(k) || (moves && k - i < physics::dx))
                values[k] = nudged(values[k], k, least);
    }
    return values;
}

NudgedSource::NudgedSource(solution::EventSource& source, const std::vector<BodyRecord>& bodies,
                           double start)
    : source_(source), start_(start) {
    for (const BodyRecord& body : bodies) {
        const std::size_t index = body.firstUnknown / physics::bodyUnknowns;
        if (body.isFixed)
            continue;
        radii_.resize(std::max(radii_.size(), index + 1), 1);
        radii_[index] = body.radius;
    }
}

// The units in the last place by which a velocity is nudged: the largest of two resolutions.
//
// Time: rounding makes an impact late by up to |t| * 2^-53. The body is then as far off as with
// |t| / (t - start) units more of its speed, once the time since the start has doubled. An impact
// at the start itself is not late.
//
// Place: the arm or the normal is the difference of two places, of which each has the resolution of
// the farthest coordinate: half a unit, as a power of 2, beside the body's radius. A turn and an
// event read the place from the same polynomial; where they differ by a unit in the last place the
// power is the same, except next to a power of 2.
double NudgedSource::unitsAt(double time, std::size_t unknown, double farthest) const {
    const double late = time > start_ ? std::min(std::abs(time) / (time - start_), latest) : 1;
    const double far = farthest / radii_[unknown / physics::bodyUnknowns];
    return least *
           std::max({1.0, late, far > 2 ? std::min(std::exp2(std::ilogb(far)), latest) : 1.0});
}

bool NudgedSource::turn(double time, std::span<solution::Turn> turns) {
    for (solution::Turn& turn : turns) {
        const double farthest =
            Vector(turn.place[0], turn.place[1], turn.place[2]).cwiseAbs().maxCoeff();
        for (std::size_t k = 0; k < 3; ++k)
            if (turn.jumps[k])
                turn.velocity[k] = given(turn.velocity[k], turn.velocities[k], time, farthest);
    }
    return turns_->turn(time, turns);
}

double NudgedSource::given(double velocity, std::size_t unknown, double time,
                           double farthest) const {
    return nudged(velocity, unknown, unitsAt(time, unknown, farthest));
}

void NudgedSource::apply(const solution::Histories& histories, const solution::Event& event,
                         solution::EquationsInForce& equations, solution::Changes& changes) {
    source_.apply(histories, event, equations, changes);
    for (solution::Changes::Jump& jump : changes.jumps)
        // Others tell of no body: multipliers, angles of joints.
        if (isVelocity(jump.unknown) && jump.unknown / physics::bodyUnknowns < radii_.size()) {
            const std::size_t first = jump.unknown - jump.unknown % physics::bodyUnknowns;
            const Vector place(histories.value(first + physics::x, event.time),
                               histories.value(first + physics::y, event.time),
                               histories.value(first + physics::z, event.time));
            jump.value = given(jump.value, jump.unknown, event.time, place.cwiseAbs().maxCoeff());
        }
}

} // namespace simulation
