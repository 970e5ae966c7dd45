#include "editing/text_edit.h"

#include <algorithm>

namespace editing {

namespace {

bool continuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

} // namespace

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
