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
};

} // namespace bench::contacts
