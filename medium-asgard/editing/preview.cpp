#include "editing/preview.h"

#include <algorithm>

namespace editing {

namespace {

constexpr std::size_t around = 24; // bytes of a line that are shown on either side

bool continuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

LineChange compared(int line, std::string before, std::string after) {
    LineChange change{line, std::move(before), std::move(after)};
    std::string &a = change.before, &b = change.after;
    const std::size_t shorter = std::min(a.size(), b.size());
    std::size_t head = 0, tail = 0;
    while (head < shorter && a[head] == b[head])
        ++head;
    while (tail < shorter - head && a[a.size() - 1 - tail] == b[b.size() - 1 - tail])
        ++tail;
    while (head > 0 && ((head < a.size() && continuesCharacter(a[head])) ||
                        (head < b.size() && continuesCharacter(b[head]))))
        --head;
    while (tail > 0 && continuesCharacter(a[a.size() - tail]))
        --tail;
    const auto shorten = [](std::string& s, std::size_t& from, std::size_t& to) {
        std::size_t end = to + around;
        while (end < s.size() && continuesCharacter(s[end]))
            ++end;
        if (end < s.size())
            s = s.substr(0, end) + "…";
        std::size_t start = from > around ? from - around : 0;
        while (start > 0 && continuesCharacter(s[start]))
            --start;
        if (start > 0)
            s = "…" + s.substr(start);
        const std::size_t gone = start > 0 ? start - std::string("…").size() : 0;
        from -= gone;
        to -= gone;
    };
    std::size_t headOfB = head;
    change.beforeTo = a.size() - tail;
    change.afterTo = b.size() - tail;
    shorten(a, head, change.beforeTo);
    shorten(b, headOfB, change.afterTo);
    change.from = head;
    return change;
}

std::string trimmed(const std::string& s) {
    const std::size_t from = s.find_first_not_of(" \t\r");
    return from == std::string::npos ? "" : s.substr(from, s.find_last_not_of(" \t\r") + 1 - from);
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

std::vector<LineChange> changedLines(const std::string& text, const std::vector<TextEdit>& edits) {
    std::vector<LineChange> changes;
    for (std::size_t i = 0; i < edits.size();) {
        // All edits that share lines, as one piece of whole lines.
        const std::size_t from = edits[i].from == 0 ? 0 : text.rfind('\n', edits[i].from - 1) + 1;
        std::size_t to = std::min(text.find('\n', edits[i].to), text.size());
        std::vector<TextEdit> inside;
        for (; i < edits.size() && edits[i].from <= to; ++i) {
            to = std::max(to, std::min(text.find('\n', edits[i].to), text.size()));
            inside.push_back({edits[i].from - from, edits[i].to - from, edits[i].text});
        }
        const std::string old = text.substr(from, to - from);
        const auto before = linesOf(old), after = linesOf(applied(old, inside));
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
