// Problems for tests.
#pragma once

#include "complementarity/laws.h"

#include <cmath>
#include <random>

namespace complementarity {

// Rows of bodies in a random heap, as J M^-1 J' of 6 freedoms each.
struct Heap {
    Matrix a;
    Vector b;
    Laws laws;
};

inline Heap randomHeap(std::mt19937_64& random, Index bodies, Index contacts, double friction) {
    std::normal_distribution<double> normal;
    std::uniform_int_distribution<Index> body(0, bodies - 1);
    Matrix j = Matrix::Zero(3 * contacts, 6 * bodies);
    Heap heap;
    for (Index c = 0; c < contacts; ++c) {
        for (const double sign : {1.0, -1.0}) {
            const Index of = body(random);
            for (Index row = 0; row < 3; ++row)
                for (Index k = 0; k < 6; ++k)
                    j(3 * c + row, 6 * of + k) += sign * normal(random);
        }
        addUnilateral(heap.laws);
        addFriction(heap.laws, 2, 3 * c, friction);
    }
    Vector inverse(6 * bodies), free(6 * bodies);
    for (Index i = 0; i < inverse.size(); ++i) {
        inverse[i] = std::pow(10, -std::abs(normal(random))); // masses of 1 to some 1000
        free[i] = normal(random);
    }
    heap.a = j * inverse.asDiagonal() * j.transpose();
    heap.b = j * free;
    return heap;
}

} // namespace complementarity
