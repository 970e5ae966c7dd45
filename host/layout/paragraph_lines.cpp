// How a paragraph becomes lines. Qt's text layout breaks a segment at every place where Unicode's
// rules let a line end: that gives each word its width. typography chooses the ends of lines among
// these places. Each line is then laid out for itself, with the width of its blanks.
#include "layout/paragraph.h"

#include "layout/measure.h"
#include "typography/hyphenation.h"
#include "typography/lines.h"

#include <QFontMetricsF>
#include <algorithm>
#include <iterator>

namespace layout {

namespace {

constexpr QChar separator(QChar::LineSeparator), softHyphen(QChar::SoftHyphen), hyphenSign('-');
constexpr QChar letterOfObject('x'); // in whose place an object is measured: it is no blank
constexpr double narrow = 1;         // twips; a line of one word
// Costs of places where a line ends only because nothing else fits.
constexpr int atSyllable = 1'000, withinUnit = 2'000, withinWord = 5'000;
constexpr double leastOfLast = 2.5; // times the size of the letters, of a paragraph's last line
// A line that needs more than its blanks may give moves its letters apart, by so much of their
// size, which no one sees; then the blanks give more, up to this, and then it stays short.
constexpr double mostApart = 0.025, mostStretch = 2;

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

// Where a line may end.
bool isBlank(QChar letter) {
    return letter.isSpace() && letter != separator && letter.decompositionTag() != QChar::NoBreak;
}

bool isEarlier(const typography::Break& a, const typography::Break& b) { return a.next < b.next; }

} // namespace

// --- letters as Qt lays them out ---------------------------------------------------------------

QTextOption Paragraph::optionOf() const {
    QTextOption option(alignmentOf(block_->style.align, isRightToLeft()));
    option.setUseDesignMetrics(true);
    option.setTextDirection(direction_);
    return option;
}

std::unique_ptr<QTextLayout> Paragraph::layoutFor(const QString& text,
                                                  const QList<QTextLayout::FormatRange>& formats,
                                                  const QTextOption& option) const {
    const auto& runs = block_->runs;
    const std::uint32_t style = runs.empty() ? block_->textStyle : runs.front().style;
    auto layout = std::make_unique<QTextLayout>(text, materials_->looks.font(style));
    layout->setTextOption(option);
    layout->setCacheEnabled(true);
    layout->setFormats(formats);
    return layout;
}

QList<QTextLayout::FormatRange> Paragraph::formatsOf(const Letters& letters, int from, int to,
                                                     double stretch, double apart) {
    const auto endsBefore = [](const Range& range, int at) {
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

// What stands around a line so that its letters go as they do in the paragraph: the embeddings that
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
    const Letters& letters = read(line.to + 1);
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
    only.setLineWidth(std::max(width_ - indent, fromPoints(1)));
    only.setPosition({indent, 0});
    layout->endLayout();
    return layout;
}

double Paragraph::indentOf(int from) const {
    const bool isFirst = from == 0 && block_->kind != model::BlockKind::verbatim &&
                         block_->kind != model::BlockKind::formula;
    return isFirst ? fromPoints(block_->style.firstLine) : 0;
}

// --- a segment's lines -------------------------------------------------------------------------

class Paragraph::Breaking {
public:
    // `isLast`: no text goes on behind it.
    Breaking(const Paragraph& of, const Letters& letters, int from, int length, bool isLast)
        : of_(of), letters_(letters), from_(from), length_(length), isLast_(isLast) {
        QString text = letters.text.mid(from, length);
        for (const InlineObject& object : objects())
            text[object.position - from] = letterOfObject;
        QTextOption option = of.optionOf();
        const bool isVerbatim = of.block_->kind == model::BlockKind::verbatim;
        option.setWrapMode(isVerbatim ? QTextOption::WrapAtWordBoundaryOrAnywhere
                                      : QTextOption::WordWrap);
        layout_ = of.layoutFor(text, formatsOf(letters, from, from + length), option);
        layout_->beginLayout();
        if (isVerbatim)
            breakAsWritten();
        else
            breakWell();
        layout_->endLayout();
    }

    struct Made {
        Line line;
        double width = 0; // as wide as it is
        double ascent = 0, descent = 0;
    };
    std::vector<Made> lines;
    double leastWidth = 0, numberWidth = 0;

private:
    struct Word {                       // with what Unicode's rules do not break off
        int from = 0, to = 0, next = 0; // blanks follow `to`; in the segment
        typography::Break behind;       // where it ends, and what follows begins
        double left = 0;
        double ascent = 0, descent = 0;
    };
    using Words = std::vector<Word>;
    using Breaks = std::vector<typography::Break>;

    [[nodiscard]] std::span<const InlineObject> objects() const;
    void breakAsWritten();
    void breakWell();
    void measureWords();
    [[nodiscard]] int costBehind(const Word& word) const;
    void findBreaks();
    void addDesperate(std::size_t first, std::size_t last);
    void tear(std::size_t word);
    [[nodiscard]] const Range& rangeAt(int letter);
    [[nodiscard]] double blankAt(int letter);
    [[nodiscard]] double widthOfBlank(int letter);
    [[nodiscard]] std::uint32_t styleAt(int letter) const; // of the segment
    [[nodiscard]] double columnAt(const typography::Break* begin) const;
    [[nodiscard]] Breaks withHyphens(const Breaks& part, const typography::Break* begin) const;
    [[nodiscard]] double widthOf(int from, int to) const;
    [[nodiscard]] Words::const_iterator endOfUnit(Words::const_iterator word) const;
    void divide(Words::const_iterator word, int cost, Breaks& found) const;
    [[nodiscard]] std::optional<std::vector<std::size_t>>
    chosen(Breaks part, const typography::Break* begin, double most) const;
    void breakPart(std::size_t first, std::size_t last, const typography::Break* begin);
    void addLine(const typography::Break* begin, const typography::Break& end);
    [[nodiscard]] double stretched(Line& line, double stretch, double blanks) const;
    [[nodiscard]] int lettersOf(const Line& line) const;

    const Paragraph& of_;
    const Letters& letters_;
    const int from_, length_;
    const bool isLast_;
    std::unique_ptr<QTextLayout> layout_;
    Words words_;
    Breaks breaks_;
    std::size_t range_ = 0; // of the letters looked at last
    std::size_t wordOfLine_ = 0;
};

std::span<const InlineObject> Paragraph::Breaking::objects() const {
    const auto isBefore = [](const InlineObject& object, int at) { return object.position < at; };
    const auto& all = of_.objects_;
    const auto first = std::lower_bound(all.begin(), all.end(), from_, isBefore);
    return {first, std::lower_bound(first, all.end(), from_ + length_, isBefore)};
}

// Line by line, each as long as it may be.
void Paragraph::Breaking::breakAsWritten() {
    const QString& text = letters_.text;
    for (QTextLine line = layout_->createLine(); line.isValid(); line = layout_->createLine()) {
        line.setLineWidth(std::max(of_.width_, fromPoints(1)));
        Made& made = lines.emplace_back();
        made.line.from = from_ + line.textStart();
        made.line.to = made.line.end = made.line.from + line.textLength();
        const bool isEnd = made.line.to == from_ + length_ && isLast_;
        if (!isEnd && line.textLength() > 0 && text[made.line.end - 1] == separator)
            --made.line.end;
        else
            while (!isEnd && made.line.end > made.line.from + 1 && isBlank(text[made.line.end - 1]))
                --made.line.end;
        made.width = line.naturalTextWidth();
        made.ascent = line.ascent();
        made.descent = line.descent();
    }
    leastWidth = layout_->minimumWidth();
}

void Paragraph::Breaking::breakWell() {
    measureWords();
    findBreaks();
    const typography::Break* begin = nullptr;
    std::size_t first = 0;
    for (std::size_t i = 0; i < breaks_.size(); ++i)
        if (breaks_[i].forced || i + 1 == breaks_.size()) {
            breakPart(first, i, begin);
            begin = &breaks_[i];
            first = i + 1;
        }
}

// Asked for one letter after the other.
const Paragraph::Range& Paragraph::Breaking::rangeAt(int letter) {
    const auto& ranges = letters_.ranges;
    while (ranges[range_].start + ranges[range_].length <= letter)
        ++range_;
    return ranges[range_];
}

double Paragraph::Breaking::widthOfBlank(int letter) {
    const Range& range = rangeAt(letter);
    const QChar sign = letters_.text[letter];
    return sign == ' ' ? range.blank : QFontMetricsF(range.format.font()).horizontalAdvance(sign);
}

// Of a blank that stretches; of several side by side the last one does.
double Paragraph::Breaking::blankAt(int letter) {
    const QString& text = letters_.text;
    if (!text[letter].isSpace() || text[letter] == separator)
        return 0;
    const Range& range = rangeAt(letter);
    const bool isLastOfSeveral =
        letter + 1 == range.start + range.length || !text[letter + 1].isSpace();
    return isLastOfSeveral ? range.blank : 0;
}

std::uint32_t Paragraph::Breaking::styleAt(int letter) const {
    const auto isBehind = [](int at, const Range& range) { return at < range.start; };
    const auto& ranges = letters_.ranges;
    const auto behind = std::upper_bound(ranges.begin(), ranges.end(), from_ + letter, isBehind);
    return behind == ranges.begin() ? 0 : std::prev(behind)->style;
}

void Paragraph::Breaking::measureWords() {
    const QString& text = letters_.text;
    const auto& ranges = letters_.ranges;
    while (range_ < ranges.size() && ranges[range_].start + ranges[range_].length <= from_)
        ++range_;
    double x = 0, blanks = 0;
    for (QTextLine line = layout_->createLine(); line.isValid(); line = layout_->createLine()) {
        line.setLineWidth(narrow);
        Word& word = words_.emplace_back();
        word.from = line.textStart();
        word.to = word.next = word.from + line.textLength();
        word.behind.forced = word.to > word.from && text[from_ + word.to - 1] == separator;
        word.to -= word.behind.forced ? 1 : 0;
        const int shown = word.to;
        while (word.to > word.from && isBlank(text[from_ + word.to - 1]))
            --word.to;
        word.ascent = line.ascent();
        word.descent = line.descent();
        word.left = x;
        for (int i = word.from; i < word.to; ++i)
            blanks += blankAt(from_ + i);
        x += line.horizontalAdvance();
        word.behind.end = x;
        word.behind.blanksAtEnd = blanks;
        for (int i = word.to; i < shown; ++i) { // Qt does not say how wide they are
            blanks += blankAt(from_ + i);
            x += widthOfBlank(from_ + i);
        }
        word.behind.begin = x;
        word.behind.blanksAtBegin = blanks;
        word.behind.next = word.next;
    }
}

int Paragraph::Breaking::costBehind(const Word& word) const {
    const int at = from_ + word.next;
    const auto isBefore = [](const NoteMark& mark, int letter) { return mark.position < letter; };
    const auto mark = std::lower_bound(of_.marks_.begin(), of_.marks_.end(), at, isBefore);
    if (mark != of_.marks_.end() && mark->position == at)
        return typography::never;
    // "Figure 1", whatever a presentation calls it.
    if (letters_.text[at].isDigit()) {
        const auto& starts = letters_.runStarts;
        const auto run = std::upper_bound(starts.begin(), starts.end(), at) - starts.begin();
        if (run > 0 && of_.block_->runs[static_cast<std::size_t>(run) - 1].refers &&
            starts[static_cast<std::size_t>(run) - 1] < at)
            return typography::never;
    }
    return typography::costOfBreak(letters_.text, at);
}

// Words between which no line ends are one.
void Paragraph::Breaking::findBreaks() {
    std::size_t first = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) {
        Word& word = words_[i];
        const bool isEnd = i + 1 == words_.size();
        if (!isEnd && !word.behind.forced) {
            word.behind.cost = costBehind(word);
            if (word.to > word.from && letters_.text[from_ + word.to - 1] == softHyphen)
                word.behind.hyphen = of_.materials_->looks.hyphen(styleAt(word.to - 1));
            if (word.behind.cost >= typography::never)
                continue;
        }
        const double left = words_[first].left;
        leastWidth = std::max(leastWidth, word.behind.end - left);
        const QStringView letters =
            QStringView(letters_.text)
                .sliced(from_ + words_[first].from, word.to - words_[first].from);
        if (std::ranges::any_of(letters, [](QChar letter) { return letter.isDigit(); }))
            numberWidth = std::max(numberWidth, word.behind.end - left);
        if (word.behind.end - left > of_.width_)
            addDesperate(first, i);
        breaks_.push_back(word.behind);
        first = i + 1;
    }
}

// Ends of lines in what is wider than a line.
void Paragraph::Breaking::addDesperate(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i <= last; ++i) {
        if (words_[i].behind.end - words_[i].left > of_.width_)
            tear(i);
        if (i < last) {
            breaks_.push_back(words_[i].behind);
            breaks_.back().cost = withinUnit;
        }
    }
}

// At its syllables, and between any two letters.
void Paragraph::Breaking::tear(std::size_t index) {
    const Word& word = words_[index];
    typography::Break place = word.behind;
    place.forced = false;
    place.cost = withinWord;
    place.blanksAtEnd = place.blanksAtBegin =
        index == 0 ? 0 : words_[index - 1].behind.blanksAtBegin; // LIMIT: of those in it none
    place.hyphen = 0;
    QTextOption option = layout_->textOption();
    option.setWrapMode(QTextOption::WrapAnywhere);
    const auto letters =
        of_.layoutFor(layout_->text().mid(word.from, word.to - word.from),
                      formatsOf(letters_, from_ + word.from, from_ + word.to), option);
    Breaks torn, syllables;
    if (index == 0 || words_[index - 1].to < words_[index - 1].next) // not within an address
        divide(words_.begin() + static_cast<std::ptrdiff_t>(index), atSyllable, syllables);
    letters->beginLayout();
    double x = word.left;
    for (QTextLine line = letters->createLine(); line.isValid(); line = letters->createLine()) {
        line.setLineWidth(narrow);
        x += line.horizontalAdvance();
        place.next = word.from + line.textStart() + line.textLength();
        place.end = place.begin = x;
        if (place.next < word.to)
            torn.push_back(place);
    }
    letters->endLayout();
    std::merge(torn.begin(), torn.end(), syllables.begin(), syllables.end(),
               std::back_inserter(breaks_), isEarlier);
}

double Paragraph::Breaking::columnAt(const typography::Break* begin) const {
    const double indent = begin ? 0 : of_.indentOf(from_);
    return std::max(of_.width_ - indent, fromPoints(1));
}

// With the places where words of the part may be divided. `begin`: the end of the line before it.
Paragraph::Breaking::Breaks Paragraph::Breaking::withHyphens(const Breaks& part,
                                                             const typography::Break* begin) const {
    const int from = begin ? begin->next : 0, to = part.back().next;
    const auto isBefore = [](const Word& word, int letter) { return word.from < letter; };
    auto word = std::lower_bound(words_.begin(), words_.end(), from, isBefore);
    Breaks found;
    while (word != words_.end() && word->from < to) {
        if (of_.materials_->looks.style(styleAt(word->from)).hyphenate)
            divide(word, typography::atHyphen, found);
        word = endOfUnit(word);
    }
    Breaks result;
    result.reserve(part.size() + found.size());
    std::merge(part.begin(), part.end(), found.begin(), found.end(), std::back_inserter(result),
               isEarlier);
    return result;
}

// Of letters without a blank.
double Paragraph::Breaking::widthOf(int from, int to) const {
    QTextOption option = layout_->textOption();
    option.setWrapMode(QTextOption::ManualWrap);
    const auto letters = of_.layoutFor(layout_->text().mid(from, to - from),
                                       formatsOf(letters_, from_ + from, from_ + to), option);
    letters->beginLayout();
    QTextLine line = letters->createLine();
    line.setLineWidth(narrow);
    letters->endLayout();
    return line.horizontalAdvance();
}

// Behind the words up to the next blank.
Paragraph::Breaking::Words::const_iterator
Paragraph::Breaking::endOfUnit(Words::const_iterator word) const {
    while (word->to == word->next && !word->behind.forced && word + 1 != words_.end())
        ++word;
    return word + 1;
}

// The places within a word, and those behind it up to the next blank.
void Paragraph::Breaking::divide(Words::const_iterator word, int cost, Breaks& found) const {
    const std::uint32_t look = styleAt(word->from);
    const std::string& language = of_.materials_->looks.style(look).language;
    if (language.empty())
        return;
    const int from = word->from, to = std::prev(endOfUnit(word))->to;
    const QStringView letters = QStringView(letters_.text).sliced(from_ + from, to - from);
    for (int place : typography::placesInWords(letters, QString::fromStdString(language))) {
        place += from;
        while (word->next <= place)
            ++word;
        typography::Break& one = found.emplace_back();
        one.next = place;
        one.begin = one.end = word->left + widthOf(word->from, place);
        one.blanksAtBegin = one.blanksAtEnd =
            word == words_.begin() ? 0 : std::prev(word)->behind.blanksAtBegin;
        one.hyphen = of_.materials_->looks.hyphen(look);
        one.cost = cost;
    }
}

std::optional<std::vector<std::size_t>>
Paragraph::Breaking::chosen(Breaks part, const typography::Break* begin, double most) const {
    const bool goesOn = !part.back().forced && !isLast_;
    if (begin)
        for (typography::Break& one : part) {
            one.end -= begin->begin;
            one.begin -= begin->begin;
            one.blanksAtEnd -= begin->blanksAtBegin;
            one.blanksAtBegin -= begin->blanksAtBegin;
        }
    const schemas::Align align = of_.block_->style.align;
    const std::uint32_t style =
        of_.block_->runs.empty() ? of_.block_->textStyle : of_.block_->runs.front().style;
    const typography::Column column{
        .firstWidth = columnAt(begin),
        .width = std::max(of_.width_, fromPoints(1)),
        .ragged = align != schemas::Align::justify,
        .even = align == schemas::Align::center,
        .leastOfLast = leastOfLast * fromPoints(of_.materials_->looks.style(style).size)};
    return typography::bestLines(part, column, most, goesOn);
}

// The breaks first..last, of which the last one is forced or the segment's end.
void Paragraph::Breaking::breakPart(std::size_t first, std::size_t last,
                                    const typography::Break* begin) {
    const typography::Break& end = breaks_[last];
    if (end.end - (begin ? begin->begin : 0) <= columnAt(begin))
        return addLine(begin, end);
    Breaks part(breaks_.begin() + static_cast<std::ptrdiff_t>(first),
                breaks_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    auto ends = chosen(part, begin, typography::fine);
    if (!ends) {
        part = withHyphens(part, begin);
        ends = chosen(part, begin, typography::fine);
    }
    if (!ends)
        ends = chosen(part, begin, typography::anything);
    for (const std::size_t at : *ends) {
        addLine(begin, part[at]);
        begin = &part[at];
    }
}

// That may move apart.
int Paragraph::Breaking::lettersOf(const Line& line) const {
    const auto endsBefore = [](const Range& range, int at) {
        return range.start + range.length <= at;
    };
    const auto& ranges = letters_.ranges;
    int count = 0;
    for (auto range = std::lower_bound(ranges.begin(), ranges.end(), line.from, endsBefore);
         range != ranges.end() && range->start < line.end; ++range)
        for (int i = std::max(range->start, line.from);
             range->blank > 0 && !range->isGap &&
             i < std::min(range->start + range->length, line.end);
             ++i)
            count += letters_.text[i].isMark() || letters_.text[i].isLowSurrogate() ? 0 : 1;
    return count;
}

// The width that it gains.
double Paragraph::Breaking::stretched(Line& line, double stretch, double blanks) const {
    line.stretch = std::min(stretch, typography::stretchOfBlank);
    if (stretch <= line.stretch)
        return line.stretch * blanks;
    const double missing = (stretch - line.stretch) * blanks;
    const double size = fromPoints(of_.materials_->looks.style(styleAt(line.from - from_)).size);
    const int letters = lettersOf(line);
    line.apart = letters == 0 ? 0 : std::min(missing / letters, mostApart * size);
    line.stretch = std::min(mostStretch, stretch - line.apart * letters / blanks);
    return line.stretch * blanks + line.apart * letters;
}

void Paragraph::Breaking::addLine(const typography::Break* begin, const typography::Break& end) {
    Made& made = lines.emplace_back();
    Line& line = made.line;
    const int from = begin ? begin->next : 0;
    line.from = from_ + from;
    line.to = line.end = from_ + end.next;
    const bool isEnd = end.next == length_ && isLast_;
    if (!isEnd) {
        if (end.forced)
            --line.end;
        while (line.end > line.from && isBlank(letters_.text[line.end - 1]))
            --line.end;
    }
    line.hyphen = end.hyphen > 0;
    made.width = end.end - (begin ? begin->begin : 0) + end.hyphen;
    const double blanks = end.blanksAtEnd - (begin ? begin->blanksAtBegin : 0);
    const bool isJustified = of_.block_->style.align == schemas::Align::justify;
    if (isJustified) {
        const double stretch = typography::stretchOf(made.width, blanks, columnAt(begin));
        if (stretch < 0 || (!isEnd && !end.forced))
            made.width += stretched(line, stretch, blanks);
    }
    while (wordOfLine_ < words_.size() && words_[wordOfLine_].next <= from)
        ++wordOfLine_;
    for (std::size_t i = wordOfLine_; i < words_.size() && words_[i].from < end.next; ++i) {
        made.ascent = std::max(made.ascent, words_[i].ascent);
        made.descent = std::max(made.descent, words_[i].descent);
    }
}

// --- lines -------------------------------------------------------------------------------------

bool Paragraph::makeLine(std::size_t line) {
    while (lines_.size() <= line && !complete_)
        breakSegment();
    return line < lines_.size();
}

int Paragraph::lengthOfSegment(const Letters& letters) const {
    const auto endsBefore = [](const Range& range, int at) {
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
    const Letters& letters = read(next_ + segmentLength + 1);
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
        naturalWidth_ = std::max(naturalWidth_, made.width + indentOf(made.line.from));
        lines_.push_back(made.line);
        measure(lines_.back(), made.ascent, made.descent);
    }
    leastWidth_ = std::max(leastWidth_, broken.leastWidth);
    numberWidth_ = std::max(numberWidth_, broken.numberWidth);
    complete_ = isLast;
    if (complete_)
        letters_.reset(); // most are asked for no more
}

void Paragraph::measure(Line& line, double lettersAscent, double lettersDescent) {
    const auto [ascent, descent] = extentOf(line, lettersAscent, lettersDescent);
    // Larger letters than the block's own need their own room, but not so much between lines.
    line.height = std::max(leading_, ascent + descent > 1.25 * leading_ ? ascent + descent : 0);
    line.baseline = (line.height - ascent - descent) / 2 + ascent;
    const auto isBefore = [](const InlineObject& object, int at) { return object.position < at; };
    const int index = static_cast<int>(lines_.size()) - 1;
    for (auto object = std::lower_bound(objects_.begin(), objects_.end(), line.from, isBefore);
         object != objects_.end() && object->position < line.to; ++object) {
        object->left = leftOf(index, object->position);
        if (object->formula) {
            makeRoom(line, *object);
            continue;
        }
        const double grow = object->size.height() + leading_ - line.height;
        if (grow > 0) {
            line.height += grow;
            line.baseline += grow;
        }
    }
}

} // namespace layout
