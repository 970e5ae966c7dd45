// How a paragraph becomes lines: it is read and broken segment by segment; each line is then laid
// out for itself, with the width of its blanks.
#include "paragraphs/paragraph_breaking.h"

#include "paragraphs/measure.h"

#include <algorithm>

namespace paragraphs {

namespace {

constexpr QChar hyphenSign('-');

Qt::Alignment alignmentOf(schemas::Align align, bool rightToLeft) {
    switch (align) {
    case schemas::Align::center:
        return Qt::AlignHCenter;
    case schemas::Align::right:
        return Qt::AlignRight;
    case schemas::Align::justify:
        return rightToLeft ? Qt::AlignRight : Qt::AlignLeft;
    case schemas::Align::left:
        break;
    }
    return Qt::AlignLeft;
}

} // namespace

// --- letters as Qt lays them out ---------------------------------------------------------------

QTextOption Paragraph::optionOf() const {
    QTextOption option(alignmentOf(block()->style.align, isRightToLeft()));
    option.setUseDesignMetrics(true);
    option.setTextDirection(direction_);
    return option;
}

std::unique_ptr<QTextLayout> Paragraph::layoutFor(const QString& text,
                                                  const QList<QTextLayout::FormatRange>& formats,
                                                  const QTextOption& option) const {
    auto layout = std::make_unique<QTextLayout>(text, materials().looks.font(firstStyle()));
    layout->setTextOption(option);
    layout->setCacheEnabled(true);
    layout->setFormats(formats);
    return layout;
}

QList<QTextLayout::FormatRange> Paragraph::formatsOf(const Letters& letters, int from, int to,
                                                     double stretch, double apart) {
    const auto endsBefore = [](const LetterRange& range, int at) {
        return range.start + range.length <= at;
    };
    QList<QTextLayout::FormatRange> result;
    const auto& ranges = letters.ranges;
    for (auto at = std::lower_bound(ranges.begin(), ranges.end(), from, endsBefore);
         at != ranges.end() && at->start < to; ++at) {
        QTextLayout::FormatRange part{0, 0, at->format};
        if (stretch != 0 && at->blank > 0) {
            QFont font = part.format.font();
            if (at->isGap)
                font.setLetterSpacing(QFont::AbsoluteSpacing, (1 + stretch) * at->blank);
            else {
                font.setWordSpacing(stretch * at->blank);
                font.setLetterSpacing(QFont::AbsoluteSpacing, font.letterSpacing() + apart);
            }
            part.format.setFont(font);
        }
        part.start = std::max(at->start, from) - from;
        part.length = std::min(at->start + at->length, to) - from - part.start;
        result.append(part);
    }
    return result;
}

namespace {

// The signs around a line so that its letters go as they do in the paragraph: the embeddings that
// are open where it begins, and signs of the directions of the letters before and behind it.
struct Marks {
    QString before, behind;
};

QString markOf(QChar letter) {
    switch (letter.direction()) {
    case QChar::DirL:
        return QChar(0x200E);
    case QChar::DirR:
        return QChar(0x200F);
    case QChar::DirAL:
        return QChar(0x061C);
    default:
        return {};
    }
}

// LIMIT: looks back as far as a segment reaches.
Marks marksAround(QStringView text, int from, int end) {
    Marks marks;
    QString open, last;
    for (int i = std::max(0, from - Paragraph::segmentLength); i < from; ++i) {
        const QChar letter = text[i];
        switch (letter.direction()) {
        case QChar::DirLRE:
        case QChar::DirLRO:
        case QChar::DirRLE:
        case QChar::DirRLO:
        case QChar::DirLRI:
        case QChar::DirRLI:
        case QChar::DirFSI:
            open += letter;
            last.clear();
            break;
        case QChar::DirPDF:
        case QChar::DirPDI:
            open.chop(1);
            break;
        default:
            if (const QString mark = markOf(letter); !mark.isEmpty())
                last = mark;
        }
    }
    marks.before = open + last;
    constexpr int near = 64;
    for (int i = end; i < std::min<qsizetype>(text.size(), end + near); ++i)
        if (marks.behind = markOf(text[i]); !marks.behind.isEmpty())
            break;
    return marks;
}

} // namespace

// The same each time that it is called.
std::unique_ptr<QTextLayout> Paragraph::shaped(const Line& line, int& marks) const {
    const Letters& letters = letters_.read(line.to + 1);
    QString text = letters.text.mid(line.from, line.end - line.from);
    QList<QTextLayout::FormatRange> formats =
        formatsOf(letters, line.from, line.end, line.stretch, line.apart);
    if (line.hyphen && text.endsWith(softHyphen))
        text.back() = hyphenSign;
    else if (line.hyphen) {
        text += hyphenSign;
        formats.back().length += 1;
    }
    marks = 0;
    if (letters.isMixed) {
        const Marks around = marksAround(letters.text, line.from, line.end);
        text = around.before + text + (line.end < line.to ? around.behind : QString());
        marks = static_cast<int>(around.before.size());
        for (QTextLayout::FormatRange& format : formats)
            format.start += marks;
    }
    QTextOption option = optionOf();
    option.setWrapMode(QTextOption::ManualWrap);
    std::unique_ptr<QTextLayout> layout = layoutFor(text, formats, option);
    layout->beginLayout();
    QTextLine only = layout->createLine();
    const double indent = indentOf(line.from);
    only.setLineWidth(std::max(width() - indent, fromPoints(1)));
    only.setPosition({indent, 0});
    layout->endLayout();
    return layout;
}

double Paragraph::indentOf(int from) const {
    const bool isFirst = from == 0 && block()->kind != model::BlockKind::verbatim &&
                         block()->kind != model::BlockKind::formula;
    return isFirst ? fromPoints(block()->style.firstLine) : 0;
}

// --- lines -------------------------------------------------------------------------------------

bool Paragraph::makeLine(std::size_t line) {
    while (lines_.size() <= line && !complete_)
        breakSegment();
    return line < lines_.size();
}

int Paragraph::lengthOfSegment(const Letters& letters) const {
    const auto endsBefore = [](const LetterRange& range, int at) {
        return range.start + range.length <= at;
    };
    const auto& ranges = letters.ranges;
    const auto all = static_cast<int>(letters.text.size());
    int end = std::min(next_ + segmentLength, all);
    const auto first = std::lower_bound(ranges.begin(), ranges.end(), next_, endsBefore);
    if (ranges.end() - first > segmentFormats)
        end = std::min(end, (first + segmentFormats)->start);
    if (end < all && end > next_ + 1 && letters.text[end].isLowSurrogate())
        --end;
    return end - next_;
}

void Paragraph::breakSegment() {
    const Letters& letters = letters_.read(next_ + segmentLength + 1);
    const int from = next_, length = lengthOfSegment(letters);
    const bool isLast = from + length == letters.text.size();
    if (direction_ == Qt::LayoutDirectionAuto)
        direction_ = letters.text.isRightToLeft() ? Qt::RightToLeft : Qt::LeftToRight;
    const Breaking broken(*this, letters, from, length, isLast);
    lettersShaped_ += static_cast<std::size_t>(length);
    std::size_t count = broken.lines.size();
    next_ = from + length;
    if (!isLast && count > 1) // the text goes on in the last line: it is made anew
        next_ = broken.lines[--count].line.from;
    for (std::size_t i = 0; i < count; ++i) {
        const Breaking::Made& made = broken.lines[i];
        widths_.natural = std::max(widths_.natural, made.width + indentOf(made.line.from));
        lines_.push_back(made.line);
        measure(lines_.back(), made.ascent, made.descent);
    }
    widths_.least = std::max(widths_.least, broken.leastWidth);
    widths_.number = std::max(widths_.number, broken.numberWidth);
    complete_ = isLast;
    if (complete_)
        letters_.finish();
}

void Paragraph::measure(Line& line, double lettersAscent, double lettersDescent) {
    const auto [ascent, descent] = extentOf(line, lettersAscent, lettersDescent);
    // Larger letters than the block's own need their own room, but not so much between lines.
    line.height = std::max(leading_, ascent + descent > 1.25 * leading_ ? ascent + descent : 0);
    line.baseline = (line.height - ascent - descent) / 2 + ascent;
    const int index = static_cast<int>(lines_.size()) - 1;
    for (InlineObject& object : letters_.objectsIn(line.from, line.to)) {
        object.left = leftOf(index, object.position);
        makeRoom(line, object);
    }
}

} // namespace paragraphs
