// Rallies of balls on one line, such as a row of balls between two walls: rally.h in one
// coordinate. All numbers are those in space: what is 0 across the line adds nothing to a sum, and
// the length of a vector along an axis is its coordinate's.
#include "simulation/collision_source.h"
#include "simulation/encounter_search.h"
#include "simulation/rally.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace simulation {

using namespace flight_hits;

using collision::approachThreshold;
using collision::FlightMeeting;
using collision::LineFlight;
using geometry::Vector;
using solution::infinity;

namespace {

// As in rally.cpp; sideways it is over the box.
bool staysBeyond(const LineFlight& ball, const geometry::Box& box, std::size_t axis, double room) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double reach = ball.radius * (1 + room);
    return (ball.velocity >= 0 && ball.place - reach > box.max()[a]) ||
           (ball.velocity <= 0 && ball.place + reach < box.min()[a]);
}

// As EncounterSearch::passApart() of two that do not approach.
bool partBeyond(const LineFlight& first, const LineFlight& second) {
    const double time = std::max(first.from, second.from);
    const double p = first.at(time) - second.at(time), reach = 2 * (first.radius + second.radius);
    constexpr double farthest = 1e12; // of the square
    return p * p > reach * reach && p * p <= farthest * (reach * reach);
}

} // namespace

// --- the line -------------------------------------------------------------------------------

// It goes along the axis through the first ball, straight, and stays in its cell sideways.
bool Rally::isOnLine(Ball& ball) const {
    const collision::BallFlight &flight = ball.flight, &first = balls[0].flight;
    ball.aside = 0;
    bool is = ball.isStraight && collision::isPlain(flight.radius);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const double place = flight.place[k];
        is = is && collision::isPlain(place) && collision::isPlain(flight.velocity[k]);
        if (i == axis)
            continue;
        ball.aside = std::max(ball.aside, std::abs(place));
        is = is && flight.velocity[k] == 0 && place == first.place[k] &&
             place >= ball.cell.min()[k] && place <= ball.cell.max()[k];
    }
    return is;
}

// One convex part of which the ball sees one face only, wherever it is on its side of it: the
// others lie along the line, or look the other way.
bool Rally::isAcrossLine(Meeting& meeting) const {
    const Ball& ball = balls[meeting.ball];
    const auto& parts = standing[meeting.other].parts;
    if (parts.size() != 1)
        return false;
    const collision::StandingPart& part = parts[0];
    const auto a = static_cast<Eigen::Index>(axis);
    const collision::StandingFace& face = part.facing(ball.flight.place);
    meeting.face = &face;
    meeting.plane = {face.plane.normal[a], face.plane.offset, part.extent};
    const Vector across = face.plane.normal - meeting.plane.side * Vector::Unit(a);
    bool is = std::abs(meeting.plane.side) == 1 && across.isZero(0) &&
              collision::isPlain(part.extent) && ball.flight.radius > 1e-9 * part.extent;
    for (const collision::StandingFace& other : part.faces) {
        const double along = other.plane.normal[a] * meeting.plane.side;
        is = is && (&other == &face || along < 0 ||
                    (along == 0 && other.plane.above(ball.flight.place) < 0));
    }
    for (const collision::StandingFace::Plane& side : face.sides)
        is = is && side.normal[a] == 0 &&
             side.above(ball.flight.place) > 1e-9 * part.extent; // clearly over its inside
    return is;
}

void Rally::lineUp() {
    axis = noAxis;
    for (const Ball& ball : balls)
        for (std::size_t i = 0; i < 3; ++i)
            if (ball.flight.velocity[static_cast<Eigen::Index>(i)] != 0)
                axis = i;
    const auto isOn = [this](Ball& ball) { return isOnLine(ball); };
    const auto isAcross = [this](Meeting& meeting) {
        return !meeting.isStanding || isAcrossLine(meeting);
    };
    if (axis != noAxis &&
        !(std::ranges::all_of(balls, isOn) && std::ranges::all_of(meetings, isAcross)))
        axis = noAxis;
}

bool Rally::areHomeOnLine(double time) const {
    const auto a = static_cast<Eigen::Index>(axis);
    return std::ranges::all_of(balls, [&](const Ball& ball) {
        const double place = onLine(ball).at(time);
        return !ball.hasTurned || (place >= ball.cell.min()[a] && place <= ball.cell.max()[a]);
    });
}

bool Rally::turnedOnLine(const Meeting& met, double time, bool parted, double room) {
    const auto renew = [&](Ball& ball) {
        ball.hasTurned = true;
        ball.until = time + EncounterSearch::firstSpan;
    };
    renew(balls[met.ball]);
    if (!met.isStanding)
        renew(balls[met.other]);
    return tellNext(met, parted,
                    [&](Meeting& meeting) { return predictOnLine(meeting, time, room); });
}

bool Rally::predictOnLine(Meeting& meeting, double time, double room) {
    const Ball& ball = balls[meeting.ball];
    const LineFlight flight = onLine(ball);
    if (meeting.isStanding && staysBeyond(flight, standing[meeting.other].box, axis, room)) {
        meeting.time = infinity;
        return true;
    }
    const FlightMeeting met =
        meeting.isStanding ? collision::meetingOnLine(flight, meeting.plane, ball.until)
                           : collision::meetingOnLine(flight, onLine(balls[meeting.other]), time);
    if (met.kind == FlightMeeting::Kind::unclear)
        return predict(meeting, time, room);
    if (met.kind == FlightMeeting::Kind::none && !meeting.isStanding &&
        partBeyond(flight, onLine(balls[meeting.other]))) {
        meeting.time = infinity;
        return true;
    }
    meeting.time = met.kind == FlightMeeting::Kind::hit ? met.time : infinity;
    meeting.isNear = true;
    ++tests;
    return true;
}

// --- hits -----------------------------------------------------------------------------------

void CollisionSource::lineUp() {
    rally_.lineUp();
    if (rally_.axis == Rally::noAxis)
        return;
    for (Rally::Meeting& meeting : rally_.meetings) {
        const auto [first, second] = meeting.pair;
        meeting.touching =
            collision::touchingGap * (records_[first].radius + records_[second].radius);
        meeting.restitution = restitutionOf(meeting.pair);
        meeting.inverseFirst = 1 / records_[first].mass;
        meeting.inverseSecond = 1 / records_[second].mass;
        if (meeting.isStanding)
            meeting.farthest =
                records_[rally_.standing[meeting.other].body].start.position.cwiseAbs().maxCoeff();
    }
}

double CollisionSource::toleranceOnLine(const Rally::Meeting& meeting, double time) const {
    const LineFlight ball = rally_.onLine(rally_.balls[meeting.ball]);
    double far = ball.farthest(ball.at(time)), speed = std::abs(ball.velocity);
    if (meeting.isStanding) {
        far += meeting.farthest;
    } else {
        const LineFlight other = rally_.onLine(rally_.balls[meeting.other]);
        far += other.farthest(other.at(time));
        speed += std::abs(other.velocity);
    }
    return meeting.touching + timeResolution * (far + std::abs(time) * speed);
}

// Nothing but `met` touches it.
bool CollisionSource::isAloneOnLine(const Rally::Ball& ball, const Rally::Meeting& met) const {
    const LineFlight flight = rally_.onLine(ball);
    const double place = flight.at(met.time);
    return std::ranges::all_of(ball.meetings, [&](std::size_t m) {
        const Rally::Meeting& meeting = rally_.meetings[m];
        if (&meeting == &met)
            return true;
        const double tolerance = toleranceOnLine(meeting, met.time);
        if (meeting.isStanding)
            return meeting.plane.above(place) - flight.radius > tolerance;
        const bool isFirst = &ball == &rally_.balls[meeting.ball];
        const LineFlight other =
            rally_.onLine(rally_.balls[isFirst ? meeting.other : meeting.ball]);
        const double apart = place - other.at(met.time),
                     far = flight.radius + other.radius + tolerance;
        return apart * apart > far * far;
    });
}

// As flightContact() and pushOf().
std::optional<CollisionSource::LineContact>
CollisionSource::contactOnLine(const Rally::Meeting& met) const {
    const LineFlight ball = rally_.onLine(rally_.balls[met.ball]);
    const double place = ball.at(met.time);
    LineContact contact;
    if (met.isStanding) {
        const bool isFirst = rally_.balls[met.ball].body == met.pair.first;
        contact.gap = met.plane.above(place) - ball.radius;
        contact.normal = isFirst ? met.plane.side : -met.plane.side;
        contact.velocities[isFirst ? 0 : 1] = ball.velocity;
    } else {
        const LineFlight other = rally_.onLine(rally_.balls[met.other]);
        const double p = place - other.at(met.time);
        contact.gap = std::abs(p) - (ball.radius + other.radius);
        contact.normal = p > 0 ? 1 : -1;
        contact.velocities = {ball.velocity, other.velocity};
    }
    const auto& [v, w] = contact.velocities;
    const double speeds = std::abs(v) + std::abs(w), speed = contact.normal * (v - w);
    if (std::abs(contact.gap) > toleranceOnLine(met, met.time) || met.restitution == 0 ||
        !(speed < -approachThreshold * speeds))
        return std::nullopt;
    const double one = met.inverseFirst, other = met.inverseSecond;
    contact.impulse = physics::centralImpulse(speed, met.restitution, one + other);
    contact.then = {v + (contact.impulse * one) * contact.normal,
                    w + (-contact.impulse * other) * contact.normal};
    contact.isClear = met.restitution * -speed > 2 * approachThreshold * (speeds - 2 * speed);
    if (contact.then == contact.velocities || !collision::isPlain(contact.then[0]) ||
        !collision::isPlain(contact.then[1]))
        return std::nullopt;
    return contact;
}

Impact CollisionSource::impactOnLine(const Rally::Meeting& met, const LineContact& contact) const {
    Impact impact{.time = met.time,
                  .first = met.pair.first,
                  .second = met.pair.second,
                  .point = {},
                  .normal = Vector::Zero(),
                  .impulse = contact.impulse};
    const Rally::Ball& ball = rally_.balls[met.ball];
    if (met.isStanding) {
        const Vector& normal = met.face->plane.normal;
        impact.point =
            ball.flight.centreAt(met.time) - (ball.flight.radius + contact.gap / 2) * normal;
        impact.normal = ball.body == met.pair.first ? normal : Vector(-normal);
    } else {
        const collision::BallFlight& second = rally_.balls[met.other].flight;
        impact.normal[static_cast<Eigen::Index>(rally_.axis)] = contact.normal;
        impact.point =
            second.centreAt(met.time) + (second.radius + contact.gap / 2) * impact.normal;
    }
    return impact;
}

// What is not plain is a hit in space.
CollisionSource::Rallied CollisionSource::meetOnLine(const Rally::Meeting& met) {
    const double time = met.time;
    Rally::Ball& one = rally_.balls[met.ball];
    Rally::Ball* const two = met.isStanding ? nullptr : &rally_.balls[met.other];
    const auto contact = contactOnLine(met);
    if (!contact || !rally_.areHomeOnLine(time) || !isAloneOnLine(one, met) ||
        (two && !isAloneOnLine(*two, met)))
        return meetInRally(met);
    const std::size_t other = two ? two->body : rally_.standing[met.other].body;
    if (meetsWithoutEnd(one.body, other, two != nullptr, time) ||
        (two && meetsWithoutEnd(other, one.body, true, time)))
        return Rallied::isEndless;
    const Impact impact = impactOnLine(met, *contact);
    std::array<solution::Turn, 2> turns;
    std::size_t count = 0;
    for (Rally::Ball* const ball : {&one, two})
        if (ball) {
            const std::size_t i = ball->body == met.pair.first ? 0 : 1;
            const Vector place = ball->flight.centreAt(time);
            ball->turn.place = {place[0], place[1], place[2]};
            ball->turn.jumps[rally_.axis] = contact->then[i] != contact->velocities[i];
            ball->turn.velocity[rally_.axis] = contact->then[i];
            turns[count++] = ball->turn;
        }
    if (!turns_->turn(time, std::span(turns).first(count)))
        return Rallied::isRefused;
    add(impact, time);
    noteEvent(time);
    one.fly(turns[0], time);
    if (two)
        two->fly(turns[1], time);
    const bool forGood = contact->isClear && contact->gap > -deep * one.flight.radius;
    return search_.turnedOnLine(rally_, met, time, forGood) ? Rallied::goesOn : Rallied::isUnclear;
}

} // namespace simulation
