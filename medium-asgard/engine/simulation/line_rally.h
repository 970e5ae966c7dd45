// A rally (rally.h) of balls in straight flight on one line along an axis, such as a row of balls
// between two walls: one coordinate of all vectors, and nothing else that only space needs.
//
//     lineUp()         once
//     take()           what the rally knows
//     play()           hit after hit; hits() and impacts() are what it did, until forgetHits()
//     giveBack()       before anything else is asked of the rally
//
// All numbers are those in space: what is 0 across the line adds nothing to a sum, and the length
// of a vector along an axis is its coordinate's. The rally in space answers all else.
#pragma once

#include "simulation/impacts.h"
#include "simulation/rally.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace simulation {

class LineRally {
public:
    struct Meeting;
    struct Ball { // as in Rally, and at the same place in the list
        collision::LineFlight flight;
        double least = 0, most = 0; // of the line, in its cell
        double until = 0;
        bool hasTurned = false;
        std::vector<Meeting*> meetings;
        std::size_t unknown = 0; // its velocity along the axis
        // At the hit that is looked at:
        double place = 0, speed = 0, farthest = 0; // the last a coordinate
    };
    struct Meeting {                            // as well
        Ball *ball = nullptr, *other = nullptr; // none: it is with what stands
        double time = 0;
        bool isNear = false;
        collision::LineFace plane;                // of what stands
        double least = 0, most = 0, farthest = 0; // coordinates: of its box, its own largest one
        double touching = 0, restitution = 0;     // the least tolerance of contact
        double inverseBall = 0, inverseOther = 0; // masses
        double normal = 0;                        // to the ball: 1 or -1
    };

    std::size_t axis = 0;
    std::vector<Ball> balls;
    std::vector<Meeting> meetings;
    double time = 0; // of the last hit

    LineRally() = default;
    LineRally(const LineRally&) = delete; // its balls and meetings refer to each other
    LineRally& operator=(const LineRally&) = delete;
    LineRally(LineRally&&) = delete;
    LineRally& operator=(LineRally&&) = delete;
    ~LineRally() = default;

    // False: they are not on a line. `room` as in Rally::turned().
    [[nodiscard]] bool lineUp(const Rally& rally, double room);
    void take(const Rally& rally);
    void giveBack(Rally& rally) const;

    // Of a hit after which some next meeting is not plain: those of both are still to be told.
    struct Unclear {
        std::size_t meeting = 0;
        bool isForGood = false; // they will part for ever
    };
    // At most so many hits, until that time, as long as they are plain, nobody left its cell and
    // those who are hit turned before. `turns` gives the velocities.
    [[nodiscard]] std::optional<Unclear> play(double until, std::size_t most,
                                              const solution::Turns& turns);
    [[nodiscard]] const solution::LineHits& hits() const { return hits_; }
    [[nodiscard]] std::span<const LineImpact> impacts() const { return impacts_; }
    void forgetHits();

private:
    struct Contact {
        double gap = 0, impulse = 0;
        std::array<double, 2> then{}; // velocities: of the ball, and of the other
        std::array<bool, 2> jumps{};
        bool isForGood = false;
    };
    [[nodiscard]] bool isOnLine(const Rally& rally, const Rally::Ball& ball) const;
    [[nodiscard]] bool isAcrossLine(const Rally& rally, const Rally::Meeting& meeting);
    void link(const Rally& rally);
    [[nodiscard]] bool areHome(double at);
    [[nodiscard]] static double toleranceOf(const Meeting& meeting, double at);
    [[nodiscard]] static bool isAlone(const Ball& ball, const Meeting& met);
    [[nodiscard]] bool isPlain(const Meeting& met, Contact& contact);
    void note(const Meeting& met, const Contact& contact);
    void turn(Ball& ball, double velocity);
    [[nodiscard]] bool renew(Meeting& met, bool isForGood);
    [[nodiscard]] bool predict(Meeting& meeting);

    double room_ = 0, others_ = 0; // when something happens to anybody else
    std::size_t tests_ = 0;
    solution::LineHits hits_;
    std::vector<LineImpact> impacts_;
};

} // namespace simulation
