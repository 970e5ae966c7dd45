#include "source/stretches.h"

#include "text/characters.h"

namespace source {

namespace {

// The letter before an edit is among the letters that may change: CR and LF may meet there.
std::size_t startBefore(std::string_view text, std::size_t at) {
    if (at == 0)
        return 0;
    --at;
    while (at > 0 && (text::isContinuation(text[at]) || (text[at] == '\n' && text[at - 1] == '\r')))
        --at;
    return at;
}

std::size_t endBehind(std::string_view text, std::size_t at) {
    while (at < text.size() && (text::isContinuation(text[at]) || text[at] == '\n'))
        ++at;
    // A mark of the byte order has a letter only where something stands before it.
    return text.substr(at).starts_with(text::byteOrderMark) ? at + text::byteOrderMark.size() : at;
}

} // namespace

std::vector<Stretch> stretchesOf(std::string_view after, const text::Edits& back) {
    std::vector<Stretch> result;
    std::size_t first = 0; // of the edits in the last stretch
    const auto finish = [&](std::size_t end) {
        Stretch& stretch = result.back();
        text::Edits inside(back.begin() + static_cast<std::ptrdiff_t>(first),
                           back.begin() + static_cast<std::ptrdiff_t>(end));
        for (text::Edit& edit : inside) {
            edit.range.from -= stretch.now.from;
            edit.range.to -= stretch.now.from;
        }
        stretch.before = text::applied(after.substr(stretch.now.from, stretch.now.size()), inside);
    };
    for (std::size_t i = 0; i < back.size(); ++i) {
        const text::Range range{startBefore(after, back[i].range.from),
                                endBehind(after, back[i].range.to)};
        if (!result.empty() && range.from < result.back().now.to) {
            result.back().now.to = std::max(result.back().now.to, range.to);
            continue;
        }
        if (!result.empty())
            finish(i);
        result.push_back({range, {}});
        first = i;
    }
    if (!result.empty())
        finish(back.size());
    return result;
}

} // namespace source
