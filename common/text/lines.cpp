#include "text/lines.h"

#include "text/characters.h"

#include <algorithm>

namespace text {

namespace {

// Depends on this byte and the one before it alone.
bool isStart(std::size_t at, std::string_view text) {
    return text[at - 1] == '\n' ||
           (text[at - 1] == '\r' && (at == text.size() || text[at] != '\n'));
}

} // namespace

Lines::Lines(std::string_view text)
    : starts_{text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0} {
    bytesPlaced() += text.size();
    if (text.find('\r') == std::string_view::npos) { // almost always, and fast
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string_view::npos;)
            starts_.push_back(++at);
        return;
    }
    for (std::size_t at = 1; at <= text.size(); ++at)
        if (isStart(at, text))
            starts_.push_back(at);
}

void Lines::follow(const Edits& edits, std::string_view after) {
    constexpr std::size_t few = 4;
    if (edits.empty())
        return;
    if (edits.size() > few || edits.front().range.from <= byteOrderMark.size()) {
        *this = Lines(after);
        return;
    }
    std::size_t distance = 0;
    for (const Edit& edit : edits)
        distance += edit.text.size() - edit.range.size();
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
        distance -= edit->text.size() - edit->range.size();
        follow(*edit, edit->range.from + distance, after);
    }
}

// The edits behind this one were followed; places do not count those before it yet. A place where
// two edits touch is looked at twice.
void Lines::follow(const Edit& edit, std::size_t now, std::string_view after) {
    const auto first = std::lower_bound(starts_.begin() + 1, starts_.end(), edit.range.from);
    const auto last = std::upper_bound(first, starts_.end(), edit.range.to);
    const std::size_t longer = edit.text.size() - edit.range.size();
    if (longer != 0)
        std::for_each(last, starts_.end(), [&](std::size_t& start) { start += longer; });
    bytesPlaced() += edit.text.size();
    std::vector<std::size_t> came;
    for (std::size_t at = now; at <= now + edit.text.size(); ++at)
        if (isStart(at, after))
            came.push_back(at - now + edit.range.from);
    starts_.insert(starts_.erase(first, last), came.begin(), came.end());
}

Position Lines::at(std::size_t offset, std::string_view text) const {
    return at(std::vector<std::size_t>{offset}, text).front();
}

std::vector<Position> Lines::at(const std::vector<std::size_t>& offsets,
                                std::string_view text) const {
    std::vector<Position> result;
    result.reserve(offsets.size());
    auto line = starts_.begin();
    std::size_t read = *line; // of this line, and so many characters in it
    std::ptrdiff_t characters = 0;
    for (std::size_t offset : offsets) {
        offset = std::clamp(offset, starts_.front(), text.size());
        if (const auto of = std::upper_bound(line, starts_.end(), offset) - 1; of != line) {
            line = of;
            read = *line;
            characters = 0;
        }
        // This byte counts, so that every byte of a character has the character's column.
        const std::size_t end = std::min(offset + 1, text.size());
        const std::string_view more = text.substr(read, end - read);
        characters += std::count_if(more.begin(), more.end(),
                                    [](char byte) { return !isContinuation(byte); });
        bytesPlaced() += more.size();
        read = end;
        const std::ptrdiff_t column = offset < text.size() ? characters : characters + 1;
        result.push_back(
            {static_cast<int>(line - starts_.begin()) + 1, std::max(static_cast<int>(column), 1)});
    }
    return result;
}

} // namespace text
