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

// Bodies that touch with faces of four points: rows of the normals, of friction along two
// directions at the middle, and of turning.
inline Heap heapOfFaces(std::mt19937_64& random, Index bodies, Index faces, double friction) {
    std::normal_distribution<double> normal;
    std::uniform_int_distribution<Index> body(0, bodies - 1);
    constexpr Index points = 4, rows = points + 3;
    Matrix j = Matrix::Zero(rows * faces, 6 * bodies);
    Heap heap;
    for (Index c = 0; c < faces; ++c) {
        const Vector way = Vector::NullaryExpr(6, [&] { return normal(random); });
        Matrix of(rows, 6); // the normal, tilted by the place of each point
        for (Index k = 0; k < points; ++k) {
            const double x = k % 2 == 0 ? -1 : 1, z = k < 2 ? -1 : 1;
            of.row(k) = way;
            of(k, 3) += z;
            of(k, 5) -= x;
        }
        for (Index row = points; row < rows; ++row)
            for (Index k = 0; k < 6; ++k)
                of(row, k) = normal(random);
        const Index first = body(random), second = body(random);
        j.block(rows * c, 6 * first, rows, 6) += of;
        if (first != second)
            j.block(rows * c, 6 * second, rows, 6) -= of;
        for (Index k = 0; k < points; ++k)
            addUnilateral(heap.laws);
        addFriction(heap.laws, 3, rows * c, friction, points);
        heap.laws.back().levers = Matrix(2, points);
        heap.laws.back().levers << -1, 1, -1, 1, -1, -1, 1, 1;
        heap.laws.back().levers *= 0.7;
    }
    Vector inverse(6 * bodies), free(6 * bodies);
    for (Index i = 0; i < inverse.size(); ++i) {
        inverse[i] = std::pow(10, -0.3 * std::abs(normal(random)));
        free[i] = normal(random);
    }
    heap.a = j * inverse.asDiagonal() * j.transpose();
    heap.b = j * free;
    return heap;
}

} // namespace complementarity
