#include "sgml/escape.h"

#include <algorithm>

namespace sgml {

namespace {

bool isSpecial(char c) { return c == '{' || c == '}' || c == '\\'; }

} // namespace

std::string escaped(std::string_view text) {
    std::string spelling;
    spelling.reserve(text.size() + text.size() / 8);
    for (const char c : text) {
        if (isSpecial(c))
            spelling += '\\';
        spelling += c;
    }
    return spelling;
}

Unescaped::Unescaped(std::string_view spelling, std::size_t start) : start_(start) {
    text_.reserve(spelling.size());
    for (std::size_t i = 0; i < spelling.size(); ++i) {
        if (spelling[i] == '\\' && i + 1 < spelling.size() && isSpecial(spelling[i + 1])) {
            escapes_.push_back(text_.size());
            ++i;
        }
        text_ += spelling[i];
    }
}

std::size_t Unescaped::fileOffset(std::size_t offset) const {
    const auto before = std::lower_bound(escapes_.begin(), escapes_.end(), offset);
    return start_ + offset + static_cast<std::size_t>(before - escapes_.begin());
}

std::size_t Unescaped::textOffset(std::size_t fileOffset) const {
    if (fileOffset <= start_)
        return 0;
    // Escape number i takes the file's bytes escapes_[i] + i and the one after it.
    const std::size_t offset = fileOffset - start_;
    std::size_t low = 0, high = escapes_.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (escapes_[middle] + middle < offset)
            low = middle + 1;
        else
            high = middle;
    }
    return std::min(offset - low, text_.size());
}

bool Unescaped::isEscaped(std::size_t offset) const {
    return std::binary_search(escapes_.begin(), escapes_.end(), offset);
}

} // namespace sgml
