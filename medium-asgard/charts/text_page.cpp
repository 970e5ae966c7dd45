#include "charts/text_page.h"

#include "text/characters.h"
#include "text/printable.h"

#include <algorithm>
#include <cmath>

namespace charts {
namespace {

constexpr double codeSize = 11, letterWidth = 0.6021 * codeSize; // DejaVu Sans Mono
constexpr double rowHeight = 14, margin = 6, gap = 8;            // gap: behind the numbers
constexpr std::size_t tab = 8;

// Pieces of a line of at most so many letters.
std::vector<std::string> wrapped(std::string_view line, std::size_t columns) {
    std::vector<std::string> pieces(1);
    std::size_t column = 0;
    const auto put = [&](std::string_view letter) {
        if (column == columns) {
            pieces.emplace_back();
            column = 0;
        }
        pieces.back() += letter;
        ++column;
    };
    while (!line.empty()) {
        const std::size_t length = std::max<std::size_t>(1, text::characterLength(line));
        if (line.front() == '\t')
            for (std::size_t i = column % tab; i < tab; ++i)
                put(" ");
        else
            put(line.substr(0, length));
        line.remove_prefix(length);
    }
    return pieces;
}

} // namespace

TextPage::TextPage(std::string_view text, const std::set<std::size_t>& faulty, double width)
    : width_(width) {
    const auto lines = 1 + static_cast<std::size_t>(std::ranges::count(text, '\n'));
    numbers_ = letterWidth * static_cast<double>(std::to_string(lines).size()) + gap;
    const double room = std::floor((width - 2 * margin - numbers_) / letterWidth);
    const auto columns = static_cast<std::size_t>(std::max(8.0, room));
    const std::string shown = text::printable(text);
    std::string_view rest = shown;
    for (std::size_t line = 1; !rest.empty(); ++line) {
        const std::string_view one = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), one.size() + 1));
        bool isFirst = true;
        for (std::string& piece : wrapped(one, columns)) {
            rows_.push_back({isFirst ? line : 0, std::move(piece), faulty.contains(line)});
            isFirst = false;
        }
    }
}

double TextPage::height() const {
    return 2 * margin + rowHeight * static_cast<double>(std::max<std::size_t>(1, rows_.size()));
}

std::size_t TextPage::rowsIn(double height) const {
    return static_cast<std::size_t>(std::max(1.0, std::floor((height - 2 * margin) / rowHeight)));
}

std::size_t TextPage::top(std::size_t first, double height) const {
    const std::size_t room = rowsIn(height);
    return std::min(first, rows_.size() > room ? rows_.size() - room : 0);
}

void TextPage::draw(Canvas& canvas, double height, std::size_t first) const {
    const std::size_t room = rowsIn(height), begin = top(first, height);
    const std::size_t left = rows_.size() - begin;
    // The last row says what is left, where there is more.
    const std::size_t shown = left > room ? room - 1 : left;
    double y = margin + codeSize;
    for (std::size_t i = begin; i < begin + shown; ++i, y += rowHeight) {
        const Row& row = rows_[i];
        if (row.isFaulty) {
            canvas.ink({0.85, 0.1, 0.1}, 0.12);
            cairo_rectangle(canvas.cairo(), 0, y - codeSize, width_, rowHeight);
            cairo_fill(canvas.cairo());
        }
        if (row.line > 0) {
            canvas.ink({}, 0.45);
            const std::string number = std::to_string(row.line);
            const double width = letterWidth * static_cast<double>(number.size());
            canvas.code(margin + numbers_ - gap - width, y, number, codeSize);
        }
        canvas.ink({});
        canvas.code(margin + numbers_, y, row.text, codeSize);
    }
    if (shown < left) {
        canvas.ink({}, 0.6);
        const auto more = std::count_if(rows_.begin() + static_cast<std::ptrdiff_t>(begin + shown),
                                        rows_.end(), [](const Row& row) { return row.line > 0; });
        canvas.text(margin + numbers_, y,
                    more > 0 ? "\u2026 " + std::to_string(more) + " more lines" : "\u2026",
                    codeSize, Canvas::Anchor::start);
    }
}

} // namespace charts
