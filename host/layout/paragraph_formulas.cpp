// Formulas in lines: each piece that stays on one line is a blank of its width, and the spaces
// between them are blanks where the line may end.
#include "layout/paragraph.h"

#include "formulas/paint.h"
#include "layout/measure.h"
#include "layout/typeface.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

namespace layout {

namespace {

constexpr QChar noBreak(0x00A0), space(0x0020);
constexpr QChar leftToRight(0x2066), asBefore(0x2069); // around pieces: they keep their order
constexpr double leastBroken = 0.25;                   // of the width: what is shorter stays whole
constexpr double roomBesideNumber = 0.8;               // of the width, for a display with a number
constexpr double distance = 0.08; // of the leading, from the next lines where they move apart
constexpr QColor faultyColor(0xC0, 0x20, 0x20);

} // namespace

// What is read again is what its lines were made for.
std::shared_ptr<const formulas::Set> Paragraph::formulaOf(std::size_t run, int position) const {
    if (run < runsRead_) {
        const auto isBefore = [](const InlineObject& object, int at) {
            return object.position < at;
        };
        return std::lower_bound(objects_.begin(), objects_.end(), position, isBefore)->formula;
    }
    const model::Run& of = block_->runs[run];
    const auto& font = formulas::Font::standard();
    const double size = fromPoints(materials_->looks.style(of.style).size);
    const auto style = of.formula->isAlone ? formulas::Style::display : formulas::Style::text;
    formulas::Set set = formulas::typeset(of.formula->read, style, size, *font);
    if (!of.formula->isAlone && set.width < leastBroken * width_)
        set = formulas::whole(set);
    const double most = width_ * (block_->marker.empty() ? 1 : roomBesideNumber);
    if (of.formula->isAlone && set.width > most) // a display is not broken, but set smaller
        set = formulas::typeset(of.formula->read, style, size * most / set.width, *font);
    return std::make_shared<const formulas::Set>(std::move(set));
}

void Paragraph::appendFormula(std::size_t index) const {
    const auto start = static_cast<int>(letters_->text.size());
    letters_->runStarts.push_back(start);
    const auto set = formulaOf(index, start);
    const std::uint32_t style = block_->runs[index].style;
    const bool several = set->pieces.size() > 1;
    if (several)
        appendBlank(leftToRight, 0, style);
    for (std::size_t i = 0; i < set->pieces.size(); ++i) {
        const formulas::Piece& piece = set->pieces[i];
        if (index >= runsRead_) {
            const QSizeF size(piece.box.width, piece.box.ascent + piece.box.descent);
            objects_.push_back({index, static_cast<int>(letters_->text.size()), size, 0,
                                piece.box.descent, set, i});
        }
        appendBlank(noBreak, piece.box.width, style);
        if (i + 1 < set->pieces.size()) {
            Range& gap = appendBlank(space, piece.space, style);
            gap.blank = piece.space;
            gap.isGap = true;
        }
    }
    if (several)
        appendBlank(asBefore, 0, style);
    runsRead_ = std::max(runsRead_, index + 1);
}

bool Paragraph::isSubdocument(const InlineObject& object) const {
    return block_->runs[object.run].kind == model::RunKind::subdocument;
}

// Of the line's letters, above and below its base line. A formula or an image counts as letters of
// the size around it: alone in a line or a cell it has the base line that a word would have.
std::pair<double, double> Paragraph::extentOf(const Line& line, double ascent,
                                              double descent) const {
    const auto isBefore = [](const InlineObject& object, int at) { return object.position < at; };
    for (auto at = std::lower_bound(objects_.begin(), objects_.end(), line.from, isBefore);
         at != objects_.end() && at->position < line.to; ++at) {
        if (isSubdocument(*at))
            continue;
        const QFontMetricsF metrics(materials_->looks.font(block_->runs[at->run].style));
        ascent = std::max(ascent, metrics.ascent());
        descent = std::max(descent, metrics.descent());
    }
    return {ascent, descent};
}

// Lines move apart only where the formula or image would come too near to one of them.
void Paragraph::makeRoom(Line& line, const InlineObject& object) const {
    const double apart = block_->kind == model::BlockKind::formula ? 0 : distance * leading_;
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
        const auto& style = materials_->looks.style(block_->runs[object.run].style);
        formulas::paint(painter, object.formula->pieces[object.piece].box,
                        topLeft + QPointF(object.left, baseline), *formulas::Font::standard(),
                        colorOf(style.color), faultyColor);
    }
}

} // namespace layout
