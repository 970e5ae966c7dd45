#include "meshes/lines.h"

#include <charconv>
#include <cmath>

namespace meshes {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

} // namespace

bool Words::continuesAt(std::size_t at) const {
    return continued_ == Continued::byBackslash && text_[at] == '\\' &&
           (text_.substr(at + 1, 1) == "\n" || text_.substr(at + 1, 2) == "\r\n");
}

bool Words::skipBlanks(bool alsoLines) {
    for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (continuesAt(at_)) {
            at_ += text_[at_ + 1] == '\r' ? 2 : 1;
            ++line_;
        } else if (c == '\n') {
            if (!alsoLines)
                return false;
            ++line_;
        } else if (!isBlank(c)) {
            return true;
        }
    }
    return false;
}

std::string_view Words::nextInLine() {
    if (!skipBlanks(false))
        return {};
    const std::size_t from = at_;
    while (at_ < text_.size() && text_[at_] != '\n' && !isBlank(text_[at_]) &&
           !(at_ > from && continuesAt(at_)))
        ++at_;
    return text_.substr(from, at_ - from);
}

std::string_view Words::next() { return skipBlanks(true) ? nextInLine() : std::string_view(); }

bool Words::nextLine() { return skipBlanks(true); }

void Words::skipLine() {
    while (!nextInLine().empty()) {
    }
}

std::optional<double> numberOf(std::string_view word) {
    if (word.starts_with('+'))
        word.remove_prefix(1);
    if (word.empty() || word.starts_with('+') || word.find_first_of("xXnNiI") != word.npos)
        return std::nullopt; // no inf, no nan
    double value = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size())
        return std::nullopt;
    if (fault == std::errc::result_out_of_range) // nothing to speak of, or far too large
        return word.find("e-") != word.npos || word.find("E-") != word.npos
                   ? std::optional(0.0)
                   : std::optional(HUGE_VAL);
    return fault == std::errc() ? std::optional(value) : std::nullopt;
}

std::string shown(std::string_view word) {
    std::string text;
    for (const char c : word.substr(0, 24))
        text += c >= 0x20 && c < 0x7f ? c : '?';
    return "\"" + text + (word.size() > 24 ? "..." : "") + "\"";
}

bool isWord(std::string_view word, std::string_view lowerCase) {
    if (word.size() != lowerCase.size())
        return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const char c = word[i];
        if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != lowerCase[i])
            return false;
    }
    return true;
}

} // namespace meshes
