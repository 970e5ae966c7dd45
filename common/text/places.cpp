#include "text/places.h"

#include "text/characters.h"

#include <algorithm>

namespace text {

std::size_t& bytesPlaced() {
    static thread_local std::size_t placed = 0;
    return placed;
}

Places::Places(std::string_view text)
    : text_(text), lines_{text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0} {
    bytesPlaced() += text.size();
    std::size_t characters = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (at % blockSize == 0)
            blocks_.push_back(characters);
        characters += isContinuation(text[at]) ? 0 : 1;
        const bool isPair = text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n';
        if (text[at] == '\n' || (text[at] == '\r' && !isPair))
            lines_.push_back(at + 1);
    }
    if (text.size() % blockSize == 0)
        blocks_.push_back(characters);
}

std::size_t Places::charactersBefore(std::size_t offset) const {
    const std::size_t block = offset / blockSize;
    std::size_t characters = blocks_[block];
    for (std::size_t at = block * blockSize; at < offset; ++at)
        characters += isContinuation(text_[at]) ? 0 : 1;
    return characters;
}

Position Places::at(std::size_t offset) const {
    offset = std::clamp(offset, lines_.front(), text_.size());
    const auto line = std::upper_bound(lines_.begin(), lines_.end(), offset) - 1;
    // Up to this byte and with it, so that every byte of a character has the character's column.
    const std::size_t characters =
        offset < text_.size() ? charactersBefore(offset + 1) : charactersBefore(offset) + 1;
    const std::size_t column = characters - charactersBefore(*line);
    return {static_cast<int>(line - lines_.begin()) + 1,
            static_cast<int>(std::max(column, std::size_t{1}))};
}

std::size_t Places::endOfLine(std::size_t line) const {
    if (line + 1 == lines_.size())
        return text_.size();
    const std::size_t end = lines_[line + 1] - 1;
    const bool isPair = text_[end] == '\n' && end > lines_[line] && text_[end - 1] == '\r';
    return isPair ? end - 1 : end;
}

std::size_t Places::offset(Position position) const {
    if (position.line < 1)
        return lines_.front();
    const auto line = static_cast<std::size_t>(position.line) - 1;
    if (line >= lines_.size())
        return text_.size();
    // The number of the character in the text, then the block that it begins in.
    const std::size_t wanted =
        charactersBefore(lines_[line]) + static_cast<std::size_t>(std::max(position.column, 1)) - 1;
    const auto block = std::upper_bound(blocks_.begin(), blocks_.end(), wanted) - 1;
    std::size_t characters = *block;
    std::size_t at = static_cast<std::size_t>(block - blocks_.begin()) * blockSize;
    const std::size_t end = endOfLine(line);
    for (; at < end && (characters < wanted || isContinuation(text_[at])); ++at)
        characters += isContinuation(text_[at]) ? 0 : 1;
    return std::min(at, end);
}

} // namespace text
