#include "modes/elimination.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <limits>
#include <random>

using solution::Elimination;

namespace {

// A = J J' + 1 of conditions that each move a few of `bodies`.
class Mechanism {
public:
    void join(std::vector<int> bodies, int conditions) {
        for (int i = 0; i < conditions; ++i)
            moved_.push_back(bodies);
    }
    [[nodiscard]] std::size_t size() const { return moved_.size(); }
    [[nodiscard]] std::vector<Elimination::Place> places() const {
        std::vector<Elimination::Place> places;
        for (std::uint32_t i = 0; i < moved_.size(); ++i)
            for (std::uint32_t j = 0; j < moved_.size(); ++j)
                if (std::ranges::any_of(moved_[i], [&](int body) {
                        return std::ranges::find(moved_[j], body) != moved_[j].end();
                    }))
                    places.push_back({i, j});
        return places;
    }
    // By random numbers, scaled.
    [[nodiscard]] Eigen::MatrixXd matrix(std::mt19937& random) const {
        std::normal_distribution<double> number;
        const auto n = static_cast<Eigen::Index>(moved_.size());
        Eigen::MatrixXd j = Eigen::MatrixXd::Zero(n, 6 * 1000);
        for (Eigen::Index i = 0; i < n; ++i)
            for (const int body : moved_[static_cast<std::size_t>(i)])
                for (int k = 0; k < 6; ++k)
                    j(i, 6 * body + k) = number(random);
        const Eigen::MatrixXd a = j * j.transpose();
        const Eigen::VectorXd scale = a.diagonal().cwiseSqrt().cwiseInverse();
        return scale.asDiagonal() * a * scale.asDiagonal();
    }

private:
    std::vector<std::vector<int>> moved_; // by condition
};

void put(const Mechanism& mechanism, const Eigen::MatrixXd& matrix, Elimination& elimination) {
    std::ranges::fill(elimination.values(), 0);
    for (const Elimination::Place place : mechanism.places())
        elimination.values()[elimination.indexOf(place)] = matrix(place.row, place.column);
}

double errorOf(const Mechanism& mechanism, unsigned seed) {
    std::mt19937 random(seed);
    const Eigen::MatrixXd matrix = mechanism.matrix(random);
    Elimination elimination;
    EXPECT_TRUE(elimination.plan(mechanism.size(), mechanism.places(), 1e9));
    put(mechanism, matrix, elimination);
    EXPECT_TRUE(elimination.factorise());
    const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(matrix.rows(), -1, 2);
    Eigen::VectorXd x = wanted;
    elimination.solve({x.data(), mechanism.size()});
    return (matrix * x - wanted).cwiseAbs().maxCoeff() / x.cwiseAbs().maxCoeff();
}

Mechanism chain(int joints, int conditions) {
    Mechanism chain;
    for (int i = 0; i < joints; ++i)
        chain.join(i == 0 ? std::vector{0} : std::vector{i - 1, i}, conditions);
    return chain;
}

} // namespace

TEST(Elimination, SolvesTreesAndLoops) {
    Mechanism tree, ring = chain(12, 2);
    for (int i = 1; i < 40; ++i)
        tree.join({(i - 1) / 3, i}, 1 + i % 3); // each body carries three
    ring.join({0, 11}, 2);
    for (unsigned seed = 0; seed < 20; ++seed) {
        EXPECT_LT(errorOf(chain(30, 2), seed), 1e-12);
        EXPECT_LT(errorOf(tree, seed), 1e-12);
        EXPECT_LT(errorOf(ring, seed), 1e-12);
    }
}

// The work is in proportion to the joints: of a planar hinge within the chain 3 * 4 / 2 + 2 * 3
// / 2.
TEST(Elimination, AChainCostsInProportionToItsJoints) {
    for (const std::size_t joints : {2U, 20U, 200U}) {
        Elimination elimination;
        const Mechanism planar = chain(static_cast<int>(joints), 2);
        ASSERT_TRUE(elimination.plan(planar.size(), planar.places(), 1e9));
        EXPECT_EQ(elimination.multiplications(), 9 * (joints - 1) + 1);
        const Mechanism spatial = chain(static_cast<int>(joints), 5);
        ASSERT_TRUE(elimination.plan(spatial.size(), spatial.places(), 1e9));
        EXPECT_EQ(elimination.multiplications(), 145 * (joints - 1) + 20);
    }
}

// A tree whose root carries all others: its conditions are the last, whatever their numbers.
TEST(Elimination, AStarStartsWithItsLeaves) {
    Mechanism star;
    star.join({0}, 2);
    for (int i = 1; i <= 50; ++i) {
        star.join({0, i}, 2);
        star.join({i, 50 + i}, 2);
    }
    Elimination elimination;
    ASSERT_TRUE(elimination.plan(star.size(), star.places(), 1e9));
    EXPECT_GE(elimination.multiplications(), 50 * 9u);
    EXPECT_FALSE(elimination.plan(star.size(), star.places(), 1000));
    EXPECT_EQ(elimination.multiplications(), 0U); // nothing is left of the plan before
    EXPECT_TRUE(elimination.values().empty());
}

TEST(Elimination, RefusesWhatMayBeSingular) {
    Mechanism twice;
    twice.join({0, 1}, 2);
    Elimination elimination;
    ASSERT_TRUE(elimination.plan(2, twice.places(), 1e9));
    put(twice, Eigen::Matrix2d{{1, 1}, {1, 1 + 1e-12}}, elimination);
    EXPECT_FALSE(elimination.factorise());
}

// Bricks on each other: four forces along the normals at each face, of which the others make one,
// and one of friction.
TEST(Elimination, LeavesOutRowsThatOthersMake) {
    constexpr int bricks = 8;
    std::mt19937 random(3);
    std::normal_distribution<double> number;
    Mechanism tower;
    for (int i = 0; i < bricks; ++i)
        tower.join(i == 0 ? std::vector{0} : std::vector{i - 1, i}, 5);
    const auto n = static_cast<Eigen::Index>(tower.size());
    Eigen::MatrixXd j = Eigen::MatrixXd::Zero(n, 6 * bricks);
    for (Eigen::Index face = 0; face < bricks; ++face) {
        const Eigen::Index first = 5 * face;
        for (Eigen::Index row = 0; row < 5; ++row)
            for (Eigen::Index k = 0; k < (face == 0 ? 6 : 12); ++k)
                j(first + row, k + (face == 0 ? 0 : 6 * (face - 1))) = number(random);
        j.row(first + 3) = j.row(first) - j.row(first + 1) + j.row(first + 2);
    }
    const Eigen::MatrixXd a = j * j.transpose();
    Elimination elimination;
    ASSERT_TRUE(elimination.plan(tower.size(), tower.places(), 1e9));
    put(tower, a, elimination);
    EXPECT_FALSE(elimination.factorise());
    put(tower, a, elimination);
    ASSERT_TRUE(elimination.factorise(Elimination::Take::all));
    ASSERT_EQ(elimination.dependent().size(), static_cast<std::size_t>(bricks));
    const Eigen::VectorXd wanted = a * Eigen::VectorXd::LinSpaced(n, -1, 2);
    Eigen::VectorXd x = wanted;
    elimination.solve({x.data(), tower.size()});
    EXPECT_LT((a * x - wanted).cwiseAbs().maxCoeff(), 1e-9 * wanted.cwiseAbs().maxCoeff());
    for (std::size_t k = 0; k < bricks; ++k) {
        elimination.kernel(k, {x.data(), tower.size()});
        EXPECT_GE(x.cwiseAbs().maxCoeff(), 1);
        EXPECT_LT((a * x).cwiseAbs().maxCoeff(), 1e-9 * x.cwiseAbs().maxCoeff());
    }
}

// The four corners of a face of which one lies a little out of their plane: what is left of the
// fourth row is the square of that, and no force may come of it.
TEST(Elimination, ATiltMakesNoFourthRowOfAPatch) {
    Mechanism face;
    face.join({0}, 4);
    for (const double tilt : {0.0, 1e-9, 1e-7, 1e-6, 1e-5}) {
        Eigen::MatrixXd j(4, 4); // the last column: what the tilt alone moves
        j << 1, 0.5, 0.5, 0, 1, 0.5, -0.5, 0, 1, -0.5, -0.5, 0, 1, -0.5, 0.5, tilt;
        const Eigen::Matrix4d a = j * j.transpose();
        Elimination elimination;
        ASSERT_TRUE(elimination.plan(4, face.places(), 1e9));
        elimination.setPatches(std::vector<Elimination::Index>(4, 7));
        put(face, a, elimination);
        ASSERT_TRUE(elimination.factorise(Elimination::Take::all));
        ASSERT_EQ(elimination.dependent().size(), 1u) << tilt;
        Eigen::Vector4d x = j * Eigen::Vector4d(1, 2, 3, 4); // what moves by the tilt is no force's
        elimination.solve({x.data(), 4});
        EXPECT_LT(x.cwiseAbs().maxCoeff(), 10) << tilt;
    }
}

// Forces along y at points of a floor, on a body of mass and moments of 1: the second point lies
// next to the first. What they make of right-hand sides that some forces have is right to rounding.
TEST(Elimination, NeighboursInAPatchLeaveItsFartherPointsFirst) {
    const std::vector<Eigen::Vector2d> points{{1, 1}, {1, 1 - 1e-5}, {-1, 1}, {-1, -1}, {1, -1}};
    const auto n = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd moves(n, 3);
    Mechanism patch;
    patch.join({0}, static_cast<int>(points.size()));
    for (Eigen::Index i = 0; i < n; ++i)
        moves.row(i) << 1, points[static_cast<std::size_t>(i)].transpose();
    const Eigen::MatrixXd matrix = moves * moves.transpose();
    Elimination elimination;
    ASSERT_TRUE(elimination.plan(points.size(), patch.places(), 1e9));
    elimination.setPatches(std::vector<Elimination::Index>(points.size(), 7));
    put(patch, matrix, elimination);
    ASSERT_TRUE(elimination.factorise(Elimination::Take::all));
    EXPECT_EQ(elimination.dependent().size(), 2U);
    const Eigen::VectorXd right = moves * Eigen::Vector3d(0.3, -0.7, 1.1);
    Eigen::VectorXd forces = right;
    elimination.solve({forces.data(), points.size()});
    EXPECT_LT((matrix * forces - right).cwiseAbs().maxCoeff(), 1e-13);
    for (std::size_t k = 0; k < 2; ++k) {
        Eigen::VectorXd idle(n);
        elimination.kernel(k, {idle.data(), points.size()});
        EXPECT_LT((matrix * idle).cwiseAbs().maxCoeff(), 1e-13);
    }
}

TEST(Elimination, RefusesWhatIsNotSymmetricOrNotDefinite) {
    Mechanism pair;
    pair.join({0, 1}, 2);
    Elimination elimination;
    ASSERT_TRUE(elimination.plan(2, pair.places(), 1e9));
    put(pair, Eigen::Matrix2d{{1, 2}, {2, 1}}, elimination);
    EXPECT_FALSE(elimination.factorise());
    put(pair, Eigen::Matrix2d{{1, 0.5}, {0.4, 1}}, elimination);
    EXPECT_FALSE(elimination.factorise());
    put(pair, Eigen::Matrix2d{{1, 0.5}, {0.4, 1}}, elimination);
    EXPECT_FALSE(elimination.factorise(Elimination::Take::all));
    put(pair, Eigen::Matrix2d{{1, 0.5}, {0.5, 0}}, elimination);
    EXPECT_FALSE(elimination.factorise());
    put(pair, Eigen::Matrix2d{{1, std::numeric_limits<double>::quiet_NaN()}, {0, 1}}, elimination);
    EXPECT_FALSE(elimination.factorise());
    put(pair, Eigen::Matrix2d{{2, 1}, {1, 2}}, elimination);
    EXPECT_TRUE(elimination.factorise());
    std::vector<double> x{4, 5};
    elimination.solve(x);
    EXPECT_NEAR(x[0], 1, 1e-15);
    EXPECT_NEAR(x[1], 2, 1e-15);
}
