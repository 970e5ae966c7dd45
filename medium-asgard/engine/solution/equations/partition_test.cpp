#include "equations/partition.h"

#include "expression/testing.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace solution;

namespace {

expression::EquationSet
equations(const std::vector<std::pair<std::string, std::string>>& derivatives) {
    expression::EquationSet set;
    set.time = set.graph.symbol("t");
    for (const auto& [name, text] : derivatives) {
        expression::Unknown unknown;
        unknown.name = name;
        unknown.symbol = set.graph.symbol(name);
        unknown.phases.push_back({});
        unknown.phases[0].derivative = expression::testing::parsed(set.graph, text);
        set.unknowns.push_back(unknown);
    }
    return set;
}

std::string print(const Partition& partition, const expression::EquationSet& set) {
    std::string text;
    for (std::size_t c = 0; c < partition.components.size(); ++c) {
        text += "{";
        for (const std::size_t i : partition.components[c])
            text += (text.back() == '{' ? "" : " ") + set.unknowns[i].name;
        text += "}";
        for (const std::size_t d : partition.reads[c])
            text += " <- " + std::to_string(d);
        text += "\n";
    }
    return text;
}

} // namespace

// A switch that can hold x's rate at 0 gives one number then, for all whose rates have it.
TEST(Partition, WhatSharesASwitchThatCanSlideIsSolvedTogether) {
    const auto held = equations({{"v", "3-5*sign(v)"}, {"w", "2*(v<0)"}, {"u", "sign(-v)"}});
    EXPECT_EQ(print(partitionOf(readsOf(held, 0)), held), "{v w u}\n");
    // Only v's own rate moves x, and no switch of x is in it: nothing slides.
    const auto passed = equations({{"x", "v"}, {"v", "-sign(x)"}, {"w", "sign(x)"}});
    EXPECT_EQ(print(partitionOf(readsOf(passed, 0)), passed), "{x v}\n{w} <- 0\n");
    const auto other = equations({{"v", "3-5*sign(v)"}, {"w", "sign(v-1)"}, {"u", "floor(v)"}});
    EXPECT_EQ(print(partitionOf(readsOf(other, 0)), other), "{v}\n{w} <- 0\n{u} <- 0\n");
}

// Dissertation, Figure 5.8: two objects that attract each other in X only. The X equations form one
// component; each Y velocity is one, and each Y position another that reads it.
TEST(Partition, IsThatOfFigure5_8) {
    const auto set = equations({{"x1", "dx1"},
                                {"dx1", "x2-x1"},
                                {"x2", "dx2"},
                                {"dx2", "x1-x2"},
                                {"y1", "dy1"},
                                {"dy1", "-9.81"},
                                {"y2", "dy2"},
                                {"dy2", "0"}});
    EXPECT_EQ(print(partitionOf(readsOf(set, 0)), set), "{x1 dx1 x2 dx2}\n"
                                                        "{dy1}\n{y1} <- 1\n"
                                                        "{dy2}\n{y2} <- 3\n");
}

TEST(Partition, QuaternionsStayTogether) {
    auto set = equations({{"qw", "wx"}, {"qx", "0"}, {"qy", "0"}, {"qz", "0"}, {"wx", "1"}});
    set.quaternions.push_back({0, 1, 2, 3});
    EXPECT_EQ(print(partitionOf(readsOf(set, 0)), set), "{wx}\n{qw qx qy qz} <- 0\n");
}

TEST(Partition, WholeIsOneComponent) {
    const auto set = equations({{"a", "1"}, {"b", "2"}});
    EXPECT_EQ(print(wholePartition(readsOf(set, 0)), set), "{a b}\n");
}

TEST(Partition, LooksAtThePhasesThatAreStillInForce) {
    auto set = equations({{"a", "b"}, {"b", "a"}});
    expression::Phase later;
    later.from = 5;
    later.derivative = set.graph.constant(0);
    set.unknowns[0].phases.push_back(later);
    EXPECT_EQ(partitionOf(readsOf(set, 4)).components.size(), 1u);
    EXPECT_EQ(partitionOf(readsOf(set, 5)).components.size(), 2u);
}

// A chain of a million equations overflows no stack.
TEST(Partition, OfALongChainIsIterative) {
    Reads reads(1'000'000);
    for (std::size_t i = 0; i + 1 < reads.size(); ++i)
        reads[i] = {i + 1};
    const Partition chain = partitionOf(reads);
    EXPECT_EQ(chain.components.size(), reads.size());
    EXPECT_EQ(chain.components.front(), std::vector<std::size_t>{reads.size() - 1});
    reads.back() = {0};
    EXPECT_EQ(partitionOf(reads).components.size(), 1u);
}

// Two unknowns share a component exactly when each reaches the other.
TEST(Partition, AgreesWithReachabilityOnRandomGraphs) {
    std::mt19937 random(3);
    for (int round = 0; round < 200; ++round) {
        const std::size_t n = 2 + random() % 9;
        Reads reads(n);
        std::vector<std::vector<bool>> reach(n, std::vector<bool>(n, false));
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                if (random() % 5 == 0) {
                    reads[i].push_back(j);
                    reach[i][j] = true;
                }
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j)
                    if (reach[i][k] && reach[k][j])
                        reach[i][j] = true;
        const Partition partition = partitionOf(reads);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                const bool together = i == j || (reach[i][j] && reach[j][i]);
                EXPECT_EQ(partition.componentOf[i] == partition.componentOf[j], together);
                if (reach[i][j]) {
                    EXPECT_GE(partition.componentOf[i], partition.componentOf[j]);
                }
            }
    }
}
