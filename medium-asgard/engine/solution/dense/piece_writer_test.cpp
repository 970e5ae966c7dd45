// How steps become pieces: in which columns, how many of them, and how held values are followed.
#include "dense/piece_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace solution;

namespace {

// One held unknown, by a formula of time and states.
struct Formula final : HeldValues {
    using Of = std::function<double(double t, std::span<const double> y)>;
    explicit Formula(Of formula) : of(std::move(formula)) {}
    bool valuesAt(double t, std::span<const double> y, std::span<double> out) override {
        ++asked;
        out[0] = of(t, y);
        return std::isfinite(out[0]);
    }
    std::vector<double> peaksOn(const StateCurves&) override { return peaks; }
    Of of;
    std::vector<double> peaks = {};
    int asked = 0;
};

constexpr std::size_t first[] = {0}, second[] = {1};

} // namespace

TEST(PieceWriter, KeepsAStepOfStatesAsItIs) {
    PieceWriter writer(1);
    writer.takeLayout(first, {}, {});
    Formula none([](double, std::span<const double>) { return NAN; });
    const Coefficients line[] = {{1, 2}};
    writer.append({line, 3, 0.5, 3.25}, none, 0);
    ASSERT_EQ(writer.history()->size(), 1u);
    const Piece piece = writer.history()->piece(0, 0);
    EXPECT_EQ(piece.origin, 3);
    EXPECT_EQ(piece.until, 3.25);
    EXPECT_EQ(piece.value(3.25), 2);
    EXPECT_EQ(piece.coefficients.size(), 2u);
    EXPECT_EQ(none.asked, 0);
}

TEST(PieceWriter, TheFirstPieceAfterAnEventSaysSo) {
    PieceWriter writer(1);
    writer.takeLayout(first, {}, {});
    Formula none([](double, std::span<const double>) { return 0; });
    const Coefficients line[] = {{1, 2}};
    for (const double t : {0.0, 1.0, 2.0}) {
        if (t == 2)
            writer.beginAnew();
        writer.append({line, t, 1, t + 1}, none, 0);
    }
    EXPECT_TRUE(writer.history()->step(0).fresh);
    EXPECT_FALSE(writer.history()->step(1).fresh);
    EXPECT_TRUE(writer.history()->step(2).fresh);
}

TEST(PieceWriter, AStepTakesThePlaceOfTheAnchor) {
    PieceWriter writer(1);
    writer.takeLayout(first, {}, {});
    writer.standAt(1, std::vector<double>{5, 2});
    EXPECT_TRUE(writer.history()->endsInAnchor());
    EXPECT_EQ(writer.history()->piece(0, 0).value(1), 5);
    Formula none([](double, std::span<const double>) { return 0; });
    const Coefficients line[] = {{5, 2}};
    writer.append({line, 1, 1, 2}, none, 0);
    ASSERT_EQ(writer.history()->size(), 1u);
    EXPECT_TRUE(writer.history()->step(0).fresh); // standing is no piece
}

TEST(PieceWriter, AVelocityThatItsPlaceTellsIsNotKept) {
    PieceWriter writer(2);
    const std::size_t states[] = {0, 1};
    const std::pair<std::size_t, std::size_t> pair[] = {{0, 1}};
    writer.takeLayout(states, {}, pair);
    Formula none([](double, std::span<const double>) { return 0; });
    const Coefficients fall[] = {{1, 0.5, -0.25}, {0.5, -0.5}};
    writer.append({fall, 0, 1, 1}, none, 0);
    EXPECT_EQ(writer.history()->row(0).size(), 3u);
    EXPECT_EQ(writer.history()->piece(0, 1).value(1), 0);
    const Coefficients other[] = {{1, 0.5, -0.25}, {0.5, -0.4}};
    writer.append({other, 1, 1, 2}, none, 0);
    EXPECT_EQ(writer.history()->row(1).size(), 6u);
}

// h = sin(40 x) of x = t: over 1 s a polynomial of degree 8 does not follow it, over 1/16 s it
// does.
TEST(PieceWriter, AStepOnWhichHeldValuesDoNotFitIsKeptInParts) {
    PieceWriter writer(2);
    writer.takeLayout(first, second, {});
    Formula wave([](double, std::span<const double> y) { return std::sin(40 * y[0]); });
    const Coefficients line[] = {{0, 1}};
    writer.append({line, 0, 1, 1}, wave, 1e-9);
    const History& history = *writer.history();
    EXPECT_GT(history.size(), 4u);
    double until = 0;
    for (std::size_t i = 0; i < history.size(); ++i) {
        EXPECT_EQ(history.origin(i), until);
        until = history.until(i);
        const double t = 0.4 * history.origin(i) + 0.6 * until;
        EXPECT_NEAR(history.piece(i, 0).value(t), t, 1e-15);
        EXPECT_NEAR(history.piece(i, 1).value(t), std::sin(40 * t), 1e-8);
    }
    EXPECT_EQ(until, 1);
}

// A peak between the points of interpolation is seen where its middle is told.
TEST(PieceWriter, HeldValuesAreComparedWhereTheyMayPeak) {
    const auto peak = [](double t, std::span<const double>) {
        return std::exp(-std::pow((t - 0.4567) / 1e-4, 2));
    };
    Formula told(peak), untold(peak);
    told.peaks = {0.4567};
    std::vector<Coefficients> held(1);
    EXPECT_TRUE(PieceWriter::fit({{}, 0, 1, 1}, untold, 1e-6, held));
    EXPECT_FALSE(PieceWriter::fit({{}, 0, 1, 1}, told, 1e-6, held));
}

TEST(PieceWriter, HeldValuesThatAreNotFiniteDoNotFit) {
    Formula root([](double t, std::span<const double>) { return std::sqrt(0.5 - t); });
    std::vector<Coefficients> held(1);
    EXPECT_FALSE(PieceWriter::fit({{}, 0, 1, 1}, root, 1e-6, held));
    EXPECT_TRUE(PieceWriter::fit({{}, 0, 1, 0.25}, root, 1e-6, held));
}
