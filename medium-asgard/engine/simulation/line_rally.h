// A rally (rally.h) of balls in straight flight on one line along an axis, such as a row of balls
// between two walls: one coordinate of all vectors, and nothing else that only space needs.
//
//     lineUp()               once
//     take()                 what the rally knows; then hit after hit:
//         next(), contactOf(), turned()
//     giveBack()             before anything else is asked of the rally
//
// All numbers are those in space: what is 0 across the line adds nothing to a sum, and the length
// of a vector along an axis is its coordinate's. What is not plain on the line is answered there.
#pragma once

#include "simulation/rally.h"

#include <array>
#include <optional>
#include <vector>

namespace simulation {

class LineRally {
public:
    struct Ball {
        collision::LineFlight flight;
        double least = 0, most = 0; // of the line, in its cell
        double until = 0;           // as in Rally
        bool hasTurned = false;
        std::vector<std::size_t> meetings;
    };
    struct Meeting { // as in Rally, and at the same place in the list
        std::size_t ball = 0, other = 0;
        bool isStanding = false, isNear = false;
        double time = 0;
        collision::LineFace plane;                // of what stands
        double least = 0, most = 0, farthest = 0; // coordinates: of its box, its own largest one
        double touching = 0, restitution = 0;     // the least tolerance of contact
        double inverseBall = 0, inverseOther = 0; // masses
        double normal = 0;                        // to the ball: 1 or -1
    };
    struct Contact {
        double gap = 0, impulse = 0;
        std::array<double, 2> before{}, then{}; // velocities: of the ball, and of the other
        bool isForGood = false;                 // they will part for ever
    };

    std::size_t axis = 0;
    std::vector<Ball> balls;
    std::vector<Meeting> meetings;

    // False: they are not on a line. `room` as in Rally::turned().
    [[nodiscard]] bool lineUp(const Rally& rally, double room);
    void take(const Rally& rally);
    void giveBack(Rally& rally) const;

    // The earliest, unless something else happens before.
    [[nodiscard]] const Meeting* next() const;
    // None: they do not push each other, or what is not plain; or somebody left its cell.
    [[nodiscard]] std::optional<Contact> contactOf(const Meeting& met);
    // Where a ball is at the time of the contact.
    [[nodiscard]] double& place(std::size_t ball) { return now_[ball].place; }
    // Both, or the one ball, go on from there as in contact.then. False: some next meeting is not
    // plain, and those of both are still to be told.
    [[nodiscard]] bool turned(const Meeting& met, const Contact& contact);

private:
    [[nodiscard]] bool isOnLine(const Rally& rally, const Rally::Ball& ball) const;
    [[nodiscard]] bool isAcrossLine(const Rally& rally, const Rally::Meeting& meeting);
    [[nodiscard]] double toleranceOf(const Meeting& meeting, double time) const;
    [[nodiscard]] bool areHome(double time);
    [[nodiscard]] bool isAlone(std::size_t ball, const Meeting& met) const;
    [[nodiscard]] bool predict(Meeting& meeting, double time);

    double room_ = 0, others_ = 0; // when something happens to anybody else
    std::size_t tests_ = 0;
    struct Now { // at the contact that is looked at
        double place = 0, speed = 0;
        double farthest = 0; // coordinate
    };
    std::array<Now, Rally::mostBalls> now_{};
};

} // namespace simulation
