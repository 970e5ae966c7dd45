#include "complementarity/least.h"

#include <gtest/gtest.h>

namespace complementarity {

namespace {

using Matrix = Least::Matrix;
using Vector = Least::Vector;

// Symmetric, of the given rank.
Matrix ofRank(Eigen::Index rank, Eigen::Index size) {
    Matrix columns(size, rank);
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index k = 0; k < rank; ++k)
            columns(i, k) = static_cast<double>((7 * i * i + 3 * i * k + 11 * k) % 13) - 6;
    return columns * columns.transpose();
}

} // namespace

TEST(Least, RowsOfOtherSizesHideNoRank) {
    Matrix a(3, 3);
    a << 1e16, 2e16, 0, 1, 1, 1, 0, 1, 3;
    const Vector x = Vector::LinSpaced(3, 1, 3);
    EXPECT_LT((Least(a).solve(a * x) - x).norm(), 1e-12);
    a.row(2) << 0, 1, -1; // the first less the second: the shortest remains
    const Vector shortest = Least(a).solve(a * x);
    EXPECT_LT((Vector(a * (shortest - x)).cwiseQuotient(Vector{{1e16, 1, 1}})).norm(), 1e-12);
    EXPECT_NEAR(shortest.dot(Vector{{-2, 1, 1}}), 0, 1e-12);
}

TEST(Least, TheShortestIsFoundOfEachRightSide) {
    for (const Eigen::Index size : {10, 80}) {
        const Matrix a = ofRank(6, size);
        const Matrix inverse = a.completeOrthogonalDecomposition().pseudoInverse();
        Least least(a);
        // Some right sides have a solution, others have none: one that errs least is given.
        for (const Vector& right : {Vector(a.col(1)), Vector(Vector::Unit(size, 2)),
                                    Vector(a.col(3)), Vector(a * a.col(0))}) {
            const Vector expected = inverse * right;
            EXPECT_LT((least.solve(right) - expected).norm(), 1e-8 * expected.norm());
        }
    }
}

} // namespace complementarity
