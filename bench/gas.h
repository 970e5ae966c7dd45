// S4: elastic balls of radius 0.05 and mass 1 in the box [-1, 1]^3, from a grid, with velocities
// that are uniform in +-sqrt(3) in each axis; and the exact motion of them, event by event.
//
// Each ball keeps its own time, the first hit that is known for it, and when it leaves its cell
// (at the box's sides: hits the wall); a tournament finds who is next (Rapaport 1980, Lubachevsky
// 1991). A ball whose partner was hit by another looks for a new one when the hit was due. One cell
// is the method without cells.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace bench {

struct GasStart {
    std::array<double, 3> position, velocity;
};
inline constexpr double gasRadius = 0.05;
[[nodiscard]] std::vector<GasStart> gasOf(int perEdge); // 8: 512 balls

class Gas {
public:
    Gas(const std::vector<GasStart>& balls, int cellsPerEdge);

    void runTo(double time);
    [[nodiscard]] std::vector<std::array<double, 3>> positions(double time) const;
    [[nodiscard]] double energy() const;
    [[nodiscard]] long hits() const { return hits_; }
    [[nodiscard]] long wallHits() const { return wallHits_; }
    [[nodiscard]] long crossings() const { return crossings_; }

private:
    struct Ball {
        double x[3], v[3], t;
        int cell[3], next, previous;
    };
    void advance(int i, double t);
    void enter(int i);
    void leave(int i);
    void findCrossing(int i);
    void consider(int i, int cell, int& best, double& soonest) const;
    void seek(int i, const int (&low)[3], const int (&high)[3]);
    void seekEverywhere(int i);
    void pair(int i, int j, double t);
    void release(int i);
    void collide(int i);
    void cross(int i);
    void update(int i);
    [[nodiscard]] int cellOf(int a, int b, int c) const { return (a * cells_ + b) * cells_ + c; }

    int cells_;
    double edge_;
    std::vector<Ball> balls_;
    std::vector<int> first_; // of each cell
    std::vector<double> hitAt_, crossAt_, key_;
    std::vector<int> partner_, crossAxis_;
    std::vector<int> winner_; // tournament
    std::size_t leaves_ = 1;
    long hits_ = 0, wallHits_ = 0, crossings_ = 0;
};

// Half of the distances from where the balls should be are shorter.
[[nodiscard]] double medianDistance(std::vector<std::array<double, 3>> a,
                                    const std::vector<std::array<double, 3>>& b);

} // namespace bench
