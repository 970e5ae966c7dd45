// The parts of a page that lie in an interval of the document: its rectangles.
#include "places/carets.h"

#include <algorithm>

namespace places {

using layout::TextPiece;
using model::Run;
using paragraphs::Paragraph;

namespace {

// Letter by letter where letters go from right to left, as some between others may.
void addInterval(const TextPiece& piece, int from, int to, std::vector<QRectF>& result) {
    const Paragraph& paragraph = *piece.paragraph;
    const double top = piece.at.y(), height = piece.letters().height;
    const auto add = [&](double left, double right) {
        left += piece.at.x();
        right += piece.at.x();
        constexpr double touching = 1;
        if (!result.empty() && result.back().top() == top &&
            std::abs(result.back().right() - left) < touching)
            result.back().setRight(right);
        else if (!result.empty() && result.back().top() == top &&
                 std::abs(result.back().left() - right) < touching)
            result.back().setLeft(left);
        else
            result.emplace_back(left, top, right - left, height);
    };
    const QString text = paragraph.text(from, to - from);
    const auto isPlain = [](QChar letter) {
        return letter.direction() != QChar::DirR && letter.direction() != QChar::DirAL;
    };
    if (!paragraph.isRightToLeft() && std::ranges::all_of(text, isPlain))
        return add(paragraph.leftOf(piece.line, from), paragraph.leftOf(piece.line, to));
    for (int letter = from; letter < to; ++letter) {
        const auto [left, right] = paragraph.edgesOf(piece.line, letter);
        if (right > left)
            add(left, right);
    }
}

} // namespace

void Carets::addSelected(const TextPiece& piece, const std::vector<model::SelectedRun>& runs,
                         text::Range interval, std::vector<QRectF>& result) const {
    const Paragraph& paragraph = *piece.paragraph;
    const Paragraph::Line& line = piece.letters();
    const std::vector<Run>& all = paragraph.block()->runs;
    for (std::size_t i = 0; i < all.size() && paragraph.startOfRun(i) < line.to; ++i) {
        if (!runs[i].isIn)
            continue;
        // Generated text is selected as a whole, and may be one sign, as a formula is.
        const bool isText = places_.isText(all[i]);
        const int next = i + 1 < all.size() ? paragraph.startOfRun(i + 1) : line.to;
        const int from =
            isText ? paragraph.letterAt(i, runs[i].bytes.from) : paragraph.startOfRun(i);
        const int to = isText ? paragraph.letterAt(i, runs[i].bytes.to) : next;
        if (std::max(from, line.from) < std::min(to, line.to))
            addInterval(piece, std::max(from, line.from), std::min(to, line.to), result);
    }
    if (line.to != paragraph.lines().back().to || !places_.isText(all.back()))
        return;
    const std::size_t end = places_.placeOf(all.back(), all.back().text.size());
    if (interval.from > end || interval.to <= end)
        return;
    const double x = piece.at.x() + paragraph.leftOf(piece.line, line.to);
    const double width = line.height / 4;
    result.emplace_back(paragraph.isRightToLeft() ? x - width : x, piece.at.y(), width,
                        line.height);
}

std::vector<QRectF> Carets::selected(std::size_t page, text::Range interval) const {
    std::vector<QRectF> result;
    if (interval.empty() || page >= pages_.pages.size())
        return result;
    const Paragraph* last = nullptr;
    std::vector<model::SelectedRun> runs;
    for (const auto& [piece, index] : linesOn(page)) {
        if (piece->paragraph.get() != last)
            runs = model::selectedRuns(places_, *piece->paragraph->block(), interval);
        last = piece->paragraph.get();
        addSelected(*piece, runs, interval, result);
    }
    return result;
}

} // namespace places
