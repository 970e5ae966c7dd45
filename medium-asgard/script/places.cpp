#include "script/places.h"

#include <algorithm>

namespace script {

Places::Places(std::string_view text) : text_(text), lines_{0} {
    for (std::size_t at = 0; at < text.size(); ++at)
        if (text[at] == '\n')
            lines_.push_back(at + 1);
}

Place Places::at(std::size_t offset) const {
    offset = std::min(offset, text_.size());
    const auto line = std::upper_bound(lines_.begin(), lines_.end(), offset) - 1;
    Place place;
    place.line = static_cast<int>(line - lines_.begin()) + 1;
    for (std::size_t i = *line; i < offset; ++i)
        if ((static_cast<unsigned char>(text_[i]) & 0xc0) != 0x80) // not inside a character
            ++place.column;
    return place;
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
