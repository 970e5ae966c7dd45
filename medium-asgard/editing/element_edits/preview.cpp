#include "element_edits/preview.h"

#include "element_edits/words.h"

#include "text/characters.h"
#include "text/difference.h"

#include <algorithm>

namespace editing {

namespace {

constexpr std::size_t around = 24; // bytes of a line that are shown on either side

LineChange compared(int line, std::string before, std::string after) {
    LineChange change{line, std::move(before), std::move(after)};
    std::string &a = change.before, &b = change.after;
    const text::Edit edit = text::difference(a, b);
    const auto shorten = [](std::string& s, std::size_t& from, std::size_t& to) {
        std::size_t end = to + around;
        while (text::isInsideCharacter(s, end))
            ++end;
        if (end < s.size())
            s = s.substr(0, end) + "…";
        const std::size_t start = text::characterStart(s, from > around ? from - around : 0);
        if (start > 0)
            s = "…" + s.substr(start);
        const std::size_t gone = start > 0 ? start - std::string("…").size() : 0;
        from -= gone;
        to -= gone;
    };
    change.from = edit.range.from;
    change.beforeTo = edit.range.to;
    change.afterTo = edit.range.from + edit.text.size();
    std::size_t fromOfB = change.from;
    shorten(a, change.from, change.beforeTo);
    shorten(b, fromOfB, change.afterTo);
    return change;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(trimmed(text.substr(at, end - at)));
        at = end + 1;
    }
    return lines;
}

} // namespace

std::vector<LineChange> changedLines(const std::string& text, const text::Edits& edits) {
    std::vector<LineChange> changes;
    for (std::size_t i = 0; i < edits.size();) {
        // All edits that share lines, as one piece of whole lines.
        const std::size_t from =
            edits[i].range.from == 0 ? 0 : text.rfind('\n', edits[i].range.from - 1) + 1;
        std::size_t to = std::min(text.find('\n', edits[i].range.to), text.size());
        text::Edits inside;
        for (; i < edits.size() && edits[i].range.from <= to; ++i) {
            to = std::max(to, std::min(text.find('\n', edits[i].range.to), text.size()));
            inside.push_back(
                {{edits[i].range.from - from, edits[i].range.to - from}, edits[i].text});
        }
        const std::string old = text.substr(from, to - from);
        const auto before = linesOf(old), after = linesOf(text::applied(old, inside));
        const int line =
            1 + static_cast<int>(std::count(
                    text.begin(), text.begin() + static_cast<std::ptrdiff_t>(from), '\n'));
        // From both ends: lines in common; those between are the change.
        std::size_t head = 0, tail = 0;
        const std::size_t shorter = std::min(before.size(), after.size());
        while (head < shorter && before[head] == after[head])
            ++head;
        while (tail < shorter - head &&
               before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
            ++tail;
        for (std::size_t k = head; k < std::max(before.size(), after.size()) - tail; ++k)
            changes.push_back(compared(line + static_cast<int>(k),
                                       k < before.size() - tail ? before[k] : "",
                                       k < after.size() - tail ? after[k] : ""));
    }
    return changes;
}

} // namespace editing
