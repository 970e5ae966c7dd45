#include "schemas/style.h"

namespace schemas {

namespace {

std::size_t hashOf(const TextStyle& style) {
    std::size_t hash = std::hash<std::string>()(style.family);
    const auto mix = [&](std::size_t value) { hash = hash * 31 + value; };
    mix(std::hash<double>()(style.size));
    mix((style.bold ? 1U : 0U) + (style.italic ? 2U : 0U) + (style.underline ? 4U : 0U) +
        (style.raised ? 8U : 0U) + (style.hyphenate ? 16U : 0U));
    mix(std::hash<std::string>()(style.language));
    mix(style.color.red * 65536U + style.color.green * 256U + style.color.blue);
    return hash;
}

} // namespace

std::uint32_t TextStyles::numberOf(const TextStyle& style) {
    const std::size_t hash = hashOf(style);
    const auto [first, last] = numbers_.equal_range(hash);
    for (auto known = first; known != last; ++known)
        if (styles_[known->second] == style)
            return known->second;
    const auto number = static_cast<std::uint32_t>(styles_.size());
    styles_.push_back(style);
    numbers_.emplace(hash, number);
    return number;
}

} // namespace schemas
