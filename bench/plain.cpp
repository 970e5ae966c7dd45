// The hand-written loops: every scene as a program of its own would move it, with the step that
// serves best, known beforehand. What a general engine needs more than this is the price of being
// general.
#include "equations.h"
#include "gas.h"
#include "measurement.h"
#include "truth.h"

#include <cmath>
#include <limits>
#include <string>

namespace {

using namespace bench;

template <class Step> void runS1(const Measurement& m, const char* name, double h, Step&& step) {
    auto state = FreeBody<double>::start();
    const int steps = static_cast<int>(std::lround(s1Span / h));
    const Time time = m.timeOfShort([&] {
        state = FreeBody<double>::start();
        for (int i = 0; i < steps; ++i)
            step(FreeBody<double>{}, s1Span / steps, state);
    });
    const double length = std::hypot(state[0], state[1], std::hypot(state[2], state[3]));
    m.add({"S1", name, h,
           s1Error({state[0] / length, state[1] / length, state[2] / length, state[3] / length}),
           time, ""});
}

void freeBody(const Measurement& m) {
    const auto rk4 = [](const auto& f, double h, auto& y) { rk4Step(f, h, y); };
    const auto gbs8 = [](const auto& f, double h, auto& y) { gbsStep<4>(f, h, y); };
    const auto gbs16 = [](const auto& f, double h, auto& y) { gbsStep<8>(f, h, y); };
    for (const double h : m.sweep({0.2, 0.1, 0.05, 0.025}))
        runS1(m, "RK4", h, rk4);
    for (const double h : m.sweep({2, 1.5, 1.25, 1, 0.75, 0.5}))
        runS1(m, "GBS8", h, gbs8);
    for (const double h : m.sweep({3, 2.5, 2, 1.5, 1.25, 1}))
        runS1(m, "GBS16", h, gbs16);
}

template <class Equations, class Step>
void runRods(const Measurement& m, const char* scene, const char* name, double h,
             const RodSamples& right, const Equations& equations, Step&& step) {
    RodSamples samples(s2Samples);
    const int steps = static_cast<int>(std::lround(0.5 / h));
    const Time time = m.timeOfShort([&] {
        auto state = Equations::start();
        for (auto& sample : samples) {
            for (int i = 0; i < steps; ++i)
                step(equations, 0.5 / steps, state);
            double out[4];
            Equations::centres(state, out);
            sample = {out[0], out[1], out[2], out[3]};
        }
    });
    m.add({scene, name, h, rodError(samples, right), time, ""});
}

template <class Equations>
void runDopri5(const Measurement& m, const char* scene, double tolerance, const RodSamples& right,
               const Equations& equations) {
    RodSamples samples(s2Samples);
    const Time time = m.timeOfShort([&] {
        auto state = Equations::start();
        Dopri5<Equations::n> method(tolerance, 1e-3);
        for (auto& sample : samples) {
            method.advance(equations, 0.5, state);
            double out[4];
            Equations::centres(state, out);
            sample = {out[0], out[1], out[2], out[3]};
        }
    });
    m.add({scene, "DOPRI5", tolerance, rodError(samples, right), time, ""});
}

template <class Equations>
void linkedRods(const Measurement& m, const char* scene, const RodSamples& right,
                const std::vector<double>& steps, const std::vector<double>& longSteps) {
    const Equations equations;
    const auto rk4 = [](const auto& f, double h, auto& y) { rk4Step(f, h, y); };
    const auto gbs8 = [](const auto& f, double h, auto& y) { gbsStep<4>(f, h, y); };
    const auto gbs12 = [](const auto& f, double h, auto& y) { gbsStep<6>(f, h, y); };
    for (const double h : m.sweep(steps))
        runRods(m, scene, "RK4", h, right, equations, rk4);
    for (const double h : m.sweep(longSteps)) {
        runRods(m, scene, "GBS8", h, right, equations, gbs8);
        runRods(m, scene, "GBS12", h, right, equations, gbs12);
    }
    for (const double tolerance : m.sweep({1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}))
        runDopri5(m, scene, tolerance, right, equations);
}

// Extrapolation of order 12 for each pendulum, with steps in proportion to its own period.
void runPendulums(const Measurement& m, int count, double ratio, int steps, int fastSteps,
                  const std::vector<double>& right) {
    std::vector<double> angles(right.size());
    const Time time = m.timeOfShort([&] {
        double* out = angles.data();
        for (int p = 0; p < count; ++p) {
            const Pendulum<double> pendulum{gravityOf(p, ratio)};
            const int n = p == 0 ? fastSteps * static_cast<int>(ratio) : steps;
            State<double, 2> state{amplitudeOf(p, count), 0};
            for (int i = 0; i < s3Samples; ++i) {
                for (int s = 0; s < n; ++s)
                    gbsStep<6>(pendulum, 1.0 / n, state);
                *out++ = state[0];
            }
        }
    });
    m.add({"S3 N=" + std::to_string(count) + " ratio " + std::to_string(static_cast<int>(ratio)),
           "GBS12-per-component", 1.0 / steps, worstDifference(angles, right), time,
           "fast one: " + std::to_string(fastSteps) + " times the ratio"});
}

void pendulums(const Measurement& m) {
    for (const int count : {10, 100, 1000})
        for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
            if (m.smoke() && (count > 10 || ratio > 1))
                continue;
            const std::vector<double> right = s3Angles(count, ratio);
            for (const double steps : m.sweep({1, 2, 3, 4}))
                for (int more = 0; more <= (ratio > 1 ? 2 : 0); ++more)
                    runPendulums(m, count, ratio, static_cast<int>(steps),
                                 static_cast<int>(steps) + more, right);
        }
}

void gas(const Measurement& m) {
    const std::vector<GasStart> balls = gasOf(m.smoke() ? 3 : 8);
    Gas right(balls, 1);
    right.runTo(0.25);
    const auto rightPlaces = right.positions(0.25);
    const double energy = right.energy();
    for (const double cells : m.sweep({1, 6, 7, 8, 9, 10, 12})) {
        long hits = 0, walls = 0, crossings = 0;
        double change = 0;
        const Time time = m.timeOf([&] {
            Gas gas(balls, static_cast<int>(cells));
            const double taken = seconds([&] { gas.runTo(s4Span); });
            hits = gas.hits();
            walls = gas.wallHits();
            crossings = gas.crossings();
            change = std::abs(gas.energy() / energy - 1);
            return taken;
        });
        Gas early(balls, static_cast<int>(cells));
        early.runTo(0.25);
        const std::string note = std::to_string(hits) + " hits " + std::to_string(walls) +
                                 " wall hits " + std::to_string(crossings) + " crossings";
        const char* name = cells == 1 ? "event-driven" : "event-driven+cells";
        m.add({"S4", name, cells, medianDistance(early.positions(0.25), rightPlaces), time, note});
        m.add({"S4 energy", name, cells, change, time, note});
    }
}

// Galperin's billiard: a ball of mass 1 at rest between a wall and one of mass 100^n that comes.
long collisionsOf(int n) {
    const double heavy = std::pow(100.0, n), sum = 1 + heavy;
    double gap = 1, distance = 1; // from the wall to the light ball, from there to the heavy one
    double v = 0, u = -1;         // light, heavy
    long count = 0;
    while (v > u || v < 0) {
        ++count;
        if (v > u) { // they meet where the light one is then
            gap += v * distance / (v - u);
            distance = 0;
            const double after = ((1 - heavy) * v + 2 * heavy * u) / sum;
            u = ((heavy - 1) * u + 2 * v) / sum;
            v = after;
            if (!(v < 0))
                continue;
        } else { // the wall
            distance = gap * (v - u) / v;
            gap = 0;
            v = -v;
        }
    }
    return count;
}

void billiard(const Measurement& m) {
    long exact = 3;
    for (const int n : {0, 1, 2, 3, 4, 5}) {
        volatile long count = 0;
        const Time time = m.timeOfShort([&] { count = collisionsOf(n); });
        m.add({"S5 n=" + std::to_string(n), "event-driven", 0,
               std::abs(static_cast<double>(count - exact)), time,
               std::to_string(count) + " hits"});
        exact = static_cast<long>(std::floor(pi<double> * std::pow(10, n + 1)));
        if (m.smoke())
            return;
    }
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("plain", argc, argv);
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    if (m.wants("S1"))
        freeBody(m);
    if (m.wants("S2a"))
        linkedRods<PlanarRods<double>>(m, "S2a", s2aCentres(), {0.005, 0.0025, 0.00125, 0.000625},
                                       {0.02, 0.0125, 0.01, 0.005});
    if (m.wants("S2b"))
        linkedRods<MinimalRods<double>>(m, "S2b", s2bCentres(), {0.1, 0.05, 0.025, 0.0125},
                                        {0.25, 0.125, 0.1, 0.0625, 0.05});
    if (m.wants("S3"))
        pendulums(m);
    if (m.wants("S4"))
        gas(m);
    if (m.wants("S5"))
        billiard(m);
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
    return 0;
}
