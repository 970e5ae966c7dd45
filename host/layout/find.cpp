#include "layout/find.h"

#include <algorithm>
#include <map>

namespace layout {

namespace {

class Finding {
public:
    explicit Finding(const QString& words) : words_(words) {}

    void line(std::size_t page, const TextPiece& piece) {
        const Paragraph& of = *piece.paragraph;
        const auto [from, to] = of.rangeOfLine(piece.line);
        const int length = static_cast<int>(words_.size());
        // A match may have begun on the line before, and may end on the next. No more of the text
        // is read for it.
        const int first = std::max(0, from - length + 1);
        const QString text = of.text(first, to + length - 1 - first);
        for (auto at = text.indexOf(words_, 0, Qt::CaseInsensitive); at >= 0;
             at = text.indexOf(words_, at + length, Qt::CaseInsensitive)) {
            const int begin = first + static_cast<int>(at);
            if (begin < to && begin + length > from)
                mark(page, piece, begin, std::max(begin, from), std::min(begin + length, to));
        }
    }
    std::vector<Found> found;

private:
    void mark(std::size_t page, const TextPiece& piece, int begin, int from, int to) {
        const auto [place, isNew] =
            places_.emplace(std::pair(piece.paragraph.get(), begin), found.size());
        if (isNew)
            found.push_back({page, {}});
        Found& one = found[place->second];
        if (one.page != page)
            return;
        one.parts.push_back({piece.paragraph, piece.line, from, to, piece.at});
    }

    const QString& words_;
    // By where they begin: the parts of one on several lines are one.
    std::map<std::pair<const Paragraph*, int>, std::size_t> places_;
};

} // namespace

double Found::Part::bottom() const {
    return at.y() + paragraph->lines()[static_cast<std::size_t>(line)].height;
}

QRectF Found::Part::rect() const {
    const double left = paragraph->leftOf(line, from), right = paragraph->leftOf(line, to);
    return {at.x() + std::min(left, right), at.y(), std::abs(right - left), bottom() - at.y()};
}

std::vector<Found> findText(const Pages& pages, const QString& words) {
    if (words.isEmpty())
        return {};
    Finding finding(words);
    for (std::size_t i = 0; i < pages.pages.size(); ++i)
        for (const Piece& piece : pages.pages[i]->pieces)
            if (const auto* text = std::get_if<TextPiece>(&piece))
                finding.line(i, *text);
    return std::move(finding.found);
}

} // namespace layout
