#include "layout/strip.h"

#include "layout/measure.h"

#include <algorithm>
#include <numeric>

namespace layout {

namespace {

template <class... Ts> struct Overloaded : Ts... { using Ts::operator()...; };

QSizeF fitted(QSizeF size, double width, double height) {
    const double scale = std::min({1.0, width / size.width(), height / size.height()});
    return size * scale;
}

double paddingOf(const document::Cell& cell) { return fromPoints(cell.style.padding); }

} // namespace

Piece moved(Piece piece, QPointF by) {
    std::visit(Overloaded{[&](TextPiece& text) { text.at += by; },
                          [&](auto& other) { other.rect.translate(by); }},
               piece);
    return piece;
}

Stack stacked(const std::vector<Strip>& strips) {
    Stack stack;
    double after = 0;
    for (const Strip& strip : strips) {
        if (&strip != &strips.front())
            stack.height += std::max(after, strip.before);
        for (const Piece& piece : strip.pieces)
            stack.pieces.push_back(moved(piece, {0, stack.height}));
        stack.footnotes.insert(stack.footnotes.end(), strip.footnotes.begin(),
                               strip.footnotes.end());
        stack.height += strip.height;
        after = strip.after;
    }
    return stack;
}

double StripBuilder::left(const document::Block& block) const {
    return fromPoints(block.style.indentLeft);
}

double StripBuilder::room(const document::Block& block) const {
    return std::max(width - left(block) - fromPoints(block.style.indentRight), fromPoints(20));
}

double StripBuilder::aligned(const document::Block& block, double itsWidth) const {
    const double spare = std::max(0.0, room(block) - itsWidth);
    switch (block.style.align) {
    case document::Align::center:
        return left(block) + spare / 2;
    case document::Align::right:
        return left(block) + spare;
    default:
        return left(block);
    }
}

std::vector<Strip> StripBuilder::strips(const std::vector<document::Block>& blocks) const {
    using document::BlockKind;
    std::vector<Strip> result;
    bool breakNext = false;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const document::Block& block = blocks[i];
        const std::size_t first = result.size();
        switch (block.kind) {
        case BlockKind::text:
        case BlockKind::verbatim:
        case BlockKind::chart:
            text(block, result);
            break;
        case BlockKind::subdocument:
            subdocument(block, result);
            break;
        case BlockKind::image:
            image(block, result);
            break;
        case BlockKind::table:
            table(block, result);
            break;
        case BlockKind::rule:
            rule(block, result);
            break;
        case BlockKind::pageBreak:
            breakNext = true;
            continue;
        }
        if (first == result.size())
            continue;
        result[first].before = fromPoints(block.style.spaceBefore);
        result[first].breakBefore = breakNext || block.style.pageBreakBefore;
        result.back().after = fromPoints(block.style.spaceAfter);
        breakNext = false;
        for (std::size_t s = first; s < result.size(); ++s) {
            result[s].block = i;
            if (block.style.keepTogether && s + 1 < result.size())
                result[s].keepWithNext = true;
        }
        if (block.style.keepWithNext)
            result.back().keepWithNext = true;
    }
    return result;
}

void StripBuilder::text(const document::Block& block, std::vector<Strip>& into) const {
    const bool markerInFront = !block.marker.empty() && block.style.markerWidth <= 0;
    const QString prefix =
        markerInFront ? QString::fromStdString(block.marker) + QChar(' ') : QString();
    const auto paragraph =
        std::make_shared<const Paragraph>(model, block, room(block), objects, prefix);
    const auto& lines = paragraph->lines();
    const bool ragged = block.kind == document::BlockKind::verbatim;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        Strip strip;
        strip.height = lines[i].height;
        strip.footnotes = lines[i].footnotes;
        strip.pieces.push_back(TextPiece{paragraph, static_cast<int>(i), {left(block), 0}});
        for (const InlineObject& object : lines[i].objects)
            strip.pieces.push_back(SubdocumentPiece{
                block.runs[object.run].subdocument,
                paragraph->objectRect(static_cast<int>(i), object).translated(left(block), 0)});
        // Neither the first nor the last line of a paragraph stands alone.
        const bool widow = i == 0 || i + 2 == lines.size();
        strip.keepWithNext = !ragged && widow && i + 1 < lines.size();
        if (i == 0 && !block.marker.empty() && !markerInFront)
            addMarker(block, strip, lines[i].baseline);
        into.push_back(std::move(strip));
    }
}

void StripBuilder::addMarker(const document::Block& block, Strip& strip,
                             double lineBaseline) const {
    document::Block marker;
    marker.style.align = block.style.markerAlign;
    marker.style.lineHeight = block.style.lineHeight;
    document::Run run;
    run.text = block.marker;
    run.style = block.markerStyle;
    marker.runs.push_back(run);
    const double column = fromPoints(block.style.markerWidth);
    const auto paragraph = std::make_shared<const Paragraph>(model, marker, column, objects);
    if (paragraph->lines().empty())
        return;
    const double down = lineBaseline - paragraph->lines().front().baseline;
    strip.pieces.push_back(TextPiece{paragraph, 0, {left(block) - column, down}});
}

void StripBuilder::subdocument(const document::Block& block, std::vector<Strip>& into) const {
    const QSizeF size = fitted(objects.subdocumentSize(block.subdocument), room(block), mostHeight);
    Strip strip;
    strip.height = size.height();
    strip.mayFloat = block.style.keepWithNext;
    strip.pieces.push_back(
        SubdocumentPiece{block.subdocument, {QPointF(aligned(block, size.width()), 0), size}});
    into.push_back(std::move(strip));
}

void StripBuilder::image(const document::Block& block, std::vector<Strip>& into) const {
    const QImage picture = objects.image ? objects.image(block.source) : QImage();
    QSizeF size = picture.isNull() ? QSizeF(320, 120) : QSizeF(picture.size());
    if (block.width)
        size.scale(*block.width, block.height ? *block.height : size.height() * *block.width,
                   block.height ? Qt::IgnoreAspectRatio : Qt::KeepAspectRatio);
    else if (block.height)
        size.scale(size.width() * *block.height, *block.height, Qt::KeepAspectRatio);
    size = fitted(fromPixels(size), room(block), mostHeight);
    Strip strip;
    strip.height = size.height();
    strip.mayFloat = block.style.keepWithNext;
    const QString named = block.alternative.empty() ? QString::fromStdString(block.source)
                                                    : QString::fromStdString(block.alternative);
    strip.pieces.push_back(
        ImagePiece{picture, {QPointF(aligned(block, size.width()), 0), size}, named});
    into.push_back(std::move(strip));
}

void StripBuilder::rule(const document::Block& block, std::vector<Strip>& into) const {
    const double thickness = fromPoints(std::max(block.style.border.width, 0.25));
    document::Border none;
    Strip strip;
    strip.height = thickness;
    strip.pieces.push_back(
        FramePiece{{left(block), 0, room(block), thickness}, block.style.border.color, none});
    into.push_back(std::move(strip));
}

// --- tables ------------------------------------------------------------------------------------

// Columns as wide as their widest text where there is room; else each gets its longest word, and
// they share what is left by how much more they would like.
std::vector<double> StripBuilder::columns(const document::Block& block, double available) const {
    std::vector<Widths> wanted;
    for (const document::Row& row : block.rows) {
        wanted.resize(std::max(wanted.size(), row.size()));
        for (std::size_t c = 0; c < row.size(); ++c)
            for (const document::Block& inside : row[c].blocks) {
                Widths widths = widthsOf(model, inside, objects);
                if (inside.kind == document::BlockKind::subdocument)
                    widths.natural = widths.least =
                        objects.subdocumentSize(inside.subdocument).width();
                else if (inside.kind != document::BlockKind::text)
                    widths.natural = std::max(widths.natural, available / 3);
                const double extra = 2 * paddingOf(row[c]) + left(inside) + fromPoints(0.5);
                wanted[c].natural = std::max(wanted[c].natural, widths.natural + extra);
                wanted[c].least = std::max(wanted[c].least, widths.least + extra);
            }
    }
    double natural = 0, least = 0;
    for (const Widths& column : wanted) {
        natural += column.natural;
        least += column.least;
    }
    const double share = natural <= available ? 1
                         : natural > least ? std::max(0.0, (available - least) / (natural - least))
                                           : 0;
    const double squeeze = least > available ? available / least : 1;
    std::vector<double> result;
    for (const Widths& column : wanted)
        result.push_back(squeeze * (column.least + share * (column.natural - column.least)));
    return result;
}

Strip StripBuilder::row(const document::Row& row, const std::vector<double>& columns,
                        double left) const {
    Strip strip;
    std::vector<Stack> stacks;
    for (std::size_t c = 0; c < row.size(); ++c) {
        const double padding = paddingOf(row[c]);
        const StripBuilder inside{model, objects, std::max(columns[c] - 2 * padding, 1.0),
                                  mostHeight};
        stacks.push_back(stacked(inside.strips(row[c].blocks)));
        strip.height = std::max(strip.height, stacks.back().height + 2 * padding);
    }
    double x = left;
    for (std::size_t c = 0; c < row.size(); ++c) {
        const document::BlockStyle& style = row[c].style;
        if (style.background || style.border.width > 0)
            strip.pieces.push_back(
                FramePiece{{x, 0, columns[c], strip.height}, style.background, style.border});
        for (const Piece& piece : stacks[c].pieces)
            strip.pieces.push_back(moved(piece, {x + paddingOf(row[c]), paddingOf(row[c])}));
        strip.footnotes.insert(strip.footnotes.end(), stacks[c].footnotes.begin(),
                               stacks[c].footnotes.end());
        x += columns[c];
    }
    return strip;
}

void StripBuilder::table(const document::Block& block, std::vector<Strip>& into) const {
    const std::vector<double> widths = columns(block, room(block));
    const double start = aligned(block, std::accumulate(widths.begin(), widths.end(), 0.0));
    for (std::size_t r = 0; r < block.rows.size(); ++r) {
        into.push_back(row(block.rows[r], widths, start));
        // Neither the first nor the last row of a table stands alone.
        into.back().keepWithNext =
            r + 1 < block.rows.size() && (r == 0 || r + 2 == block.rows.size());
    }
}

} // namespace layout
