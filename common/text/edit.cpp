#include "text/edit.h"

#include <algorithm>
#include <utility>

namespace text {

bool areOrdered(const Edits& edits, std::size_t size) {
    std::size_t before = 0;
    for (const Edit& edit : edits) {
        if (edit.range.from < before || edit.range.to < edit.range.from || edit.range.to > size)
            return false;
        before = edit.range.to;
    }
    return true;
}

std::string applied(std::string_view text, const Edits& edits) {
    if (!areOrdered(edits, text.size()))
        return std::string(text);
    std::string result;
    std::size_t kept = 0;
    for (const Edit& edit : edits) {
        result += text.substr(kept, edit.range.from - kept);
        result += edit.text;
        kept = edit.range.to;
    }
    result += text.substr(kept);
    return result;
}

Edits inverse(std::string_view text, const Edits& edits) {
    Edits result;
    std::size_t added = 0, removed = 0;
    for (const Edit& edit : edits) {
        const std::size_t from = edit.range.from + added - removed;
        result.push_back({{from, from + edit.text.size()},
                          std::string(text.substr(edit.range.from, edit.range.size()))});
        added += edit.text.size();
        removed += edit.range.size();
    }
    return result;
}

void putInOrder(Edits& edits) {
    std::ranges::stable_sort(
        edits, {}, [](const Edit& edit) { return std::pair(edit.range.from, edit.range.to); });
}

Edits::iterator startingAt(Edits& edits, std::size_t place) {
    return std::ranges::find(edits, place, [](const Edit& edit) { return edit.range.from; });
}

bool join(Edits& edits, const Edit& edit) {
    for (const Edit& other : edits) {
        const bool overlap = edit.range.from < other.range.to && other.range.from < edit.range.to;
        const bool inserts = edit.range.empty() || other.range.empty();
        if (!inserts && other == edit)
            return true;
        if (overlap)
            return false;
    }
    edits.push_back(edit);
    return true;
}

std::size_t moved(std::size_t place, const Edits& edits, Gravity gravity) {
    std::size_t added = 0, removed = 0;
    for (const Edit& edit : edits) {
        const Range& range = edit.range;
        if (range.from > place || (range.from == place && !range.empty()))
            break;
        const bool chooses = range.empty() ? range.from == place : place < range.to;
        if (chooses && gravity == Gravity::before)
            return range.from + added - removed;
        added += edit.text.size();
        removed += range.size();
        if (chooses && !range.empty())
            return range.to + added - removed;
    }
    return place + added - removed;
}

std::optional<std::size_t> movedByte(std::size_t offset, const Edits& edits) {
    std::size_t added = 0, removed = 0;
    for (const Edit& edit : edits) {
        if (edit.range.from > offset)
            break;
        if (edit.range.contains(offset))
            return std::nullopt;
        added += edit.text.size();
        removed += edit.range.size();
    }
    return offset + added - removed;
}

} // namespace text
