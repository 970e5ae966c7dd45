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

// The side of the second ball on which the first one is. Balls in a row never change sides.
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
             .meetings = {}});
    }
    for (const Rally::Meeting& meeting : rally.meetings) {
        meetings.emplace_back();
        if (meeting.isStanding && !isAcrossLine(rally, meeting))
            return false;
        if (!meeting.isStanding)
            meetings.back().normal =
                sideOf(rally.balls[meeting.ball].flight, rally.balls[meeting.other].flight, a);
    }
    link(rally);
    return true;
}

// From then on neither list moves.
void LineRally::link(const Rally& rally) {
    for (std::size_t m = 0; m < meetings.size(); ++m) {
        const Rally::Meeting& inSpace = rally.meetings[m];
        meetings[m].ball = &balls[inSpace.ball];
        meetings[m].other = inSpace.isStanding ? nullptr : &balls[inSpace.other];
    }
    for (std::size_t b = 0; b < balls.size(); ++b)
        for (const std::size_t m : rally.balls[b].meetings)
            balls[b].meetings.push_back(&meetings[m]);
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

inline bool LineRally::areHome(double at) {
    bool are = true;
    for (Ball& ball : balls) {
        ball.place = ball.flight.at(at);
        ball.speed = std::abs(ball.flight.velocity);
        ball.farthest = ball.flight.farthest(ball.place);
        are = are && (!ball.hasTurned || (ball.place >= ball.least && ball.place <= ball.most));
    }
    return are;
}

inline double LineRally::toleranceOf(const Meeting& meeting, double at) {
    double far = meeting.ball->farthest, speed = meeting.ball->speed;
    if (meeting.other) {
        far += meeting.other->farthest;
        speed += meeting.other->speed;
    } else {
        far += meeting.farthest;
    }
    return meeting.touching + timeResolution * (far + std::abs(at) * speed);
}

// Nothing but `met` touches it.
inline bool LineRally::isAlone(const Ball& ball, const Meeting& met) {
    for (const Meeting* meeting : ball.meetings) {
        if (meeting == &met)
            continue;
        const double tolerance = toleranceOf(*meeting, met.time);
        const Ball &first = *meeting->ball, *second = meeting->other;
        if (!second) {
            if (!(meeting->plane.above(first.place) - first.flight.radius > tolerance))
                return false;
            continue;
        }
        const double apart = first.place - second->place,
                     far = first.flight.radius + second->flight.radius + tolerance;
        if (!(apart * apart > far * far))
            return false;
    }
    return true;
}

// As flightContact() and pushOf() of a CollisionSource. False: they do not push each other, or what
// is not plain; or somebody left its cell.
inline bool LineRally::isPlain(const Meeting& met, Contact& contact) {
    const Ball &ball = *met.ball, *other = met.other;
    if (!areHome(met.time) || !isAlone(ball, met) || (other && !isAlone(*other, met)))
        return false;
    const double v = ball.flight.velocity, w = other ? other->flight.velocity : 0;
    if (other) {
        const double p = ball.place - other->place;
        if ((p > 0 ? 1 : -1) != met.normal)
            return false;
        contact.gap = std::abs(p) - (ball.flight.radius + other->flight.radius);
    } else {
        contact.gap = met.plane.above(ball.place) - ball.flight.radius;
    }
    const double speeds = std::abs(v) + std::abs(w), speed = met.normal * (v - w);
    if (std::abs(contact.gap) > toleranceOf(met, met.time) || met.restitution == 0 ||
        !(speed < -approachThreshold * speeds))
        return false;
    contact.impulse =
        physics::centralImpulse(speed, met.restitution, met.inverseBall + met.inverseOther);
    contact.then = {v + (contact.impulse * met.inverseBall) * met.normal,
                    w + (-contact.impulse * met.inverseOther) * met.normal};
    const bool isClear = met.restitution * -speed > 2 * approachThreshold * (speeds - 2 * speed);
    contact.isForGood = isClear && contact.gap > -deep * ball.flight.radius;
    contact.jumps = {contact.then[0] != v, contact.then[1] != w};
    return (contact.jumps[0] || contact.jumps[1]) && collision::isPlain(contact.then[0]) &&
           collision::isPlain(contact.then[1]);
}

inline void LineRally::note(const Meeting& met, const Contact& contact) {
    // From the ball to what stands, or from the other ball.
    const Ball& from = met.other ? *met.other : *met.ball;
    const double way = (from.flight.radius + contact.gap / 2) * met.normal;
    impacts_.push_back({.time = met.time,
                        .impulse = contact.impulse,
                        .place = met.other ? from.place + way : from.place - way,
                        .pair = static_cast<std::uint32_t>(&met - meetings.data())});
    hits_.times.push_back(met.time);
}

inline void LineRally::turn(Ball& ball, double velocity) {
    ball.flight.from = time;
    ball.flight.place = ball.place;
    ball.flight.velocity = velocity;
    ball.until = time + EncounterSearch::firstSpan;
    std::vector<solution::LineTurn>& turns =
        hits_.ofFlight[static_cast<std::size_t>(&ball - balls.data())];
    if (turns.empty() || turns.back().time < time)
        turns.emplace_back();
    turns.back() = {time, ball.place, velocity};
}

bool LineRally::predict(Meeting& meeting) {
    const LineFlight& flight = meeting.ball->flight;
    meeting.time = infinity;
    if (!meeting.other && staysBeyond(flight, meeting, room_))
        return true;
    const FlightMeeting met =
        meeting.other ? collision::meetingOnLine(flight, meeting.other->flight, time)
                      : collision::meetingOnLine(flight, meeting.plane, meeting.ball->until);
    if (met.kind == FlightMeeting::Kind::none && meeting.other &&
        partBeyond(flight, meeting.other->flight))
        return true;
    if (met.kind == FlightMeeting::Kind::hit)
        meeting.time = met.time;
    meeting.isNear = true;
    ++tests_;
    return met.kind != FlightMeeting::Kind::unclear;
}

// When both, or the one ball, meet whom next.
inline bool LineRally::renew(Meeting& met, bool isForGood) {
    const std::size_t tests = tests_;
    bool tells = true;
    if (isForGood)
        met.time = infinity;
    else
        tells = predict(met);
    for (const Ball* ball : {met.ball, met.other})
        for (std::size_t i = 0; ball && i < ball->meetings.size(); ++i)
            if (ball->meetings[i] != &met)
                tells = predict(*ball->meetings[i]) && tells;
    if (!tells)
        tests_ = tests;
    return tells;
}

std::optional<LineRally::Unclear> LineRally::play(double until, std::size_t most,
                                                  const solution::Turns& turns) {
    for (std::size_t played = 0; played < most; ++played) {
        Meeting* const met = nextMeeting(balls, meetings, others_);
        Contact contact;
        if (!met || met->time > until || met->time < time || !met->ball->hasTurned ||
            (met->other && !met->other->hasTurned) || !isPlain(*met, contact))
            break;
        time = met->time; // its own will be the next time
        note(*met, contact);
        for (std::size_t i = 0; i < (met->other ? 2 : 1); ++i) {
            Ball& ball = i == 0 ? *met->ball : *met->other;
            const double then = contact.then[i];
            turn(ball,
                 contact.jumps[i] ? turns.given(then, ball.unknown, time, ball.farthest) : then);
        }
        if (!renew(*met, contact.isForGood))
            return Unclear{static_cast<std::size_t>(met - meetings.data()), contact.isForGood};
    }
    return std::nullopt;
}

void LineRally::forgetHits() {
    impacts_.clear();
    hits_.times.clear();
    hits_.ofFlight.resize(balls.size());
    for (std::vector<solution::LineTurn>& turns : hits_.ofFlight)
        turns.clear();
}

} // namespace simulation
