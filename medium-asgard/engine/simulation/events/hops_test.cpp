// A box that lands tilted on a floor hops and rocks itself to rest: each hop is right, not only the
// rest that all of them lead to. Held against an integration that shares nothing with the engine.
#include "simulation/testing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace simulation::testing {
namespace {

using ::testing::Contains, ::testing::HasSubstr, ::testing::IsEmpty;

struct Fall {
    double height = 1;                // of the box, whose width is 1
    double restitution = 0, tilt = 0; // about the z axis
};
constexpr double width = 1, depth = 0.8, drop = 0.3, finish = 1.2;

// In the plane, from event to event in long double: in free flight the next time at which a corner
// can touch follows from its speed and a bound on its acceleration; on one corner the box falls by
// an equation in its angle, by the method of Runge and Kutta; hops end where they are slower than
// `still`.
class RockingBox {
    using Real = long double;

public:
    explicit RockingBox(const Fall& fall)
        : height_(fall.height), restitution_(fall.restitution),
          inertia_((width * width + height_ * height_) / 12), y_(height_ / 2 + drop),
          angle_(fall.tilt) {}

    [[nodiscard]] double y() const { return static_cast<double>(y_); }
    [[nodiscard]] double angle() const { return static_cast<double>(angle_); }

    void advanceTo(double time) {
        while (time_ < time && !isAtRest_)
            if (pivot_ < 0)
                fly(time);
            else
                rock(time);
    }

private:
    static constexpr Real still = 1e-7L, touching = 1e-17L, step = 1e-4L;
    struct Arm { // from the centre of mass to a lower corner
        Real x, y;
    };
    [[nodiscard]] Arm arm(int corner, Real angle) const {
        const Real along = corner == 0 ? -width / 2.0L : width / 2.0L;
        const Real c = std::cos(angle), s = std::sin(angle);
        return {along * c + height_ / 2 * s, along * s - height_ / 2 * c};
    }
    [[nodiscard]] Real gap(int corner) const { return y_ + arm(corner, angle_).y; }
    [[nodiscard]] Real rate(int corner) const { return v_ + spin_ * arm(corner, angle_).x; }

    void fly(Real until) {
        const Real radius = std::hypot(Real(width), height_) / 2;
        const Real most = Real(g) + radius * spin_ * spin_; // acceleration towards the floor
        Real dt = until - time_;
        int next = -1;
        for (const int corner : {0, 1}) {
            const Real h = std::max<Real>(gap(corner), 0), u = rate(corner);
            const Real root = std::sqrt(u * u + 2 * most * h);
            const Real safe = u < 0 ? 2 * h / (root - u) : (u + root) / most;
            if (safe < dt) {
                dt = safe;
                next = corner;
            }
        }
        y_ += v_ * dt - Real(g) * dt * dt / 2;
        v_ -= Real(g) * dt;
        angle_ += spin_ * dt;
        time_ = next < 0 ? until : time_ + dt;
        if (next >= 0 && rate(next) < 0 && gap(next) < touching)
            hit(next);
    }

    [[nodiscard]] Real turning(Real angle, Real spin) const { // about the pivot, without friction
        const Arm a = arm(pivot_, angle);
        return a.x * (Real(g) + a.y * spin * spin) / (inertia_ + a.x * a.x);
    }
    void turn(Real dt) {
        const Real k1 = spin_, l1 = turning(angle_, spin_);
        const Real k2 = spin_ + dt / 2 * l1, l2 = turning(angle_ + dt / 2 * k1, k2);
        const Real k3 = spin_ + dt / 2 * l2, l3 = turning(angle_ + dt / 2 * k2, k3);
        const Real k4 = spin_ + dt * l3, l4 = turning(angle_ + dt * k3, k4);
        angle_ += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        spin_ += dt / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
        y_ = -arm(pivot_, angle_).y;
        v_ = -arm(pivot_, angle_).x * spin_;
        time_ += dt;
    }
    void rock(Real until) {
        const RockingBox before = *this;
        const int other = 1 - pivot_;
        turn(std::min(step, until - time_));
        if (gap(other) > 0)
            return;
        Real early = 0, late = time_ - before.time_;
        for (int i = 0; i < 80; ++i) {
            const Real middle = (early + late) / 2;
            *this = before;
            turn(middle);
            (gap(other) > 0 ? early : late) = middle;
        }
        hit(other);
    }

    bool push(int corner, Real restitution) {
        const Real u = rate(corner), x = arm(corner, angle_).x;
        if (u >= 0)
            return false;
        const Real impulse = -(1 + restitution) * u / (1 + x * x / inertia_);
        v_ += impulse;
        spin_ += impulse * x / inertia_;
        return true;
    }
    // What the box stood on is hit after it, and so on in turn.
    void hit(int corner) {
        const int other = 1 - corner;
        push(corner, restitution_);
        for (int i = 0; i < 10'000 && pivot_ == other; ++i)
            if (!push(other, restitution_) && !push(corner, restitution_))
                break;
        const bool stoodOn = std::exchange(pivot_, -1) == other;
        const bool isSlow = std::abs(rate(corner)) < still;
        isAtRest_ = isSlow && (stoodOn || gap(other) < touching) && std::abs(rate(other)) < still;
        if (isAtRest_)
            return;
        for (const int slow : {corner, other})
            if (std::abs(rate(slow)) < still && (slow == corner || stoodOn)) {
                push(slow, 0);
                pivot_ = slow;
            }
    }

    Real height_, restitution_, inertia_;
    Real time_ = 0, y_, v_ = 0, angle_, spin_ = 0;
    int pivot_ = -1;
    bool isAtRest_ = false;
};

Result fallOf(const Fall& fall, double accuracy) {
    SceneBuilder b(finish, accuracy);
    b.floor();
    scene::Body& box = b.box("box", {0, fall.height / 2 + drop, 0}, {width, fall.height, depth});
    box.restitution = fall.restitution;
    box.initialAttitude = geometry::fromRotationVector({0, 0, fall.tilt});
    b.weight("box");
    return simulate(b.scene);
}

// Over the size of what moves, as the accuracy is.
double largestError(const Fall& fall, const Motion& motion) {
    const double radius = Vector(width, fall.height, depth).norm() / 2;
    RockingBox truth(fall);
    double largest = 0;
    constexpr int times = 600;
    for (int i = 0; i <= times; ++i) {
        const double t = finish * i / times;
        truth.advanceTo(t);
        const BodyState state = motion.at(1, t);
        const double angle = 2 * std::atan2(state.attitude.z(), state.attitude.w());
        largest = std::max({largest, std::abs(state.position.y() - truth.y()),
                            radius * std::abs(angle - truth.angle())});
    }
    return largest / (2 * radius + drop);
}

TEST(Hops, OfABoxThatRocksItselfToRestAreRight) {
    for (const double accuracy : {1e-4, 1e-7})
        for (const double height : {0.2, 0.4, 1.0})
            for (const double restitution : {0.04, 0.3, 0.6})
                for (const double tilt : {0.001, 0.01, 0.03}) {
                    const Fall fall{.height = height, .restitution = restitution, .tilt = tilt};
                    const Result result = fallOf(fall, accuracy);
                    ASSERT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
                    ASSERT_TRUE(result.motion->errorEstimate());
                    const double estimate = *result.motion->errorEstimate();
                    EXPECT_LE(estimate, 30 * accuracy);
                    EXPECT_LE(largestError(fall, *result.motion), std::max(accuracy, 3 * estimate))
                        << accuracy << " " << height << " " << restitution << " " << tilt;
                }
}

// A box that slides, and rocks itself to rest, has lost as much speed as its weight presses with:
// hops that are left out, too, press in sum as the weight does, and rub so.
TEST(Hops, OfABoxThatSlidesRubAsItsWeightDoes) {
    constexpr double slides = 3, friction = 0.3, until = 0.5;
    for (const double accuracy : {1e-2, 1e-3, 1e-4})
        for (const double restitution : {0.0, 0.3, 0.6})
            for (const double tilt : {0.001, 0.003}) {
                SceneBuilder b(until, accuracy);
                b.floor().friction = friction;
                scene::Body& box = b.box("box", {0, 0.105, 0}, {1, 0.2, 1});
                box.restitution = restitution;
                box.friction = friction;
                box.initialAttitude = geometry::fromRotationVector({0, 0, tilt});
                box.initialVelocity = {slides, 0, 0};
                b.weight("box");
                const Result result = simulate(b.scene);
                ASSERT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
                EXPECT_NEAR(result.motion->at(1, until).velocity.x(), slides - friction * g * until,
                            1e-3 * accuracy)
                    << accuracy << " " << restitution << " " << tilt;
            }
}

// So do two that lie on each other, and rattle: their common centre of mass knows the floor alone.
TEST(Hops, OfBoxesThatSlideTogetherRubAsTheirWeightDoes) {
    constexpr double slides = 4, friction = 0.3, until = 0.5;
    for (const double accuracy : {1e-3, 1e-4})
        for (const double restitution : {0.0, 0.6}) {
            SceneBuilder b(until, accuracy);
            b.floor().friction = friction;
            for (const double y : {0.105, 0.315}) {
                scene::Body& box = b.box(y < 0.2 ? "low" : "high", {0, y, 0}, {1, 0.2, 1});
                box.restitution = restitution;
                box.friction = friction;
                box.initialAttitude =
                    geometry::fromRotationVector({0, 0, y < 0.2 ? 0.001 : -0.002});
                box.initialVelocity = {slides, 0, 0};
            }
            b.weight("low");
            b.weight("high");
            const Result result = simulate(b.scene);
            ASSERT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
            const Vector mean =
                (result.motion->at(1, until).velocity + result.motion->at(2, until).velocity) / 2;
            EXPECT_NEAR(mean.x(), slides - friction * (g * until + mean.y()), 1e-3 * accuracy)
                << accuracy << " " << restitution;
        }
}

// Where a ball is that falls from a height of 1 and bounces: above the floor, from its lower side.
double bounced(double e, double time) {
    double speed = std::sqrt(2 * g), from = speed / g;
    if (time < from)
        return 1 - g * time * time / 2;
    const double end = from * (1 + e) / (1 - e);
    if (time >= end)
        return 0;
    for (;;) {
        speed *= e;
        const double next = from + 2 * speed / g;
        if (time < next || next <= from)
            return std::max(0.0, speed * (time - from) - g * (time - from) * (time - from) / 2);
        from = next;
    }
}

// Rest begins by leaving out hops without end, and all runs leave out those that are too low to be
// told apart: what is printed of the error is no less than it is, and not all that is lost is put
// down to rounding.
TEST(Hops, ThatAreLeftOutAreAPartOfTheEstimate) {
    constexpr double radius = 0.1, size = 1 + 2 * radius;
    const std::array<std::pair<double, double>, 5> rests = {{{0.3, 0.838543905},
                                                             {0.5, 1.354570923},
                                                             {0.7, 2.558633966},
                                                             {0.9, 8.578949179},
                                                             {0.99, 89.853204556}}};
    for (const auto& [e, rest] : rests)
        for (const double accuracy : {1e-3, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12}) {
            SceneBuilder b(rest + 0.1, accuracy);
            b.floor();
            b.ball("ball", {0, 1 + radius, 0}, radius).restitution = e;
            b.weight("ball");
            const Result result = simulate(b.scene);
            ASSERT_FALSE(result.motion->stop(1)) << result.motion->stop(1)->sentence;
            double worst = 0;
            for (int i = 0; i <= 4000; ++i) { // ever more densely towards the end
                const double t = rest * (1 - std::exp(-20.0 * i / 4000));
                const double y = result.motion->at(1, t).position.y() - radius;
                worst = std::max(worst, std::abs(y - bounced(e, t)) / size);
            }
            ASSERT_TRUE(result.statistics.errorEstimate);
            EXPECT_GE(*result.statistics.errorEstimate, worst) << e << " " << accuracy;
            EXPECT_LT(*result.statistics.errorEstimate, std::max(accuracy, 3e-9))
                << e << " " << accuracy;
            if (*result.statistics.errorEstimate > accuracy)
                EXPECT_THAT(result.motion->notes(),
                            Contains(HasSubstr("leaves out the last hops")));
            else
                EXPECT_THAT(result.motion->notes(), IsEmpty());
            EXPECT_EQ(result.motion->at(1, rest).velocity.y(), 0);
            EXPECT_LT(result.motion->impacts().back().time, rest + 1e-6);
        }
}

// Another body lies on the floor with friction: that makes the floor no less exact a place for who
// hops on it.
TEST(Hops, AreNoOtherBesideABodyThatLiesOnTheFloor) {
    constexpr double radius = 0.1, size = 1 + 2 * radius;
    for (const double e : {0.2, 0.25, 0.3, 0.4, 0.5})
        for (const double accuracy : {1e-3, 1e-4, 1e-5, 1e-6}) {
            const double rest = std::sqrt(2 / g) * (1 + e) / (1 - e);
            SceneBuilder b(rest + 0.1, accuracy);
            b.floor().friction = 0.3;
            scene::Body& lying = b.ball("lying", {1, radius, 0}, radius);
            lying.restitution = 0;
            lying.friction = 0.3;
            b.ball("ball", {0, 1 + radius, 0}, radius).restitution = e;
            b.weight("lying");
            b.weight("ball");
            const Result result = simulate(b.scene);
            ASSERT_FALSE(result.motion->stop(2))
                << e << " " << accuracy << " " << result.motion->stop(2)->sentence;
            for (int i = 0; i <= 1000; ++i) {
                const double t = rest * i / 1000;
                ASSERT_NEAR(result.motion->at(2, t).position.y() - radius, bounced(e, t),
                            accuracy * size)
                    << e << " " << accuracy << " " << t;
            }
        }
}

} // namespace
} // namespace simulation::testing
