// Runs of lines that are no letters: how high they make a line, and how formulas are painted.
#include "paragraphs/paragraph.h"

#include "formulas/paint.h"
#include "paragraphs/measure.h"
#include "paragraphs/typeface.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

namespace paragraphs {

namespace {

constexpr double distance = 0.08; // of the leading, from the next lines where they move apart
constexpr QColor faultyColor(0xC0, 0x20, 0x20);

} // namespace

// Of the line's letters, above and below its base line. Other things count as letters of the
// size around it: alone in a line or a cell it has the base line of a word.
std::pair<double, double> Paragraph::extentOf(const Line& line, double ascent,
                                              double descent) const {
    if (line.from == line.to) { // as with the letters that may come to stand there
        const QFontMetricsF metrics(materials().looks.font(firstStyle()));
        return {metrics.ascent(), metrics.descent()};
    }
    for (const InlineObject& object : letters_.objectsIn(line.from, line.to)) {
        const QFontMetricsF metrics(materials().looks.font(block()->runs[object.run].style));
        ascent = std::max(ascent, metrics.ascent());
        descent = std::max(descent, metrics.descent());
    }
    return {ascent, descent};
}

// Lines move apart only where what stands in one would come too near to another.
void Paragraph::makeRoom(Line& line, const InlineObject& object) const {
    const double apart = block()->kind == model::BlockKind::formula ? 0 : distance * leading_;
    const double above = object.size.height() - object.depth - line.baseline;
    if (above > 0) {
        line.height += above + apart;
        line.baseline += above + apart;
    }
    const double below = object.depth - (line.height - line.baseline);
    if (below > 0)
        line.height += below + apart;
}

void Paragraph::paintFormulas(QPainter& painter, int line, QPointF topLeft) const {
    const double baseline = lines_[static_cast<std::size_t>(line)].baseline;
    for (const InlineObject& object : objectsOf(line)) {
        if (!object.formula)
            continue;
        const auto& style = materials().looks.style(block()->runs[object.run].style);
        formulas::paint(painter, object.formula->pieces[object.piece].box,
                        topLeft + QPointF(object.left, baseline), *formulas::Font::standard(),
                        colorOf(style.color), faultyColor);
    }
}

} // namespace paragraphs
