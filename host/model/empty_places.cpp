#include "model/empty_places.h"

#include "model/kept_blocks.h"

#include <algorithm>

namespace model {

namespace {

// Such as the word "Abstract" before what is one.
bool isGenerated(const Block& block) {
    return block.kind == BlockKind::text && !block.runs.empty() &&
           std::ranges::all_of(block.runs, [](const Run& run) {
               return run.kind == RunKind::text && run.content == sgml::noNode && !run.refers;
           });
}

} // namespace

bool isWithoutText(const Block& block) {
    return block.kind == BlockKind::text && std::ranges::all_of(block.runs, [](const Run& run) {
               return run.kind == RunKind::text && run.text.empty();
           });
}

bool isEmptyPlace(const Block& block) { return !block.style.hint.empty() && isWithoutText(block); }

std::shared_ptr<const Model> withoutEmptyPlaces(const Model& whole) {
    Blocks shown = whole.blocks;
    bool isWhole = true;
    for (auto& block : shown)
        if (isEmptyPlace(*block)) {
            block.reset();
            isWhole = false;
        }
    if (isWhole)
        return nullptr;
    // Those inside come behind those around them.
    for (auto box = whole.boxes.rbegin(); box != whole.boxes.rend(); ++box) {
        const auto first = shown.begin() + static_cast<std::ptrdiff_t>(box->first);
        const auto end = shown.begin() + static_cast<std::ptrdiff_t>(box->last) + 1;
        const bool wasEmpty = std::find(first, end, nullptr) != end;
        if (wasEmpty && std::all_of(first, end, [](const auto& block) {
                return !block || isGenerated(*block);
            }))
            std::fill(first, end, nullptr);
    }
    return withBlocks(whole, shown);
}

} // namespace model
