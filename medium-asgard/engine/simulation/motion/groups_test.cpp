// Members of one group are known by their least.
#include "motion/groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace simulation {
namespace {

using ::testing::ElementsAre;

TEST(Groups, AreKnownByTheirLeastMember) {
    Groups groups(6);
    groups.join(4, 5);
    groups.join(1, 3);
    EXPECT_THAT(groups.roots(), ElementsAre(0, 1, 2, 1, 4, 4));
    groups.join(5, 3);
    EXPECT_THAT(groups.roots(), ElementsAre(0, 1, 2, 1, 1, 1));
    EXPECT_EQ(groups.root(5), 1u);
}

TEST(Groups, GoOnFromOthers) {
    Groups groups(std::vector<std::size_t>{0, 0, 2, 2});
    groups.join(1, 3);
    EXPECT_THAT(groups.roots(), ElementsAre(0, 0, 0, 0));
}

} // namespace
} // namespace simulation
