// Multipliers as expressions are those of the equations that they solve.
#include "equations/solved_conditions.h"

#include "expression/tape.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <random>
#include <string>

using namespace solution;
using expression::Graph;
using expression::Node;
using expression::Tape;

namespace {

// Conditions of which each meets the next ones, `reach` of them; entries and rests are symbols.
class Band {
public:
    Band(std::size_t size, std::size_t reach)
        : size_(size), linear_{.graph = graph_,
                               .symbols = symbols_,
                               .constants = constants_,
                               .multipliers = held_,
                               .held = {},
                               .places = {},
                               .entries = {},
                               .rests = {},
                               .lefts = {}} {
        for (std::uint32_t row = 0; row < size; ++row)
            for (std::uint32_t column = 0; column < size; ++column)
                if (std::max(row, column) - std::min(row, column) <= reach) {
                    linear_.places.push_back({row, column});
                    linear_.entries.push_back(
                        symbol("a" + std::to_string(row) + "_" + std::to_string(column)));
                }
        for (std::size_t row = 0; row < size; ++row)
            linear_.rests.push_back(symbol("b" + std::to_string(row)));
        for (std::size_t row = 0; row < size; ++row)
            held_.push_back(symbol("m" + std::to_string(row)));
        linear_.lefts = linear_.rests;
        for (std::size_t k = 0; k < linear_.places.size(); ++k) {
            const auto [row, column] = linear_.places[k];
            linear_.lefts[row] =
                graph_.add(linear_.lefts[row], graph_.multiply(linear_.entries[k], held_[column]));
        }
        constants_ = {symbol("c")};
        std::ranges::sort(symbols_);
        symbols_.erase(std::unique(symbols_.begin(), symbols_.end()), symbols_.end());
        linear_.symbols = symbols_;
        linear_.constants = constants_;
        linear_.multipliers = held_;
        linear_.held = held_;
    }

    [[nodiscard]] Graph& graph() { return graph_; }
    [[nodiscard]] const std::vector<Node>& multipliers() const { return held_; }
    [[nodiscard]] Node constant() const { return constants_[0]; }
    [[nodiscard]] auto solvedWith(std::span<const Node> outputs) {
        const auto order = orderToWrite(size_, linear_.places);
        return solvedConditions(linear_, order.value(), outputs);
    }
    void leaveOut(std::size_t row, std::size_t column) {
        const auto at = std::ranges::find_if(linear_.places, [&](const auto& place) {
            return place.row == row && place.column == column;
        });
        linear_.entries.erase(linear_.entries.begin() + (at - linear_.places.begin()));
        linear_.places.erase(at);
    }

    // Of these nodes, where the matrix has these entries and c is 4.
    [[nodiscard]] std::vector<double> values(const SolvedConditions& solved,
                                             std::span<const Node> nodes,
                                             const Eigen::MatrixXd& matrix,
                                             const Eigen::VectorXd& rests) const {
        std::vector<double> in, out(nodes.size());
        for (const Node n : solved.symbols) {
            const std::string& name = solved.graph.name(n);
            const std::size_t bar = name.find('_');
            const auto first = static_cast<Eigen::Index>(name == "c" ? 0 : std::stoul(&name[1]));
            in.push_back(name == "c"      ? 4
                         : name[0] == 'b' ? rests[first]
                         : name[0] == 'm' ? 0
                                          : matrix(first, std::stol(&name[bar + 1])));
        }
        Tape::Scratch scratch;
        Tape(solved.graph, solved.symbols, nodes).evaluate(in, out, scratch);
        return out;
    }
    [[nodiscard]] Eigen::MatrixXd matrix(std::mt19937& random) const {
        std::normal_distribution<double> number;
        const auto n = static_cast<Eigen::Index>(size_);
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
        for (const auto& [row, column] : linear_.places)
            matrix(row, column) = matrix(column, row) = number(random);
        matrix.diagonal().setConstant(10);
        return matrix;
    }

private:
    Node symbol(const std::string& name) {
        symbols_.push_back(graph_.symbol(name));
        return symbols_.back();
    }

    std::size_t size_;
    Graph graph_;
    std::vector<Node> symbols_, constants_, held_;
    LinearConditions linear_;
};

} // namespace

TEST(SolvedConditions, AreThoseOfTheEquations) {
    std::mt19937 random(3);
    for (const auto& [size, reach] : {std::pair(1, 0), std::pair(7, 1), std::pair(12, 3)}) {
        Band band(static_cast<std::size_t>(size), static_cast<std::size_t>(reach));
        const auto solved = band.solvedWith({});
        ASSERT_TRUE(solved);
        const Eigen::MatrixXd matrix = band.matrix(random);
        const Eigen::VectorXd rests = Eigen::VectorXd::Random(size);
        const Eigen::VectorXd expected = matrix.partialPivLu().solve(-rests);
        const auto found = band.values(*solved, solved->multipliers, matrix, rests);
        for (Eigen::Index i = 0; i < size; ++i)
            EXPECT_NEAR(found[static_cast<std::size_t>(i)], expected[i], 1e-14);
        for (const double check : band.values(*solved, solved->checks, matrix, rests))
            EXPECT_GT(check, 0);
    }
}

TEST(SolvedConditions, ArePutIntoOutputs) {
    std::mt19937 random(4);
    Band band(3, 1);
    Graph& graph = band.graph();
    const Node m = band.multipliers()[1], a = graph.symbol("a0_0"), c = band.constant();
    const std::vector<Node> outputs = {graph.multiply(a, graph.multiply(c, m)), graph.divide(a, c),
                                       graph.negate(graph.divide(graph.multiply(a, c), m))};
    const auto solved = band.solvedWith(outputs);
    ASSERT_TRUE(solved);
    const Eigen::MatrixXd matrix = band.matrix(random);
    const Eigen::Vector3d rests(1, 2, 3), expected = matrix.partialPivLu().solve(-rests);
    const auto found = band.values(*solved, solved->outputs, matrix, rests);
    EXPECT_NEAR(found[0], matrix(0, 0) * 4 * expected[1], 1e-13);
    EXPECT_EQ(found[1], matrix(0, 0) / 4);
    EXPECT_NEAR(found[2], -matrix(0, 0) * 4 / expected[1], 1e-11);
}

TEST(SolvedConditions, SayWhereARowIsRedundant) {
    Band band(2, 1);
    const auto solved = band.solvedWith({});
    ASSERT_TRUE(solved);
    const auto checks = band.values(*solved, solved->checks, Eigen::MatrixXd::Constant(2, 2, 3),
                                    Eigen::Vector2d(1, 1));
    EXPECT_LT(*std::ranges::min_element(checks), 0);
}

TEST(SolvedConditions, SayWhereTheMatrixIsNotSymmetric) {
    std::mt19937 random(5);
    Band band(12, 2);
    const auto solved = band.solvedWith({});
    ASSERT_TRUE(solved);
    const Eigen::MatrixXd symmetric = band.matrix(random);
    const Eigen::VectorXd rests = Eigen::VectorXd::Random(12);
    for (const auto& [row, column] : {std::pair(3, 4), std::pair(4, 3), std::pair(11, 9)})
        for (const double by : {1e-9, 1e-3, 1.0}) {
            Eigen::MatrixXd matrix = symmetric;
            matrix(row, column) += by;
            const auto checks = band.values(*solved, solved->checks, matrix, rests);
            EXPECT_LT(*std::ranges::min_element(checks), 0) << row << " " << column << " " << by;
        }
}

TEST(SolvedConditions, AreNoneWhereTheMatrixHasNoMirror) {
    Band band(3, 1);
    band.leaveOut(1, 2);
    EXPECT_FALSE(band.solvedWith({}));
}

// Nothing moves, and nothing is to be kept.
TEST(SolvedConditions, MayAllBeNothing) {
    std::mt19937 random(6);
    Band band(4, 1);
    const auto solved = band.solvedWith({});
    ASSERT_TRUE(solved);
    for (const double check :
         band.values(*solved, solved->checks, band.matrix(random), Eigen::VectorXd::Zero(4)))
        EXPECT_GT(check, 0);
}

// The code of a chain is in proportion to its conditions, and so it is at most of others: a
// lattice, of which a dense elimination would take still more, is not written.
TEST(SolvedConditions, AreNotWrittenOfALattice) {
    const auto orderOf = [](std::uint32_t wide, std::uint32_t high) {
        std::vector<EliminationOrder::Place> places;
        for (std::uint32_t i = 0; i < wide * high; ++i) {
            places.push_back({i, i});
            for (const std::uint32_t next :
                 {i % wide + 1 < wide ? i + 1 : i, i + wide < wide * high ? i + wide : i})
                if (next != i) {
                    places.push_back({i, next});
                    places.push_back({next, i});
                }
        }
        return orderToWrite(std::size_t{wide} * high, places);
    };
    EXPECT_TRUE(orderOf(2, 1000));
    EXPECT_TRUE(orderOf(8, 8));
    EXPECT_FALSE(orderOf(42, 42));
}

TEST(EliminationOrder, TakesAChainFromBothEnds) {
    std::vector<EliminationOrder::Place> places;
    for (std::uint32_t i = 0; i + 1 < 6; ++i)
        places.push_back({i, i + 1});
    using Rows = std::vector<std::uint32_t>;
    EXPECT_EQ(eliminationOrder(6, places, 100)->rows, Rows({0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(eliminationOrder(6, places, 100, AmongEquals::waitsLeast)->rows,
              Rows({0, 5, 1, 4, 2, 3}));
    EXPECT_EQ(eliminationOrder(6, places, 100)->multiplications, 5u);
    EXPECT_FALSE(eliminationOrder(6, places, 4));
}
