#include "editing/text_edit.h"

#include <algorithm>
#include <utility>

namespace editing {

namespace {

bool continuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

} // namespace

std::string applied(const std::string& text, const std::vector<TextEdit>& edits) {
    std::string result;
    std::size_t at = 0;
    for (const TextEdit& edit : edits) {
        if (edit.from < at || edit.to < edit.from || edit.to > text.size())
            return text;
        result.append(text, at, edit.from - at);
        result += edit.text;
        at = edit.to;
    }
    return result.append(text, at);
}

void putInOrder(std::vector<TextEdit>& edits) {
    std::ranges::stable_sort(edits, {}, [](const TextEdit& e) { return std::pair(e.from, e.to); });
}

bool join(std::vector<TextEdit>& edits, const TextEdit& edit) {
    for (const TextEdit& other : edits) {
        const bool putsIn = edit.from == edit.to || other.from == other.to;
        if (putsIn ? edit.from < other.to && other.from < edit.to
                   : edit.from < other.to && other.from < edit.to && !(other == edit))
            return false;
        if (!putsIn && other == edit)
            return true;
    }
    edits.push_back(edit);
    return true;
}

TextEdit editBetween(const std::string& before, const std::string& after) {
    const std::size_t shorter = std::min(before.size(), after.size());
    std::size_t head = 0;
    while (head < shorter && before[head] == after[head])
        ++head;
    while (head > 0 && ((head < before.size() && continuesCharacter(before[head])) ||
                        (head < after.size() && continuesCharacter(after[head]))))
        --head;
    std::size_t tail = 0;
    while (tail < shorter - head &&
           before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
        ++tail;
    while (tail > 0 && continuesCharacter(before[before.size() - tail]))
        --tail;
    return {head, before.size() - tail, after.substr(head, after.size() - tail - head)};
}

} // namespace editing
