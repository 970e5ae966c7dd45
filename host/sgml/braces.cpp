#include "sgml/braces.h"

namespace sgml {

namespace {

// The next bare brace at or after `at`, or npos. `at` must not stand behind a backslash that
// escapes it.
std::size_t nextBareBrace(std::string_view text, std::size_t at) {
    while ((at = text.find_first_of("{}\\", at)) != std::string_view::npos) {
        if (text[at] != '\\')
            return at;
        at +=
            2; // a backslash takes the brace or backslash after it along, and nothing else matters
    }
    return std::string_view::npos;
}

} // namespace

std::size_t closingBrace(std::string_view text, std::size_t open) {
    std::size_t depth = 0;
    for (std::size_t at = open; (at = nextBareBrace(text, at)) != std::string_view::npos; ++at) {
        if (text[at] == '{')
            ++depth;
        else if (--depth == 0)
            return at;
    }
    return std::string_view::npos;
}

std::vector<std::size_t> unclosedBraces(std::string_view text) {
    std::vector<std::size_t> open;
    for (std::size_t at = 0; (at = nextBareBrace(text, at)) != std::string_view::npos; ++at) {
        if (text[at] == '{')
            open.push_back(at);
        else if (!open.empty())
            open.pop_back();
    }
    return open;
}

std::unordered_map<std::size_t, std::size_t> bracePairs(std::string_view spelling) {
    std::unordered_map<std::size_t, std::size_t> pairs;
    std::vector<std::size_t> open;
    for (std::size_t at = 0; (at = nextBareBrace(spelling, at)) != std::string_view::npos; ++at) {
        if (spelling[at] == '{') {
            open.push_back(at);
        } else if (!open.empty()) {
            pairs[open.back()] = at;
            pairs[at] = open.back();
            open.pop_back();
        }
    }
    return pairs;
}

} // namespace sgml
