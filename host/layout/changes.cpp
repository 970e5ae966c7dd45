#include "layout/changes.h"

#include <algorithm>
#include <unordered_map>

namespace layout {

namespace {

// Collects what is not the same; what touches becomes one.
class Hunks {
public:
    void add(std::size_t oldFrom, std::size_t oldTo, std::size_t newFrom, std::size_t newTo) {
        if (oldFrom == oldTo && newFrom == newTo)
            return;
        if (!all.empty() && all.back().oldTo == oldFrom && all.back().newTo == newFrom) {
            all.back().oldTo = oldTo;
            all.back().newTo = newTo;
        } else {
            all.push_back({oldFrom, oldTo, newFrom, newTo});
        }
    }
    std::vector<Hunk> all;
};

// The block before a display is kept with it.
std::vector<Hunk> withTextBeforeDisplays(const std::vector<Hunk>& hunks,
                                         const model::Blocks& before, const model::Blocks& now) {
    const auto isDisplay = [](const model::Blocks& all, std::size_t at) {
        return at < all.size() && all[at]->kind == model::BlockKind::formula;
    };
    Hunks result;
    std::size_t passed = 0; // blocks of hunks so far
    for (Hunk hunk : hunks) {
        const bool keeps = isDisplay(before, hunk.oldFrom) || isDisplay(now, hunk.newFrom);
        if (keeps && hunk.oldFrom > 0 && hunk.newFrom > passed) {
            --hunk.oldFrom;
            --hunk.newFrom;
        }
        passed = hunk.newTo;
        result.add(hunk.oldFrom, hunk.oldTo, hunk.newFrom, hunk.newTo);
    }
    return std::move(result.all);
}

} // namespace

std::vector<Hunk> differences(const model::Model& before, const Frames& framesBefore,
                              const model::Model& now, const Frames& framesNow,
                              const std::unordered_set<const model::Block*>& changed) {
    const model::Blocks &a = before.blocks, &b = now.blocks;
    Frames::Comparison frames(framesBefore, framesNow);
    Hunks hunks;
    std::size_t i = 0, j = 0; // blocks before these are compared
    const auto pass = [&] {   // two that are one
        if (!frames.same(i, j) || changed.contains(b[j].get()))
            hunks.add(i, i + 1, j, j + 1);
        ++i;
        ++j;
    };
    while (i < a.size() && j < b.size() && a[i] == b[j])
        pass();
    std::size_t aEnd = a.size(), bEnd = b.size();
    while (aEnd > i && bEnd > j && a[aEnd - 1] == b[bEnd - 1]) {
        --aEnd;
        --bEnd;
    }
    std::unordered_map<const model::Block*, std::size_t> places;
    for (std::size_t k = i; k < aEnd; ++k)
        places.emplace(a[k].get(), k);
    std::size_t newFrom = j;
    for (std::size_t k = j; k < bEnd; ++k) {
        const auto found = places.find(b[k].get());
        if (found == places.end() || found->second < i)
            continue;
        hunks.add(i, found->second, newFrom, k);
        i = found->second;
        j = k;
        pass();
        newFrom = j;
    }
    hunks.add(i, aEnd, newFrom, bEnd);
    i = aEnd;
    j = bEnd;
    while (i < a.size())
        pass();
    return withTextBeforeDisplays(hunks.all, a, b);
}

} // namespace layout
