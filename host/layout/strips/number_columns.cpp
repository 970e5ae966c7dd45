#include "strips/number_columns.h"

#include "paragraphs/measure.h"
#include "typography/numbers.h"

#include <QFontMetricsF>
#include <algorithm>

namespace layout {

using paragraphs::BlockPointer;
using paragraphs::fromPoints;
using paragraphs::Looks;
using paragraphs::Paragraph;
using paragraphs::widthsOf;

namespace {

constexpr std::size_t longestNumber = 64; // bytes

double freeBefore(schemas::Align align, double free) {
    switch (align) {
    case schemas::Align::center:
        return std::max(0.0, free / 2);
    case schemas::Align::right:
        return std::max(0.0, free);
    default:
        return 0;
    }
}

// A number that plays counts as the widest so far.
QString measuredText(const model::Run& run) {
    const bool hasRoom = run.value && !run.value->room.empty();
    return QString::fromStdString(hasRoom ? run.value->room : run.text);
}

// The number that a block is, and how wide it is on both sides of its point.
void measureNumber(Looks& looks, const model::Block& block, Measured& measured) {
    std::size_t length = 0;
    for (const model::Run& run : block.runs) {
        const bool isText = run.kind == model::RunKind::text || run.kind == model::RunKind::value;
        length += isText ? run.text.size() : longestNumber + 1;
    }
    if (block.kind != model::BlockKind::text || !block.marker.empty() || length > longestNumber)
        return;
    QString text;
    for (const model::Run& run : block.runs)
        text += measuredText(run);
    measured.isNoNumber = typography::isNoNumber(text);
    const QString language =
        block.runs.empty() ? QString()
                           : QString::fromStdString(looks.style(block.runs.front().style).language);
    const std::optional<qsizetype> point = typography::pointOf(text, language);
    if (!point)
        return;
    NumberWidths widths;
    qsizetype left = *point;
    for (const model::Run& run : block.runs) {
        const QString part = measuredText(run);
        const QFontMetricsF metrics(looks.font(run.style));
        const qsizetype before = std::clamp<qsizetype>(left, 0, part.size());
        widths.before += metrics.horizontalAdvance(part.first(before));
        widths.behind += metrics.horizontalAdvance(part.sliced(before));
        left -= part.size();
    }
    measured.number = widths;
}

} // namespace

std::shared_ptr<const Measured> measuredOf(const Surroundings& in, const BlockPointer& block,
                                           std::size_t letters) {
    return in.stock.measured(block, letters, [&] {
        auto made = std::make_unique<Measured>(Measured{.block = block});
        std::size_t left = letters;
        made->widths = widthsOf(in.stock.materials(), *block, left);
        made->letters = letters - left;
        in.work.letters += made->letters;
        measureNumber(in.stock.materials()->looks, *block, *made);
        return made;
    });
}

void NumberColumn::add(const model::Cell& cell, const Measured* measured, bool isHeader) {
    if (measured != nullptr && measured->number && cell.style.alignNumbers) {
        if (count_++ == 0) {
            align_ = cell.blocks.front()->style.align;
            padding_ = fromPoints(cell.style.padding);
        }
        before_ = std::max(before_, measured->number->before);
        behind_ = std::max(behind_, measured->number->behind);
        return;
    }
    const bool isEmpty = cell.blocks.empty() || (measured != nullptr && measured->isNoNumber);
    hasOthers_ = hasOthers_ || !(isHeader || isEmpty);
}

double NumberColumn::ofCells() const { return before_ + behind_ + 2 * padding_ + fromPoints(0.5); }

std::optional<double> NumberColumn::point(double ofCells) const {
    constexpr double rounding = 1;
    const double inner = ofCells - 2 * padding_;
    const double width = before_ + behind_;
    if (!isOne() || width > inner + rounding)
        return std::nullopt;
    return freeBefore(align_, inner - width) + before_;
}

double shiftToPoint(const Surroundings& in, const model::Cell& cell, double point) {
    if (cell.blocks.size() != 1 || !cell.style.alignNumbers)
        return 0;
    const auto measured = measuredOf(in, cell.blocks.front(), Paragraph::segmentLength);
    if (!measured->number)
        return 0;
    const double width = measured->number->before + measured->number->behind;
    const double own = freeBefore(cell.blocks.front()->style.align, in.width - width);
    const double shift = point - measured->number->before - own;
    return own + shift < 0 || own + shift + width > in.width + 1 ? 0 : shift;
}

} // namespace layout
