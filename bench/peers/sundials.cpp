// SUNDIALS' integrators on the equations of the hand-written loops.
#include "equations.h"
#include "measurement.h"
#include "truth.h"

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace {

using namespace bench;

enum class Method { dormandPrince, verner, fehlberg, bdf, adams };
const char* nameOf(Method method) {
    switch (method) {
    case Method::dormandPrince:
        return "ARKODE-ERK-DP5(4)";
    case Method::verner:
        return "ARKODE-ERK-Verner6(5)";
    case Method::fehlberg:
        return "ARKODE-ERK-Fehlberg8(7)";
    case Method::bdf:
        return "CVODE-BDF-dense";
    case Method::adams:
        break;
    }
    return "CVODE-Adams-FP";
}

using Side = std::function<void(const double* y, double* slope)>;

int sideOf(realtype, N_Vector y, N_Vector slope, void* data) {
    (*static_cast<const Side*>(data))(N_VGetArrayPointer(y), N_VGetArrayPointer(slope));
    return 0;
}

void keepQuiet(int, const char*, const char*, char*, void*) {}

// One integration; advanceTo() may be called for increasing times.
class Integration {
public:
    Integration(Method method, double tolerance, const Side& side, const std::vector<double>& start)
        : explicit_(method != Method::bdf && method != Method::adams) {
        SUNContext_Create(nullptr, &context_);
        y_ = N_VNew_Serial(static_cast<sunindextype>(start.size()), context_);
        std::ranges::copy(start, N_VGetArrayPointer(y_));
        void* data = const_cast<Side*>(&side);
        if (explicit_)
            makeExplicit(method, tolerance, data);
        else
            makeMultistep(method, tolerance, data);
    }
    ~Integration() {
        explicit_ ? ERKStepFree(&memory_) : CVodeFree(&memory_);
        if (nonlinear_)
            SUNNonlinSolFree(nonlinear_);
        if (linear_)
            SUNLinSolFree(linear_);
        if (matrix_)
            SUNMatDestroy(matrix_);
        N_VDestroy(y_);
        SUNContext_Free(&context_);
    }
    Integration(const Integration&) = delete;
    Integration& operator=(const Integration&) = delete;

    bool advanceTo(double time) {
        double t = 0;
        if (!explicit_)
            return CVode(memory_, time, y_, &t, CV_NORMAL) >= 0;
        ERKStepSetStopTime(memory_, time);
        return ERKStepEvolve(memory_, time, y_, &t, ARK_NORMAL) >= 0;
    }
    [[nodiscard]] const double* state() const { return N_VGetArrayPointer(y_); }

private:
    static constexpr long mostSteps = 100'000'000;

    void makeExplicit(Method method, double tolerance, void* data) {
        memory_ = ERKStepCreate(sideOf, 0, y_, context_);
        ERKStepSetTableNum(memory_, method == Method::dormandPrince ? ARKODE_DORMAND_PRINCE_7_4_5
                                    : method == Method::verner      ? ARKODE_VERNER_8_5_6
                                                                    : ARKODE_FEHLBERG_13_7_8);
        ERKStepSStolerances(memory_, tolerance, tolerance);
        ERKStepSetUserData(memory_, data);
        ERKStepSetMaxNumSteps(memory_, mostSteps);
        ERKStepSetErrHandlerFn(memory_, keepQuiet, nullptr);
    }
    void makeMultistep(Method method, double tolerance, void* data) {
        memory_ = CVodeCreate(method == Method::bdf ? CV_BDF : CV_ADAMS, context_);
        CVodeInit(memory_, sideOf, 0, y_);
        CVodeSStolerances(memory_, tolerance, tolerance);
        CVodeSetUserData(memory_, data);
        CVodeSetMaxNumSteps(memory_, mostSteps);
        CVodeSetErrHandlerFn(memory_, keepQuiet, nullptr);
        if (method == Method::bdf) {
            const sunindextype n = NV_LENGTH_S(y_);
            matrix_ = SUNDenseMatrix(n, n, context_);
            linear_ = SUNLinSol_Dense(y_, matrix_, context_);
            CVodeSetLinearSolver(memory_, linear_, matrix_);
        } else {
            nonlinear_ = SUNNonlinSol_FixedPoint(y_, 0, context_);
            CVodeSetNonlinearSolver(memory_, nonlinear_);
        }
    }

    bool explicit_;
    SUNContext context_ = nullptr;
    N_Vector y_ = nullptr;
    void* memory_ = nullptr;
    SUNMatrix matrix_ = nullptr;
    SUNLinearSolver linear_ = nullptr;
    SUNNonlinearSolver nonlinear_ = nullptr;
};

template <class Equations> Side sideWith(const Equations& equations) {
    return [equations](const double* y, double* slope) {
        State<double, Equations::n> state, rates;
        std::copy_n(y, Equations::n, state.begin());
        equations(state, rates);
        std::ranges::copy(rates, slope);
    };
}

template <class Equations> std::vector<double> startOf() {
    const auto start = Equations::start();
    return {start.begin(), start.end()};
}

// Visits the states at the times; the time of stepping alone. Infinite when it failed.
double visit(Method method, double tolerance, const Side& side, const std::vector<double>& start,
             const std::vector<double>& times, const std::function<void(const double*)>& at) {
    Integration integration(method, tolerance, side, start);
    double taken = 0;
    for (const double time : times) {
        bool good = false;
        taken += seconds([&] { good = integration.advanceTo(time); });
        if (!good)
            return std::numeric_limits<double>::infinity();
        at(integration.state());
    }
    return taken;
}

void freeBody(const Measurement& m) {
    const Side side = sideWith(FreeBody<double>{});
    for (const Method method :
         {Method::dormandPrince, Method::verner, Method::fehlberg, Method::adams})
        for (const double tolerance : m.sweep({1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11})) {
            std::array<double, 4> q{};
            const Time time = m.timeOf([&] {
                return visit(method, tolerance, side, startOf<FreeBody<double>>(), {s1Span},
                             [&](const double* y) { std::copy_n(y, 4, q.begin()); });
            });
            m.add({"S1", nameOf(method), tolerance, s1Error(q), time, ""});
        }
}

template <class Equations>
void linkedRods(const Measurement& m, const char* scene, const RodSamples& right) {
    const Side side = sideWith(Equations{});
    std::vector<double> times;
    for (int i = 1; i <= s2Samples; ++i)
        times.push_back(0.5 * i);
    for (const Method method :
         {Method::dormandPrince, Method::verner, Method::fehlberg, Method::bdf, Method::adams})
        for (const double tolerance :
             m.sweep({1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11})) {
            RodSamples samples;
            const Time time = m.timeOf([&] {
                samples.clear();
                return visit(method, tolerance, side, startOf<Equations>(), times,
                             [&](const double* y) {
                                 State<double, Equations::n> state;
                                 std::copy_n(y, Equations::n, state.begin());
                                 double out[4];
                                 Equations::centres(state, out);
                                 samples.push_back({out[0], out[1], out[2], out[3]});
                             });
            });
            m.add({scene, nameOf(method), tolerance, rodError(samples, right), time, ""});
        }
}

// All pendulums in one system, angles first. After `limit` seconds the rest is extrapolated.
double runPendulums(const Measurement& m, Method method, double tolerance, int count, double ratio,
                    const std::vector<double>& right, double& error) {
    constexpr double limit = 2;
    const auto n = static_cast<std::size_t>(count);
    std::vector<double> gravity(n), start(2 * n);
    for (std::size_t p = 0; p < n; ++p) {
        gravity[p] = gravityOf(static_cast<int>(p), ratio);
        start[p] = amplitudeOf(static_cast<int>(p), count);
    }
    const Side side = [&](const double* y, double* slope) {
        for (std::size_t p = 0; p < n; ++p) {
            slope[p] = y[n + p];
            slope[n + p] = -gravity[p] * std::sin(y[p]);
        }
    };
    int samples = 0;
    const Time time = m.timeOf([&] {
        Integration integration(method, tolerance, side, start);
        double taken = 0;
        error = 0;
        for (samples = 0; samples < s3Samples && taken < limit; ++samples) {
            bool good = false;
            taken += seconds([&] { good = integration.advanceTo(samples + 1); });
            for (std::size_t p = 0; p < n; ++p)
                error = std::max(
                    error, std::abs(integration.state()[p] -
                                    right[p * s3Samples + static_cast<std::size_t>(samples)]));
            if (!good)
                error = std::numeric_limits<double>::infinity();
        }
        return taken * s3Samples / samples;
    });
    m.add({"S3 N=" + std::to_string(count) + " ratio " + std::to_string(static_cast<int>(ratio)),
           nameOf(method), tolerance, error, time,
           samples < s3Samples ? "scaled from " + std::to_string(samples) + " s" : ""});
    return time.least;
}

// Of more than ten pendulums only what did best with ten, at the tolerance that these wanted: the
// fast one decides.
void pendulums(const Measurement& m) {
    for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
        Method best = Method::fehlberg;
        double enough = 1e-10, least = std::numeric_limits<double>::infinity();
        for (const Method method : {Method::dormandPrince, Method::fehlberg, Method::adams}) {
            if (m.smoke() && ratio > 1)
                return;
            const std::vector<double> right = s3Angles(10, ratio);
            double error = 1;
            for (const double tolerance : m.sweep({1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10})) {
                if (error <= 1e-4)
                    break;
                const double taken = runPendulums(m, method, tolerance, 10, ratio, right, error);
                if (error <= 1e-4 && taken < least) {
                    least = taken;
                    best = method;
                    enough = tolerance;
                }
            }
        }
        if (m.smoke())
            return;
        for (const int count : {100, 1000}) {
            double error = 1;
            for (double tolerance = enough; error > 1e-4 && tolerance > 1e-12; tolerance /= 10)
                runPendulums(m, best, tolerance, count, ratio, s3Angles(count, ratio), error);
        }
    }
}

void linkedMass(const Measurement& m) {
    for (const double tightness : {1e2, 1e6, 1e12}) {
        char name[20];
        std::snprintf(name, sizeof name, "S6 k=%.0e", tightness);
        const double damping = 2 * std::sqrt(tightness);
        const Side side = [&](const double* y, double* slope) {
            slope[0] = y[1];
            slope[1] = -tightness * y[0] - damping * y[1];
        };
        for (const Method method : {Method::bdf, Method::adams, Method::dormandPrince})
            for (const double tolerance : m.sweep({1e-6, 1e-7, 1e-8})) {
                if (method != Method::bdf && tightness > 1e6)
                    continue; // as slow as its stability: half a second
                std::vector<double> places;
                const Time time = m.timeOf([&] {
                    places.clear();
                    return visit(method, tolerance, side, {1, 0}, s6Times(tightness),
                                 [&](const double* y) { places.push_back(y[0]); });
                });
                m.add({name, nameOf(method), tolerance,
                       worstDifference(places, s6Places(tightness)), time, ""});
            }
    }
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("sundials", argc, argv);
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    if (m.wants("S1"))
        freeBody(m);
    if (m.wants("S2a"))
        linkedRods<PlanarRods<double>>(m, "S2a", s2aCentres());
    if (m.wants("S2b"))
        linkedRods<MinimalRods<double>>(m, "S2b", s2bCentres());
    if (m.wants("S3"))
        pendulums(m);
    if (m.wants("S6"))
        linkedMass(m);
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
    return 0;
}
