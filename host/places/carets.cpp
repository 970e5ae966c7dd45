#include "places/carets.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace places {

using layout::Piece;
using layout::TextPiece;
using paragraphs::Paragraph;

using model::Run;

namespace {

double topOf(const TextPiece& piece) { return piece.at.y(); }
double bottomOf(const TextPiece& piece) { return piece.at.y() + piece.letters().height; }

// How far `x` is beside the column that the line was broken to.
double besides(const TextPiece& piece, double x) {
    return std::max({0.0, piece.at.x() - x, x - piece.at.x() - piece.paragraph->width()});
}

bool sharesColumn(const TextPiece& a, const TextPiece& b) {
    return a.at.x() < b.at.x() + b.paragraph->width() && b.at.x() < a.at.x() + a.paragraph->width();
}

} // namespace

const TextPiece& Carets::pieceOf(const Caret& caret) const {
    return std::get<TextPiece>(pages_.pages[caret.page]->pieces[caret.piece]);
}

bool Carets::hasPlaces(const Paragraph& paragraph) const {
    return std::ranges::any_of(paragraph.block()->runs, [&](const Run& run) {
        return places_.isText(run) || isUnitIn(paragraph, run);
    });
}

bool Carets::isUnitIn(const Paragraph& paragraph, const Run& run) const {
    return paragraph.block()->kind == model::BlockKind::text && places_.isUnit(run);
}

// In the order of their painting.
std::vector<Carets::Line> Carets::linesOn(std::size_t page) const {
    std::vector<Line> result;
    const std::vector<Piece>& pieces = pages_.pages[page]->pieces;
    const Paragraph* last = nullptr;
    bool has = false;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (const auto* text = std::get_if<TextPiece>(&pieces[i]); text && !text->isRepeated) {
            if (text->paragraph.get() != last)
                has = hasPlaces(*text->paragraph);
            last = text->paragraph.get();
            if (has)
                result.emplace_back(text, i);
        }
    return result;
}

// --- places in a paragraph ---------------------------------------------------------------------

// Of two texts that meet here the first; but where blanks between are left out, the second.
std::optional<std::size_t> Carets::runAt(const Paragraph& paragraph, int letter) const {
    const std::vector<Run>& runs = paragraph.block()->runs;
    for (std::size_t i = 0; i < runs.size() && paragraph.startOfRun(i) <= letter; ++i) {
        const bool isLast = i + 1 == runs.size();
        if (!places_.isText(runs[i]) || (!isLast && paragraph.startOfRun(i + 1) < letter))
            continue;
        if (!isLast && runs[i + 1].content == runs[i].content &&
            paragraph.startOfRun(i + 1) == letter)
            continue;
        if (letter <= paragraph.letterAt(i, runs[i].text.size()))
            return i;
    }
    return std::nullopt;
}

std::optional<std::size_t> Carets::placeAt(const Paragraph& paragraph, int letter) const {
    const std::vector<Run>& runs = paragraph.block()->runs;
    if (const std::optional<std::size_t> run = runAt(paragraph, letter))
        return places_.placeOf(runs[*run], paragraph.byteAt(*run, letter));
    for (std::size_t i = 0; i < runs.size() && paragraph.startOfRun(i) <= letter; ++i) {
        if (!isUnitIn(paragraph, runs[i]))
            continue;
        if (paragraph.startOfRun(i) == letter)
            return places_.rangeOf(runs[i]).from;
        if (paragraph.endOfRun(i) == letter)
            return places_.rangeOf(runs[i]).to;
    }
    return std::nullopt;
}

// The place at or next to a letter.
std::optional<int> Carets::placeFrom(const Paragraph& paragraph, int letter, Search search) const {
    if (placeAt(paragraph, letter))
        return letter;
    const std::vector<Run>& runs = paragraph.block()->runs;
    std::optional<int> before, behind;
    for (std::size_t i = 0; i < runs.size() && !behind; ++i) {
        const bool isText = places_.isText(runs[i]);
        if (!isText && !isUnitIn(paragraph, runs[i]))
            continue;
        const int start = paragraph.startOfRun(i);
        const int end = isText ? paragraph.letterAt(i, runs[i].text.size()) : paragraph.endOfRun(i);
        if (start > letter)
            behind = start;
        else if (isText || end < letter)
            before = end;
        else
            std::tie(before, behind) = std::pair(start, end);
    }
    if (search == Search::before ||
        (search == Search::nearest && before && behind && letter - *before <= *behind - letter))
        return before;
    return search == Search::behind || behind ? behind : before;
}

std::size_t Carets::placeOf(const Caret& caret) const {
    return placeAt(*pieceOf(caret).paragraph, caret.letter).value_or(0); // 0: none stands there
}

// The line of it, which is on that page or on one near it.
std::optional<Caret> Carets::caretIn(const Paragraph& paragraph, int letter,
                                     std::size_t page) const {
    const int line = paragraph.lineOf(letter);
    const std::size_t count = pages_.pages.size();
    for (std::size_t i = 0; i < 2 * count + 1; ++i) {
        const std::size_t at = i % 2 == 0 ? page - i / 2 : page + (i + 1) / 2; // may wrap
        if (at >= count)
            continue;
        const std::vector<Piece>& pieces = pages_.pages[at]->pieces;
        for (std::size_t p = 0; p < pieces.size(); ++p)
            if (const auto* text = std::get_if<TextPiece>(&pieces[p]);
                text && !text->isRepeated && text->paragraph.get() == &paragraph &&
                text->line == line)
                return Caret{at, p, letter};
    }
    return std::nullopt;
}

// --- places of the document --------------------------------------------------------------------

template <typename Find>
std::optional<Caret> Carets::inParagraphs(std::size_t page, const Find& find) const {
    const std::size_t count = pages_.pages.size();
    for (std::size_t i = 0; i < 2 * count + 1; ++i) {
        const std::size_t at = i % 2 == 0 ? page - i / 2 : page + (i + 1) / 2; // may wrap
        if (at >= count)
            continue;
        const Paragraph* last = nullptr;
        for (const Piece& piece : pages_.pages[at]->pieces) {
            const auto* text = std::get_if<TextPiece>(&piece);
            if (text == nullptr || text->isRepeated || text->paragraph.get() == last)
                continue;
            last = text->paragraph.get();
            if (const std::optional<int> letter = find(*last))
                return caretIn(*last, *letter, at);
        }
    }
    return std::nullopt;
}

std::optional<Caret> Carets::inContent(sgml::NodeId content, std::size_t place,
                                       std::size_t page) const {
    return inParagraphs(page, [&](const Paragraph& paragraph) -> std::optional<int> {
        const std::vector<Run>& runs = paragraph.block()->runs;
        std::optional<std::size_t> found;
        for (std::size_t r = 0; r < runs.size(); ++r)
            if (runs[r].content == content && (!found || places_.placeOf(runs[r], 0) <= place))
                found = r;
        if (!found)
            return std::nullopt;
        return paragraph.letterAt(*found, places_.byteAt(runs[*found], place));
    });
}

std::optional<Caret> Carets::besideUnit(std::size_t place, std::size_t page) const {
    sgml::NodeId around = tree_.innermostAt(place);
    if (around != sgml::noNode && tree_.node(around).range.from == place)
        around = tree_.node(around).parent;
    if (around == sgml::noNode)
        return std::nullopt;
    const auto touches = [&](sgml::NodeId node) {
        const text::Range range = tree_.node(node).range;
        return tree_.node(node).kind == sgml::NodeKind::element &&
               (range.from == place || range.to == place);
    };
    std::vector<sgml::NodeId> beside;
    for (sgml::NodeId child = tree_.node(around).firstChild; child != sgml::noNode;
         child = tree_.node(child).next)
        if (touches(child))
            beside.push_back(child);
    if (beside.empty())
        return std::nullopt;
    return inParagraphs(page, [&](const Paragraph& paragraph) -> std::optional<int> {
        const std::vector<Run>& runs = paragraph.block()->runs;
        for (std::size_t r = 0; r < runs.size(); ++r)
            if (isUnitIn(paragraph, runs[r]) && std::ranges::count(beside, runs[r].element) > 0)
                return places_.rangeOf(runs[r]).to == place ? paragraph.endOfRun(r)
                                                            : paragraph.startOfRun(r);
        return std::nullopt;
    });
}

// Goes through all pages.
std::optional<Caret> Carets::nearestTo(std::size_t place) const {
    std::size_t least = std::numeric_limits<std::size_t>::max();
    sgml::NodeId nearest = sgml::noNode;
    std::size_t page = 0;
    for (std::size_t i = 0; i < pages_.pages.size(); ++i)
        for (const auto& [piece, index] : linesOn(i))
            for (const Run& run : piece->paragraph->block()->runs) {
                if (!places_.isText(run))
                    continue;
                const text::Range range = tree_.contentRange(run.content);
                const std::size_t away = place < range.from ? range.from - place
                                         : place > range.to ? place - range.to
                                                            : 0;
                if (away < least) {
                    least = away;
                    nearest = run.content;
                    page = i;
                }
            }
    return nearest == sgml::noNode ? std::nullopt : inContent(nearest, place, page);
}

std::optional<Caret> Carets::of(std::size_t place, std::size_t page) const {
    if (pages_.pages.empty())
        return std::nullopt;
    page = std::min(page, pages_.pages.size() - 1);
    const sgml::NodeId node = tree_.innermostAt(place);
    if (node != sgml::noNode && tree_.node(node).kind == sgml::NodeKind::content)
        if (const std::optional<Caret> caret = inContent(node, place, page))
            return caret;
    if (const std::optional<Caret> caret = besideUnit(place, page))
        return caret;
    return nearestTo(place);
}

// --- places on a page --------------------------------------------------------------------------

Caret Carets::inLine(std::size_t page, const Line& line, double x) const {
    const Paragraph& paragraph = *line.first->paragraph;
    const int letter = paragraph.placeAt(line.first->line, x - line.first->at.x());
    const int place = placeFrom(paragraph, letter, Search::nearest).value_or(letter);
    return caretIn(paragraph, place, page).value_or(Caret{page, line.second, place});
}

std::optional<Caret> Carets::at(std::size_t page, QPointF point) const {
    const auto above = [&](const TextPiece& piece) {
        return std::max({0.0, topOf(piece) - point.y(), point.y() - bottomOf(piece)});
    };
    const std::vector<Line> lines = linesOn(page);
    const Line* best = nullptr;
    const Line* inColumn = nullptr; // the nearest line below or above the point
    const auto isNearer = [&](const Line& line, const Line& than) {
        return std::pair(above(*line.first), besides(*line.first, point.x())) <
               std::pair(above(*than.first), besides(*than.first, point.x()));
    };
    for (const Line& line : lines) {
        if (!best || isNearer(line, *best))
            best = &line;
        if (besides(*line.first, point.x()) == 0 && (!inColumn || isNearer(line, *inColumn)))
            inColumn = &line;
    }
    // Beside the short cell of a row stand the lines of a tall one.
    if (best && inColumn && !sharesColumn(*best->first, *inColumn->first))
        best = inColumn;
    if (best)
        return inLine(page, *best, point.x());
    for (std::size_t i = page + 1; i < pages_.pages.size(); ++i)
        if (const std::optional<Caret> caret = firstOn(i))
            return caret;
    for (std::size_t i = page; i-- > 0;)
        if (const std::optional<Caret> caret = lastOn(i))
            return caret;
    return std::nullopt;
}

bool Carets::isBelowAll(std::size_t page, QPointF point) const {
    if (page + 1 != pages_.pages.size())
        return false;
    const auto bottom = [](const auto& piece) {
        if constexpr (std::is_same_v<std::decay_t<decltype(piece)>, TextPiece>)
            return bottomOf(piece);
        else
            return piece.rect.bottom();
    };
    const layout::Page& last = *pages_.pages[page];
    return std::ranges::all_of(
               last.pieces,
               [&](const Piece& piece) { return std::visit(bottom, piece) < point.y(); }) &&
           std::ranges::all_of(last.tables, [&](const layout::PlacedRows& rows) {
               return rows.bottom < point.y();
           });
}

std::optional<Caret> Carets::firstOn(std::size_t page) const {
    const std::vector<Line> lines = linesOn(page);
    if (lines.empty())
        return std::nullopt;
    const Paragraph& paragraph = *lines.front().first->paragraph;
    const int from = lines.front().first->letters().from;
    return caretIn(paragraph, placeFrom(paragraph, from, Search::nearest).value_or(from), page);
}

// A footnote stands below text that follows it in the document.
std::optional<Caret> Carets::lastOn(std::size_t page) const {
    std::optional<Caret> last;
    for (const auto& [piece, index] : linesOn(page)) {
        const Paragraph& paragraph = *piece->paragraph;
        const int to = paragraph.endOfLine(piece->line);
        const std::optional<Caret> end =
            caretIn(paragraph, placeFrom(paragraph, to, Search::nearest).value_or(to), page);
        if (end && (!last || placeOf(*end) > placeOf(*last)))
            last = end;
    }
    return last;
}

QRectF Carets::rectOf(const Caret& caret) const {
    const TextPiece& piece = pieceOf(caret);
    return {piece.at.x() + piece.paragraph->leftOf(piece.line, caret.letter), topOf(piece), 0,
            piece.letters().height};
}

// --- moves -------------------------------------------------------------------------------------

std::optional<Caret> Carets::nextParagraph(const Caret& caret) const {
    const Paragraph* own = pieceOf(caret).paragraph.get();
    std::size_t from = caret.piece + 1;
    for (std::size_t page = caret.page; page < pages_.pages.size(); ++page, from = 0)
        for (const auto& [piece, index] : linesOn(page))
            if (index >= from && piece->paragraph.get() != own)
                if (const auto place = placeFrom(*piece->paragraph, 0, Search::behind))
                    return caretIn(*piece->paragraph, *place, page);
    return std::nullopt;
}

std::optional<Caret> Carets::previousParagraph(const Caret& caret) const {
    const Paragraph* own = pieceOf(caret).paragraph.get();
    for (std::size_t page = caret.page + 1; page-- > 0;) {
        const std::vector<Line> lines = linesOn(page);
        for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
            const auto& [piece, index] = *line;
            if ((page == caret.page && index >= caret.piece) || piece->paragraph.get() == own)
                continue;
            const int end = piece->letters().to;
            if (const auto place = placeFrom(*piece->paragraph, end, Search::before))
                return caretIn(*piece->paragraph, *place, page);
        }
    }
    return std::nullopt;
}

Caret Carets::sideways(const Caret& caret, Move move) const {
    const Paragraph& paragraph = *pieceOf(caret).paragraph;
    const bool toRight = move == Move::right || move == Move::wordRight;
    const bool onward = toRight != paragraph.isRightToLeft();
    const auto step = [&](int letter) {
        if (move == Move::left || move == Move::right)
            return paragraph.placeBeside(letter,
                                         toRight ? Paragraph::Side::right : Paragraph::Side::left);
        return onward ? paragraph.nextWord(letter) : paragraph.previousWord(letter);
    };
    int letter = caret.letter;
    for (int next = step(letter); next != letter; next = step(letter)) {
        letter = next;
        if (placeAt(paragraph, letter))
            return caretIn(paragraph, letter, caret.page).value_or(caret);
    }
    return (onward ? nextParagraph(caret) : previousParagraph(caret)).value_or(caret);
}

// To the nearest line there in the same column, of those that stand side by side the nearest one.
// The text goes on behind the footnotes of its page; out of these all lines are near.
Caret Carets::vertically(const Caret& caret, Move move, double x) const {
    const TextPiece& own = pieceOf(caret);
    const bool down = move == Move::down;
    const auto away = [&](const TextPiece& piece, double from) {
        return down ? topOf(piece) - from : from - bottomOf(piece);
    };
    double from = down ? bottomOf(own) : topOf(own);
    constexpr double slack = 1; // lines touch, but for rounding
    for (std::size_t page = caret.page; page < pages_.pages.size(); down ? ++page : --page) {
        const std::vector<Line> lines = linesOn(page);
        if (page != caret.page)
            from = down ? 0 : pages_.size.height();
        const auto mayBe = [&](const TextPiece& piece) {
            const bool isFlow =
                own.isOfNote ? page == caret.page || !piece.isOfNote : !piece.isOfNote;
            return isFlow && away(piece, from) > -slack &&
                   (page != caret.page || sharesColumn(piece, own));
        };
        const Line* first = nullptr;
        for (const Line& line : lines)
            if (mayBe(*line.first) &&
                (!first || away(*line.first, from) < away(*first->first, from)))
                first = &line;
        if (!first)
            continue;
        const Line* best = first;
        for (const Line& line : lines)
            if (mayBe(*line.first) && topOf(*line.first) < bottomOf(*first->first) &&
                bottomOf(*line.first) > topOf(*first->first) &&
                besides(*line.first, x) < besides(*best->first, x))
                best = &line;
        return inLine(page, *best, x);
    }
    return caret;
}

Caret Carets::moved(const Caret& caret, Move move, double x) const {
    const TextPiece& piece = pieceOf(caret);
    const Paragraph& paragraph = *piece.paragraph;
    const auto within = [&](int letter, Search search) {
        const auto place = placeFrom(paragraph, letter, search);
        return place ? caretIn(paragraph, *place, caret.page).value_or(caret) : caret;
    };
    switch (move) {
    case Move::up:
    case Move::down:
        return vertically(caret, move, x);
    case Move::lineStart:
        return within(piece.letters().from, Search::behind);
    case Move::lineEnd:
        return within(paragraph.endOfLine(piece.line), Search::before);
    case Move::documentStart:
        for (std::size_t i = 0; i < pages_.pages.size(); ++i)
            if (const std::optional<Caret> first = firstOn(i))
                return *first;
        return caret;
    case Move::documentEnd:
        for (std::size_t i = pages_.pages.size(); i-- > 0;)
            if (const std::optional<Caret> last = lastOn(i))
                return *last;
        return caret;
    default:
        return sideways(caret, move);
    }
}

namespace {

enum class Sort { word, blank, sign };

Sort sortOf(QChar letter) {
    if (letter.isSpace())
        return Sort::blank;
    return letter.isLetterOrNumber() || letter.isMark() || letter.isSurrogate() || letter == '_'
               ? Sort::word
               : Sort::sign;
}

} // namespace

std::pair<Caret, Caret> Carets::wordAt(const Caret& caret) const {
    const Paragraph& paragraph = *pieceOf(caret).paragraph;
    // LIMIT: of a longer word so much on each side.
    constexpr int most = 200;
    const int from = std::max(0, caret.letter - most);
    const QString text = paragraph.text(from, 2 * most);
    if (text.isEmpty())
        return {caret, caret};
    qsizetype first = std::min<qsizetype>(caret.letter - from, text.size() - 1);
    const Sort sort = sortOf(text[first]);
    qsizetype last = first + 1;
    while (first > 0 && sortOf(text[first - 1]) == sort)
        --first;
    while (last < text.size() && sortOf(text[last]) == sort)
        ++last;
    const auto caretAt = [&](qsizetype at) {
        const int letter = from + static_cast<int>(at);
        const int place = placeFrom(paragraph, letter, Search::nearest).value_or(caret.letter);
        return caretIn(paragraph, place, caret.page).value_or(caret);
    };
    return {caretAt(first), caretAt(last)};
}

std::pair<Caret, Caret> Carets::paragraphAt(const Caret& caret) const {
    const Paragraph& paragraph = *pieceOf(caret).paragraph;
    const auto caretAt = [&](int letter, Search search) {
        const int place = placeFrom(paragraph, letter, search).value_or(caret.letter);
        return caretIn(paragraph, place, caret.page).value_or(caret);
    };
    return {caretAt(0, Search::behind), caretAt(paragraph.lines().back().to, Search::before)};
}

} // namespace places
