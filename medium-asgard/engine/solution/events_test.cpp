// Events from outside: cutting, restarting, new equations.
#include "solution/solver_testing.h"
#include "solution/strikes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace solution;
using namespace solution::testing;

namespace {

// A ball x with velocity v bounces at x = 0: the first root of x on its pieces after the last one.
class Bounce final : public EventSource {
public:
    Bounce(std::size_t x, std::size_t v, double restitution)
        : x_(x), v_(v), restitution_(restitution) {}

    std::optional<Event> next(const Histories& h, double known) override {
        ++asked;
        for (double t = from_; t < known;) {
            const Piece piece = h.piece(x_, t);
            const double end = std::min(piece.until, known);
            double low = t, high = end;
            if (piece.value(end) < 0 ||
                (piece.derivative(end) > 0 && lowest(piece, t, end, high) < 0)) {
                for (int k = 0; k < 200 && std::nextafter(low, high) < high; ++k) {
                    const double middle = 0.5 * (low + high);
                    (piece.value(middle) > 0 || middle <= from_ ? low : high) = middle;
                }
                from_ = high;
                return Event{high, {x_, v_}, 7};
            }
            t = end;
        }
        from_ = known;
        return std::nullopt;
    }

    void apply(const Histories& h, const Event& event, EquationsInForce& set,
               Changes& changes) override {
        EXPECT_EQ(event.tag, 7u);
        times.push_back(event.time);
        changes.jumps.push_back({x_, 0});
        const double speed = -restitution_ * h.pieceBefore(v_, event.time).value(event.time);
        changes.jumps.push_back({v_, speed});
        if (speed > restSpeed)
            return;
        // It comes to rest: from now on nothing moves it.
        expression::Phase rest;
        rest.derivative = set.changing().graph.constant(0);
        changes.equations.push_back({v_, rest, {}});
        changes.jumps.back().value = 0;
        from_ = infinity;
    }

    std::vector<double> times;
    std::size_t asked = 0;
    double restSpeed = 0;

private:
    static double lowest(const Piece& piece, double a, double b, double& where) {
        double best = infinity;
        for (int k = 0; k <= 50; ++k) {
            const double t = a + (b - a) * k / 50;
            if (piece.value(t) < best) {
                best = piece.value(t);
                where = t;
            }
        }
        return best;
    }
    std::size_t x_, v_;
    double restitution_, from_ = 0;
};

// Reports given times as events of given unknowns, and reverses them.
class Clock final : public EventSource {
public:
    Clock(std::vector<double> times, std::size_t unknown) : times_(std::move(times)), u_(unknown) {}
    std::optional<Event> next(const Histories&, double known) override {
        if (next_ < times_.size() && times_[next_] <= known)
            return Event{times_[next_++], {u_}, 0};
        return std::nullopt;
    }
    void apply(const Histories& h, const Event& event, EquationsInForce&,
               Changes& changes) override {
        changes.jumps.push_back({u_, -h.pieceBefore(u_, event.time).value(event.time)});
    }

private:
    std::vector<double> times_;
    std::size_t u_, next_ = 0;
};

const std::vector<Line> ballAndMore = {
    {"x", "v", 5, 1}, {"v", "-10", 0}, {"a", "b", 1, 1}, {"b", "-a-a^3", 0}, {"r", "sin(v)-r", 0}};

} // namespace

TEST(Events, ABallBouncesAThousandTimes) {
    Bounce source(0, 1, 1);
    const Solver solver = solved(equationsOf(ballAndMore), 2000, tolerance(1e-6), &source);
    ASSERT_EQ(source.times.size(), 1000u);
    for (std::size_t k = 0; k < 1000; ++k)
        EXPECT_NEAR(source.times[k], 1 + 2 * static_cast<double>(k), 1e-9);
    EXPECT_NEAR(solver.histories().value(0, 2000), 5, 1e-7);
    EXPECT_EQ(solver.statistics().events, 1000u);
}

// What an event does not touch, and what reads nothing of it, keeps every step; the reader of what
// it touches restarts there.
TEST(Events, CutOnlyWhatDependsOnThem) {
    Bounce source(0, 1, 1);
    const Solver with = solved(equationsOf(ballAndMore), 20, tolerance(1e-6), &source);
    const Solver without = solved(equationsOf(ballAndMore), 20, tolerance(1e-6));
    for (const auto& component : with.statistics().componentList)
        if (component.unknowns == std::vector<std::size_t>{2, 3}) {
            EXPECT_EQ(component.discardedSteps, 0u);
            for (const auto& other : without.statistics().componentList)
                if (other.unknowns == component.unknowns) {
                    EXPECT_EQ(component.steps, other.steps);
                    EXPECT_EQ(component.evaluations, other.evaluations);
                }
        }
    EXPECT_EQ(with.histories().value(2, 19.7), without.histories().value(2, 19.7));
    EXPECT_TRUE(with.histories().restarts(2).empty());
    EXPECT_EQ(with.histories().restarts(4).size(), source.times.size());
    EXPECT_EQ(with.histories().restarts(4)[3], source.times[3]);
}

// However far things had been solved when an event was found, what follows has the same bits: here
// step by step, or only when all components had run to the end.
TEST(Events, LeaveTheSameBitsWheneverTheyAreFound) {
    const auto lines = ballAndMore;
    Clock early({1.3, 2.7, 2.7, 4.4}, 3), late({1.3, 2.7, 2.7, 4.4}, 3);
    Options toTheEnd;
    toTheEnd.eventDriven = false;
    const Solver a = solved(equationsOf(lines), 9, {}, &early);
    const Solver b = solved(equationsOf(lines), 9, toTheEnd, &late);
    for (std::size_t u = 0; u < lines.size(); ++u)
        for (int k = 0; k <= 900; ++k)
            ASSERT_EQ(a.histories().value(u, k / 100.0), b.histories().value(u, k / 100.0))
                << u << " " << k;
    EXPECT_GT(b.statistics().discardedSteps, a.statistics().discardedSteps);
    EXPECT_EQ(a.histories().restarts(3), (std::vector<double>{1.3, 2.7, 4.4}));
}

TEST(Events, AtOneInstantSeeEachOther) {
    Clock source({2, 2, 2}, 3); // three reversals: one in the end
    const Solver solver = solved(equationsOf(ballAndMore), 3, tolerance(1e-9), &source);
    const Piece before = solver.histories().pieceBefore(3, 2);
    EXPECT_EQ(solver.histories().value(3, 2), -before.value(2));
}

TEST(Events, NewEquationsRepartition) {
    Bounce source(0, 1, 0.5);
    source.restSpeed = 1e-3;
    const Solver solver = solved(equationsOf(ballAndMore), 20, tolerance(1e-9), &source);
    // Bounces at 1, then after 1, 1/2, 1/4, ...: rest near 3.
    EXPECT_NEAR(source.times.back(), 3, 1e-3);
    EXPECT_EQ(solver.histories().value(0, 20), 0);
    EXPECT_EQ(solver.histories().value(1, 20), 0);
    EXPECT_NEAR(solver.histories().value(0, 1.5), 5.0 * 0.25, 1e-9);
    EXPECT_EQ(solver.statistics().components, 4u);
    // r follows r' = sin(0) - r from rest on.
    EXPECT_NEAR(solver.histories().value(4, 20), solver.histories().value(4, 10) * std::exp(-10.0),
                1e-9);
}

namespace {

// At t = 1 couples a and b, which were apart; at t = 2 ends a.
class Coupling final : public EventSource {
public:
    std::optional<Event> next(const Histories&, double known) override {
        if (stage_ < 2 && known >= 1 + stage_)
            return Event{1.0 + stage_++, {0}, 0};
        return std::nullopt;
    }
    void apply(const Histories&, const Event& event, EquationsInForce& set,
               Changes& changes) override {
        if (event.time == 2) {
            changes.ends.push_back({{0}, "it was asked to end"});
            return;
        }
        expression::Phase a, b;
        a.derivative = expression::testing::parsed(set.changing().graph, "b");
        b.derivative = expression::testing::parsed(set.changing().graph, "-a");
        changes.equations.push_back({0, a, {}});
        changes.equations.push_back({1, b, {}});
    }

private:
    int stage_ = 0;
};

} // namespace

TEST(Events, MayJoinComponentsAndEndThem) {
    Coupling source;
    const Solver solver = solved(equationsOf({{"a", "0", 1}, {"b", "0", 0}, {"c", "-c", 1}}), 5,
                                 tolerance(1e-10), &source);
    const Histories& h = solver.histories();
    EXPECT_EQ(solver.statistics().components, 2u);
    EXPECT_EQ(h.value(0, 0.9), 1);
    EXPECT_NEAR(h.value(0, 1.7), std::cos(0.7), 1e-9);
    EXPECT_NEAR(h.value(1, 1.7), -std::sin(0.7), 1e-9);
    ASSERT_NE(h.stop(1), nullptr);
    EXPECT_EQ(h.stop(1)->time, 2);
    EXPECT_EQ(h.stop(1)->sentence, "it was asked to end");
    EXPECT_NEAR(h.value(2, 5), std::exp(-5.0), 1e-9);
}

// A source that never lets time pass is stopped, not obeyed; and nothing goes on without events.
TEST(Events, WithoutEndAtOneInstantEndTheMotion) {
    class Stuck final : public EventSource {
    public:
        std::optional<Event> next(const Histories&, double known) override {
            if (known < 1)
                return std::nullopt;
            return Event{1, {2}, 0};
        }
        void apply(const Histories&, const Event&, EquationsInForce&, Changes&) override {}
    } source;
    Options options;
    options.maximumEventsAtOnce = 50;
    const Solver solver = solved(equationsOf(ballAndMore), 3, options, &source);
    ASSERT_NE(solver.histories().stop(2), nullptr);
    EXPECT_EQ(solver.histories().stop(2)->reason, Stop::Reason::tooManyEvents);
    ASSERT_NE(solver.histories().stop(0), nullptr);
    EXPECT_EQ(solver.histories().stop(0)->time, 1);
    EXPECT_NEAR(solver.histories().value(0, 1), 5 - 5, 1e-12);
}

// Many that have nothing to do with each other may be struck at the same time.
TEST(Events, AtOneInstantAreCountedByWhatTheyConcern) {
    std::vector<Line> lines;
    std::vector<Strikes::Strike> strikes;
    constexpr std::size_t many = 120;
    for (std::size_t u = 0; u < many; ++u) {
        lines.push_back({"x" + std::to_string(u), "1", 1});
        strikes.emplace_back(1, u);
    }
    Strikes source(strikes);
    Options options;
    options.maximumEventsAtOnce = 50;
    const Solver solver = solved(equationsOf(lines), 3, options, &source);
    EXPECT_TRUE(solver.histories().stops().empty());
    EXPECT_EQ(solver.statistics().events, many);
    EXPECT_EQ(solver.histories().value(many - 1, 3), -2 + 2);
}
