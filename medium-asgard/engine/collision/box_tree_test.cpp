#include "collision/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace collision {
namespace {

using geometry::Vector;

std::vector<std::size_t> overlapping(const BoxTree& tree, const geometry::Box& box) {
    std::vector<std::size_t> owners;
    tree.overlapping(box, owners);
    std::ranges::sort(owners);
    return owners;
}

// Boxes of all sizes come, move and go in any order; every answer is that of looking at all.
TEST(BoxTree, AnswersLikeLookingAtAllBoxes) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> place(-5, 5), exponent(-3, 1);
    const auto draw = [&] {
        const Vector corner(place(random), place(random), place(random));
        const Vector size(std::pow(10, exponent(random)), std::pow(10, exponent(random)),
                          std::pow(10, exponent(random)));
        return geometry::Box(corner, corner + size);
    };
    constexpr std::size_t owners = 120;
    BoxTree tree(owners);
    std::vector<geometry::Box> boxes(owners);
    std::size_t found = 0;
    for (int i = 0; i < 4000; ++i) {
        const std::size_t owner = random() % owners;
        if (tree.contains(owner) && random() % 3 == 0)
            tree.remove(owner);
        else
            tree.put(owner, boxes[owner] = draw());
        const geometry::Box asked = draw();
        std::vector<std::size_t> expected;
        for (std::size_t o = 0; o < owners; ++o)
            if (tree.contains(o) && boxes[o].intersects(asked))
                expected.push_back(o);
        ASSERT_EQ(overlapping(tree, asked), expected) << i;
        found += expected.size();
    }
    EXPECT_GT(found, 1000u);
}

// However they were put in, asking about one of many looks at a number that grows like log n.
TEST(BoxTree, LooksAtFewOfManyDistantBoxes) {
    for (const std::size_t n : {1000u, 8000u}) {
        BoxTree tree(n);
        const auto boxOf = [](std::size_t i) { // in a row, in order: the worst for plain trees
            const Vector corner(3.0 * static_cast<double>(i), 0, 0);
            return geometry::Box(corner, corner + Vector::Ones());
        };
        for (std::size_t i = 0; i < n; ++i)
            tree.put(i, boxOf(i));
        const std::size_t before = tree.visits();
        for (std::size_t i = 0; i < n; ++i)
            ASSERT_EQ(overlapping(tree, boxOf(i)), std::vector{i});
        EXPECT_LT(static_cast<double>(tree.visits() - before) / static_cast<double>(n),
                  8 * std::log2(static_cast<double>(n)));
    }
}

} // namespace
} // namespace collision
