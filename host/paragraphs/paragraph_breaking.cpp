#include "paragraphs/paragraph_breaking.h"

#include "paragraphs/measure.h"
#include "typography/hyphenation.h"

#include <QFontMetricsF>
#include <algorithm>
#include <iterator>

namespace paragraphs {

namespace {

constexpr QChar separator(QChar::LineSeparator);
constexpr QChar letterOfObject('x'); // in whose place an object is measured: it is no blank
constexpr double narrow = 1;         // twips; a line of one word
// Costs of places where a line ends only because nothing else fits.
constexpr int atSyllable = 1'000, withinUnit = 2'000, withinWord = 5'000;
constexpr double leastOfLast = 2.5; // times the size of the letters, of a paragraph's last line
// A line that needs more than its blanks may give moves its letters apart, by so much of their
// size, which no one sees; then the blanks give more, up to this, and then it stays short.
constexpr double mostApart = 0.025, mostStretch = 2;

// A place where a line may end.
bool isBlank(QChar letter) {
    return letter.isSpace() && letter != separator && letter.decompositionTag() != QChar::NoBreak;
}

bool isEarlier(const typography::Break& a, const typography::Break& b) { return a.next < b.next; }

} // namespace

Paragraph::Breaking::Breaking(const Paragraph& of, const Letters& letters, int from, int length,
                              bool isLast)
    : of_(of), letters_(letters), from_(from), length_(length), isLast_(isLast) {
    QString text = letters.text.mid(from, length);
    for (const InlineObject& object : objects())
        text[object.position - from] = letterOfObject;
    QTextOption option = of.optionOf();
    const bool isVerbatim = of.block()->kind == model::BlockKind::verbatim;
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

std::span<const InlineObject> Paragraph::Breaking::objects() const {
    const auto isBefore = [](const InlineObject& object, int at) { return object.position < at; };
    const auto& all = of_.letters_.objects();
    const auto first = std::lower_bound(all.begin(), all.end(), from_, isBefore);
    return {first, std::lower_bound(first, all.end(), from_ + length_, isBefore)};
}

// Line by line, each as long as it may be.
void Paragraph::Breaking::breakAsWritten() {
    const QString& text = letters_.text;
    for (QTextLine line = layout_->createLine(); line.isValid(); line = layout_->createLine()) {
        line.setLineWidth(std::max(of_.width(), fromPoints(1)));
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
const LetterRange& Paragraph::Breaking::rangeAt(int letter) {
    const auto& ranges = letters_.ranges;
    while (ranges[range_].start + ranges[range_].length <= letter)
        ++range_;
    return ranges[range_];
}

double Paragraph::Breaking::widthOfBlank(int letter) {
    const LetterRange& range = rangeAt(letter);
    const QChar sign = letters_.text[letter];
    return sign == ' ' ? range.blank : QFontMetricsF(range.format.font()).horizontalAdvance(sign);
}

// Of a blank that stretches; of several side by side the last one does.
double Paragraph::Breaking::blankAt(int letter) {
    const QString& text = letters_.text;
    if (!text[letter].isSpace() || text[letter] == separator)
        return 0;
    const LetterRange& range = rangeAt(letter);
    const bool isLastOfSeveral =
        letter + 1 == range.start + range.length || !text[letter + 1].isSpace();
    return isLastOfSeveral ? range.blank : 0;
}

std::uint32_t Paragraph::Breaking::styleAt(int letter) const {
    const auto isBehind = [](int at, const LetterRange& range) { return at < range.start; };
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
        // Qt shows a soft hyphen where it ends a line, as it ends each word here.
        if (word.to > word.from && text[from_ + word.to - 1] == softHyphen)
            x = word.left + widthOf(word.from, word.to - 1);
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
    const auto mark =
        std::lower_bound(of_.letters_.marks().begin(), of_.letters_.marks().end(), at, isBefore);
    if (mark != of_.letters_.marks().end() && mark->position == at)
        return typography::never;
    // "Figure 1", whatever a presentation calls it.
    if (letters_.text[at].isDigit()) {
        const auto& starts = letters_.runStarts;
        const auto run = std::upper_bound(starts.begin(), starts.end(), at) - starts.begin();
        if (run > 0 && of_.block()->runs[static_cast<std::size_t>(run) - 1].refers &&
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
                word.behind.hyphen = of_.materials().looks.hyphen(styleAt(word.to - 1));
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
        if (word.behind.end - left > of_.width())
            addDesperate(first, i);
        breaks_.push_back(word.behind);
        first = i + 1;
    }
}

// Ends of lines in what is wider than a line.
void Paragraph::Breaking::addDesperate(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i <= last; ++i) {
        if (words_[i].behind.end - words_[i].left > of_.width())
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
    return std::max(of_.width() - indent, fromPoints(1));
}

// With the places where words of the part may be divided. `begin`: the end of the line before it.
Paragraph::Breaking::Breaks Paragraph::Breaking::withHyphens(const Breaks& part,
                                                             const typography::Break* begin) const {
    const int from = begin ? begin->next : 0, to = part.back().next;
    const auto isBefore = [](const Word& word, int letter) { return word.from < letter; };
    auto word = std::lower_bound(words_.begin(), words_.end(), from, isBefore);
    Breaks found;
    while (word != words_.end() && word->from < to) {
        if (of_.materials().looks.style(styleAt(word->from)).hyphenate)
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
    const std::string& language = of_.materials().looks.style(look).language;
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
        one.hyphen = of_.materials().looks.hyphen(look);
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
    const schemas::Align align = of_.block()->style.align;
    const std::uint32_t style = of_.firstStyle();
    const typography::Column column{
        .firstWidth = columnAt(begin),
        .width = std::max(of_.width(), fromPoints(1)),
        .ragged = align != schemas::Align::justify,
        .even = align == schemas::Align::center,
        .leastOfLast = leastOfLast * fromPoints(of_.materials().looks.style(style).size)};
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
    const auto endsBefore = [](const LetterRange& range, int at) {
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
    const double size = fromPoints(of_.materials().looks.style(styleAt(line.from - from_)).size);
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
    const bool isJustified = of_.block()->style.align == schemas::Align::justify;
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

} // namespace paragraphs
