// Which of many boxes overlap a given one, while boxes come, move and go?
//
// A binary tree of boxes, each the hull of its two children's. A box is put beside the sibling that
// makes all boxes above grow least (the surface that a ray or a neighbour can meet, Goldsmith and
// Salmon 1987), and on the way up children and nephews change places where that makes a box
// smaller. Putting in, taking out and asking visit about log n boxes each; all pairs are never
// looked at.
#pragma once

#include "geometry/shape.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace collision {

class BoxTree {
public:
    explicit BoxTree(std::size_t owners) : leafOf_(owners, nothing) {}

    [[nodiscard]] bool contains(std::size_t owner) const { return leafOf_[owner] != nothing; }
    [[nodiscard]] const geometry::Box& box(std::size_t owner) const {
        return nodes_[leafOf_[owner]].box;
    }
    // Puts the owner's box in, in place of the one that it had.
    void put(std::size_t owner, const geometry::Box& box);
    void remove(std::size_t owner);

    // Appends the owners of all boxes that overlap this one, in no order.
    void overlapping(const geometry::Box& box, std::vector<std::size_t>& owners) const;
    // Boxes looked at by overlapping() so far.
    [[nodiscard]] std::size_t visits() const { return visits_; }

private:
    using Index = std::uint32_t;
    static constexpr Index nothing = ~Index{0};
    struct Node {
        geometry::Box box;
        Index parent = nothing, left = nothing, right = nothing; // left: nothing in a leaf
        std::size_t owner = 0;
    };

    [[nodiscard]] Index make(const geometry::Box& box);
    [[nodiscard]] Index siblingFor(const geometry::Box& box) const;
    void replaceChild(Index parent, Index old, Index now);
    void refit(Index node);
    void rotate(Index node);
    [[nodiscard]] bool tryRotation(Index node, Index child, Index other);

    std::vector<Node> nodes_;
    std::vector<Index> free_;
    std::vector<Index> leafOf_;
    Index root_ = nothing;
    mutable std::size_t visits_ = 0;
    mutable std::vector<Index> stack_;
};

} // namespace collision
