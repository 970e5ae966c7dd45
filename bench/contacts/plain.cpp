// The chains of hinges as a program of its own would move them: the number of rods is known to the
// compiler, each rod has its angle and rate, and a sweep from the free end and one back give all
// angular accelerations in proportion to the number of rods (articulated bodies in the plane).
//
// With u = (cos q, sin q) along rod i, n = (-sin q, cos q), l half its length, a the acceleration
// of its hinge, and F' = A' a' + b' the force at its far hinge on the next rod, whose hinge has
//     a' = a + 2 l (q'' n - q'^2 u):
// couples about its hinge give   D q'' = - w . a + (m l n . g - 2 l n . c)
//     c = b' - 2 l q'^2 A' u      w = m l n + 2 l A' n      D = I + m l^2 + 4 l^2 n . A' n
// and so the force at its hinge is F = A a + b with
//     A = m + A' - w w / D        b = c - m (g + l q'^2 u) + w (m l n . g - 2 l n . c) / D
#include "cases.h"
#include "integrators.h"
#include "measurement.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace {

using namespace bench;
using namespace bench::contacts;

struct Rod { // of all rods
    static constexpr double length = 1, half = length / 2, depth = 0.1, mass = 1;
    static constexpr double aboutEnd =
        mass / 12 * (length * length + depth * depth) + mass * half * half;
};

template <std::size_t count> struct PlaneChain {
    static constexpr std::size_t n = 2 * count; // angles, then rates

    void operator()(const State<double, n>& s, State<double, n>& d) const {
        constexpr double m = Rod::mass, l = Rod::half, g = -standardGravity;
        std::array<double, count> cosine, sine, wx, wy, free; // w / D and what a does not change
        double xx = 0, xy = 0, yy = 0, bx = 0, by = 0;        // A' and b'
        for (std::size_t i = count; i-- > 0;) {
            const double ux = std::cos(s[i]), uy = std::sin(s[i]), rate = s[count + i];
            const double pull = l * rate * rate;
            const double px = xy * ux - xx * uy, py = yy * ux - xy * uy; // A' n
            const double cx = bx - 2 * pull * (xx * ux + xy * uy),
                         cy = by - 2 * pull * (xy * ux + yy * uy);
            const double turnsX = l * (2 * px - m * uy), turnsY = l * (2 * py + m * ux);
            const double inverse = 1 / (Rod::aboutEnd + 4 * l * l * (py * ux - px * uy));
            const double freely = inverse * l * (m * ux * g - 2 * (cy * ux - cx * uy));
            cosine[i] = ux;
            sine[i] = uy;
            wx[i] = inverse * turnsX;
            wy[i] = inverse * turnsY;
            free[i] = freely;
            xx += m - turnsX * wx[i];
            xy -= turnsX * wy[i];
            yy += m - turnsY * wy[i];
            bx = cx - m * pull * ux + turnsX * freely;
            by = cy - m * (pull * uy + g) + turnsY * freely;
        }
        double ax = 0, ay = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double rate = s[count + i], turn = free[i] - wx[i] * ax - wy[i] * ay;
            d[i] = rate;
            d[count + i] = turn;
            ax -= 2 * l * (turn * sine[i] + rate * rate * cosine[i]);
            ay += 2 * l * (turn * cosine[i] - rate * rate * sine[i]);
        }
    }
};

template <std::size_t n> std::vector<Place> centres(const State<double, n>& s) {
    std::vector<Place> places;
    double x = 0, y = 0;
    for (std::size_t i = 0; i < n / 2; ++i) {
        const double dx = Rod::half * std::cos(s[i]), dy = Rod::half * std::sin(s[i]);
        places.push_back({x + dx, y + dy, 0});
        x += 2 * dx;
        y += 2 * dy;
    }
    return places;
}

// advance(span, state) goes from one sample to the next.
template <std::size_t count, class Begin>
void row(const Measurement& m, const Case& scene, const char* method, double parameter,
         Begin&& begin) {
    std::vector<State<double, 2 * count>> samples(scene.times.size());
    const Time time = m.timeOfShort([&] {
        auto advance = begin();
        State<double, 2 * count> state{};
        double now = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            advance(scene.times[i] - now, state);
            now = scene.times[i];
            samples[i] = state;
        }
    });
    std::vector<std::vector<Place>> places;
    places.reserve(samples.size());
    for (const auto& sample : samples)
        places.push_back(centres(sample));
    m.add({scene.name, method, parameter, worstDistance(scene, places), time, ""});
}

template <std::size_t count, int columns>
void extrapolated(const Measurement& m, const Case& scene, const char* method) {
    for (const double steps : m.sweep({1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 30, 50}))
        row<count>(m, scene, method, 0.25 / steps, [steps] {
            return [steps](double span, State<double, 2 * count>& state) {
                for (int i = 0; i < static_cast<int>(steps); ++i)
                    gbsStep<columns>(PlaneChain<count>{}, span / steps, state);
            };
        });
}

template <std::size_t count> void play(const Measurement& m, const Case& scene) {
    extrapolated<count, 4>(m, scene, "GBS8");
    extrapolated<count, 6>(m, scene, "GBS12");
    for (const double tolerance : m.sweep({1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9}))
        row<count>(m, scene, "DOPRI5", tolerance, [tolerance] {
            return [method = Dopri5<2 * count>(tolerance, 0.02)](
                       double span, State<double, 2 * count>& state) mutable {
                method.advance(PlaneChain<count>{}, span, state);
            };
        });
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("plain", argc, argv);
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    for (const Case& scene : allCases(m.smoke())) {
        if (!m.wants(scene.name) || scene.name.rfind("chain ", 0) != 0)
            continue;
        switch (scene.bodies.size()) {
        case 2:
            play<2>(m, scene);
            break;
        case 5:
            play<5>(m, scene);
            break;
        case 20:
            play<20>(m, scene);
            break;
        case 50:
            play<50>(m, scene);
            break;
        case 200:
            play<200>(m, scene);
            break;
        default:
            std::fprintf(stderr, "plain: no loop for %s\n", scene.name.c_str());
            return 1;
        }
    }
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
    return 0;
}
