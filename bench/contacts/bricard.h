// The exact motion of Bricard's mechanism, integrated as answers.h says.
//
// Six hinges about y, z, x, y, z, x join five rods of length 1 and mass 1 and the ground to a ring,
// which begins along the edges of a cube. By symmetry every second hinge has turned alike: by u the
// first, third and fifth, by w the others, and
//     sin u + sin w + sin u sin w = 0
// so one number moves it all.
#pragma once

#include "cases.h"

namespace bench::contacts {

struct Bricard {
    // Of the hinges at the start, along the ring; the rods lie between them, with these centres.
    static constexpr std::array<Place, 6> hinges{
        {{0, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, -1, 1}, {0, -1, 1}, {0, 0, 1}}};
    static constexpr std::array<Place, 6> axes{
        {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
    static constexpr double thickness = 0.1;

    [[nodiscard]] static Place centre(std::size_t rod);
    [[nodiscard]] static Place edges(std::size_t rod); // of its box
    [[nodiscard]] static std::vector<std::vector<Place>> places(const std::vector<double>& times);
    [[nodiscard]] static double halfSwing(); // from rest to rest
    // How far the ring of rods that have turned by u is from closed.
    [[nodiscard]] static double gap(double u);
};

} // namespace bench::contacts
