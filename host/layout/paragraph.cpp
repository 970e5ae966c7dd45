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
    return model.textStyles && index < model.textStyles->size() ? (*model.textStyles)[index]
                                                                : plain;
}

} // namespace

Paragraph::Paragraph(const document::Model& model, const document::Block& block, double width,
                     const Objects& objects, const QString& prefix)
    : model_(model), objectsOf_(objects), kind_(block.kind), style_(block.style), width_(width),
      runs_(block.runs) {
    const document::TextStyle& style =
        styleOf(model, runs_.empty() ? block.textStyle : runs_.front().style);
    font_ = fontOf(style);
    leading_ = fromPoints(style.size) * block.style.lineHeight;
    if (!prefix.isEmpty()) {
        formats_.append({0, static_cast<int>(prefix.size()), format(block.markerStyle)});
        text_ = prefix;
    }
}

const QTextCharFormat& Paragraph::format(std::uint32_t style) {
    const auto [known, isNew] = styles_.try_emplace(style);
    if (isNew)
        known->second = formatOf(styleOf(model_, style));
    return known->second;
}

// --- letters -----------------------------------------------------------------------------------

void Paragraph::readRuns(int to) {
    while (text_.size() < to && runStarts_.size() < runs_.size())
        append(runStarts_.size());
}

void Paragraph::append(std::size_t index) {
    const document::Run& run = runs_[index];
    const int start = static_cast<int>(text_.size());
    runStarts_.push_back(start);
    QTextCharFormat own = format(run.style);
    if (run.kind == document::RunKind::subdocument && objectsOf_.subdocumentSize) {
        const QSizeF size = objectsOf_.subdocumentSize(run.subdocument);
        objects_.push_back({index, start, size});
        text_ += blank;
        QFont font = own.font();
        font.setPixelSize(1);
        font.setLetterSpacing(QFont::AbsoluteSpacing, size.width());
        own.setFont(font);
    } else if (run.kind == document::RunKind::lineBreak) {
        text_ += QChar(QChar::LineSeparator);
    } else {
        text_ += QString::fromStdString(run.text).replace(QLatin1Char('\n'),
                                                          QChar(QChar::LineSeparator));
    }
    if (run.kind == document::RunKind::footnote)
        footnotes_.emplace_back(start, run.footnote);
    const int length = static_cast<int>(text_.size()) - start;
    const bool isObject = !objects_.empty() && objects_.back().position == start;
    if (!isObject && lastStyle_ == run.style)
        formats_.back().length += length;
    else
        formats_.append({start, length, own});
    lastStyle_ = isObject ? std::nullopt : std::optional(run.style);
}

// --- lines -------------------------------------------------------------------------------------

bool Paragraph::makeLine(std::size_t line) {
    while (lines_.size() <= line && !complete_)
        breakSegment();
    return line < lines_.size();
}

namespace {

bool endsBefore(const QTextLayout::FormatRange& range, int at) {
    return range.start + range.length <= at;
}

} // namespace

int Paragraph::lengthOfSegment() const {
    int end = std::min(next_ + segmentLength, static_cast<int>(text_.size()));
    const auto first = std::lower_bound(formats_.begin(), formats_.end(), next_, endsBefore);
    if (formats_.end() - first > segmentFormats)
        end = std::min(end, (first + segmentFormats)->start);
    if (end < text_.size() && end > next_ + 1 && text_[end].isLowSurrogate())
        --end;
    return end - next_;
}

void Paragraph::breakSegment() {
    readRuns(next_ + segmentLength + 1);
    const int length = lengthOfSegment();
    const bool isLast = next_ + length == text_.size();
    QTextOption option(alignmentOf(style_.align));
    option.setUseDesignMetrics(true);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    if (!segments_.empty())
        option.setTextDirection(segments_.front().layout->textOption().textDirection());
    else if (!isLast)
        option.setTextDirection(text_.isRightToLeft() ? Qt::RightToLeft : Qt::LeftToRight);
    auto layout = std::make_unique<QTextLayout>(text_.mid(next_, length), font_);
    layout->setTextOption(option);
    layout->setCacheEnabled(true);
    layout->setFormats(formatsOf(next_, next_ + length));
    lettersShaped_ += static_cast<std::size_t>(length);
    const std::size_t before = lines_.size();
    layout->beginLayout();
    for (QTextLine line = layout->createLine(); line.isValid(); line = layout->createLine()) {
        const bool indented = lines_.empty() && kind_ != document::BlockKind::verbatim;
        const double indent = indented ? fromPoints(style_.firstLine) : 0;
        line.setLineWidth(std::max(width_ - indent, fromPoints(1)));
        line.setPosition({indent, 0});
        naturalWidth_ = std::max(naturalWidth_, line.naturalTextWidth() + indent);
        lines_.push_back(measured(line, next_));
        lines_.back().segment = segments_.size();
        lines_.back().index = static_cast<int>(lines_.size() - 1 - before);
    }
    layout->endLayout();
    leastWidth_ = std::max(leastWidth_, layout->minimumWidth());
    const int from = next_;
    next_ += length;
    complete_ = isLast;
    if (!isLast && lines_.size() > before + 1) {
        // The text goes on in it: it is made anew.
        next_ = from + layout->lineAt(lines_.back().index).textStart();
        lines_.pop_back();
    }
    segments_.push_back({from, std::move(layout)});
}

QList<QTextLayout::FormatRange> Paragraph::formatsOf(int from, int to) const {
    QList<QTextLayout::FormatRange> result;
    for (auto at = std::lower_bound(formats_.begin(), formats_.end(), from, endsBefore);
         at != formats_.end() && at->start < to; ++at) {
        QTextLayout::FormatRange part = *at;
        part.start = std::max(at->start, from) - from;
        part.length = std::min(at->start + at->length, to) - from - part.start;
        result.append(part);
    }
    return result;
}

Paragraph::Line Paragraph::measured(const QTextLine& line, int from) const {
    const double ascent = line.ascent(), descent = line.descent();
    Line result;
    // Larger letters than the block's own need their own room, but not so much between lines.
    result.height = std::max(leading_, ascent + descent > 1.25 * leading_ ? ascent + descent : 0);
    result.baseline = (result.height - ascent - descent) / 2 + ascent;
    const int first = from + line.textStart(), end = first + line.textLength();
    const auto isBefore = [](const auto& object, int at) { return object.position < at; };
    for (auto object = std::lower_bound(objects_.begin(), objects_.end(), first, isBefore);
         object != objects_.end() && object->position < end; ++object) {
        result.objects.push_back(*object);
        const double grow = object->size.height() + leading_ - result.height;
        if (grow > 0) {
            result.height += grow;
            result.baseline += grow;
        }
    }
    const auto marksBefore = [](const auto& mark, int at) { return mark.first < at; };
    for (auto mark = std::lower_bound(footnotes_.begin(), footnotes_.end(), first, marksBefore);
         mark != footnotes_.end() && mark->first < end; ++mark)
        result.footnotes.push_back(mark->second);
    return result;
}

// --- what stands on them -----------------------------------------------------------------------

QTextLine Paragraph::drawn(int line) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    return segments_[of.segment].layout->lineAt(of.index);
}

void Paragraph::paintLine(QPainter& painter, int line, QPointF topLeft) const {
    const QTextLine of = drawn(line);
    // A line knows its own x (indent and alignment); its y is the page's.
    const double top = topLeft.y() + lines_[static_cast<std::size_t>(line)].baseline - of.ascent() -
                       of.position().y();
    of.draw(&painter, {topLeft.x(), top});
}

QRectF Paragraph::objectRect(int line, const InlineObject& object) const {
    const double baseline = lines_[static_cast<std::size_t>(line)].baseline;
    return {QPointF(leftOf(line, object.position), baseline - object.size.height()), object.size};
}

const document::Run* Paragraph::runAt(int line, double x) const {
    const QTextLine found = drawn(line);
    if (x < found.naturalTextRect().left() || x > found.naturalTextRect().right())
        return nullptr;
    const int position = segments_[lines_[static_cast<std::size_t>(line)].segment].from +
                         found.xToCursor(x, QTextLine::CursorOnCharacter);
    const auto behind = std::upper_bound(runStarts_.begin(), runStarts_.end(), position);
    return behind == runStarts_.begin() ? nullptr : &runs_[behind - runStarts_.begin() - 1];
}

QString Paragraph::textOfLine(int line) const {
    const auto [from, to] = rangeOfLine(line);
    return text_.mid(from, to - from);
}

std::pair<int, int> Paragraph::rangeOfLine(int line) const {
    const QTextLine found = drawn(line);
    const int from = segments_[lines_[static_cast<std::size_t>(line)].segment].from;
    return {from + found.textStart(), from + found.textStart() + found.textLength()};
}

double Paragraph::leftOf(int line, int position) const {
    const int from = segments_[lines_[static_cast<std::size_t>(line)].segment].from;
    return drawn(line).cursorToX(position - from);
}

Widths widthsOf(const document::Model& model, const document::Block& block, const Objects& objects,
                std::size_t& letters) {
    document::Block left;
    left.kind = block.kind;
    left.style = block.style;
    left.style.align = document::Align::left;
    left.textStyle = block.textStyle;
    left.runs = block.runs;
    Paragraph whole(model, left, unbroken, objects);
    for (std::size_t line = 0; whole.lettersShaped() < letters && whole.makeLine(line);)
        line = whole.lines().size();
    letters -= std::min(letters, std::max<std::size_t>(whole.lettersShaped(), 1));
    return {whole.naturalWidth(), std::min(whole.leastWidth(), whole.naturalWidth())};
}

} // namespace layout
