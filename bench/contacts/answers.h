// The exact motion of the scenes that need an integration: of order 16, in long double, in least
// coordinates. Halving the steps changes nothing above 1e-12.
#pragma once

#include "cases.h"

namespace bench::contacts {

// A uniform block `width` by `height` that leans over its lower edge on a slope, from rest: the
// angle from the vertical of the line from the edge to the centre, at each time.
[[nodiscard]] std::vector<double> tippingAngles(double width, double height, double slope,
                                                const std::vector<double>& times);

// `count` rods of length 1, depth 0.1 and mass 1, hinged end to end, the first one's end to the
// origin, let go level along +x.
[[nodiscard]] std::vector<std::vector<Place>> chainPlaces(int count,
                                                          const std::vector<double>& times);

// A slider-crank without gravity or friction, from `angle` of the crank and its `rate`.
struct SliderCrank {
    double crank = 0.05, rod = 0.12; // lengths
    double crankMass = 0.5, rodMass = 0.5, pistonMass = 2;
    double thickness = 0.01;
    double angle = 0.5, rate = 20;

    struct Pose {
        long double rodAngle = 0, rodRate = 0; // rates are per rate of the crank
        std::array<Place, 3> at{}, velocity{}; // crank, rod, piston
        long double inertia = 0;               // of all, as the crank feels it
    };
    [[nodiscard]] Pose pose(long double crankAngle) const;
    [[nodiscard]] std::vector<std::vector<Place>> places(const std::vector<double>& times) const;
    // Of a crank that a motor holds to its rate.
    [[nodiscard]] std::vector<std::vector<Place>>
    placesHeld(const std::vector<double>& times) const;
};

// A machine that walks on level ground along +x: a wheel of legs that end in round feet, and a
// trunk that hangs at its hub, with a motor of a constant couple between them. It starts upright on
// one leg, which `rate` turns over.
//   The foot on the ground rolls, all others are in the air; the next one lands without a rebound
//   and without slip, and the old one leaves the ground then. Unknowns are the angle a of the leg
//   from straight down and b of the trunk. The hub's velocity is A a', the trunk's A a' + B b' with
//     A = -(leg cos a + foot, leg sin a)     B = hang (cos b, sin b)
struct Walker {
    int legs = 8;
    double leg = 0.5, foot = 0.05; // from the hub to a foot's centre, and the foot's radius
    double track = 0.3;            // from the plane to the feet of either side
    double wheelMass = 2, trunkMass = 8;
    double trunk = 0.3, hang = 0.3; // the trunk's edge, and from the hub to its centre
    double couple = 8, rate = -2.5;

    [[nodiscard]] std::vector<std::vector<Place>> places(const std::vector<double>& times) const;

private:
    using Pair = std::array<long double, 2>;
    struct Mass;
    [[nodiscard]] Mass mass(long double legAngle, long double trunkAngle) const;
    [[nodiscard]] Pair accelerations(const std::vector<long double>& state) const;
    [[nodiscard]] std::vector<long double> landed(const std::vector<long double>& state) const;
};

} // namespace bench::contacts
