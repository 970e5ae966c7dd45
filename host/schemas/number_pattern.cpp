#include "schemas/number_pattern.h"

#include <algorithm>

namespace schemas {

namespace {

bool isWordPart(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
           (static_cast<unsigned char>(c) & 0x80) != 0;
}

bool isLevel(std::string_view pattern, std::size_t at) {
    constexpr std::string_view kinds = "1aAiI";
    return kinds.find(pattern[at]) != std::string_view::npos &&
           (at == 0 || !isWordPart(pattern[at - 1])) &&
           (at + 1 == pattern.size() || !isWordPart(pattern[at + 1]));
}

// 1 is a, 27 is aa. LIMIT: numbers under 1 are written in digits.
std::string letters(int number, char first) {
    std::string result;
    for (; number > 0; number = (number - 1) / 26)
        result.insert(result.begin(), static_cast<char>(first + (number - 1) % 26));
    return result;
}

// LIMIT: from 4000 on in digits, since M is the last letter.
std::string roman(int number) {
    constexpr std::pair<int, std::string_view> signs[] = {
        {1000, "m"}, {900, "cm"}, {500, "d"}, {400, "cd"}, {100, "c"}, {90, "xc"}, {50, "l"},
        {40, "xl"},  {10, "x"},   {9, "ix"},  {5, "v"},    {4, "iv"},  {1, "i"}};
    std::string result;
    for (const auto& [value, sign] : signs)
        for (; number >= value; number -= value)
            result += sign;
    return result;
}

std::string spelled(int number, char kind) {
    if (kind == '1' || number < 1 || (number >= 4000 && (kind == 'i' || kind == 'I')))
        return std::to_string(number);
    if (kind == 'a' || kind == 'A')
        return letters(number, kind);
    std::string result = roman(number);
    if (kind == 'I')
        std::transform(result.begin(), result.end(), result.begin(),
                       [](char c) { return static_cast<char>(c - 'a' + 'A'); });
    return result;
}

} // namespace

std::string numbered(std::string_view pattern, const std::vector<int>& path) {
    std::vector<std::size_t> levels;
    for (std::size_t at = 0; at < pattern.size(); ++at)
        if (isLevel(pattern, at))
            levels.push_back(at);
    if (levels.empty() || path.empty())
        return std::string(pattern);
    // More levels in the pattern than there are: the outer ones go, with what stands behind them.
    const std::size_t used = std::min(levels.size(), path.size());
    const std::size_t skipped = levels.size() - used;
    std::string result(pattern.substr(0, levels[0]));
    for (std::size_t i = 0; i < used; ++i) {
        const std::size_t at = levels[skipped + i];
        const std::size_t end =
            skipped + i + 1 < levels.size() ? levels[skipped + i + 1] : pattern.size();
        result += spelled(path[path.size() - used + i], pattern[at]);
        result += pattern.substr(at + 1, end - at - 1);
    }
    return result;
}

std::string_view withoutWords(std::string_view pattern) {
    for (std::size_t at = 0; at < pattern.size(); ++at)
        if (isLevel(pattern, at))
            return pattern.substr(at);
    return {};
}

std::string_view wordsBefore(std::string_view pattern) {
    const std::string_view words = pattern.substr(0, pattern.size() - withoutWords(pattern).size());
    const std::size_t end = words.find_last_not_of(' ');
    return words.substr(0, end == words.npos ? 0 : end + 1);
}

std::string withoutPunctuation(std::string_view number) {
    const std::size_t end = number.find_last_not_of(" .:,;)\t");
    return std::string(number.substr(0, end == std::string_view::npos ? 0 : end + 1));
}

} // namespace schemas
