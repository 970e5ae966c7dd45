// Impacts of balls in flight, where nothing else touches: collision_source.h in closed form.
#include "simulation/collision_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace simulation {
namespace {

using collision::FlightContact;
using solution::Event;
using solution::Histories;

constexpr double timeResolution = 8 * std::numeric_limits<double>::epsilon();
constexpr double approachThreshold = 1e-12; // of the speeds that enter, as in physics/impact.h

// A ball in flight at an instant, to see that another does not touch it by more than any tolerance.
struct At {
    const collision::BallFlight* flight; // may be null: then nothing is known
    double time;
    Vector centre = flight ? flight->centreAt(time) : Vector::Zero();
    double speeds = flight ? flight->velocityAt(time).lpNorm<1>() : 0;

    [[nodiscard]] bool isApartFrom(const collision::BallFlight* other) const {
        if (!flight || !other)
            return false;
        const double far = 1.001 * (flight->radius + other->radius);
        return (centre - other->centreAt(time)).squaredNorm() > far * far &&
               timeResolution * std::abs(time) * (speeds + other->velocityAt(time).lpNorm<1>()) <
                   1e-4 * far;
    }
    // Of something that stands still, by what holds it.
    [[nodiscard]] bool isApartFrom(const geometry::Box& box, double radius) const {
        if (!flight)
            return false;
        const double tolerance = collision::touchingGap * (flight->radius + radius) +
                                 timeResolution * std::abs(time) * speeds;
        const double far = 1.001 * flight->radius + tolerance;
        return ((centre.array() > box.max().array() + far) ||
                (centre.array() < box.min().array() - far))
            .any();
    }
};

} // namespace

FlightContact CollisionSource::flightContact(const Pair& pair, double time) const {
    const collision::BallFlight* a = search_.flight(pair.first);
    const collision::BallFlight* b = search_.flight(pair.second);
    const double tolerance = contactTolerance(pair, time);
    if (a && b)
        return collision::contactOf(*a, *b, time, tolerance);
    const auto parts = search_.standing(a ? pair.second : pair.first);
    if ((!a && !b) || parts.empty())
        return {FlightContact::Kind::unclear, {}, {}};
    FlightContact found;
    for (const collision::StandingPart& part : parts) {
        const FlightContact contact = collision::contactOf(a ? *a : *b, part, time, tolerance);
        if (contact.kind == FlightContact::Kind::none)
            continue;
        if (contact.kind == FlightContact::Kind::unclear ||
            found.kind == FlightContact::Kind::contact)
            return {FlightContact::Kind::unclear, {}, {}};
        found = contact;
    }
    if (!a)
        found.normal = -found.normal;
    return found;
}

// None: they do not touch, or something else touches one of them, or that is not clear.
std::optional<FlightContact> CollisionSource::onlyContact(const Histories& histories,
                                                          const Pair& pair, double time) {
    const FlightContact found = flightContact(pair, time);
    if (found.kind != FlightContact::Kind::contact)
        return std::nullopt;
    bool isOnly = true;
    for (const std::size_t body : {pair.first, pair.second}) {
        const At here{.flight = search_.flight(body), .time = time};
        search_.forEachPartner(body, [&](std::size_t other) {
            const Pair met = std::minmax(body, other);
            if (!isOnly || met == pair || here.isApartFrom(search_.flight(other)) ||
                (records_[other].isFixed &&
                 here.isApartFrom(search_.box(other), records_[other].radius)))
                return;
            const FlightContact contact = flightContact(met, time);
            isOnly = contact.kind == FlightContact::Kind::none ||
                     (contact.kind == FlightContact::Kind::unclear &&
                      !touchesClosely(histories, met, other, time));
        });
    }
    return isOnly ? std::optional(found) : std::nullopt;
}

// Whoever is near without touching leaves no trace in the result.
bool CollisionSource::touchesClosely(const Histories& histories, const Pair& pair,
                                     std::size_t other, double time) {
    Cluster cluster;
    if (!search_.hasEnded(other))
        addContacts(histories, cluster, pair.first, pair.second, time, true);
    return !cluster.contacts.empty();
}

// softenLastHops() would end the bouncing here, or is near to it.
bool CollisionSource::isLastHop(const Pair& pair, const Vector& normal, double speed,
                                double time) const {
    double push = 0, reach = 0;
    for (const auto& [body, sign] : {std::pair{pair.first, 1.0}, std::pair{pair.second, -1.0}})
        if (const collision::BallFlight* flight = search_.flight(body))
            push += 2 * sign * normal.dot(flight->half);
    if (!(push < 0))
        return false;
    double radius = solution::infinity;
    for (const std::size_t body : {pair.first, pair.second}) {
        radius = std::min(radius, records_[body].radius);
        reach += records_[body].radius;
        if (const collision::BallFlight* flight = search_.flight(body))
            reach += flight->centreAt(time).norm();
    }
    const double lowest = std::max({limits_.hopHeight * radius, 2e-9 * radius, 1e-13 * reach});
    return speed * speed / (-2 * push) < 2 * lowest;
}

Vector CollisionSource::velocityOf(const Histories& histories, std::size_t body,
                                   double time) const {
    if (records_[body].isFixed)
        return Vector::Zero();
    if (search_.isFollowed(body))
        return search_.flight(body)->velocityAt(time);
    const std::size_t first = records_[body].firstUnknown + physics::dx;
    return {histories.value(first, time), histories.value(first + 1, time),
            histories.value(first + 2, time)};
}

// On the spot, where the solver agrees and nobody reads them.
bool CollisionSource::turn(const Pair& pair, double time, const std::array<Vector, 2>& before,
                           const std::array<Vector, 2>& after) {
    std::array<solution::Turn, 2> turns;
    std::array<std::size_t, 2> turned{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t body = i == 0 ? pair.first : pair.second;
        if (records_[body].isFixed)
            continue;
        if (!turns_ || !search_.isFollowed(body) || !dependents_[body].empty())
            return false;
        turned[count] = body;
        solution::Turn& turn = turns[count++];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            turn.places[k] = records_[body].firstUnknown + physics::x + k;
            turn.velocities[k] = records_[body].firstUnknown + physics::dx + k;
            turn.jumps[k] = after[i][axis] != before[i][axis];
            turn.velocity[k] = after[i][axis];
        }
    }
    if (!turns_->turn(time, std::span(turns).first(count)))
        return false;
    for (std::size_t i = 0; i < count; ++i)
        search_.turn(turned[i], turns[i], time);
    search_.goOn(pair, time, renewal_);
    lookAtJoined(time);
    noteEvent(time);
    return true;
}

std::optional<CollisionSource::Handled>
CollisionSource::meetInFlight(const Histories& histories, const Pair& pair, double time) {
    const auto contact = onlyContact(histories, pair, time);
    const double restitution =
        std::min(scene_.bodies[pair.first].restitution, scene_.bodies[pair.second].restitution);
    if (!contact || restitution == 0)
        return std::nullopt;
    const std::array<Vector, 2> velocities{velocityOf(histories, pair.first, time),
                                           velocityOf(histories, pair.second, time)};
    const std::array<double, 2> inverseMasses{1 / records_[pair.first].mass,
                                              1 / records_[pair.second].mass};
    const double speed = contact->normal.dot(velocities[0] - velocities[1]);
    if (!(speed < -approachThreshold * (velocities[0].norm() + velocities[1].norm())) ||
        isLastHop(pair, contact->normal, restitution * speed, time))
        return std::nullopt;
    const double impulse =
        physics::centralImpulse(speed, restitution, inverseMasses[0] + inverseMasses[1]);
    std::array<Vector, 2> then;
    for (std::size_t i = 0; i < 2; ++i)
        then[i] =
            velocities[i] + ((i == 0 ? impulse : -impulse) * inverseMasses[i]) * contact->normal;
    if (then == velocities)
        return std::nullopt;
    add({.time = time,
         .first = pair.first,
         .second = pair.second,
         .point = contact->point,
         .normal = contact->normal,
         .impulse = impulse},
        time);
    if (turn(pair, time, velocities, then))
        return Handled{.event = {}, .isDone = true};
    // All axes of what could be turned restart, as they do in a turn: whether somebody reads a body
    // changes no bit of it.
    Event event{.time = time, .touched = {}, .tag = 0};
    outcome_ = {};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t body = i == 0 ? pair.first : pair.second;
        for (std::size_t k = 0; k < 3 && !records_[body].isFixed; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const bool jumps = then[i][axis] != velocities[i][axis];
            const std::size_t unknown = records_[body].firstUnknown + physics::dx + k;
            if (jumps || search_.isFollowed(body))
                event.touched.push_back(unknown);
            if (jumps)
                outcome_.jumps.push_back({unknown, then[i][axis]});
        }
    }
    return Handled{.event = std::move(event), .isDone = false};
}

} // namespace simulation
