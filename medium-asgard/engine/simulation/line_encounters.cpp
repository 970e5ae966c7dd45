// Impacts in a rally on a line, where nothing else touches: ball_encounters.cpp in one coordinate.
// The solver is told of hits in blocks, as far as it promised to do them.
#include "simulation/collision_source.h"

#include <algorithm>

namespace simulation {

using geometry::Vector;

bool CollisionSource::lineUp() {
    if (!line_.lineUp(rally_, search_.slack()))
        return false;
    auto line = std::make_shared<ImpactLine>();
    line->axis = line_.axis;
    flights_.clear();
    for (const Rally::Ball& ball : rally_.balls)
        flights_.push_back(ball.turn);
    for (std::size_t m = 0; m < line_.meetings.size(); ++m) {
        LineRally::Meeting& meeting = line_.meetings[m];
        const Rally::Meeting& inSpace = rally_.meetings[m];
        const Rally::Ball& ball = rally_.balls[meeting.ball];
        const std::size_t body = ball.body, other = inSpace.pair.first == body ? inSpace.pair.second
                                                                               : inSpace.pair.first;
        meeting.touching =
            collision::touchingGap * (records_[body].radius + records_[other].radius);
        meeting.restitution = restitutionOf(inSpace.pair);
        meeting.inverseBall = 1 / records_[body].mass;
        meeting.inverseOther = 1 / records_[other].mass;
        if (meeting.isStanding)
            meeting.farthest = records_[other].start.position.cwiseAbs().maxCoeff();
        Vector normal = Vector::Zero();
        normal[static_cast<Eigen::Index>(line_.axis)] = meeting.normal;
        if (meeting.isStanding)
            normal = rally_.standing[meeting.other].parts[0].facing(ball.flight.place).plane.normal;
        if (body != inSpace.pair.first)
            normal = -normal;
        line->ofPair.push_back({.first = inSpace.pair.first,
                                .second = inSpace.pair.second,
                                .point = ball.flight.place,
                                .normal = normal});
    }
    impactLine_ = std::move(line);
    return true;
}

// All that waits, and asks for more room.
void CollisionSource::tellHits() {
    constexpr std::size_t most = 64;
    if (!hits_.empty())
        turns_->turn(hits_, flights_, line_.axis);
    hits_.clear();
    promised_ = std::min(most, turns_->promisedHits(flights_, line_.axis));
}

void CollisionSource::rallyOnLine(double until, Course& course) {
    line_.take(rally_);
    tellHits();
    while (course.state == Rallied::goesOn) {
        const LineRally::Meeting* met = line_.next();
        if (!met || met->time > until || met->time < course.time)
            break;
        auto contact = line_.contactOf(*met);
        if (!contact)
            break;
        course.last = &rally_.meetings[static_cast<std::size_t>(met - line_.meetings.data())];
        course.time = met->time; // its own will be the next time
        course.state = meetOnLine(*met, *contact);
        if (++course.hits % 64 == 0 && cancelled_ && cancelled_())
            course.state = Rallied::isOver;
    }
    tellHits();
    line_.giveBack(rally_);
}

// As meetInRally().
CollisionSource::Rallied CollisionSource::meetOnLine(const LineRally::Meeting& met,
                                                     LineRally::Contact& contact) {
    const double time = met.time;
    const auto m = static_cast<std::size_t>(&met - line_.meetings.data());
    const std::size_t one = rally_.balls[met.ball].body;
    const std::size_t other =
        met.isStanding ? rally_.standing[met.other].body : rally_.balls[met.other].body;
    if (meetsWithoutEnd(one, other, !met.isStanding, time) ||
        (!met.isStanding && meetsWithoutEnd(other, one, true, time)))
        return Rallied::isEndless;
    // From the ball to what stands, or from the other ball.
    const std::size_t from = met.isStanding ? met.ball : met.other;
    const double way = (line_.balls[from].flight.radius + contact.gap / 2) * met.normal;
    const LineImpact impact{.time = time,
                            .impulse = contact.impulse,
                            .place =
                                met.isStanding ? line_.place(from) - way : line_.place(from) + way,
                            .pair = static_cast<std::uint32_t>(m)};
    if (!turnOnLine(met, contact))
        return Rallied::isRefused;
    impacts_.add(impactLine_, impact);
    if (line_.turned(met, contact))
        return Rallied::goesOn;
    line_.giveBack(rally_);
    const bool tells = search_.turned(rally_, rally_.meetings[m], time, contact.isForGood);
    line_.take(rally_);
    return tells ? Rallied::goesOn : Rallied::isUnclear;
}

// It waits to be told, or the solver is asked at once.
bool CollisionSource::turnOnLine(const LineRally::Meeting& met, LineRally::Contact& contact) {
    const std::array<std::size_t, 2> two{met.ball, met.other};
    const std::size_t count = met.isStanding ? 1 : 2;
    bool mayWait = hits_.size() < promised_;
    for (std::size_t i = 0; i < count; ++i)
        mayWait = mayWait && line_.balls[two[i]].hasTurned;
    if (mayWait) {
        solution::LineHit& hit = hits_.emplace_back();
        hit.time = met.time;
        for (std::size_t i = 0; i < count; ++i) {
            const double place = line_.place(two[i]);
            double& velocity = contact.then[i];
            if (velocity != contact.before[i])
                velocity = turns_->given(velocity, flights_[two[i]].velocities[line_.axis],
                                         met.time, line_.balls[two[i]].flight.farthest(place));
            hit.flights[i] = static_cast<std::uint32_t>(two[i]);
            hit.places[i] = place;
            hit.velocities[i] = velocity;
        }
        if (hits_.size() == promised_)
            tellHits();
        return true;
    }
    tellHits();
    std::array<solution::Turn, 2> turns;
    for (std::size_t i = 0; i < count; ++i) {
        turns[i] = flights_[two[i]];
        const Vector& place = rally_.balls[two[i]].flight.place;
        turns[i].place = {place[0], place[1], place[2]};
        turns[i].place[line_.axis] = line_.place(two[i]);
        turns[i].jumps[line_.axis] = contact.then[i] != contact.before[i];
        turns[i].velocity[line_.axis] = contact.then[i];
    }
    if (!turns_->turn(met.time, std::span(turns).first(count)))
        return false;
    for (std::size_t i = 0; i < count; ++i) {
        line_.place(two[i]) = turns[i].place[line_.axis];
        contact.then[i] = turns[i].velocity[line_.axis];
    }
    promised_ = 0; // until tellHits()
    tellHits();
    return true;
}

} // namespace simulation
