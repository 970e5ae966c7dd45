#include "complementarity/by_few.h"
#include "complementarity/solve.h"
#include "complementarity/testing.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace complementarity {
namespace {

constexpr double g = 9.81;

// A block of mass 1 on a slope: rows along the normal, down the slope and across.
struct Slope {
    Matrix a = Matrix::Identity(3, 3);
    Laws laws;
    explicit Slope(double friction) {
        addUnilateral(laws);
        addFriction(laws, 2, 0, friction);
    }
    [[nodiscard]] Answer at(double angle) const {
        const Vector b = (Vector(3) << -g * std::cos(angle), g * std::sin(angle), 0).finished();
        return solve(a, b, laws).value();
    }
};

TEST(Solve, ABlockHoldsOnASlopeUpToTheAngleOfFriction) {
    const Slope slope(0.6);
    const double angle = std::atan(0.6);
    const Answer holds = slope.at(angle - 1e-12);
    EXPECT_EQ(holds.states[1], State::inside);
    EXPECT_LE(holds.rates.norm(), 1e-15);
    const Answer slides = slope.at(angle + 1e-9);
    EXPECT_EQ(slides.states[1], State::edge);
    EXPECT_GT(slides.rates[1], 0);
    const Answer fast = slope.at(1);
    EXPECT_NEAR(fast.rates[1], g * (std::sin(1.0) - 0.6 * std::cos(1.0)), 1e-14);
    EXPECT_NEAR(fast.forces[1], -0.6 * g * std::cos(1.0), 1e-14);
    EXPECT_EQ(fast.rates[2], 0);
}

TEST(Solve, AContactThatOpensHasNoFriction) {
    const Slope slope(0.6);
    const Vector b = (Vector(3) << 1, 2, 3).finished();
    const Answer answer = solve(slope.a, b, slope.laws).value();
    EXPECT_TRUE(answer.forces.isZero(0));
    EXPECT_EQ(answer.rates, b);
}

// A block of mass 1 on a floor that slides along x with its centre of mass beside the middle of its
// two feet, at z = -1 and 1, and above them: rows of the normals, of friction along x and z, and of
// turning.
struct Loaded {
    Matrix a = Matrix::Zero(5, 5);
    Vector b = Vector::Zero(5);
    Laws laws;
    Loaded(double beside, double speed) {
        constexpr double weight = 9.81, friction = 0.3;
        // Velocities (y, x, z, turns about x, turns about y), of unit mass and inertia.
        Matrix rows(5, 5);
        rows << 1, 0, 0, 1 + beside, 0, //
            1, 0, 0, beside - 1, 0,     //
            0, 1, 0, 0, -beside,        //
            0, 0, 1, -0.8, 0,           //
            0, 0, 0, 0, 1;
        a = rows * rows.transpose();
        b << -weight, -weight, speed, 0, 0;
        addUnilateral(laws);
        addUnilateral(laws);
        addFriction(laws, 3, 0, friction, 2);
        laws.back().levers = (Matrix(2, 2) << -1, 1, 0, 0).finished();
    }
};

TEST(Solve, FrictionOfAFaceActsAtTheCentreOfItsNormalForces) {
    for (const double beside : {0.0, 0.4, -0.7}) {
        const Loaded loaded(beside, 5);
        Work work;
        const auto answer = solve(loaded.a, loaded.b, loaded.laws, {}, &work);
        ASSERT_TRUE(answer) << beside;
        EXPECT_LE(work.rounds, 8);
        EXPECT_LE(violation(loaded.a, loaded.b, loaded.laws, *answer), 1e-11);
        EXPECT_EQ(answer->states[2], State::edge);
        EXPECT_NEAR(answer->forces[2], -0.3 * 9.81, 1e-10);
        EXPECT_NEAR(answer->rates[4], 0, 1e-10) << beside; // it does not turn
    }
    Loaded held(0.4, 0.1);
    const auto answer = solve(held.a, held.b, held.laws);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->states[2], State::inside);
    EXPECT_LE(answer->rates.norm(), 1e-12);
}

// A can of unit mass and inertia, hit beside its middle so that it tips, on sixteen points of its
// rim: those few that carry are found, and the others would not sink in.
TEST(Solve, ByFewOfManyNormalForcesIsTheSameAnswer) {
    constexpr Index many = 16;
    for (const double side : {0.1, 0.5, 2.0, 3.9}) {
        Matrix rows = Matrix::Zero(many + 3, 5); // velocities (y, x, z, turns about x, about z)
        Matrix levers(2, many);
        for (Index i = 0; i < many; ++i) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(i) / many;
            rows.row(i) << 1, 0, 0, -std::sin(angle), std::cos(angle);
            levers.col(i) << -std::sin(angle), std::cos(angle);
        }
        rows(many, 1) = rows(many + 1, 2) = 1;
        const Matrix a = rows * rows.transpose();
        Vector blow(5);
        blow << -1, 0.3, 0, 0.9 * std::sin(side), -0.9 * std::cos(side);
        const Vector b = rows * blow;
        Laws laws;
        for (Index i = 0; i < many; ++i)
            addUnilateral(laws);
        addFriction(laws, 3, 0, 0.3, many);
        laws.back().levers = levers;
        const auto few = solveByFew(a, b, laws), all = solve(a, b, laws);
        ASSERT_TRUE(few && all) << side;
        EXPECT_LE(violation(a, b, laws, *few), 1e-10) << side;
        EXPECT_LE((few->rates - all->rates).norm(), 1e-9) << side;
        EXPECT_EQ(few->states.size(), laws.size());
        EXPECT_LE(std::ranges::count(few->states, State::inside), 6);
    }
}

// The same block while it slides and turns: its friction follows its normal forces, and the couple
// of these.
TEST(Solve, ASlipActsAtTheCentreOfItsNormalForces) {
    for (const double turning : {0.0, 0.5, -3.0}) {
        Loaded loaded(0.4, 0);
        Law& slip = loaded.laws.back();
        slip.kind = Law::Kind::slip;
        slip.velocity = (Vector(3) << 1, 0.2, turning).finished();
        slip.beside = Vector::Zero(3);
        const auto answer = solve(loaded.a, loaded.b, loaded.laws);
        ASSERT_TRUE(answer) << turning;
        EXPECT_LE(violation(loaded.a, loaded.b, loaded.laws, *answer), 1e-11);
        EXPECT_EQ(answer->states[2], State::edge);
        const double pressed = answer->forces[0] + answer->forces[1];
        const double centre = (answer->forces[1] - answer->forces[0]) / pressed;
        const Eigen::Vector3d way(1 + centre * turning, 0.2, turning);
        const Eigen::Vector3d force = -0.3 * pressed * way / way.norm();
        EXPECT_NEAR(answer->forces[2], force[0], 1e-9);
        EXPECT_NEAR(answer->forces[4], force[2] + centre * force[0], 1e-9);
    }
}

// Four feet of a plate at x, y = -1 or 1, of mass 1, on a floor; `slide` of each normal force is
// friction that turns the plate about y. Feet that are not quite in a plane have rates that cannot
// all be 0.
struct Plate {
    Matrix a = Matrix::Zero(4, 4);
    Vector b = Vector::Zero(4);
    Laws laws;
    Plate(double slide, double bent) {
        constexpr double weight = 9.81;
        const double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
        for (Index i = 0; i < 4; ++i) {
            addUnilateral(laws);
            b[i] = -weight + (i == 2 ? bent : 0);
            for (Index k = 0; k < 4; ++k)
                a(i, k) = 1 + 2 * y[i] * y[k] + 2 * x[i] * (x[k] - slide);
        }
    }
};

TEST(Solve, OfFourFeetThatBendTheFloorOneLeaves) {
    for (const double slide : {0.0, 0.3}) {
        const Plate plate(slide, 1e-5);
        const auto answer = solve(plate.a, plate.b, plate.laws);
        ASSERT_TRUE(answer) << slide;
        EXPECT_LE(violation(plate.a, plate.b, plate.laws, *answer), 1e-11);
        EXPECT_NEAR(answer->rates.maxCoeff(), 1e-5, 1e-10);
        EXPECT_NEAR(answer->forces.sum(), 9.81, 1e-4);
        EXPECT_GE(answer->forces.minCoeff(), 0);
    }
}

// The same with all feet's friction in rows of their own, which slip a million times as fast as the
// feet hit the floor.
TEST(Solve, ASlipThatForcesHardlyTurnIsOutOfSightOfTheRest) {
    constexpr double friction = 0.3, height = 1, fast = 2;
    const Plate flat(0, 1e-11);
    Matrix a = Matrix::Zero(8, 8);
    Vector b(8);
    Laws laws = flat.laws;
    const double x[] = {-1, 1, 1, -1};
    a.topLeftCorner(4, 4) = flat.a;
    for (Index i = 0; i < 4; ++i) {
        addFriction(laws, 1, i, friction);
        b[i] = flat.b[i] * 1e-6;
        b[4 + i] = fast;
        for (Index k = 0; k < 4; ++k) {
            a(4 + i, 4 + k) = 1 + 2 * height * height;
            a(i, 4 + k) = a(4 + k, i) = 2 * x[i] * height;
        }
    }
    const auto answer = solve(a, b, laws);
    ASSERT_TRUE(answer);
    EXPECT_LE(violation(a, b, laws, *answer), 1e-11);
    EXPECT_LE(answer->rates.head(4).cwiseAbs().maxCoeff(), 1e-10);
    for (Index i = 0; i < 4; ++i)
        EXPECT_NEAR(answer->forces[4 + i], -friction * answer->forces[i], 1e-17);
}

// Two equal balls on a floor, one on both, in a plane; masses, radii and weights are 1. Rows: for
// each contact its normal and its tangent. The pile stands where the friction between balls is at
// least 2 - sqrt 3, and that on the floor a third of it.
class ThreeBalls {
public:
    ThreeBalls(double ballFriction, double floorFriction) {
        const double c = 0.5, s = std::numbers::sqrt3 / 2;
        addContact(0, -1, 0, -1, floorFriction); // from the first body to its partner
        addContact(1, -1, 0, -1, floorFriction);
        addContact(0, 2, c, s, ballFriction);
        addContact(1, 2, -c, s, ballFriction);
        Matrix mass = Matrix::Identity(9, 9);
        for (Index body = 0; body < 3; ++body)
            mass(3 * body + 2, 3 * body + 2) = 0.4;
        const Matrix j = jacobian_;
        a_ = j * mass.inverse() * j.transpose();
        Vector weight = Vector::Zero(9);
        for (Index body = 0; body < 3; ++body)
            weight[3 * body + 1] = -1;
        b_ = j * weight;
    }
    [[nodiscard]] bool stands() const {
        const std::optional<Answer> answer = solve(a_, b_, laws_);
        return answer && answer->rates.cwiseAbs().maxCoeff() <= 1e-12;
    }

private:
    // (x, y): from the body's centre towards its partner, of length 1.
    void addContact(Index body, Index partner, double x, double y, double friction) {
        const Index row = jacobian_.rows();
        jacobian_.conservativeResize(row + 2, 9);
        jacobian_.bottomRows(2).setZero();
        const auto add = [&](Index of, double sign) { // the lever is sign * (x, y)
            jacobian_.block(row, 3 * of, 2, 3) << -x * sign, -y * sign, 0, -y * sign, x * sign, 1;
        };
        add(body, 1);
        if (partner >= 0)
            add(partner, -1);
        const Index normal = row;
        addUnilateral(laws_);
        addFriction(laws_, 1, normal, friction);
    }

    Matrix jacobian_ = Matrix(0, 9);
    Matrix a_;
    Vector b_;
    Laws laws_;
};

TEST(Solve, ThreeBallsStandAtTheFrictionThatTheyNeed) {
    const double needed = 2 - std::numbers::sqrt3;
    EXPECT_TRUE(ThreeBalls(needed * (1 + 1e-9), needed).stands());
    EXPECT_FALSE(ThreeBalls(needed * (1 - 1e-9), needed).stands());
    EXPECT_TRUE(ThreeBalls(0.5, needed / 3 * (1 + 1e-9)).stands());
    EXPECT_FALSE(ThreeBalls(0.5, needed / 3 * (1 - 1e-9)).stands());
}

// A rod that slides on its lower end at 1 rad over the floor. Friction turns it into the floor:
// with much of it the normal force would have to be negative to hold the end (Painleve).
TEST(Solve, PainlevesRodHasNoneOrTwoSolutions) {
    const auto rowsWith = [](double friction, double free) {
        const double s = std::sin(1.0), c = std::cos(1.0); // mass 1, length 2, I = 1/3
        const double normal = 1 + 3 * c * c, along = -3 * s * c;
        return std::pair(Matrix::Constant(1, 1, normal + friction * along),
                         Vector::Constant(1, free));
    };
    Laws laws;
    addUnilateral(laws);
    const auto [usual, free] = rowsWith(0.3, -g);
    EXPECT_EQ(everySolution(usual, free, laws).size(), 1u);
    const auto [steep, pressed] = rowsWith(2, -g);
    EXPECT_LT(steep(0, 0), 0);
    EXPECT_FALSE(solve(steep, pressed, laws));
    const auto [same, lifted] = rowsWith(2, 0.5);
    EXPECT_EQ(everySolution(same, lifted, laws).size(), 2u);
    // The state before goes on.
    for (const State state : {State::inside, State::low}) {
        const Answer before{Vector::Ones(1), Vector::Ones(1), {state}};
        EXPECT_EQ(solve(same, lifted, laws, before)->states[0], state);
    }
}

// Symmetric, and not convex: the active set method would go round for ever.
TEST(Solve, ASymmetricMatrixWithANegativeDirectionHasItsAnswer) {
    Laws laws;
    addUnilateral(laws);
    addUnilateral(laws);
    const Matrix a = (Matrix(2, 2) << -0.1, 5, 5, 1).finished();
    const auto answer = solve(a, (Vector(2) << -4, -1).finished(), laws);
    ASSERT_TRUE(answer);
    EXPECT_LE(violation(a, (Vector(2) << -4, -1).finished(), laws, *answer), 1e-14);
}

TEST(Solve, AnEdgeWithoutForceIsNoAnswer) {
    Laws laws;
    addDisc(laws, 2, 5);
    const Vector zero = Vector::Zero(2), rate = Vector::Unit(2, 0);
    EXPECT_GT(violation(Matrix::Zero(2, 2), rate, laws, {zero, rate, {State::edge}}), 0.5);
}

TEST(Solve, RandomHeapsKeepTheirLaws) {
    std::mt19937_64 random(11);
    int found = 0, steps = 0, tries = 0, tried = 0;
    for (const double friction : {0.1, 0.5, 1.0})
        for (Index contacts = 1; contacts <= 20; ++contacts) {
            const Heap heap = randomHeap(random, 1 + contacts / 2, contacts, friction);
            Work work;
            const auto answer = solve(heap.a, heap.b, heap.laws, {}, &work);
            ++tried;
            steps += work.steps;
            tries += work.tries;
            if (!answer)
                continue;
            ++found;
            EXPECT_LE(violation(heap.a, heap.b, heap.laws, *answer), 1e-11);
            // A guess that is right costs one solve of its states.
            const auto again = solve(heap.a, heap.b, heap.laws, *answer, &work);
            ASSERT_TRUE(again);
            EXPECT_EQ(work.steps, 0);
        }
    EXPECT_EQ(found, tried);
    EXPECT_LE(steps, 30 * tried);
    EXPECT_LE(tries, 3 * tried);
}

struct Tally {
    int tried = 0, found = 0, rounds = 0, steps = 0;

    void add(const Heap& heap, double allowed) {
        Work work;
        const auto answer = solve(heap.a, heap.b, heap.laws, {}, &work);
        ++tried;
        rounds += work.rounds;
        steps += work.steps;
        if (!answer)
            return;
        ++found;
        EXPECT_LE(violation(heap.a, heap.b, heap.laws, *answer), allowed);
    }
};

// Rows of cubes of side 1 on each other, the lowest on the floor.
class Cubes {
public:
    explicit Cubes(Index cubes) : rows_(Matrix::Zero(0, 6 * cubes)) {}
    // Along or about a way where a cube stands on what is below; `arm`: from the middle of its
    // face.
    void add(Index cube, const Vector& along, const Vector& about, const Vector& arm) {
        const Index row = rows_.rows();
        rows_.conservativeResize(row + 1, Eigen::NoChange);
        rows_.row(row).setZero();
        for (const Index side : {0, 1}) { // the upper cube, and the one below
            if (cube - side < 0)
                continue;
            const Eigen::Vector3d way = along;
            const Eigen::Vector3d from = arm + Eigen::Vector3d(0, side == 0 ? -0.5 : 0.5, 0);
            const double sign = side == 0 ? 1 : -1;
            rows_.row(row).segment(6 * (cube - side), 3) = sign * way;
            rows_.row(row).segment(6 * (cube - side) + 3, 3) = sign * (from.cross(way) + about);
        }
    }
    [[nodiscard]] static Vector corner(Index which) {
        return Eigen::Vector3d(which % 2 == 0 ? -0.5 : 0.5, 0, which < 2 ? -0.5 : 0.5);
    }
    // With masses of 1 to so many decades less, pushed and turned at random as they fall.
    void move(std::mt19937_64& random, double decades, Heap& heap) const {
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> lighter(0, decades);
        Vector inverse(rows_.cols()), free(rows_.cols());
        for (Index first = 0; first < rows_.cols(); first += 6) {
            const double mass = decades > 0 ? std::pow(10, -lighter(random)) : 1;
            inverse.segment(first, 3).setConstant(1 / mass);
            inverse.segment(first + 3, 3).setConstant(6 / mass);
            for (Index i = 0; i < 6; ++i)
                free[first + i] = 2 * normal(random) - (i == 1 ? 10 : 0);
        }
        heap.a = rows_ * inverse.asDiagonal() * rows_.transpose();
        heap.b = rows_ * free;
    }

private:
    Matrix rows_;
};

const Vector ahead = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitY(),
             aside = Eigen::Vector3d::UnitZ(), none = Eigen::Vector3d::Zero();

// Each pair touches by four corners and a face of friction; the lowest face slips.
Heap randomTower(std::mt19937_64& random, Index count, double friction) {
    std::normal_distribution<double> normal;
    constexpr Index corners = 4;
    Cubes cubes(count);
    Heap heap;
    for (Index cube = 0; cube < count; ++cube) {
        Matrix levers(2, corners);
        for (Index c = 0; c < corners; ++c) {
            const Vector corner = Cubes::corner(c);
            cubes.add(cube, up, none, corner);
            addUnilateral(heap.laws);
            levers.col(c) << corner[2], -corner[0];
        }
        cubes.add(cube, ahead, none, none);
        cubes.add(cube, aside, none, none);
        cubes.add(cube, none, up, none);
        addFriction(heap.laws, 3, rowsOf(heap.laws) - corners, friction, corners);
        heap.laws.back().levers = levers;
    }
    heap.laws[corners].kind = Law::Kind::slip;
    heap.laws[corners].velocity = Vector::NullaryExpr(3, [&]() { return normal(random); });
    heap.laws[corners].beside = Vector::Zero(3);
    cubes.move(random, 0, heap);
    return heap;
}

// Each corner has friction of its own, more than there are freedoms.
TEST(Solve, CornersOfTowersOfAnyMassesKeepTheirLaws) {
    std::mt19937_64 random(8);
    Tally tally;
    for (const double friction : {0.1, 0.3, 0.6, 1.0})
        for (Index count = 1; count <= 6; ++count) {
            Cubes cubes(count);
            Heap heap;
            for (Index row = 0; row < 4 * count; ++row) {
                for (const Vector& way : {up, ahead, aside})
                    cubes.add(row / 4, way, none, Cubes::corner(row % 4));
                addUnilateral(heap.laws);
                addFriction(heap.laws, 2, 3 * row, friction);
            }
            cubes.move(random, 6, heap);
            tally.add(heap, 1e-11);
        }
    EXPECT_EQ(tally.found, tally.tried);
    EXPECT_LE(tally.steps, 40 * tally.tried);
}

TEST(Solve, RandomTowersThatSlipKeepTheirLaws) {
    std::mt19937_64 random(3);
    Tally tally;
    for (const double friction : {0.1, 0.3, 0.6})
        for (int k = 0; k < 20; ++k)
            tally.add(randomTower(random, 2 + k % 4, friction), 1e-8);
    EXPECT_EQ(tally.found, tally.tried);
    EXPECT_LE(tally.rounds, 2 * tally.tried); // without Newton's method at moving centres: 453
}

// Three slabs stand on an edge; one foot slides, and the rates of the others are rounding.
TEST(Solve, RatesThatAreRoundingHinderNoAnswer) {
    Matrix a = Matrix::Zero(6, 6);
    const auto put = [&a](Index foot, double normal, double between, double along) {
        a(foot, foot) = normal;
        a(foot, 3 + foot) = a(3 + foot, foot) = between;
        a(3 + foot, 3 + foot) = along;
    };
    put(0, 7.5356, -1.6033, 2.4644);
    put(1, 7.1285, -2.1141, 2.8715);
    put(2, 7.1286, -2.1140, 2.8714);
    Laws laws;
    for (int foot = 0; foot < 3; ++foot)
        addUnilateral(laws);
    for (Index foot = 0; foot < 3; ++foot)
        addFriction(laws, 1, foot, 0.34641);
    const Vector b =
        (Vector(6) << -8e-14, -2.576e-11, -1.01e-11, 0.6936, 1.06e-11, 4.16e-12).finished();
    const auto answer = solve(a, b, laws);
    ASSERT_TRUE(answer);
    EXPECT_LE(violation(a, b, laws, *answer), 1e-10);
    EXPECT_LE(answer->forces.cwiseAbs().maxCoeff(), 1e-10);
}

// A cloth on a slider that a motor draws over a table, and that nothing presses down: its rates are
// what is left of a motion that fades.
TEST(Solve, RatesThatFadeAskForNoForces) {
    Matrix rows = Matrix::Zero(13, 6); // by ways and turns of the cloth
    const double arm = 0.8944, side = 0.4472, thick = 0.003577;
    rows.topLeftCorner(6, 6).setIdentity(); // the slider's
    for (Index corner = 0; corner < 4; ++corner)
        rows.row(6 + corner) << 0, 1, 0, corner % 3 == 0 ? -arm : arm, 0, corner < 2 ? -side : side;
    rows.row(10) << 1, 0, 0, thick, 0, 0;
    rows.row(11) << 0, 0, 1, 0, 0, -thick;
    rows.row(12) << 0, 0, 0, 0, -0.53061, 0;
    const Vector mobility = (Vector(6) << 10 / 3., 10 / 3., 10 / 3., 12.5, 10, 50).finished();
    const Matrix a = rows * mobility.asDiagonal() * rows.transpose();
    Laws laws;
    for (Index row = 0; row < 10; ++row)
        laws.push_back({.first = row, .low = row < 6 ? -unbounded : 0});
    Law slip{.kind = Law::Kind::slip,
             .first = 10,
             .rows = 3,
             .coefficient = 0.4,
             .normal = 6,
             .normals = 4,
             .levers = Matrix(2, 4),
             .velocity = Eigen::Vector3d(2, -3e-36, 6e-35),
             .beside = Eigen::Vector3d(2.8e-32, 1.4e-66, 8.3e-67)};
    slip.levers << 0.8428, 0.8428, -0.8428, -0.8428, 1.6857, -1.6857, -1.6857, 1.6857;
    laws.push_back(slip);
    const Vector b = (Vector(13) << 0, 0, 5.5201e-72, 1.1254e-66, 7.3144e-67, 0, 2.6106e-68,
                      2.6115e-68, 2.6074e-68, 2.6064e-68, -1.2343e-69, -1.3083e-69, 8.9573e-67)
                         .finished();
    const auto answer = solve(a, b, laws);
    ASSERT_TRUE(answer);
    EXPECT_LE(answer->forces.cwiseAbs().maxCoeff(), 1e-30);
}

} // namespace
} // namespace complementarity
