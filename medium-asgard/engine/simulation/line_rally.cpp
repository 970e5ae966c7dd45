#include "simulation/line_rally.h"

#include "simulation/collision_source.h"
#include "simulation/encounter_search.h"

#include <algorithm>
#include <cmath>

namespace simulation {

using namespace flight_hits;

using collision::approachThreshold;
using collision::FlightMeeting;
using collision::LineFlight;
using geometry::Vector;
using solution::infinity;

namespace {

// As in rally.cpp; sideways it is over the box.
bool staysBeyond(const LineFlight& ball, const LineRally::Meeting& standing, double room) {
    const double reach = ball.radius * (1 + room);
    return (ball.velocity >= 0 && ball.place - reach > standing.most) ||
           (ball.velocity <= 0 && ball.place + reach < standing.least);
}

// As EncounterSearch::passApart() of two that do not approach.
bool partBeyond(const LineFlight& first, const LineFlight& second) {
    const double time = std::max(first.from, second.from);
    const double p = first.at(time) - second.at(time), reach = 2 * (first.radius + second.radius);
    constexpr double farthest = 1e12; // of the square
    return p * p > reach * reach && p * p <= farthest * (reach * reach);
}

// On which the first is of the second: they stay in a row.
double sideOf(const collision::BallFlight& first, const collision::BallFlight& second,
              Eigen::Index axis) {
    const double time = std::max(first.from, second.from);
    return first.centreAt(time)[axis] > second.centreAt(time)[axis] ? 1 : -1;
}

} // namespace

// --- the line -------------------------------------------------------------------------------

// It goes along the axis through the first ball, straight, and stays in its cell sideways.
bool LineRally::isOnLine(const Rally& rally, const Rally::Ball& ball) const {
    const collision::BallFlight &flight = ball.flight, &first = rally.balls[0].flight;
    bool is = ball.isStraight && collision::isPlain(flight.radius);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const double place = flight.place[k];
        is = is && collision::isPlain(place) && collision::isPlain(flight.velocity[k]) &&
             (i == axis || (flight.velocity[k] == 0 && place == first.place[k] &&
                            place >= ball.cell.min()[k] && place <= ball.cell.max()[k]));
    }
    return is;
}

// One convex part of which the ball sees one face only, wherever it is on its side of it: the
// others lie along the line, or look the other way.
bool LineRally::isAcrossLine(const Rally& rally, const Rally::Meeting& meeting) {
    const collision::BallFlight& flight = rally.balls[meeting.ball].flight;
    const Rally::Standing& standing = rally.standing[meeting.other];
    if (standing.parts.size() != 1)
        return false;
    const collision::StandingPart& part = standing.parts[0];
    const auto a = static_cast<Eigen::Index>(axis);
    const collision::StandingFace& face = part.facing(flight.place);
    const collision::LineFace plane{face.plane.normal[a], face.plane.offset, part.extent};
    const Vector across = face.plane.normal - plane.side * Vector::Unit(a);
    bool is = std::abs(plane.side) == 1 && across.isZero(0) && collision::isPlain(part.extent) &&
              flight.radius > 1e-9 * part.extent;
    for (const collision::StandingFace& other : part.faces) {
        const double along = other.plane.normal[a] * plane.side;
        is = is &&
             (&other == &face || along < 0 || (along == 0 && other.plane.above(flight.place) < 0));
    }
    for (const collision::StandingFace::Plane& side : face.sides)
        is = is && side.normal[a] == 0 &&
             side.above(flight.place) > 1e-9 * part.extent; // clearly over its inside
    Meeting& made = meetings.back();
    made.plane = plane;
    made.least = standing.box.min()[a];
    made.most = standing.box.max()[a];
    made.normal = plane.side;
    return is;
}

bool LineRally::lineUp(const Rally& rally, double room) {
    room_ = room;
    axis = 0;
    for (const Rally::Ball& ball : rally.balls)
        for (std::size_t i = 0; i < 3; ++i)
            if (ball.flight.velocity[static_cast<Eigen::Index>(i)] != 0)
                axis = i;
    const auto a = static_cast<Eigen::Index>(axis);
    balls.clear();
    meetings.clear();
    for (const Rally::Ball& ball : rally.balls) {
        if (!isOnLine(rally, ball))
            return false;
        Vector across = ball.flight.place;
        across[a] = 0;
        balls.push_back(
            {.flight = {.radius = ball.flight.radius, .aside = across.cwiseAbs().maxCoeff()},
             .least = ball.cell.min()[a],
             .most = ball.cell.max()[a],
             .meetings = ball.meetings});
    }
    for (const Rally::Meeting& meeting : rally.meetings) {
        meetings.push_back({.ball = meeting.ball,
                            .other = meeting.other,
                            .isStanding = meeting.isStanding,
                            .plane = {}});
        if (meeting.isStanding && !isAcrossLine(rally, meeting))
            return false;
        if (!meeting.isStanding)
            meetings.back().normal =
                sideOf(rally.balls[meeting.ball].flight, rally.balls[meeting.other].flight, a);
    }
    return true;
}

void LineRally::take(const Rally& rally) {
    const auto a = static_cast<Eigen::Index>(axis);
    others_ = rally.others;
    tests_ = rally.tests;
    for (std::size_t b = 0; b < balls.size(); ++b) {
        const Rally::Ball& ball = rally.balls[b];
        balls[b].flight.from = ball.flight.from;
        balls[b].flight.place = ball.flight.place[a];
        balls[b].flight.velocity = ball.flight.velocity[a];
        balls[b].until = ball.until;
        balls[b].hasTurned = ball.hasTurned;
    }
    for (std::size_t m = 0; m < meetings.size(); ++m) {
        meetings[m].time = rally.meetings[m].time;
        meetings[m].isNear = rally.meetings[m].isNear;
    }
}

void LineRally::giveBack(Rally& rally) const {
    const auto a = static_cast<Eigen::Index>(axis);
    rally.tests = tests_;
    for (std::size_t b = 0; b < balls.size(); ++b) {
        Rally::Ball& ball = rally.balls[b];
        ball.flight.from = balls[b].flight.from;
        ball.flight.place[a] = balls[b].flight.place;
        ball.flight.velocity[a] = balls[b].flight.velocity;
        ball.until = balls[b].until;
        ball.hasTurned = balls[b].hasTurned;
    }
    for (std::size_t m = 0; m < meetings.size(); ++m) {
        rally.meetings[m].time = meetings[m].time;
        rally.meetings[m].isNear = meetings[m].isNear;
    }
}

// --- hits -----------------------------------------------------------------------------------

const LineRally::Meeting* LineRally::next() const { return nextMeeting(balls, meetings, others_); }

bool LineRally::areHome(double time) {
    bool are = true;
    for (std::size_t b = 0; b < balls.size(); ++b) {
        const Ball& ball = balls[b];
        const double place = ball.flight.at(time);
        now_[b] = {.place = place,
                   .speed = std::abs(ball.flight.velocity),
                   .farthest = ball.flight.farthest(place)};
        are = are && (!ball.hasTurned || (place >= ball.least && place <= ball.most));
    }
    return are;
}

inline double LineRally::toleranceOf(const Meeting& meeting, double time) const {
    const Now& ball = now_[meeting.ball];
    double far = ball.farthest, speed = ball.speed;
    if (meeting.isStanding) {
        far += meeting.farthest;
    } else {
        far += now_[meeting.other].farthest;
        speed += now_[meeting.other].speed;
    }
    return meeting.touching + timeResolution * (far + std::abs(time) * speed);
}

// Nothing but `met` touches it.
bool LineRally::isAlone(std::size_t ball, const Meeting& met) const {
    for (const std::size_t m : balls[ball].meetings) {
        const Meeting& meeting = meetings[m];
        if (&meeting == &met)
            continue;
        const double tolerance = toleranceOf(meeting, met.time), place = now_[meeting.ball].place;
        const double radius = balls[meeting.ball].flight.radius;
        if (meeting.isStanding) {
            if (!(meeting.plane.above(place) - radius > tolerance))
                return false;
            continue;
        }
        const double apart = place - now_[meeting.other].place,
                     far = radius + balls[meeting.other].flight.radius + tolerance;
        if (!(apart * apart > far * far))
            return false;
    }
    return true;
}

// As flightContact() and pushOf() of a CollisionSource.
std::optional<LineRally::Contact> LineRally::contactOf(const Meeting& met) {
    if (!areHome(met.time) || !isAlone(met.ball, met) ||
        (!met.isStanding && !isAlone(met.other, met)))
        return std::nullopt;
    const LineFlight& ball = balls[met.ball].flight;
    const double place = now_[met.ball].place;
    Contact contact;
    auto& [v, w] = contact.before;
    v = ball.velocity;
    if (met.isStanding) {
        contact.gap = met.plane.above(place) - ball.radius;
    } else {
        const LineFlight& other = balls[met.other].flight;
        const double p = place - now_[met.other].place;
        if ((p > 0 ? 1 : -1) != met.normal)
            return std::nullopt;
        contact.gap = std::abs(p) - (ball.radius + other.radius);
        w = other.velocity;
    }
    const double speeds = std::abs(v) + std::abs(w), speed = met.normal * (v - w);
    if (std::abs(contact.gap) > toleranceOf(met, met.time) || met.restitution == 0 ||
        !(speed < -approachThreshold * speeds))
        return std::nullopt;
    const double one = met.inverseBall, other = met.inverseOther;
    contact.impulse = physics::centralImpulse(speed, met.restitution, one + other);
    contact.then = {v + (contact.impulse * one) * met.normal,
                    w + (-contact.impulse * other) * met.normal};
    const bool isClear = met.restitution * -speed > 2 * approachThreshold * (speeds - 2 * speed);
    contact.isForGood = isClear && contact.gap > -deep * ball.radius;
    if (contact.then == contact.before || !collision::isPlain(contact.then[0]) ||
        !collision::isPlain(contact.then[1]))
        return std::nullopt;
    return contact;
}

bool LineRally::predict(Meeting& meeting, double time) {
    const Ball& ball = balls[meeting.ball];
    meeting.time = infinity;
    if (meeting.isStanding && staysBeyond(ball.flight, meeting, room_))
        return true;
    const FlightMeeting met =
        meeting.isStanding
            ? collision::meetingOnLine(ball.flight, meeting.plane, ball.until)
            : collision::meetingOnLine(ball.flight, balls[meeting.other].flight, time);
    if (met.kind == FlightMeeting::Kind::none && !meeting.isStanding &&
        partBeyond(ball.flight, balls[meeting.other].flight))
        return true;
    if (met.kind == FlightMeeting::Kind::hit)
        meeting.time = met.time;
    meeting.isNear = true;
    ++tests_;
    return met.kind != FlightMeeting::Kind::unclear;
}

bool LineRally::turned(const Meeting& met, const Contact& contact) {
    const double time = met.time; // its own will be the next time
    const std::array<std::size_t, 2> two{met.ball, met.other};
    const std::size_t count = met.isStanding ? 1 : 2;
    for (std::size_t i = 0; i < count; ++i) {
        Ball& ball = balls[two[i]];
        ball.flight.from = time;
        ball.flight.place = now_[two[i]].place;
        ball.flight.velocity = contact.then[i];
        ball.hasTurned = true;
        ball.until = time + EncounterSearch::firstSpan;
    }
    const std::size_t tests = tests_;
    bool tells = true;
    for (std::size_t i = 0; i < count; ++i)
        for (const std::size_t m : balls[two[i]].meetings) {
            Meeting& meeting = meetings[m];
            if (&meeting != &met)
                tells = predict(meeting, time) && tells;
            else if (i == 0 && contact.isForGood)
                meeting.time = infinity;
            else if (i == 0)
                tells = predict(meeting, time) && tells;
        }
    if (!tells)
        tests_ = tests;
    return tells;
}

} // namespace simulation
