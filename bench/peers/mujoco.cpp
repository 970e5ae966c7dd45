// MuJoCo: hinges in reduced coordinates where the scene has joints, RK4, forces by its callback;
// contacts as stiff springs with critical damping that is left out (bounces return all energy).
#include "equations.h"
#include "gas.h"
#include "measurement.h"
#include "truth.h"

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>

namespace {

using namespace bench;

struct Destroy {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
};
using Model = std::unique_ptr<mjModel, Destroy>;
using Data = std::unique_ptr<mjData, Destroy>;

Model modelOf(const std::string& xml) {
    std::string name =
        (std::filesystem::temp_directory_path() / "bench_mujoco_XXXXXX.xml").string();
    char why[1000] = "";
    const int file = mkstemps(name.data(), 4);
    if (file >= 0)
        close(file);
    std::ofstream(name) << xml;
    Model model(mj_loadXML(name.c_str(), nullptr, why, sizeof why));
    std::remove(name.c_str());
    if (!model) {
        std::fprintf(stderr, "bench_mujoco: %s\n", why);
        std::exit(1);
    }
    return model;
}

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

std::string document(const std::string& options, const std::string& bodies) {
    return "<mujoco><size nconmax=\"4000\" njmax=\"8000\"/><compiler angle=\"radian\"/>"
           "<option " +
           options + "/><worldbody>" + bodies + "</worldbody></mujoco>";
}

std::string inertial(const std::string& place, double mass, const std::string& diagonal) {
    return "<inertial pos=\"" + place + "\" mass=\"" + number(mass) + "\" diaginertia=\"" +
           diagonal + "\"/>";
}

// Steps of about h from sample to sample; the time of stepping alone.
template <class Sample>
double march(const mjModel* model, mjData* data, int samples, int steps, Sample&& sample) {
    double taken = 0;
    for (int i = 0; i < samples; ++i) {
        taken += seconds([&] {
            for (int s = 0; s < steps; ++s)
                mj_step(model, data);
        });
        sample();
    }
    return taken;
}

void freeBody(const Measurement& m) {
    const Model model =
        modelOf(document("integrator=\"RK4\" gravity=\"0 0 0\"",
                         "<body><freejoint/>" + inertial("0 0 0", 1, "1 2 3") + "</body>"));
    for (const double h : m.sweep({0.1, 1.0 / 60, 1.0 / 240, 1.0 / 1000})) {
        model->opt.timestep = h;
        std::array<double, 4> q{};
        const Time time = m.timeOf([&] {
            const Data data(mj_makeData(model.get()));
            data->qvel[3] = 0.01;
            data->qvel[4] = 1;
            return march(model.get(), data.get(), 1, static_cast<int>(std::lround(s1Span / h)),
                         [&] { std::copy_n(data->qpos + 3, 4, q.begin()); });
        });
        m.add({"S1", "RK4", h, s1Error(q), time, ""});
    }
}

std::string rodInertia() {
    const double around = rods::mass / 12 * 2 * 1.1 * 1.1;
    return number(around) + " " + number(rods::inertia) + " " + number(rods::inertia);
}

// The links' forces of S2a on two free bodies: world forces at the ends.
void linkForces(const mjModel* model, mjData* data) {
    static const double damping = 2 * std::sqrt(rods::tightness * rods::mass);
    double end[3][3], rate[3][3]; // right end of the first, its left end, upper end of the second
    for (int i = 0; i < 3; ++i) {
        const int body = i < 2 ? 1 : 2;
        const double along = i == 1 ? -rods::half : rods::half;
        const double offset[3] = {along, 0, 0};
        double arm[3], spin[3], turned[3];
        mju_mulMatVec(arm, data->xmat + 9 * body, offset, 3, 3);
        mju_mulMatVec(spin, data->xmat + 9 * body, data->qvel + 6 * (body - 1) + 3, 3, 3);
        mju_cross(turned, spin, arm);
        for (int a = 0; a < 3; ++a) {
            end[i][a] = data->xpos[3 * body + a] + arm[a];
            rate[i][a] = data->qvel[6 * (body - 1) + a] + turned[a];
        }
    }
    double first[3], second[3], opposite[3];
    for (int a = 0; a < 3; ++a) {
        first[a] = -rods::tightness * end[0][a] - damping * rate[0][a];
        second[a] =
            -rods::tightness * (end[1][a] - end[2][a]) - damping * (rate[1][a] - rate[2][a]);
        opposite[a] = -second[a];
    }
    const double none[3] = {};
    mj_applyFT(model, data, first, none, end[0], 1, data->qfrc_passive);
    mj_applyFT(model, data, second, none, end[1], 1, data->qfrc_passive);
    mj_applyFT(model, data, opposite, none, end[2], 2, data->qfrc_passive);
}

void softRods(const Measurement& m) {
    const Model model = modelOf(
        document("integrator=\"RK4\" gravity=\"0 -10 0\"",
                 "<body pos=\"-5 0 0\"><freejoint/>" + inertial("0 0 0", rods::mass, rodInertia()) +
                     "</body><body pos=\"-15 0 0\"><freejoint/>" +
                     inertial("0 0 0", rods::mass, rodInertia()) + "</body>"));
    mjcb_passive = linkForces;
    const RodSamples right = s2aCentres();
    for (const double h : m.sweep({0.005, 0.0025, 0.001, 0.0005, 0.00025})) {
        model->opt.timestep = h;
        RodSamples samples;
        const Time time = m.timeOf([&] {
            samples.clear();
            const Data data(mj_makeData(model.get()));
            return march(model.get(), data.get(), s2Samples, static_cast<int>(std::lround(0.5 / h)),
                         [&] {
                             const double* q = data->qpos;
                             samples.push_back({q[0], q[1], q[7], q[8]});
                         });
        });
        m.add({"S2a", "RK4+mjcb_passive", h, rodError(samples, right), time, ""});
    }
    mjcb_passive = nullptr;
}

void pinnedRods(const Measurement& m) {
    const std::string hinge = "<joint type=\"hinge\" axis=\"0 0 1\"/>";
    const Model model = modelOf(document(
        "integrator=\"RK4\" gravity=\"0 -10 0\"",
        "<body>" + hinge + inertial("-5 0 0", rods::mass, rodInertia()) + "<body pos=\"-10 0 0\">" +
            hinge + inertial("-5 0 0", rods::mass, rodInertia()) + "</body></body>"));
    const RodSamples right = s2bCentres();
    for (const double h : m.sweep({0.1, 0.05, 0.025, 0.01, 0.005, 0.0025})) {
        model->opt.timestep = h;
        RodSamples samples;
        const Time time = m.timeOf([&] {
            samples.clear();
            const Data data(mj_makeData(model.get()));
            return march(
                model.get(), data.get(), s2Samples, static_cast<int>(std::lround(0.5 / h)), [&] {
                    const double first = pi<double> + data->qpos[0];
                    double out[4];
                    MinimalRods<double>::centres({first, first + data->qpos[1], 0, 0}, out);
                    samples.push_back({out[0], out[1], out[2], out[3]});
                });
        });
        m.add({"S2b", "hinge;RK4", h, rodError(samples, right), time, ""});
    }
}

double fastGravity = 0; // the first pendulum's, above the others'
void fastForce(const mjModel*, mjData* data) {
    data->qfrc_passive[0] -= fastGravity * std::sin(data->qpos[0]);
}

void runPendulums(const Measurement& m, mjModel* model, double h, int count, double ratio,
                  const std::vector<double>& right, double& error) {
    constexpr double limit = 2;
    model->opt.timestep = h;
    int samples = 0;
    const Time time = m.timeOf([&] {
        const Data data(mj_makeData(model));
        for (int p = 0; p < count; ++p)
            data->qpos[p] = amplitudeOf(p, count);
        double taken = 0;
        error = 0;
        for (samples = 0; samples < s3Samples && taken < limit; ++samples)
            taken += march(model, data.get(), 1, static_cast<int>(std::lround(1 / h)), [&] {
                for (int p = 0; p < count; ++p)
                    error = std::max(
                        error, std::abs(data->qpos[p] -
                                        right[static_cast<std::size_t>(p * s3Samples + samples)]));
            });
        return taken * s3Samples / samples;
    });
    m.add({"S3 N=" + std::to_string(count) + " ratio " + std::to_string(static_cast<int>(ratio)),
           "hinge;RK4", h, error, time,
           samples < s3Samples ? "scaled from " + std::to_string(samples) + " s" : ""});
}

void pendulums(const Measurement& m) {
    double longest[3] = {1, 1, 1}; // by ratio: the step that fewer pendulums wanted
    for (const int count : {10, 100, 1000}) {
        std::string bodies;
        for (int p = 0; p < count; ++p)
            bodies += "<body><joint type=\"hinge\" axis=\"0 0 1\"/>" +
                      inertial("0 -1 0", 1, "1e-9 1e-9 1e-9") + "</body>";
        const Model model = modelOf(document("integrator=\"RK4\" gravity=\"0 -10 0\"", bodies));
        for (const double ratio : {1.0, 10.0, 100.0}) { // 1000: hours
            if (m.smoke() && (count > 10 || ratio > 1))
                continue;
            fastGravity = gravityOf(0, ratio) - 10;
            mjcb_passive = ratio > 1 ? fastForce : nullptr;
            const std::vector<double> right = s3Angles(count, ratio);
            double error = 1;
            double& known = longest[std::lround(std::log10(ratio))];
            for (const double h : m.sweep({0.04, 0.02, 0.01, 0.005, 0.0025, 0.00125}))
                if (!(error <= 1e-4) && h <= known) {
                    runPendulums(m, model.get(), h / ratio, count, ratio, right, error);
                    if (error <= 1e-4)
                        known = h;
                }
            mjcb_passive = nullptr;
        }
    }
}

// A contact is half a period of a spring that takes ten steps.
std::string bouncing(double h) {
    const double stiffness = std::pow(pi<double> / (10 * h), 2);
    return "condim=\"1\" solref=\"" + number(-stiffness) + " 0\" solimp=\"1 1 0.001\"";
}

void gas(const Measurement& m) {
    const std::vector<GasStart> balls = gasOf(m.smoke() ? 3 : 8);
    Gas exact(balls, 8);
    exact.runTo(0.25);
    const auto right = exact.positions(0.25);
    for (const double h : m.sweep({1.0 / 240, 0.001})) {
        std::string bodies;
        for (const char* wall :
             {"-1 0 0\" zaxis=\"1 0 0", "1 0 0\" zaxis=\"-1 0 0", "0 -1 0\" zaxis=\"0 1 0",
              "0 1 0\" zaxis=\"0 -1 0", "0 0 -1\" zaxis=\"0 0 1", "0 0 1\" zaxis=\"0 0 -1"})
            bodies += std::string("<geom type=\"plane\" size=\"2 2 1\" pos=\"") + wall + "\" " +
                      bouncing(h) + "/>";
        for (const GasStart& ball : balls)
            bodies += "<body pos=\"" + number(ball.position[0]) + " " + number(ball.position[1]) +
                      " " + number(ball.position[2]) +
                      "\"><freejoint/><geom type=\"sphere\" size=\"0.05\" mass=\"1\" " +
                      bouncing(h) + "/></body>";
        const Model model =
            modelOf(document("gravity=\"0 0 0\" timestep=\"" + number(h) + "\"", bodies));
        std::vector<std::array<double, 3>> early;
        double energy = 0;
        const Time time = m.timeOf([&] {
            const Data data(mj_makeData(model.get()));
            for (std::size_t b = 0; b < balls.size(); ++b)
                std::ranges::copy(balls[b].velocity, data->qvel + 6 * b);
            early.clear();
            const double soon =
                march(model.get(), data.get(), 1, static_cast<int>(std::lround(0.25 / h)), [&] {
                    for (std::size_t b = 0; b < balls.size(); ++b) {
                        const double* q = data->qpos + 7 * b;
                        early.push_back({q[0], q[1], q[2]});
                    }
                });
            const double more =
                march(model.get(), data.get(), 1,
                      static_cast<int>(std::lround((m.smoke() ? 0.1 : s4Span - 0.25) / h)), [] {});
            energy = 0;
            for (std::size_t b = 0; b < balls.size(); ++b)
                for (int a = 0; a < 3; ++a)
                    energy += data->qvel[6 * b + static_cast<std::size_t>(a)] *
                              data->qvel[6 * b + static_cast<std::size_t>(a)] / 2;
            return soon + more;
        });
        m.add({"S4", "soft;condim1", h, medianDistance(early, right), time, ""});
        m.add({"S4 energy", "soft;condim1", h, std::abs(energy / exact.energy() - 1), time, ""});
    }
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("mujoco", argc, argv);
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    if (m.wants("S1"))
        freeBody(m);
    if (m.wants("S2a"))
        softRods(m);
    if (m.wants("S2b"))
        pinnedRods(m);
    if (m.wants("S3"))
        pendulums(m);
    if (m.wants("S4"))
        gas(m);
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
    return 0;
}
