#include "layout/old_pages.h"

#include <algorithm>

namespace layout {

using paragraphs::Sizes;

void PageStart::shift(std::size_t by) {
    group.at.block += by;
    for (GroupStart& waiting : floats)
        waiting.at.block += by;
    first += by;
    reached += by;
}

namespace {

std::unordered_set<const model::Block*> blocksWith(const Sizes::Changed& resized,
                                                   const Pages& pages) {
    std::unordered_set<const model::Block*> result;
    if (resized.empty())
        return result;
    for (const auto& page : pages.pages)
        for (const PlacedObject& object : page->objects)
            if (object.subdocument ? resized.subdocuments.contains(object.subdocument)
                                   : resized.images.contains(object.image))
                result.insert(object.block);
    return result;
}

} // namespace

OldPages::OldPages(Pages old, const Basis& now, const Sizes::Changed& resized)
    : old_(std::move(old)) {
    if (old_.basis)
        hunks_ = differences(*old_.basis->model, old_.basis->frames, *now.model, now.frames,
                             blocksWith(resized, old_));
}

// From there on, up to the last start of a page before which nothing of the hunk was read.
OldPages::Part OldPages::before(std::size_t hunk, std::size_t from, std::size_t shift) const {
    if (hunk == hunks_.size())
        return {from, old_.pages.size(), shift, std::nullopt};
    const auto hasReached = [&](const PageStart& start) {
        return start.reached <= hunks_[hunk].oldFrom;
    };
    const auto first = starts().begin() + static_cast<std::ptrdiff_t>(from);
    auto at = std::partition_point(first, starts().end(), hasReached);
    at -= at == first ? 0 : 1;
    while (at != first && at->next == PageStart::Next::within)
        --at;
    const auto to = static_cast<std::size_t>(at - starts().begin());
    return {from, to, shift, startOf(to, shift)};
}

PageStart OldPages::startOf(std::size_t page, std::size_t shift) const {
    PageStart start = starts()[page];
    start.shift(shift);
    return start;
}

std::optional<OldPages::Part> OldPages::first() const {
    if (!old_.basis || starts().empty())
        return std::nullopt;
    return before(0, 0, 0);
}

std::optional<OldPages::Part> OldPages::met(const PageStart& start) {
    if (!old_.basis || start.next == PageStart::Next::within)
        return std::nullopt;
    while (passed_ < hunks_.size() && hunks_[passed_].newTo <= start.first)
        ++passed_;
    if (passed_ < hunks_.size() && hunks_[passed_].newFrom < start.reached)
        return std::nullopt; // it is of something that has changed
    const std::size_t shift =
        passed_ == 0 ? 0 : hunks_[passed_ - 1].newTo - hunks_[passed_ - 1].oldTo;
    PageStart wanted = start;
    wanted.shift(0 - shift);
    const auto isBefore = [](const PageStart& one, const Flow::Place& place) {
        return one.group.at < place;
    };
    auto old = std::lower_bound(starts().begin(), starts().end(), wanted.group.at, isBefore);
    while (old != starts().end() && old->group.at == wanted.group.at && *old != wanted)
        ++old;
    if (old == starts().end() || old->group.at != wanted.group.at)
        return std::nullopt;
    const Part part = before(passed_, static_cast<std::size_t>(old - starts().begin()), shift);
    return part.to > part.from ? std::optional(part) : std::nullopt;
}

std::size_t OldPages::behind(const PageStart& start) const {
    if (!old_.basis)
        return 0;
    Flow::Place place = start.group.at;
    std::size_t shift = 0;
    for (const Hunk& hunk : hunks_) {
        if (hunk.newFrom > place.block)
            break;
        shift = hunk.newTo - hunk.oldTo;
    }
    place.block = std::min(place.block - shift, old_.basis->model->blocks.size());
    const auto isBefore = [](const PageStart& one, const Flow::Place& at) {
        return one.group.at < at;
    };
    return static_cast<std::size_t>(
        std::lower_bound(starts().begin(), starts().end(), place, isBefore) - starts().begin());
}

} // namespace layout
