#include "layout/paragraph.h"

#include "layout/measure.h"
#include "layout/typeface.h"

#include <QPainter>
#include <algorithm>

namespace layout {

namespace {

constexpr double unbroken = 4e6; // twips; a width that nothing reaches
constexpr QChar blank(0x00A0);

Qt::Alignment alignmentOf(document::Align align) {
    switch (align) {
    case document::Align::center:
        return Qt::AlignHCenter;
    case document::Align::right:
        return Qt::AlignRight;
    case document::Align::justify:
        return Qt::AlignJustify;
    case document::Align::left:
        break;
    }
    return Qt::AlignLeft;
}

const document::TextStyle& styleOf(const document::Model& model, std::uint32_t index) {
    static const document::TextStyle plain;
    return index < model.textStyles.size() ? model.textStyles[index] : plain;
}

} // namespace

Paragraph::Paragraph(const document::Model& model, const document::Block& block, double width,
                     const Objects& objects, const QString& prefix)
    : runs_(block.runs) {
    if (!prefix.isEmpty()) {
        formats_.append(
            {0, static_cast<int>(prefix.size()), formatOf(styleOf(model, block.markerStyle))});
        text_ = prefix;
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        runStarts_.push_back(static_cast<int>(text_.size()));
        append(model, runs_[i], objects);
        if (!objects_.empty() && objects_.back().position == runStarts_.back())
            objects_.back().run = i;
    }
    breakLines(model, block, width);
}

void Paragraph::append(const document::Model& model, const document::Run& run,
                       const Objects& objects) {
    const int start = static_cast<int>(text_.size());
    QTextCharFormat format = formatOf(styleOf(model, run.style));
    if (run.kind == document::RunKind::subdocument && objects.subdocumentSize) {
        const QSizeF size = objects.subdocumentSize(run.subdocument);
        objects_.push_back({0, start, size});
        text_ += blank;
        QFont font = format.font();
        font.setPixelSize(1);
        font.setLetterSpacing(QFont::AbsoluteSpacing, size.width());
        format.setFont(font);
    } else if (run.kind == document::RunKind::lineBreak) {
        text_ += QChar(QChar::LineSeparator);
    } else {
        text_ += QString::fromStdString(run.text).replace(QLatin1Char('\n'),
                                                          QChar(QChar::LineSeparator));
    }
    formats_.append({start, static_cast<int>(text_.size()) - start, format});
}

void Paragraph::breakLines(const document::Model& model, const document::Block& block,
                           double width) {
    const document::TextStyle& style =
        styleOf(model, block.runs.empty() ? block.textStyle : block.runs.front().style);
    const bool verbatim = block.kind == document::BlockKind::verbatim;
    QTextOption option(alignmentOf(block.style.align));
    option.setUseDesignMetrics(true);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout_ = std::make_unique<QTextLayout>(text_, fontOf(style));
    layout_->setTextOption(option);
    layout_->setCacheEnabled(true);
    layout_->setFormats(formats_);
    const double leading = fromPoints(style.size) * block.style.lineHeight;
    layout_->beginLayout();
    for (QTextLine line = layout_->createLine(); line.isValid(); line = layout_->createLine()) {
        const double indent = lines_.empty() && !verbatim ? fromPoints(block.style.firstLine) : 0;
        line.setLineWidth(std::max(width - indent, fromPoints(1)));
        line.setPosition({indent, 0});
        naturalWidth_ = std::max(naturalWidth_, line.naturalTextWidth() + indent);
        lines_.push_back(measured(line, leading));
    }
    layout_->endLayout();
}

Paragraph::Line Paragraph::measured(const QTextLine& line, double leading) const {
    const double ascent = line.ascent(), descent = line.descent();
    Line result;
    // Larger letters than the block's own need their own room, but not so much between lines.
    result.height = std::max(leading, ascent + descent > 1.25 * leading ? ascent + descent : 0);
    result.baseline = (result.height - ascent - descent) / 2 + ascent;
    const int from = line.textStart(), to = from + line.textLength();
    for (const InlineObject& object : objects_)
        if (object.position >= from && object.position < to) {
            result.objects.push_back(object);
            const double grow = object.size.height() + leading - result.height;
            if (grow > 0) {
                result.height += grow;
                result.baseline += grow;
            }
        }
    for (std::size_t i = 0; i < runs_.size(); ++i)
        if (runs_[i].kind == document::RunKind::footnote && runStarts_[i] >= from &&
            runStarts_[i] < to)
            result.footnotes.push_back(runs_[i].footnote);
    return result;
}

void Paragraph::paintLine(QPainter& painter, int line, QPointF topLeft) const {
    const QTextLine drawn = layout_->lineAt(line);
    // A line knows its own x (indent and alignment); its y is the page's.
    const double top = topLeft.y() + lines_[static_cast<std::size_t>(line)].baseline -
                       drawn.ascent() - drawn.position().y();
    drawn.draw(&painter, {topLeft.x(), top});
}

QRectF Paragraph::objectRect(int line, const InlineObject& object) const {
    const double x = layout_->lineAt(line).cursorToX(object.position);
    const double baseline = lines_[static_cast<std::size_t>(line)].baseline;
    return {QPointF(x, baseline - object.size.height()), object.size};
}

const document::Run* Paragraph::runAt(int line, double x) const {
    const QTextLine found = layout_->lineAt(line);
    if (x < found.naturalTextRect().left() || x > found.naturalTextRect().right())
        return nullptr;
    const int position = found.xToCursor(x, QTextLine::CursorOnCharacter);
    for (std::size_t i = runs_.size(); i-- > 0;)
        if (runStarts_[i] <= position)
            return &runs_[i];
    return nullptr;
}

QString Paragraph::textOfLine(int line) const {
    const QTextLine found = layout_->lineAt(line);
    return text_.mid(found.textStart(), found.textLength());
}

std::pair<int, int> Paragraph::rangeOfLine(int line) const {
    const QTextLine found = layout_->lineAt(line);
    return {found.textStart(), found.textStart() + found.textLength()};
}

double Paragraph::leftOf(int line, int position) const {
    return layout_->lineAt(line).cursorToX(position);
}

Widths widthsOf(const document::Model& model, const document::Block& block,
                const Objects& objects) {
    document::Block left = block;
    left.style.align = document::Align::left;
    const Paragraph whole(model, left, unbroken, objects);
    return {whole.naturalWidth(), std::min(whole.leastWidth(), whole.naturalWidth())};
}

} // namespace layout
