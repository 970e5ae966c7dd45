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
        const QString text = of.text();
        const auto [from, to] = of.rangeOfLine(piece.line);
        const int length = static_cast<int>(words_.size());
        // A match may have begun on the line before.
        int at = static_cast<int>(
            text.indexOf(words_, std::max(0, from - length + 1), Qt::CaseInsensitive));
        for (; at >= 0 && at < to;
             at = static_cast<int>(text.indexOf(words_, at + length, Qt::CaseInsensitive)))
            if (at + length > from)
                mark(page, piece, at, std::max(at, from), std::min(at + length, to));
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
        const Paragraph& of = *piece.paragraph;
        const double left = of.leftOf(piece.line, from), right = of.leftOf(piece.line, to);
        const double height = of.lines()[static_cast<std::size_t>(piece.line)].height;
        one.rects.emplace_back(piece.at.x() + std::min(left, right), piece.at.y(),
                               std::abs(right - left), height);
    }

    const QString& words_;
    // By where they begin: the parts of one on several lines are one.
    std::map<std::pair<const Paragraph*, int>, std::size_t> places_;
};

} // namespace

std::vector<Found> findText(const Pages& pages, const QString& words) {
    if (words.isEmpty())
        return {};
    Finding finding(words);
    for (std::size_t i = 0; i < pages.pages.size(); ++i)
        for (const Piece& piece : pages.pages[i].pieces)
            if (const auto* text = std::get_if<TextPiece>(&piece))
                finding.line(i, *text);
    return std::move(finding.found);
}

} // namespace layout
