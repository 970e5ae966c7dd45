#include "model/contents.h"

#include "model/empty_places.h"
#include "model/same_blocks.h"

#include <algorithm>

namespace model {

namespace {

using schemas::ContainerRole;

// Without the marks of footnotes.
std::string wordsOf(const Block& block) {
    std::string words = block.marker;
    if (!words.empty() && !words.ends_with(' '))
        words += ' ';
    for (const Run& run : block.runs)
        if (run.kind != RunKind::footnote)
            words += run.kind == RunKind::lineBreak ? " " : run.text;
    return words;
}

struct Listed {
    const Block* block = nullptr;
    int level = 1;
};

std::vector<Listed> headingsOf(const Model& model) {
    std::vector<Listed> found;
    for (const auto& block : model.blocks)
        if (block->headingLevel > 0 && !isWithoutText(*block))
            found.push_back({block.get(), block->headingLevel});
    return found;
}

// The captions in containers of that role. Containers come with the outer ones first.
std::vector<Listed> captionsOf(const Model& model, ContainerRole role) {
    std::vector<Listed> found;
    std::vector<const Container*> around;
    for (const Container& container : model.containers) {
        while (!around.empty() && around.back()->last < container.first)
            around.pop_back();
        const auto outer = std::find_if(around.rbegin(), around.rend(), [](const Container* one) {
            return one->role == ContainerRole::figure || one->role == ContainerRole::table;
        });
        if (container.role == ContainerRole::caption && outer != around.rend() &&
            (*outer)->role == role && !isWithoutText(*model.blocks[container.first]))
            found.push_back({model.blocks[container.first].get(), 1});
        around.push_back(&container);
    }
    return found;
}

std::shared_ptr<Block> filled(const Block& empty, const std::vector<Listed>& all) {
    auto made = std::make_shared<Block>(empty);
    made->entries.clear();
    constexpr double indent = 14; // points a level
    for (const Listed& one : all) {
        const auto anchor = std::ranges::find_if(one.block->anchors, isGeneratedAnchor);
        if (anchor == one.block->anchors.end())
            continue;
        Block entry;
        entry.element = empty.element;
        entry.style = empty.style;
        entry.style.spaceBefore = entry.style.spaceAfter = 0;
        entry.style.indentLeft = indent * (one.level - 1);
        entry.style.indentRight = 0;
        entry.textStyle = empty.textStyle;
        Run run{.text = wordsOf(*one.block), .style = empty.textStyle, .element = empty.element};
        run.target = "#" + *anchor;
        entry.runs.push_back(std::move(run));
        made->entries.push_back(std::make_shared<const Block>(std::move(entry)));
    }
    return made;
}

} // namespace

std::size_t fillContents(Model& model, const Blocks& old) {
    std::size_t made = 0;
    for (std::shared_ptr<const Block>& block : model.blocks) {
        if (block->kind != BlockKind::contents)
            continue;
        std::shared_ptr<Block> now = filled(*block, block->lists == ContainerRole::heading
                                                        ? headingsOf(model)
                                                        : captionsOf(model, block->lists));
        if (isEqual(*now, *block))
            continue;
        const auto same = std::ranges::find_if(old, [&](const auto& known) {
            return known->element == block->element && known->kind == block->kind;
        });
        if (same == old.end()) {
            block = std::move(now);
            ++made;
            continue;
        }
        if (isEqual(**same, *now)) {
            block = *same;
            continue;
        }
        (void)keepOld({.old = (*same)->entries,
                       .from = 0,
                       .to = (*same)->entries.size(),
                       .now = now->entries,
                       .first = 0,
                       .end = now->entries.size()});
        block = std::move(now);
        ++made;
    }
    return made;
}

} // namespace model
