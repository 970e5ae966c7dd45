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
//
// Balls in straight flight on one line along an axis, between faces across it, need one coordinate
// of all vectors (line_rally.cpp). What is not plain there is asked of the formulas in space.
#pragma once

#include "collision/ball_cells.h"
#include "collision/ball_flight.h"
#include "collision/broad_phase.h"
#include "collision/time_of_impact.h"
#include "solution/event_source.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace simulation {

// Of hits in flight, in a rally and outside.
namespace flight_hits {
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
inline constexpr double timeResolution = 8 * epsilon;
inline constexpr double deep = 400 * epsilon; // of the radius
} // namespace flight_hits

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
        double aside = 0;                  // its largest coordinate across the line

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

        // On a line:
        const collision::StandingFace* face = nullptr; // that it is over
        collision::LineFace plane;                     // of it
        double farthest = 0;                           // coordinate of what stands
        double touching = 0, restitution = 0;          // the least tolerance of contact
        double inverseFirst = 0, inverseSecond = 0;    // masses
    };
    static constexpr std::size_t noAxis = 3;

    std::vector<Ball> balls;
    std::vector<Standing> standing;
    std::vector<Meeting> meetings; // in order of pairs
    double others = 0;             // when something happens to anybody else
    std::size_t axis = noAxis;     // along which the line is that all are on
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
    // Finds the line that all are on, if there is one.
    void lineUp();
    [[nodiscard]] collision::LineFlight onLine(const Ball& ball) const {
        const auto a = static_cast<Eigen::Index>(axis);
        const collision::BallFlight& flight = ball.flight;
        return {flight.from, flight.place[a], flight.velocity[a], flight.radius, ball.aside};
    }
    // As areHome() and turned().
    [[nodiscard]] bool areHomeOnLine(double time) const;
    [[nodiscard]] bool turnedOnLine(const Meeting& met, double time, bool parted, double room);
    // Whether a rally is worth a try after this hit: the more often it was not, the less often.
    [[nodiscard]] bool isDue() { return ++waited_ > wait_; }
    void tried(std::size_t hits);

private:
    // When the two, or the one, meet next, told by predict(meeting). False: formulas do not tell.
    template <class Predict>
    [[nodiscard]] bool tellNext(const Meeting& met, bool parted, const Predict& predict);
    [[nodiscard]] bool predict(Meeting& meeting, double time, double room);
    [[nodiscard]] bool predictOnLine(Meeting& meeting, double time, double room);
    [[nodiscard]] bool isOnLine(Ball& ball) const;
    [[nodiscard]] bool isAcrossLine(Meeting& meeting) const;

    static constexpr std::size_t shortWait = 4, longWait = 1024;
    std::size_t waited_ = 0, wait_ = shortWait;
};

template <class Predict>
bool Rally::tellNext(const Meeting& met, bool parted, const Predict& predict) {
    bool tells = true;
    for (const std::size_t m : balls[met.ball].meetings) {
        if (&meetings[m] == &met && parted)
            meetings[m].time = std::numeric_limits<double>::infinity();
        else
            tells = tells && predict(meetings[m]);
    }
    if (!met.isStanding)
        for (const std::size_t m : balls[met.other].meetings)
            if (&meetings[m] != &met)
                tells = tells && predict(meetings[m]);
    return tells;
}

} // namespace simulation
