#include "excerpts/folding.h"

#include "model/kept_blocks.h"

#include <algorithm>

namespace model {

using schemas::ContainerRole;

std::vector<Section> sectionsOf(const Model& model) {
    std::vector<Section> result;
    struct Open {
        std::size_t section = 0, end = 0; // behind the last block that it may have
        int level = 0;
    };
    std::vector<Open> open;        // headings, each of a lower level than the one before
    std::vector<std::size_t> ends; // of the section elements around the block
    std::size_t container = 0;     // the next one
    const auto close = [&](std::size_t behind) {
        result[open.back().section].last = std::min(open.back().end, behind) - 1;
        open.pop_back();
    };
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        while (!ends.empty() && ends.back() <= i)
            ends.pop_back();
        for (; container < model.containers.size() && model.containers[container].first <= i;
             ++container)
            if (model.containers[container].role == ContainerRole::section)
                ends.push_back(model.containers[container].last + 1);
        const int level = model.blocks[i]->headingLevel;
        if (level <= 0)
            continue;
        while (!open.empty() && (open.back().level >= level || open.back().end <= i))
            close(i);
        open.push_back({result.size(), ends.empty() ? model.blocks.size() : ends.back(), level});
        result.push_back({i, i});
    }
    while (!open.empty())
        close(model.blocks.size());
    return result;
}

// A caption belongs to what it describes.
SectionCounts countsOf(const Model& model, const Section& section) {
    SectionCounts counts;
    for (std::size_t i = section.heading + 1; i <= section.last; ++i) {
        const Block& block = *model.blocks[i];
        if (block.headingLevel > 0)
            ++counts.sections;
        else if (block.kind == BlockKind::text)
            ++counts.paragraphs;
    }
    for (const Container& container : model.containers) {
        if (container.first <= section.heading || container.first > section.last)
            continue;
        counts.figures += container.role == ContainerRole::figure ? 1 : 0;
        counts.tables += container.role == ContainerRole::table ? 1 : 0;
        if (container.role != ContainerRole::caption)
            continue;
        for (std::size_t i = container.first; i <= container.last; ++i)
            counts.paragraphs -= model.blocks[i]->kind == BlockKind::text ? 1 : 0;
    }
    return counts;
}

// It does not ask to stand with what follows, which is not its own.
Folding::Pointer Folding::headingOf(const Model& whole, const Section& section) {
    const Pointer& own = whole.blocks[section.heading];
    auto shown = std::make_shared<Block>(*own);
    shown->style.keepWithNext = false;
    for (std::size_t i = section.heading + 1; i <= section.last; ++i)
        shown->anchors.insert(shown->anchors.end(), whole.blocks[i]->anchors.begin(),
                              whole.blocks[i]->anchors.end());
    const auto known = std::ranges::find(headings_, own, &Heading::whole);
    if (known != headings_.end() && known->shown->anchors == shown->anchors)
        return known->shown;
    return shown;
}

std::shared_ptr<const Model> Folding::folded(const Model& whole,
                                             const std::vector<Section>& sections) {
    Blocks shown(whole.blocks.size());
    std::vector<Heading> headings;
    auto next = sections.begin();
    std::size_t hiddenTo = 0; // behind the last one
    for (std::size_t i = 0; i < whole.blocks.size(); ++i) {
        while (next != sections.end() && next->heading < i)
            ++next; // it is hidden itself
        if (i < hiddenTo)
            continue;
        const bool isFolded = next != sections.end() && next->heading == i && !next->isEmpty();
        if (isFolded) {
            headings.push_back({whole.blocks[i], headingOf(whole, *next)});
            hiddenTo = next->last + 1;
        }
        shown[i] = isFolded ? headings.back().shown : whole.blocks[i];
    }
    headings_ = std::move(headings);
    return withBlocks(whole, shown);
}

} // namespace model
