#include "script/places.h"

#include <algorithm>

namespace script {

namespace {

bool startsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

} // namespace

Places::Places(std::string_view text) : text_(text), lines_{0} {
    std::size_t characters = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (at % blockSize == 0)
            blocks_.push_back(characters);
        characters += startsCharacter(text[at]) ? 1 : 0;
        if (text[at] == '\n')
            lines_.push_back(at + 1);
    }
    blocks_.push_back(characters);
}

std::size_t Places::charactersBefore(std::size_t offset) const {
    const std::size_t block = std::min(offset / blockSize, blocks_.size() - 1);
    std::size_t characters = blocks_[block];
    for (std::size_t at = block * blockSize; at < offset; ++at)
        characters += startsCharacter(text_[at]) ? 1 : 0;
    return characters;
}

Place Places::at(std::size_t offset) const {
    offset = std::min(offset, text_.size());
    const auto line = std::upper_bound(lines_.begin(), lines_.end(), offset) - 1;
    return {static_cast<int>(line - lines_.begin()) + 1,
            static_cast<int>(charactersBefore(offset) - charactersBefore(*line)) + 1};
}

void Places::locate(scene::Diagnostic& diagnostic) const {
    if (!diagnostic.range.known())
        return;
    const Place from = at(diagnostic.range.from);
    const Place to = at(diagnostic.range.to);
    diagnostic.line = from.line;
    diagnostic.column = from.column;
    diagnostic.endLine = to.line;
    diagnostic.endColumn = to.column;
}

} // namespace script
