#include "scene/diagnostic.h"

#include <algorithm>
#include <string_view>

namespace scene {

namespace {

constexpr std::size_t widest = 100; // characters of a source line that are shown
constexpr std::size_t tabStop = 8;
constexpr std::size_t longestShown = 20'000; // bytes of a line

// One character of the line as shown: what the reader sees, and the character of the text it is of.
struct Cell {
    std::string_view bytes;
    std::size_t character = 0; // from 0
};

std::size_t bytesOfCharacter(std::string_view text, std::size_t at) {
    std::size_t end = at + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
        ++end;
    return end - at;
}

// Tabs become blanks up to the next stop. Other control characters must not reach a terminal.
std::vector<Cell> cellsOf(std::string_view line) {
    std::vector<Cell> cells;
    std::size_t character = 0;
    for (std::size_t at = 0; at < line.size(); ++character) {
        const std::size_t length = bytesOfCharacter(line, at);
        const auto byte = static_cast<unsigned char>(line[at]);
        if (line[at] == '\t')
            do
                cells.push_back({" ", character});
            while (cells.size() % tabStop != 0);
        else
            cells.push_back(
                {byte < 0x20 || byte == 0x7f ? "?" : line.substr(at, length), character});
        at += length;
    }
    return cells;
}

std::string_view lineOf(std::string_view text, int number) {
    std::size_t from = 0;
    for (int line = 1; line < number; ++line) {
        const std::size_t end = text.find('\n', from);
        if (end == std::string_view::npos)
            return {};
        from = end + 1;
    }
    std::string_view line = text.substr(from, text.find('\n', from) - from);
    if (!line.empty() && line.back() == '\r')
        line.remove_suffix(1);
    return line;
}

// The cells that show characters from..to of the line; one past its end when there are none.
std::pair<std::size_t, std::size_t> marked(const std::vector<Cell>& cells, std::size_t from,
                                           std::size_t to) {
    const auto at = [&](std::size_t character) {
        return static_cast<std::size_t>(
            std::find_if(cells.begin(), cells.end(),
                         [&](const Cell& c) { return c.character >= character; }) -
            cells.begin());
    };
    const std::size_t first = at(from);
    return {first, std::max(first + 1, std::min(at(to), cells.size()))};
}

std::string excerpt(const Diagnostic& d, const std::string& text) {
    const std::vector<Cell> cells = cellsOf(lineOf(text, d.line));
    const auto column = static_cast<std::size_t>(std::max(d.column, 1) - 1);
    const std::size_t endColumn = d.endLine > d.line ? cells.size() + column + 1
                                  : d.endColumn > d.column
                                      ? static_cast<std::size_t>(d.endColumn - 1)
                                      : column + 1;
    const auto [first, last] = marked(cells, column, endColumn);

    // Of a long line, the part around the mark.
    const std::size_t from = cells.size() > widest && first > widest / 2 ? first - widest / 2 : 0;
    const std::size_t to = std::min(cells.size(), from + widest);
    std::string shown = from > 0 ? "    ..." : "    ";
    const std::size_t indent = shown.size();
    for (std::size_t i = from; i < to; ++i)
        shown += cells[i].bytes;
    if (to < cells.size())
        shown += "...";
    const std::size_t length =
        std::max<std::size_t>(1, std::min(last, std::max(to, first + 1)) - first);
    shown += "\n" + std::string(indent + first - from, ' ') + "^" + std::string(length - 1, '~');
    return d.suggestion.empty() ? shown : shown + " " + d.suggestion;
}

} // namespace

void sortByPlace(std::vector<Diagnostic>& diagnostics) {
    std::stable_sort(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) {
                         if ((a.line == 0) != (b.line == 0))
                             return b.line == 0;
                         return std::pair(a.line, a.column) < std::pair(b.line, b.column);
                     });
}

std::string formatted(const Diagnostic& diagnostic, const std::string& file,
                      const std::string& text) {
    const std::string kind = diagnostic.severity == Severity::error ? "error: " : "warning: ";
    if (diagnostic.line == 0) {
        const std::string sentence = file + ": " + kind + diagnostic.message;
        return diagnostic.suggestion.empty() ? sentence : sentence + " " + diagnostic.suggestion;
    }
    std::string sentence = file + ":" + std::to_string(diagnostic.line) + ":" +
                           std::to_string(diagnostic.column) + ": " + kind + diagnostic.message;
    // LIMIT: a line that no person wrote is not shown; a thousand faults in one would take minutes.
    if (lineOf(text, diagnostic.line).size() > longestShown)
        return diagnostic.suggestion.empty() ? sentence : sentence + " " + diagnostic.suggestion;
    return sentence + "\n" + excerpt(diagnostic, text);
}

} // namespace scene
