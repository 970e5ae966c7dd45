// Turns of what flies: the same motion as by events, on the spot.
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace solution;
using namespace solution::testing;

namespace {

enum Unknowns : std::size_t { x, y, z, dx, dy, dz };

expression::EquationSet flight(std::vector<Line> more = {}) {
    std::vector<Line> lines{{"x", "dx", 1, 1}, {"y", "dy", 2, 1}, {"z", "dz", 0, 1},
                            {"dx", "0", 3},    {"dy", "-10", 1},  {"dz", "0", 0}};
    lines.insert(lines.end(), more.begin(), more.end());
    return equationsOf(lines);
}

struct Kick {
    double time = 0;
    std::array<double, 3> velocity{};
};
const std::vector<Kick> kicks{{0.3, {1, 4, 0}},  {0.7, {-2, 4, 0}}, {0.7, {-2, 5, 0}},
                              {1.1, {-2, 1, 0}}, {1.9, {3, 7, 0}},  {2.5, {0, 2, 0}}};

// Gives these velocities at these times; by a turn where `byTurn` says so and the solver agrees.
class Kicks final : public EventSource {
public:
    Kicks(std::vector<Kick> list, std::function<bool(std::size_t)> byTurn)
        : list_(std::move(list)), byTurn_(std::move(byTurn)) {}

    void use(Turns& turns) override { turns_ = &turns; }
    std::optional<Event> next(const Histories& /*histories*/, double known) override {
        for (; done_ < list_.size() && list_[done_].time <= known; ++done_) {
            const Kick& kick = list_[done_];
            Turn turn{.places = {x, y, z},
                      .velocities = {dx, dy, dz},
                      .jumps = {true, true, true},
                      .place = {},
                      .velocity = kick.velocity};
            if (!byTurn_(done_) || !turns_->turn(kick.time, {&turn, 1})) {
                ++done_;
                return Event{kick.time, {dx, dy, dz}, 0};
            }
            places.push_back(turn.place);
        }
        return std::nullopt;
    }
    void apply(const Histories& /*histories*/, const Event& /*event*/, EquationsInForce& /*set*/,
               Changes& changes) override {
        for (std::size_t k = 0; k < 3; ++k)
            changes.jumps.push_back({dx + k, list_[done_ - 1].velocity[k]});
    }

    std::vector<std::array<double, 3>> places; // of turns

private:
    std::vector<Kick> list_;
    std::function<bool(std::size_t)> byTurn_;
    Turns* turns_ = nullptr;
    std::size_t done_ = 0;
};

TEST(Flights, ATurnIsTheEventThatItReplaces) {
    Kicks events(kicks, [](std::size_t) { return false; });
    const Solver right = solved(flight(), 3, {}, &events);
    for (const int every : {1, 2, 3}) {
        Kicks turns(kicks, [every](std::size_t i) { return i % every == 0; });
        const Solver turned = solved(flight(), 3, {}, &turns);
        const Histories &a = right.histories(), &b = turned.histories();
        EXPECT_EQ(turned.statistics().events, kicks.size());
        EXPECT_EQ(turns.places.size(), (kicks.size() + every - 1) / every);
        for (std::size_t u = x; u <= dz; ++u) {
            EXPECT_EQ(b.reached(u), infinity);
            EXPECT_LE(b.restarts(u).size(), kicks.size());
            for (int i = 0; i <= 300; ++i) {
                const double t = 0.01 * i;
                EXPECT_EQ(b.value(u, t), a.value(u, t)) << u << " at " << t;
                EXPECT_EQ(b.derivative(u, t), a.derivative(u, t)) << u << " at " << t;
            }
            for (const Kick& kick : kicks)
                EXPECT_EQ(b.pieceBefore(u, kick.time).value(kick.time),
                          a.pieceBefore(u, kick.time).value(kick.time));
        }
        EXPECT_EQ(turns.places[0][0], b.value(x, kicks[0].time));
        if (every == 1) {
            EXPECT_LT(turned.statistics().historyBytes, right.statistics().historyBytes);
        }
    }
}

// A snapshot keeps what it shows while turns go on.
TEST(Flights, ASnapshotStaysAsItIs) {
    Kicks turns(kicks, [](std::size_t) { return true; });
    Solver solver(flight(), {}, &turns);
    (void)solver.advanceTo(1);
    const auto then = solver.snapshot();
    const double before = then->value(y, 0.9);
    (void)solver.advanceTo(3);
    EXPECT_EQ(then->value(y, 0.9), before);
    EXPECT_EQ(solver.histories().value(y, 0.9), before);
    EXPECT_EQ(turns.places.size(), kicks.size());
}

TEST(Flights, WhatIsReadOrLeavesItsPlaneNeedsAnEvent) {
    Kicks read(kicks, [](std::size_t) { return true; });
    const Solver watched = solved(flight({{"seen", "x", 0}}), 3, {}, &read);
    EXPECT_TRUE(read.places.empty());
    EXPECT_EQ(watched.statistics().events, kicks.size());

    std::vector<Kick> outwards = kicks;
    outwards[3].velocity[2] = 1;
    for (std::size_t i = 4; i < outwards.size(); ++i)
        outwards[i].velocity[2] = 1;
    Kicks leaves(outwards, [](std::size_t) { return true; });
    const Solver left = solved(flight(), 3, {}, &leaves);
    EXPECT_EQ(leaves.places.size(), kicks.size() - 1);
    EXPECT_NEAR(left.histories().value(z, 3), 3 - outwards[3].time, 1e-14);
    EXPECT_EQ(left.histories().value(z, 1), 0);
}

} // namespace
