// A change of a scene's text.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace editing {

// Bytes [from, to) of the old text become `text`.
struct TextEdit {
    std::size_t from = 0, to = 0;
    std::string text;
    bool operator==(const TextEdit&) const = default;
};

// Edits are of the text as it was, in order and apart from each other. Others change nothing: no
// text is better than one with parts lost or twice.
[[nodiscard]] std::string applied(const std::string& text, const std::vector<TextEdit>& edits);
// As applied() wants them; what is put in stands before what is rewritten at the same place.
void putInOrder(std::vector<TextEdit>& edits);
// Takes the edit into the list, once. False: another of the list changes the same bytes otherwise.
[[nodiscard]] bool join(std::vector<TextEdit>& edits, const TextEdit& edit);

// The smallest one that makes `after` of `before`, at character boundaries of UTF-8.
[[nodiscard]] TextEdit editBetween(const std::string& before, const std::string& after);

} // namespace editing
