#include "excerpts/outline.h"

#include "excerpts/equal_ends.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace model {

using schemas::ContainerRole;

namespace {

bool isListed(const Container& container) {
    return container.role == ContainerRole::figure || container.role == ContainerRole::table;
}

std::string trimmed(const std::string& text) {
    const auto isBlank = [](char c) { return c == ' ' || c == '\n'; };
    const auto from = std::find_if_not(text.begin(), text.end(), isBlank);
    const auto to = std::find_if_not(text.rbegin(), std::make_reverse_iterator(from), isBlank);
    return {from, to.base()};
}

// The text of its line, footnotes left out.
std::string textOf(const Block& block) {
    std::string text = trimmed(block.marker);
    if (!text.empty())
        text += ' ';
    for (const Run& run : block.runs)
        if (run.kind == RunKind::lineBreak)
            text += ' ';
        else if (run.kind != RunKind::footnote)
            text += run.text;
    return trimmed(text);
}

} // namespace

void Outline::add(Place place, Entry entry) {
    entries_.push_back(std::move(entry));
    places_.push_back(place);
}

void Outline::addHeadings(const Model& model, Range blocks) {
    for (std::size_t i = blocks.from; i < blocks.to; ++i) {
        ++blocksRead_;
        const Block& block = *model.blocks[i];
        if (block.headingLevel > 0)
            add({i, i, 0}, {Kind::heading, block.headingLevel, textOf(block), block.element});
    }
}

// By its caption; without one it is called by what stands for it, or what it is.
void Outline::addContainer(const Model& model, std::size_t index) {
    const Container& of = model.containers[index];
    const bool isFigure = of.role == ContainerRole::figure;
    std::string text;
    for (std::size_t i = index + 1;
         i < model.containers.size() && model.containers[i].first <= of.last && text.empty(); ++i)
        if (model.containers[i].role == ContainerRole::caption)
            text = textOf(*model.blocks[model.containers[i].first]);
    for (std::size_t i = of.first; i <= of.last && text.empty(); ++i)
        text = model.blocks[i]->picture.alternative;
    blocksRead_ += of.last - of.first + 1;
    if (text.empty())
        text = isFigure ? "Figure" : "Table";
    add({of.first, of.last, index},
        {isFigure ? Kind::figure : Kind::table, 1, std::move(text), of.element});
}

// By their places, a figure before the table in it.
void Outline::sort() {
    std::vector<std::size_t> order(places_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [this](std::size_t i) {
        return std::pair(places_[i].first, places_[i].container);
    });
    std::vector<Entry> entries;
    std::vector<Place> places;
    entries.reserve(order.size());
    places.reserve(order.size());
    for (const std::size_t i : order) {
        entries.push_back(std::move(entries_[i]));
        places.push_back(places_[i]);
    }
    entries_ = std::move(entries);
    places_ = std::move(places);
}

bool Outline::follow(const std::shared_ptr<const Model>& model) {
    if (!model || model == model_)
        return false;
    static const Model none;
    const Model& old = model_ ? *model_ : none;
    const Model& now = *model;
    const std::size_t oldSize = old.blocks.size(), newSize = now.blocks.size();
    const Ends blocks = equalEnds(old.blocks, now.blocks,
                                  [](const auto& a, const auto& b, bool) { return a == b; });
    // Numbers of blocks behind the change have moved by that much.
    const std::size_t moved = newSize - oldSize; // may wrap, as sums with it do
    const Ends containers =
        equalEnds(old.containers, now.containers, [&](Container a, const Container& b, bool back) {
            if (back && a.first >= oldSize - blocks.back)
                a.first += moved, a.last += moved;
            return a == b;
        });
    const std::size_t movedContainers = now.containers.size() - old.containers.size();

    const std::vector<Entry> oldEntries = std::exchange(entries_, {});
    const std::vector<Place> oldPlaces = std::exchange(places_, {});
    std::vector<std::size_t> again; // containers
    for (std::size_t i = 0; i < oldEntries.size(); ++i) {
        Place place = oldPlaces[i];
        const bool isBefore = place.last < blocks.front;
        const bool isBehind = place.first >= oldSize - blocks.back;
        const bool isHeading = oldEntries[i].kind == Kind::heading;
        bool isKept = isBefore || isBehind;
        if (!isHeading) {
            const bool isInBack = place.container >= old.containers.size() - containers.back;
            if (place.container >= containers.front && !isInBack)
                continue; // it is among those that changed
            place.container += isInBack ? movedContainers : 0;
            if (!isKept)
                again.push_back(place.container);
        }
        if (!isKept)
            continue;
        if (isBehind) {
            place.first += moved;
            place.last += moved;
        }
        add(place, oldEntries[i]);
    }
    addHeadings(now, {blocks.front, newSize - blocks.back});
    for (std::size_t i = containers.front; i < now.containers.size() - containers.back; ++i)
        if (isListed(now.containers[i]))
            again.push_back(i);
    for (const std::size_t index : again)
        addContainer(now, index);
    sort();
    model_ = model;
    return entries_ != oldEntries;
}

} // namespace model
