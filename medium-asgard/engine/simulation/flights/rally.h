// Balls in flight that meet nobody but each other and what stands still, hit after hit.
//
// A rally begins when a hit turned two balls, and all that they, and those near them, may meet
// while they stay in their cells are a few such balls and faces that stand still. It goes on until
// the first of: one leaves its cell; anything happens to anybody else; a hit that is not settled on
// the spot (encounters.cpp answers those). Until then each pair keeps the one time at which it
// meets next, and a hit renews those of the balls that it turned. There are no windows, boxes,
// neighbours or queue to keep, which are most of what a hit costs otherwise.
//
//     gather()            the balls and their next meetings leave the search
//     next(), turned()    hit after hit
//     dissolve()          the search knows all as if it had done each hit itself
//
// The numbers are those of the search, bit by bit: the formulas are the same, of the same flights.
// So nobody need know when a rally begins or ends, and others that end one change no bit of it.
// LIMIT: the meetings of a rally are looked through one by one, so its balls are few.
#pragma once

#include "collision/ball_cells.h"
#include "collision/ball_flight.h"
#include "collision/broad_phase.h"
#include "flights/flight_meetings.h"
#include "solution/event_source.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace simulation {

class Rally {
public:
    using Pair = collision::Pair; // of bodies, the lesser first
    static constexpr std::size_t mostBalls = 6, mostStanding = 8;

    struct Ball {
        std::size_t body = 0;
        collision::BallFlight flight;
        geometry::Box cell; // it stays there, which is looked at when somebody turns,
        double until = 0;   // and until then at most
        bool hasTurned = false, isStraight = true;
        solution::Turn turn = {};          // whose unknowns these are
        std::vector<std::size_t> meetings; // that it has a part in

        void fly(const solution::Turn& turned, double from);
    };
    struct Standing { // somebody fixed with flat faces
        std::size_t body = 0;
        std::span<const collision::StandingPart> parts;
        geometry::Box box; // with some room
    };
    struct Meeting {
        Pair pair;
        std::size_t ball = 0, other = 0; // a ball, or with isStanding what stands
        bool isStanding = false, isNear = false;
        double time = 0; // infinity: none
    };

    std::vector<Ball> balls;
    std::vector<Standing> standing;
    std::vector<Meeting> meetings; // in order of pairs
    double others = 0;             // when something happens to anybody else
    std::size_t tests = 0;

    void clear();
    // In a list of Ball or Standing; its size: not there.
    template <class Member>
    [[nodiscard]] static std::size_t indexOf(const std::vector<Member>& list, std::size_t body) {
        return static_cast<std::size_t>(std::ranges::find(list, body, &Member::body) -
                                        list.begin());
    }
    // Puts the meetings in order, and tells each ball its own.
    void shareMeetings();
    // The earliest meeting; null: none before something else happens.
    [[nodiscard]] const Meeting* next() const;
    // All were in their cells up to a time: straight ways leave what is convex but once.
    [[nodiscard]] bool areHome(double time) const;
    // Both, or the one ball, have new flights from now on; `parted`: these two part for ever.
    // False: formulas do not tell whom they meet next; then their meetings are unknown.
    [[nodiscard]] bool turned(const Meeting& met, double time, bool parted,
                              const collision::BallCells& cells, double room);
    void forgetMeetings(const Meeting& met); // of both
    // Whether a rally is worth a try after this hit: the more often it was not, the less often.
    [[nodiscard]] bool isDue() { return ++waited_ > wait_; }
    void tried(std::size_t hits);

private:
    [[nodiscard]] bool predict(Meeting& meeting, double time, double room);

    static constexpr std::size_t shortWait = 4, longWait = 1024;
    std::size_t waited_ = 0, wait_ = shortWait;
};

// The next of a rally's meetings, before anything happens to anybody else (`others`) or a ball is
// no longer known; of equal times the least pair. Null: none.
template <class Balls, class Meetings>
[[nodiscard]] auto nextMeeting(const Balls& balls, Meetings& meetings, double others) {
    decltype(meetings.data()) first = nullptr;
    double time = others;
    for (const auto& ball : balls)
        time = std::min(time, ball.until);
    for (auto& meeting : meetings)
        if (meeting.time < time) {
            time = meeting.time;
            first = &meeting;
        }
    return first;
}

} // namespace simulation
