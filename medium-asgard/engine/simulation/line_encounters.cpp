// Impacts in a rally on a line, where nothing else touches: ball_encounters.cpp in one coordinate.
// They are played in blocks, as far as the solver promised to do them, and told afterwards.
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
    for (std::size_t b = 0; b < rally_.balls.size(); ++b) {
        flights_.push_back(rally_.balls[b].turn);
        line_.balls[b].unknown = flights_[b].velocities[line_.axis];
    }
    line_.forgetHits();
    for (std::size_t m = 0; m < line_.meetings.size(); ++m) {
        LineRally::Meeting& meeting = line_.meetings[m];
        const Rally::Meeting& inSpace = rally_.meetings[m];
        const Rally::Ball& ball = rally_.balls[inSpace.ball];
        const std::size_t body = ball.body, other = inSpace.pair.first == body ? inSpace.pair.second
                                                                               : inSpace.pair.first;
        meeting.touching =
            collision::touchingGap * (records_[body].radius + records_[other].radius);
        meeting.restitution = restitutionOf(inSpace.pair);
        meeting.inverseBall = 1 / records_[body].mass;
        meeting.inverseOther = 1 / records_[other].mass;
        if (inSpace.isStanding)
            meeting.farthest = records_[other].start.position.cwiseAbs().maxCoeff();
        Vector normal = Vector::Zero();
        normal[static_cast<Eigen::Index>(line_.axis)] = meeting.normal;
        if (inSpace.isStanding)
            normal = rally_.standing[inSpace.other].parts[0].facing(ball.flight.place).plane.normal;
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

// The solver, the list of impacts and all that counts meetings are told of what was played.
void CollisionSource::tellHits() {
    if (line_.impacts().empty())
        return;
    turns_->turn(line_.hits(), flights_, line_.axis);
    impacts_.add(impactLine_, line_.impacts());
    for (const LineImpact& impact : line_.impacts()) {
        const Rally::Meeting& met = rally_.meetings[impact.pair];
        const std::size_t ball = rally_.balls[met.ball].body;
        if (met.isStanding) {
            meetings_[ball].add(rally_.standing[met.other].body, false, impact.time);
        } else {
            const std::size_t other = rally_.balls[met.other].body;
            meetings_[ball].add(other, true, impact.time);
            meetings_[other].add(ball, true, impact.time);
        }
    }
    line_.forgetHits();
}

// So many hits need no answer but that of the line.
std::size_t CollisionSource::plainHits() {
    std::size_t most = 64; // until somebody may cancel
    for (const Rally::Ball& ball : rally_.balls)
        most = std::min(most, plainMeetings(ball.body));
    return std::min(most, turns_->promisedHits(flights_, line_.axis));
}

void CollisionSource::rallyOnLine(double until, Course& course) {
    line_.take(rally_);
    line_.time = course.time;
    std::optional<LineRally::Unclear> unclear;
    bool goesOn = true;
    while (goesOn) {
        const std::size_t most = plainHits();
        unclear = line_.play(until, most, *turns_);
        const std::size_t played = line_.impacts().size();
        course.hits += played;
        tellHits();
        if (cancelled_ && cancelled_())
            course.state = Rallied::isOver;
        goesOn = !unclear && played > 0 && played == most && course.state == Rallied::goesOn;
    }
    course.time = line_.time;
    line_.giveBack(rally_);
    if (unclear && course.state == Rallied::goesOn) {
        course.last = &rally_.meetings[unclear->meeting];
        if (!search_.turned(rally_, *course.last, course.time, unclear->isForGood))
            course.state = Rallied::isUnclear;
    }
}

} // namespace simulation
