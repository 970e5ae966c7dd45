#include "complementarity/pivots.h"

#include "complementarity/solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace complementarity {
namespace {

constexpr double gravity = 9.81;

// Boxes of mass 1 and side 1 in a plane, each with x, y and a turn: contacts at points, with
// friction for each two points of one pair.
class Boxes {
public:
    explicit Boxes(std::vector<Eigen::Vector2d> centres) : centres_(std::move(centres)) {}

    // Of an upper box on a lower one, or on the floor (-1): from `left` to `right`. Of two side by
    // side the normal lies.
    void touch(int upper, int lower, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
               const Eigen::Vector2d& normal, double friction) {
        const auto first = static_cast<Index>(rows_.size());
        for (const Eigen::Vector2d& point : {from, to}) {
            rows_.push_back(rowOf(upper, lower, point, normal));
            addUnilateral(laws_);
        }
        rows_.push_back(rowOf(upper, lower, (from + to) / 2, {normal.y(), -normal.x()}));
        addFriction(laws_, 1, first, friction, 2);
    }
    // With these accelerations of boxes without contact.
    void fill(const Vector& accelerations, Matrix& a, Vector& b) const {
        constexpr double inertia = 1.0 / 6;
        Matrix j(static_cast<Index>(rows_.size()), accelerations.size());
        for (std::size_t i = 0; i < rows_.size(); ++i)
            j.row(static_cast<Index>(i)) = rows_[i];
        Vector inverse(accelerations.size());
        for (Index i = 0; i < inverse.size(); ++i)
            inverse[i] = i % 3 == 2 ? 1 / inertia : 1;
        a = j * inverse.asDiagonal() * j.transpose();
        b = j * accelerations;
    }
    [[nodiscard]] const Laws& laws() const { return laws_; }

private:
    [[nodiscard]] Eigen::RowVectorXd rowOf(int upper, int lower, const Eigen::Vector2d& point,
                                           const Eigen::Vector2d& way) const {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(3 * static_cast<Index>(centres_.size()));
        const auto add = [&](int box, double sign) {
            if (box < 0)
                return;
            const Eigen::Vector2d arm = point - centres_[static_cast<std::size_t>(box)];
            row.segment(3 * box, 3) +=
                sign * Eigen::RowVector3d(way.x(), way.y(), arm.x() * way.y() - arm.y() * way.x());
        };
        add(upper, 1);
        add(lower, -1);
        return row;
    }

    std::vector<Eigen::Vector2d> centres_;
    std::vector<Eigen::RowVectorXd> rows_;
    Laws laws_;
};

// Four rows of boxes next to each other, whose faces tilt by some 1e-9.
Boxes pyramid(double friction, std::mt19937& random) {
    constexpr int rows = 4;
    std::vector<Eigen::Vector2d> centres;
    std::vector<std::vector<int>> names;
    for (int r = 0; r < rows; ++r) {
        names.emplace_back();
        for (int k = 0; k < rows - r; ++k) {
            names.back().push_back(static_cast<int>(centres.size()));
            centres.emplace_back(k + r / 2.0, r + 0.5);
        }
    }
    Boxes boxes(centres);
    std::normal_distribution<double> tilt(0, 4e-9);
    const auto touch = [&](int upper, int lower, double x0, double y0, double x1, double y1,
                           double angle) {
        const double turned = angle + tilt(random);
        boxes.touch(upper, lower, {x0, y0}, {x1, y1}, {std::cos(turned), std::sin(turned)},
                    friction);
    };
    constexpr double up = std::numbers::pi / 2;
    const auto at = [&](int r, int k) {
        return names[static_cast<std::size_t>(r)][static_cast<std::size_t>(k)];
    };
    for (int r = 0; r < rows; ++r)
        for (int k = 0; k < rows - r; ++k) {
            const double x = k + r / 2.0;
            if (r == 0)
                touch(at(0, k), -1, x - 0.5, 0, x + 0.5, 0, up);
            else
                for (const int side : {0, 1})
                    touch(at(r, k), at(r - 1, k + side), x - 0.5 + side * 0.5, r, x + side * 0.5, r,
                          up);
            if (k > 0)
                touch(at(r, k), at(r, k - 1), x - 0.5, r, x - 0.5, r + 1, 0);
        }
    return boxes;
}

TEST(Pivots, FindTheForcesInAPyramidThatIsPushed) {
    std::mt19937 random(7);
    for (const double friction : {0.2, 0.5, 0.8})
        for (const double pushed : {0.0, 3.0, 6.0, 20.0}) {
            const Boxes boxes = pyramid(friction, random);
            Vector accelerations(30);
            for (Index i = 0; i < 10; ++i)
                accelerations.segment(3 * i, 3) << 0, -gravity, 0;
            accelerations[0] += pushed; // the first box of the lowest row
            Matrix a;
            Vector b;
            boxes.fill(accelerations, a, b);
            const auto answer = byPivots(a, b, boxes.laws());
            ASSERT_TRUE(answer) << friction << " " << pushed;
            EXPECT_LE(violation(a, b, boxes.laws(), *answer), 1e-8) << friction << " " << pushed;
            Work work;
            ASSERT_TRUE(solve(a, b, boxes.laws(), {}, &work)) << friction << " " << pushed;
            EXPECT_EQ(work.pulls, 0) << friction << " " << pushed;
        }
}

// Some of its contacts slip already, and their friction is known but for its size.
TEST(Pivots, FindTheForcesInAPyramidThatFalls) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> one(-1, 1);
    int found = 0;
    for (int round = 0; round < 40; ++round) {
        const Boxes boxes = pyramid(0.5, random);
        Vector accelerations(30);
        for (Index i = 0; i < 10; ++i)
            accelerations.segment(3 * i, 3) << 2 * one(random), -gravity + 2 * one(random),
                one(random);
        Matrix a;
        Vector b;
        boxes.fill(accelerations, a, b);
        Laws laws = boxes.laws();
        for (Law& law : laws)
            if (law.kind == Law::Kind::disc && one(random) < 0.6) {
                law.kind = Law::Kind::slip;
                law.velocity = Vector::Constant(1, one(random));
                law.beside = Vector::Zero(1);
            }
        const auto answer = solve(a, b, laws);
        if (!answer)
            continue;
        ++found;
        EXPECT_LE(violation(a, b, laws, *answer), 1e-8) << round;
    }
    EXPECT_GE(found, 36); // a direction of slip need not allow any forces
}

TEST(Pivots, KeepBothBoundsOfAMotorAndAJoint) {
    // Two slides, of which the second is held to the first by a joint; a motor drives the first.
    const Matrix a = (Matrix(2, 2) << 1, -1, -1, 2).finished();
    Laws laws;
    addInterval(laws, -3, 2);
    addEquality(laws);
    for (const double rest : {-10.0, -0.9, 1.0, 10.0}) {
        const Vector b = (Vector(2) << rest, 0).finished();
        const auto answer = byPivots(a, b, laws);
        ASSERT_TRUE(answer);
        EXPECT_LE(violation(a, b, laws, *answer), 1e-14) << rest;
        const double wanted = std::clamp(-2 * rest, -3.0, 2.0); // of 1/2 f + rest = 0
        EXPECT_NEAR(answer->forces[0], wanted, 1e-13) << rest;
        EXPECT_EQ(answer->states[0], wanted == 2    ? State::high
                                     : wanted == -3 ? State::low
                                                    : State::inside);
    }
}

// Friction along x and z is no linear law, unless nothing moves along z.
TEST(Pivots, LeaveFrictionInSpaceToOthers) {
    Laws laws;
    addUnilateral(laws);
    addFriction(laws, 2, 0, 0.5);
    const Matrix a = Matrix::Identity(3, 3);
    EXPECT_FALSE(byPivots(a, (Vector(3) << -gravity, 1, 2).finished(), laws));
    const auto answer = byPivots(a, (Vector(3) << -gravity, 6, 0).finished(), laws);
    ASSERT_TRUE(answer);
    EXPECT_NEAR(answer->forces[1], -0.5 * gravity, 1e-13);
    EXPECT_EQ(answer->states[1], State::edge);
}

} // namespace
} // namespace complementarity
