#include "text/merge.h"

#include "text/difference.h"

namespace text {

namespace {

bool touch(Range a, Range b) { return a.from <= b.to && b.from <= a.to; }

} // namespace

Merge merged(std::string_view base, std::string_view mine, std::string_view theirs) {
    const std::vector<Hunk> my = differences(base, mine), their = differences(base, theirs);
    Merge merge;
    long shift = 0; // of places in mine by the edits made so far
    std::vector<bool> conflicts(my.size(), false);
    std::vector<long> shifts(my.size(), 0);
    std::size_t next = 0; // of mine, the first that may reach this one of theirs
    for (const Hunk& hunk : their) {
        while (next < my.size() && my[next].before.to < hunk.before.from)
            shifts[next++] = shift;
        bool free = true;
        for (std::size_t i = next; i < my.size() && my[i].before.from <= hunk.before.to; ++i)
            if (touch(my[i].before, hunk.before)) {
                free = false;
                const auto text = [](std::string_view of, Range range) {
                    return of.substr(range.from, range.size());
                };
                if (my[i].before != hunk.before ||
                    text(mine, my[i].after) != text(theirs, hunk.after))
                    conflicts[i] = true;
            }
        if (!free)
            continue;
        const long moved = next == 0 ? 0
                                     : static_cast<long>(my[next - 1].after.to) -
                                           static_cast<long>(my[next - 1].before.to);
        const auto inMine = [&](std::size_t at) {
            return static_cast<std::size_t>(static_cast<long>(at) + moved);
        };
        merge.edits.push_back({{inMine(hunk.before.from), inMine(hunk.before.to)},
                               std::string(theirs.substr(hunk.after.from, hunk.after.size()))});
        shift += static_cast<long>(hunk.after.size()) - static_cast<long>(hunk.before.size());
    }
    for (; next < my.size(); ++next)
        shifts[next] = shift;
    for (std::size_t i = 0; i < my.size(); ++i)
        if (conflicts[i])
            merge.conflicts.push_back(
                {static_cast<std::size_t>(static_cast<long>(my[i].after.from) + shifts[i]),
                 static_cast<std::size_t>(static_cast<long>(my[i].after.to) + shifts[i])});
    return merge;
}

} // namespace text
