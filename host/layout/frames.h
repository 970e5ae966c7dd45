// Which frames of a model's boxes are on a page?
#pragma once

#include "strips/strip.h"

namespace layout {

// A strip that was put on the page.
struct Placed {
    std::size_t block = 0;
    bool firstOfBlock = false, lastOfBlock = false;
    double top = 0, bottom = 0;
};

class Frames {
public:
    // LIMIT: a frame inside so many others is not drawn; its paddings are there.
    static constexpr int deepest = 64;

    explicit Frames(const model::Model& model);

    // The paddings that boxes put above the block's top and below its bottom.
    [[nodiscard]] double above(std::size_t block) const { return above_[block]; }

    // Those of a page, outer ones first, for a text area of that width at `left`. Takes a step for
    // each strip and for each box that is on the page: `boxesVisited` grows by these.
    [[nodiscard]] std::vector<FramePiece> on(const std::vector<Placed>& page, double left,
                                             double width, std::size_t& boxesVisited) const;

    // Compares the frames of two models.
    class Comparison;

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    struct Nested {
        std::size_t outer = none;
        // Its padding and those of the boxes in it that begin, end with it.
        double before = 0, after = 0;
    };
    const std::vector<model::Box>& boxes_;
    std::vector<Nested> nested_;         // of each box
    std::vector<std::size_t> innermost_; // of each block, its box or none
    std::vector<double> above_;
    std::vector<std::uint64_t> edges_; // of each block, how many boxes begin with it and end
};

class Frames::Comparison {
public:
    Comparison(const Frames& a, const Frames& b) : a_(a), b_(b), matched_(b.boxes_.size(), none) {}
    // Do both blocks stand in the same place of boxes that look the same?
    [[nodiscard]] bool same(std::size_t blockOfA, std::size_t blockOfB);

private:
    bool sameBox(std::size_t ofA, std::size_t ofB);

    const Frames& a_;
    const Frames& b_;
    std::vector<std::size_t> matched_; // of each box of b, that of a
};

} // namespace layout
