// Impacts of balls in flight, where nothing else touches: collision_source.h in closed form.
#include "simulation/collision_source.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace simulation {
namespace {

using collision::FlightContact;
using solution::Event;
using solution::Histories;

constexpr double approachThreshold = 1e-12; // of the speeds that enter, as in physics/impact.h

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
    FlightContact found;
    for (const std::size_t body : {pair.first, pair.second})
        for (const std::size_t other : search_.partners(body)) {
            const Pair met = std::minmax(body, other);
            if (met == pair && body == pair.second && !records_[pair.first].isFixed)
                continue; // seen
            const FlightContact contact = flightContact(met, time);
            if (contact.kind == FlightContact::Kind::none)
                continue;
            if (contact.kind == FlightContact::Kind::unclear && met != pair) {
                // Whoever is near without touching leaves no trace in the result.
                Cluster others;
                if (!search_.hasEnded(other))
                    addContacts(histories, others, met.first, met.second, time);
                if (others.contacts.empty())
                    continue;
            }
            if (contact.kind == FlightContact::Kind::unclear || met != pair)
                return std::nullopt;
            found = contact;
        }
    return found.kind == FlightContact::Kind::contact ? std::optional(found) : std::nullopt;
}

// softenLastHops() would end the bouncing here, or is near to it.
bool CollisionSource::isLastHop(const Pair& pair, const Vector& normal, double speed,
                                double time) const {
    double push = 0, reach = 0;
    double radius = solution::infinity;
    for (const auto& [body, sign] : {std::pair{pair.first, 1.0}, std::pair{pair.second, -1.0}}) {
        radius = std::min(radius, records_[body].radius);
        reach += records_[body].radius;
        if (const collision::BallFlight* flight = search_.flight(body)) {
            push += 2 * sign * normal.dot(flight->half);
            reach += flight->centreAt(time).norm();
        }
    }
    const double lowest = std::max({limits_.hopHeight * radius, 2e-9 * radius, 1e-13 * reach});
    return push < 0 && speed * speed / (-2 * push) < 2 * lowest;
}

bool CollisionSource::meetInFlight(const Histories& histories, const Pair& pair, double time,
                                   std::optional<Event>& event) {
    const auto contact = onlyContact(histories, pair, time);
    const double restitution =
        std::min(scene_.bodies[pair.first].restitution, scene_.bodies[pair.second].restitution);
    if (!contact || restitution == 0)
        return false;
    std::array<Vector, 2> velocities{Vector::Zero(), Vector::Zero()};
    std::array<double, 2> inverseMasses{};
    for (std::size_t i = 0; i < 2; ++i) {
        const BodyRecord& record = records_[i == 0 ? pair.first : pair.second];
        if (record.isFixed)
            continue;
        inverseMasses[i] = 1 / record.mass;
        for (std::size_t k = 0; k < 3; ++k)
            velocities[i][static_cast<Eigen::Index>(k)] =
                histories.value(record.firstUnknown + physics::dx + k, time);
    }
    const double speed = contact->normal.dot(velocities[0] - velocities[1]);
    if (!(speed < -approachThreshold * (velocities[0].norm() + velocities[1].norm())) ||
        isLastHop(pair, contact->normal, restitution * speed, time))
        return false;
    const double impulse =
        physics::centralImpulse(speed, restitution, inverseMasses[0] + inverseMasses[1]);
    event = Event{.time = time, .touched = {}, .tag = 0};
    outcome_ = {};
    for (std::size_t i = 0; i < 2; ++i) {
        const double sign = i == 0 ? 1 : -1;
        const std::size_t first = records_[i == 0 ? pair.first : pair.second].firstUnknown;
        const Vector change = (sign * impulse * inverseMasses[i]) * contact->normal;
        for (std::size_t k = 0; k < 3 && inverseMasses[i] > 0; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const double then = velocities[i][axis] + change[axis];
            if (then == velocities[i][axis])
                continue;
            outcome_.jumps.push_back({first + physics::dx + k, then});
            event->touched.push_back(first + physics::dx + k);
        }
    }
    if (event->touched.empty())
        return false;
    add({.time = time,
         .first = pair.first,
         .second = pair.second,
         .point = contact->point,
         .normal = contact->normal,
         .impulse = impulse},
        time);
    return true;
}

} // namespace simulation
