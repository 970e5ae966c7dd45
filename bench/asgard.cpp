// Our engine on the shared scenes.
#include "driver.h"
#include "equations.h"
#include "gas.h"
#include "measurement.h"
#include "shared_scenes.h"
#include "truth.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

using namespace bench;
using simulation::Motion;

const std::vector<double> usual = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};

double attitudeError(const Motion& motion) {
    const geometry::Quaternion q = motion.at(0, motion.finish()).attitude;
    return s1Error({q.w(), q.x(), q.y(), q.z()});
}

double linkedRodError(const Motion& motion, const RodSamples& right) {
    RodSamples samples;
    for (int i = 1; i <= s2Samples; ++i) {
        const auto a = motion.at(0, 0.5 * i).position, b = motion.at(1, 0.5 * i).position;
        samples.push_back({a.x(), a.y(), b.x(), b.y()});
    }
    return rodError(samples, right);
}

double pinnedRodError(const Motion& motion, const RodSamples& right) {
    RodSamples samples;
    for (int i = 1; i <= s2Samples; ++i) {
        const auto angles = motion.at(0, 0.5 * i).position;
        double out[4];
        MinimalRods<double>::centres({angles.x(), angles.y(), 0, 0}, out);
        samples.push_back({out[0], out[1], out[2], out[3]});
    }
    return rodError(samples, right);
}

void pendulums(Driver& driver) {
    for (const int count : {10, 100, 1000})
        for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
            if (driver.measurement().smoke() && (count > 10 || ratio > 1))
                continue;
            const std::vector<double> right = s3Angles(count, ratio);
            driver.run("S3 N=" + std::to_string(count) + " ratio " +
                           std::to_string(static_cast<int>(ratio)),
                       driver.read(s3Scene(count, ratio)), {1e-2, 1e-3, 1e-4, 1e-5, 1e-6},
                       [&](const Motion& motion) {
                           std::vector<double> angles;
                           for (std::size_t b = 0; b < motion.bodies(); ++b)
                               for (int i = 1; i <= s3Samples; ++i)
                                   angles.push_back(motion.at(b, i).position.x());
                           return worstDifference(angles, right);
                       });
        }
}

void gas(Driver& driver) {
    const int perEdge = driver.measurement().smoke() ? 3 : 8;
    const scene::Scene scene = driver.read(s4Scene(perEdge));
    Gas gas(gasOf(perEdge), 8);
    gas.runTo(0.25);
    constexpr std::size_t walls = 6;
    driver.run("S4", scene, {1e-4}, [&](const Motion& motion) {
        std::vector<std::array<double, 3>> places;
        for (std::size_t b = walls; b < motion.bodies(); ++b) {
            const auto p = motion.at(b, 0.25).position;
            places.push_back({p.x(), p.y(), p.z()});
        }
        double energy = 0;
        for (std::size_t b = walls; b < motion.bodies(); ++b)
            energy += motion.at(b, s4Span).velocity.squaredNorm() / 2;
        driver.measurement().add({"S4 energy",
                                  "change",
                                  1e-4,
                                  std::abs(energy / gas.energy() - 1),
                                  {},
                                  std::to_string(motion.impacts().size()) + " hits"});
        return medianDistance(gas.positions(0.25), places);
    });
}

void billiard(Driver& driver) {
    for (int n = 0; n <= 5; ++n) {
        const double exact = std::floor(pi<double> * std::pow(10, n));
        driver.run("S5 n=" + std::to_string(n), driver.read(s5Scene(n)), {1e-4},
                   [&](const Motion& motion) {
                       return std::abs(static_cast<double>(motion.impacts().size()) - exact);
                   });
        if (driver.measurement().smoke())
            return;
    }
}

void linkedMass(Driver& driver) {
    for (const double tightness : {1e2, 1e6, 1e12}) {
        char name[20];
        std::snprintf(name, sizeof name, "S6 k=%.0e", tightness);
        const std::vector<double> right = s6Places(tightness);
        driver.run(name, driver.read(s6Scene(tightness)), {1e-4, 1e-6, 1e-8},
                   [&](const Motion& motion) {
                       std::vector<double> places;
                       for (const double t : s6Times(tightness))
                           places.push_back(motion.at(0, t).position.x());
                       return worstDifference(places, right);
                   });
    }
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("asgard", argc, argv);
    Driver driver(m);
    m.add({"calibration", "sine and division", 0, 0, calibration(m), ""});
    if (m.wants("S1"))
        driver.run("S1", driver.read(s1Scene()), usual, attitudeError);
    if (m.wants("S2a"))
        driver.run("S2a", driver.read(s2aScene()), usual,
                   [right = s2aCentres()](const Motion& x) { return linkedRodError(x, right); });
    if (m.wants("S2b"))
        driver.run("S2b", driver.read(s2bScene()), usual,
                   [right = s2bCentres()](const Motion& x) { return pinnedRodError(x, right); });
    if (m.wants("S3"))
        pendulums(driver);
    if (m.wants("S4"))
        gas(driver);
    if (m.wants("S5"))
        billiard(driver);
    if (m.wants("S6"))
        linkedMass(driver);
    m.add({"calibration", "sine and division", 1, 0, calibration(m), ""});
    return 0;
}
