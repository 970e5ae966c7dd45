// New equations: components that they concern are made anew, all others stay.
#include "solution/network_testing.h"
#include "solution/replacement.h"

#include <gtest/gtest.h>

using namespace solution;
using namespace solution::testing;

namespace {

struct ReplacementTest : NetworkTest {
    EventIslands islands;
    Flights flights{network, islands};
    Replacement replacement{network, flights};

    // From t = 1 on the unknown has this rate.
    std::vector<std::size_t> replace(std::size_t unknown, const std::string& rate) {
        stepTo(2);
        const Event event = at(1, unknown);
        Changes changes;
        expression::Phase phase;
        phase.derivative = expression::testing::parsed(network.set.changing().graph, rate);
        changes.equations.push_back({unknown, phase, {}});
        network.goBack(network.touchedBy(event, changes), event.time);
        replacement.change(event, changes);
        auto touched = replacement.replace(event, changes, {});
        network.restart(touched, changes);
        return touched;
    }
};

} // namespace

TEST_F(ReplacementTest, OthersStay) {
    const Component* const before = network.components[network.componentOf[w]].get();
    const Component* const other = network.components[network.componentOf[alone]].get();
    const auto touched = replace(v, "-2*v");
    EXPECT_EQ(touched, componentsOf({v, x}));
    EXPECT_EQ(network.components[network.componentOf[w]].get(), before);
    EXPECT_EQ(network.components[network.componentOf[alone]].get(), other);
    EXPECT_EQ(network.touchedBy(at(1, w), {}), componentsOf({w})); // nobody reads it any more
    EXPECT_GT(replacement.retired().steps, 0u);
}

TEST_F(ReplacementTest, MotionGoesOnByTheNewEquation) {
    replace(alone, "-3");
    stepTo(2);
    EXPECT_NEAR(network.histories.value(alone, 1), 5, 1e-12);
    EXPECT_NEAR(network.histories.value(alone, 2), 2, 1e-12);
}

TEST_F(ReplacementTest, ThoseThatComeToReadEachOtherMoveTogether) {
    replace(w, "-w-x");
    EXPECT_EQ(network.componentOf[w], network.componentOf[x]);
    EXPECT_EQ(network.componentOf[w], network.componentOf[v]);
}
