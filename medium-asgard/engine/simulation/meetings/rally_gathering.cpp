#include "meetings/rally_gathering.h"

#include <algorithm>

namespace simulation {
namespace {

using solution::infinity;

class Gathering {
public:
    Gathering(EncounterSearch& search, Rally& rally) : search_(search), rally_(rally) {}

    // The balls, and who stands where they may come to; false: somebody else may.
    [[nodiscard]] bool addAll(const Pair& pair) {
        for (const std::size_t body : {pair.first, pair.second})
            if (!isFixed(body) && !join(body))
                return false;
        for (std::size_t b = 0; b < rally_.balls.size(); ++b) // they become more meanwhile
            if (!addBallsNear(rally_.balls[b].body) || !addStanding(b))
                return false;
        rally_.shareMeetings();
        return true;
    }
    // The hits that were found; false: one that a rally does not know.
    [[nodiscard]] bool takeHits() {
        const auto isIn = [&](std::size_t body) {
            return Rally::indexOf(rally_.balls, body) < rally_.balls.size();
        };
        return search_.hits().allOf([&](const Found& hit) {
            if (!isIn(hit.pair.first) && !isIn(hit.pair.second))
                return true;
            const auto meeting =
                std::ranges::find(rally_.meetings, hit.pair, &Rally::Meeting::pair);
            if (meeting == rally_.meetings.end() || hit.pressing || hit.isLost)
                return false;
            meeting->time = std::min(meeting->time, hit.time);
            return true;
        });
    }

private:
    [[nodiscard]] bool isFixed(std::size_t body) const { return search_.isFixed(body); }

    // False: it cannot be followed in a rally, or there is no room for it.
    [[nodiscard]] bool join(std::size_t body) {
        if (Rally::indexOf(rally_.balls, body) < rally_.balls.size())
            return true;
        if (rally_.balls.size() == Rally::mostBalls || !search_.canRally(body))
            return false;
        const EncounterSearch::Window& window = search_.window(body);
        rally_.balls.push_back({.body = body,
                                .flight = window.flight,
                                .cell = search_.near().cells.cell(body),
                                .until = window.until,
                                .isStraight = window.flight.half.isZero(0),
                                .meetings = {}});
        return true;
    }
    // The balls that may come near one of the rally's, each a ball of it from now on.
    [[nodiscard]] bool addBallsNear(std::size_t body) {
        for (const std::uint32_t near : search_.near().cells.near(body)) {
            if (!search_.near().mayMeet(body, near))
                continue;
            if (!join(near))
                return false;
            const Pair both = std::minmax(body, std::size_t{near});
            if (std::ranges::find(rally_.meetings, both, &Rally::Meeting::pair) ==
                rally_.meetings.end())
                rally_.meetings.push_back({.pair = both, .time = infinity});
        }
        return true;
    }
    // Who stands where a ball of the rally may come to.
    [[nodiscard]] bool addStanding(std::size_t ball) {
        const std::size_t body = rally_.balls[ball].body;
        for (const std::size_t partner : search_.near().partners(body)) {
            if (!isFixed(partner) || search_.standing(partner).empty())
                return false;
            const std::size_t s = Rally::indexOf(rally_.standing, partner);
            if (s == Rally::mostStanding)
                return false;
            if (s == rally_.standing.size())
                rally_.standing.push_back({.body = partner,
                                           .parts = search_.standing(partner),
                                           .box = search_.box(partner)});
            rally_.meetings.push_back({.pair = std::minmax(body, partner),
                                       .ball = ball,
                                       .other = s,
                                       .isStanding = true,
                                       .time = infinity});
        }
        return true;
    }

    EncounterSearch& search_;
    Rally& rally_;
};

} // namespace

bool gather(EncounterSearch& search, const Pair& pair, Rally& rally) {
    rally.clear();
    Gathering gathering(search, rally);
    if (!search.mayAnyRally() || !gathering.addAll(pair) || !gathering.takeHits())
        return false;
    for (const Rally::Ball& ball : rally.balls)
        search.leave(ball.body);
    rally.others = search.next().time;
    return true;
}

void dissolve(const Rally& rally, EncounterSearch& search) { search.comeBack(rally); }

} // namespace simulation
