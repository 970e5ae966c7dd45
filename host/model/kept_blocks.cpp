#include "model/kept_blocks.h"

#include <algorithm>

namespace model {

namespace {

// Ranges of blocks of which some are gone; without those of which all are.
template <class Ranges>
void moveRanges(Ranges& ranges, const std::vector<std::size_t>& shownBefore) {
    for (auto& range : ranges) {
        range.first = shownBefore[range.first];
        range.last = shownBefore[range.last + 1]; // the one behind it
    }
    std::erase_if(ranges, [](const auto& range) { return range.first == range.last; });
    for (auto& range : ranges)
        --range.last;
}

} // namespace

std::shared_ptr<const Model> withBlocks(const Model& whole, const Blocks& shown) {
    auto result = std::make_shared<Model>();
    result->page = whole.page;
    result->textStyles = whole.textStyles;
    result->containers = whole.containers;
    result->boxes = whole.boxes;
    result->footnotes = whole.footnotes;
    result->title = whole.title;
    result->blocks.reserve(whole.blocks.size());
    std::vector<std::size_t> shownBefore; // how many are, of each block
    shownBefore.reserve(whole.blocks.size() + 1);
    for (const auto& block : shown) {
        shownBefore.push_back(result->blocks.size());
        if (block)
            result->blocks.push_back(block);
    }
    shownBefore.push_back(result->blocks.size());
    moveRanges(result->containers, shownBefore);
    moveRanges(result->boxes, shownBefore);
    return result;
}

} // namespace model
