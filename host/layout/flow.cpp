#include "layout/flow.h"

#include "layout/cells.h"
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

} // namespace

Piece moved(Piece piece, QPointF by) {
    std::visit(Overloaded{[&](TextPiece& text) { text.at += by; },
                          [&](auto& other) { other.rect.translate(by); }},
               piece);
    return piece;
}

Flow::Flow(const Surroundings& in, const document::Blocks& blocks) : in_(in), blocks_(blocks) {}

Flow::~Flow() = default;
Flow::Flow(Flow&&) noexcept = default;

double Flow::left(const document::Block& block) const { return fromPoints(block.style.indentLeft); }

double Flow::room(const document::Block& block) const {
    return std::max(in_.width - left(block) - fromPoints(block.style.indentRight), fromPoints(20));
}

double Flow::aligned(const document::Block& block, double itsWidth) const {
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

Made Flow::next(Strip& strip) {
    while (block_ < blocks_.size()) {
        const document::Block& block = *blocks_[block_];
        bool last = true;
        const Made made = inBlock(block, strip, last);
        if (made == Made::strip)
            finish(block, strip, last);
        if (made != Made::end && (made == Made::pause || !last))
            return made;
        breakNext_ =
            made == Made::end && (breakNext_ || block.kind == document::BlockKind::pageBreak);
        leaveBlock();
        if (made == Made::strip)
            return made;
    }
    return Made::end;
}

void Flow::leaveBlock() {
    if (paragraph_)
        in_.work.letters += paragraph_->lettersShaped();
    ++block_;
    made_ = 0;
    paragraph_.reset();
    table_.reset();
}

// The next strip of a block, `last` when there is none behind it; Made::end: the block has none.
Made Flow::inBlock(const document::Block& block, Strip& strip, bool& last) {
    using document::BlockKind;
    switch (block.kind) {
    case BlockKind::text:
    case BlockKind::verbatim:
    case BlockKind::chart:
        return text(block, strip, last);
    case BlockKind::table:
        return table(block, strip, last);
    case BlockKind::subdocument:
        subdocument(block, strip);
        return Made::strip;
    case BlockKind::image:
        image(block, strip);
        return Made::strip;
    case BlockKind::rule:
        rule(block, strip);
        return Made::strip;
    case BlockKind::pageBreak:
        break;
    }
    return Made::end;
}

void Flow::finish(const document::Block& block, Strip& strip, bool last) {
    ++in_.work.strips;
    strip.block = block_;
    strip.firstOfBlock = made_ == 0;
    strip.lastOfBlock = last;
    if (strip.firstOfBlock) {
        strip.before = fromPoints(block.style.spaceBefore);
        strip.breakBefore = breakNext_ || block.style.pageBreakBefore;
    }
    if (last)
        strip.after = fromPoints(block.style.spaceAfter);
    if (last ? block.style.keepWithNext : block.style.keepTogether)
        strip.keepWithNext = true;
    ++made_;
}

// --- text --------------------------------------------------------------------------------------

Made Flow::text(const document::Block& block, Strip& strip, bool& last) {
    const bool markerInFront = !block.marker.empty() && block.style.markerWidth <= 0;
    if (!paragraph_) {
        const QString prefix =
            markerInFront ? QString::fromStdString(block.marker) + QChar(' ') : QString();
        paragraph_ =
            std::make_shared<Paragraph>(in_.model, block, room(block), in_.objects, prefix);
    }
    const std::size_t i = made_;
    if (!paragraph_->makeLine(i))
        return Made::end;
    last = !paragraph_->makeLine(i + 1);
    const Paragraph::Line& line = paragraph_->lines()[i];
    const int index = static_cast<int>(i);
    strip.height = line.height;
    strip.footnotes = line.footnotes;
    strip.pieces.emplace_back(TextPiece{paragraph_, index, {left(block), 0}});
    for (const InlineObject& object : line.objects)
        strip.pieces.emplace_back(
            SubdocumentPiece{block.runs[object.run].subdocument,
                             paragraph_->objectRect(index, object).translated(left(block), 0)});
    // Neither the first nor the last line of a paragraph stands alone.
    const bool ragged = block.kind == document::BlockKind::verbatim;
    strip.keepWithNext = !ragged && !last && (i == 0 || !paragraph_->makeLine(i + 2));
    if (i == 0 && !block.marker.empty() && !markerInFront)
        addMarker(block, strip, line.baseline);
    return Made::strip;
}

void Flow::addMarker(const document::Block& block, Strip& strip, double lineBaseline) const {
    document::Block marker;
    marker.style.align = block.style.markerAlign;
    marker.style.lineHeight = block.style.lineHeight;
    document::Run run;
    run.text = block.marker;
    run.style = block.markerStyle;
    marker.runs.push_back(run);
    const double column = fromPoints(block.style.markerWidth);
    const auto paragraph = std::make_shared<Paragraph>(in_.model, marker, column, in_.objects);
    if (!paragraph->makeLine(0))
        return;
    const double down = lineBaseline - paragraph->lines().front().baseline;
    strip.pieces.emplace_back(TextPiece{paragraph, 0, {left(block) - column, down}});
}

// --- pictures and rules ------------------------------------------------------------------------

void Flow::subdocument(const document::Block& block, Strip& strip) const {
    const QSizeF size =
        fitted(in_.objects.subdocumentSize(block.subdocument), room(block), in_.pictureHeight);
    strip.height = size.height();
    strip.mayFloat = block.style.keepWithNext;
    strip.pieces.emplace_back(
        SubdocumentPiece{block.subdocument, {QPointF(aligned(block, size.width()), 0), size}});
}

void Flow::image(const document::Block& block, Strip& strip) const {
    const QSize pixels = in_.objects.imageSize ? in_.objects.imageSize(block.source) : QSize();
    QSizeF size = pixels.isEmpty() ? QSizeF(320, 120) : QSizeF(pixels);
    if (block.width)
        size.scale(*block.width, block.height ? *block.height : size.height() * *block.width,
                   block.height ? Qt::IgnoreAspectRatio : Qt::KeepAspectRatio);
    else if (block.height)
        size.scale(size.width() * *block.height, *block.height, Qt::KeepAspectRatio);
    size = fitted(fromPixels(size), room(block), in_.pictureHeight);
    strip.height = size.height();
    strip.mayFloat = block.style.keepWithNext;
    const QString named = block.alternative.empty() ? QString::fromStdString(block.source)
                                                    : QString::fromStdString(block.alternative);
    strip.pieces.emplace_back(
        ImagePiece{block.source, {QPointF(aligned(block, size.width()), 0), size}, named});
}

void Flow::rule(const document::Block& block, Strip& strip) const {
    const double thickness = fromPoints(std::max(block.style.border.width, 0.25));
    document::Border none;
    strip.height = thickness;
    strip.pieces.emplace_back(
        FramePiece{{left(block), 0, room(block), thickness}, block.style.border.color, none});
}

// --- tables ------------------------------------------------------------------------------------

namespace {

// What a block in a cell would like, and cannot do without, of at most so many letters.
Widths widthsIn(const Surroundings& in, const document::Block& block, double available,
                std::size_t& letters) {
    Widths widths = widthsOf(in.model, block, in.objects, letters);
    if (block.kind == document::BlockKind::subdocument)
        widths.natural = widths.least = in.objects.subdocumentSize(block.subdocument).width();
    else if (block.kind != document::BlockKind::text)
        widths.natural = std::max(widths.natural, available / 3);
    return widths;
}

// Of each column. Every column is measured by one of its cells at least.
std::vector<Widths> wantedBy(const Surroundings& in, const document::Block& block,
                             double available) {
    std::vector<Widths> wanted;
    std::size_t letters = Flow::lettersForColumns;
    for (const document::Row& row : block.rows) {
        wanted.resize(std::max(wanted.size(), row.size()));
        for (std::size_t c = 0; c < row.size(); ++c) {
            if (letters == 0 && wanted[c].natural > 0)
                continue;
            const double padding = fromPoints(row[c].style.padding);
            std::size_t ofCell = Paragraph::segmentLength;
            for (const auto& inside : row[c].blocks) {
                const std::size_t before = ofCell;
                if (before == 0)
                    break;
                const Widths widths = widthsIn(in, *inside, available, ofCell);
                letters -= std::min(letters, before - ofCell);
                const double extra =
                    2 * padding + fromPoints(inside->style.indentLeft) + fromPoints(0.5);
                wanted[c].natural = std::max(wanted[c].natural, widths.natural + extra);
                wanted[c].least = std::max(wanted[c].least, widths.least + extra);
            }
        }
    }
    return wanted;
}

// Columns as wide as their widest text where there is room; else each gets its longest word, and
// they share what is left by how much more they would like.
std::vector<double> columnsOf(const Surroundings& in, const document::Block& block,
                              double available) {
    const std::vector<Widths> wanted = wantedBy(in, block, available);
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

} // namespace

Made Flow::table(const document::Block& block, Strip& strip, bool& last) {
    const std::size_t rows = block.rows.size();
    if (!table_) {
        table_ = std::make_unique<Table>();
        table_->columns = columnsOf(in_, block, room(block));
        const auto& columns = table_->columns;
        table_->left = aligned(block, std::accumulate(columns.begin(), columns.end(), 0.0));
    }
    if (table_->row >= rows)
        return Made::end;
    if (!table_->cells)
        table_->cells =
            std::make_shared<Cells>(in_, block.rows[table_->row], table_->columns, table_->left);
    if (!table_->cells->prepare())
        return Made::pause;
    if (table_->cells->fitsOnPage())
        strip = table_->cells->take(in_.pageHeight, true);
    else
        strip.cells = std::move(table_->cells);
    table_->cells.reset();
    const std::size_t r = table_->row++;
    last = r + 1 == rows;
    // Neither the first nor the last row of a table stands alone.
    strip.keepWithNext = !last && (r == 0 || r + 2 == rows);
    return Made::strip;
}

} // namespace layout
