#include "layout/paragraph.h"

#include "layout/measure.h"
#include "layout/typeface.h"

#include <QPainter>
#include <algorithm>

namespace layout {

namespace {

constexpr double unbroken = 4e6; // twips; a width that nothing reaches
constexpr QChar blank(0x00A0);

Qt::Alignment alignmentOf(schemas::Align align) {
    switch (align) {
    case schemas::Align::center:
        return Qt::AlignHCenter;
    case schemas::Align::right:
        return Qt::AlignRight;
    case schemas::Align::justify:
        return Qt::AlignJustify;
    case schemas::Align::left:
        break;
    }
    return Qt::AlignLeft;
}

} // namespace

// --- what is kept ------------------------------------------------------------------------------

// Of all paragraphs, what was asked for last in front. LIMIT: one thread lays out and paints.
class Paragraph::Kept {
public:
    // Never destroyed: paragraphs may live as long as the program.
    static Kept& all() {
        static Kept& kept = *new Kept;
        return kept;
    }
    KeptPlace add(const Paragraph& of, int segment, int letters) {
        items_.push_front({&of, segment, static_cast<std::size_t>(letters)});
        letters_ += items_.front().letters;
        while (letters_ > mostKept && items_.size() > 1) {
            const KeptItem last = items_.back();
            last.of->forget(last.segment); // removes it
        }
        return items_.begin();
    }
    void use(KeptPlace item, int letters) {
        items_.splice(items_.begin(), items_, item);
        letters_ -= std::exchange(item->letters, static_cast<std::size_t>(letters));
        letters_ += item->letters;
    }
    void remove(KeptPlace item) {
        letters_ -= item->letters;
        items_.erase(item);
    }
    [[nodiscard]] std::size_t letters() const { return letters_; }
    std::size_t layoutsMade = 0;

private:
    std::list<KeptItem> items_;
    std::size_t letters_ = 0;
};

std::size_t Paragraph::lettersKept() { return Kept::all().letters(); }
std::size_t Paragraph::layoutsMade() { return Kept::all().layoutsMade; }

void Paragraph::forget(int segment) const {
    if (segment == ofLetters) {
        Kept::all().remove(*letters_->kept);
        letters_.reset();
        return;
    }
    Segment& of = segments_[static_cast<std::size_t>(segment)];
    Kept::all().remove(of.kept);
    of.layout.reset();
}

Paragraph::Paragraph(std::shared_ptr<Materials> materials, BlockPointer block, double width,
                     bool markerInFront)
    : materials_(std::move(materials)), block_(std::move(block)), width_(width),
      markerInFront_(markerInFront) {
    const std::uint32_t style = block_->runs.empty() ? block_->textStyle : block_->runs[0].style;
    leading_ = fromPoints(materials_->looks.style(style).size) * block_->style.lineHeight;
}

Paragraph::~Paragraph() {
    if (letters_ && letters_->kept)
        forget(ofLetters);
    for (std::size_t i = 0; i < segments_.size(); ++i)
        if (segments_[i].layout)
            forget(static_cast<int>(i));
}

// --- letters -----------------------------------------------------------------------------------

// As far as that letter, and so many runs.
const Paragraph::Letters& Paragraph::read(int to, std::size_t runs) const {
    if (!letters_) {
        letters_ = std::make_unique<Letters>();
        if (markerInFront_) {
            letters_->text = QString::fromStdString(block_->marker) + QChar(' ');
            letters_->formats.append({0, static_cast<int>(letters_->text.size()),
                                      materials_->looks.format(block_->markerStyle)});
        }
    }
    runs = std::min(runs, block_->runs.size());
    while (letters_->runStarts.size() < runs ||
           (letters_->text.size() < to && letters_->runStarts.size() < block_->runs.size()))
        append(letters_->runStarts.size());
    const auto length = static_cast<int>(letters_->text.size());
    if (letters_->kept)
        Kept::all().use(*letters_->kept, length);
    else if (complete_) // until then they are needed for the next line
        letters_->kept = Kept::all().add(*this, ofLetters, length);
    return *letters_;
}

// What is read again has the size that its lines were made for.
QSizeF Paragraph::sizeOfObject(std::size_t run, int position) const {
    if (run >= runsRead_) {
        const QSizeF size = materials_->sizes.subdocument(block_->runs[run].subdocument);
        objects_.push_back({run, position, size, 0});
        return size;
    }
    const auto isBefore = [](const InlineObject& object, int at) { return object.position < at; };
    return std::lower_bound(objects_.begin(), objects_.end(), position, isBefore)->size;
}

void Paragraph::append(std::size_t index) const {
    const model::Run& run = block_->runs[index];
    if (run.formula && formulas::Font::standard())
        return appendFormula(index);
    QString& text = letters_->text;
    const int start = static_cast<int>(text.size());
    letters_->runStarts.push_back(start);
    QTextCharFormat own = materials_->looks.format(run.style);
    const bool isObject = run.kind == model::RunKind::subdocument;
    if (isObject) {
        text += blank;
        QFont font = own.font();
        font.setPixelSize(1);
        font.setLetterSpacing(QFont::AbsoluteSpacing, sizeOfObject(index, start).width());
        own.setFont(font);
    } else if (run.kind == model::RunKind::lineBreak) {
        text += QChar(QChar::LineSeparator);
    } else {
        text += QString::fromStdString(run.text).replace(QLatin1Char('\n'),
                                                         QChar(QChar::LineSeparator));
    }
    if (run.kind == model::RunKind::footnote && index >= runsRead_ && run.footnote)
        marks_.push_back({start, run.footnote});
    runsRead_ = std::max(runsRead_, index + 1);
    const int length = static_cast<int>(text.size()) - start;
    if (!isObject && letters_->lastStyle == run.style)
        letters_->formats.back().length += length;
    else
        letters_->formats.append({start, length, own});
    letters_->lastStyle = isObject ? std::nullopt : std::optional(run.style);
}

bool Paragraph::isOf(Sizes& sizes) const {
    return std::ranges::all_of(objects_, [&](const InlineObject& object) {
        return object.formula ||
               sizes.subdocument(block_->runs[object.run].subdocument) == object.size;
    });
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

int Paragraph::lengthOfSegment(const Letters& letters) const {
    const auto& formats = letters.formats;
    const auto all = static_cast<int>(letters.text.size());
    int end = std::min(next_ + segmentLength, all);
    const auto first = std::lower_bound(formats.begin(), formats.end(), next_, endsBefore);
    if (formats.end() - first > segmentFormats)
        end = std::min(end, (first + segmentFormats)->start);
    if (end < all && end > next_ + 1 && letters.text[end].isLowSurrogate())
        --end;
    return end - next_;
}

double Paragraph::indentOf(int from) const {
    const bool isFirst = from == 0 && block_->kind != model::BlockKind::verbatim &&
                         block_->kind != model::BlockKind::formula;
    return isFirst ? fromPoints(block_->style.firstLine) : 0;
}

// The same each time that it is called.
std::unique_ptr<QTextLayout> Paragraph::shaped(int from, int length) const {
    const Letters& letters = read(from + length);
    const auto& runs = block_->runs;
    const std::uint32_t style = runs.empty() ? block_->textStyle : runs.front().style;
    QTextOption option(alignmentOf(block_->style.align));
    option.setUseDesignMetrics(true);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    option.setTextDirection(direction_);
    auto layout = std::make_unique<QTextLayout>(letters.text.mid(from, length),
                                                materials_->looks.font(style));
    ++Kept::all().layoutsMade;
    layout->setTextOption(option);
    layout->setCacheEnabled(true);
    layout->setFormats(formatsOf(letters, from, from + length));
    layout->beginLayout();
    for (QTextLine line = layout->createLine(); line.isValid(); line = layout->createLine()) {
        const double indent = indentOf(from + line.textStart());
        line.setLineWidth(std::max(width_ - indent, fromPoints(1)));
        line.setPosition({indent, 0});
    }
    layout->endLayout();
    return layout;
}

void Paragraph::breakSegment() {
    const Letters& letters = read(next_ + segmentLength + 1);
    const int from = next_, length = lengthOfSegment(letters);
    const bool isLast = from + length == letters.text.size();
    if (segments_.empty() && !isLast)
        direction_ = letters.text.isRightToLeft() ? Qt::RightToLeft : Qt::LeftToRight;
    std::unique_ptr<QTextLayout> layout = shaped(from, length);
    lettersShaped_ += static_cast<std::size_t>(length);
    int count = layout->lineCount();
    next_ = from + length;
    if (!isLast && count > 1) // the text goes on in the last line: it is made anew
        next_ = from + layout->lineAt(--count).textStart();
    for (int i = 0; i < count; ++i) {
        const QTextLine line = layout->lineAt(i);
        naturalWidth_ =
            std::max(naturalWidth_, line.naturalTextWidth() + indentOf(from + line.textStart()));
        Line& made = lines_.emplace_back();
        made.from = from + line.textStart();
        made.to = made.from + line.textLength();
        made.segment = static_cast<int>(segments_.size());
        made.index = i;
        measure(made, line);
    }
    leastWidth_ = std::max(leastWidth_, layout->minimumWidth());
    complete_ = isLast;
    segments_.push_back({from, length});
    segments_.back().layout = std::move(layout);
    segments_.back().kept = Kept::all().add(*this, static_cast<int>(segments_.size()) - 1, length);
    if (complete_)
        letters_.reset(); // most are asked for no more
}

QList<QTextLayout::FormatRange> Paragraph::formatsOf(const Letters& letters, int from, int to) {
    QList<QTextLayout::FormatRange> result;
    for (auto at =
             std::lower_bound(letters.formats.begin(), letters.formats.end(), from, endsBefore);
         at != letters.formats.end() && at->start < to; ++at) {
        QTextLayout::FormatRange part = *at;
        part.start = std::max(at->start, from) - from;
        part.length = std::min(at->start + at->length, to) - from - part.start;
        result.append(part);
    }
    return result;
}

void Paragraph::measure(Line& line, const QTextLine& of) {
    const auto [ascent, descent] = extentOf(line, of);
    // Larger letters than the block's own need their own room, but not so much between lines.
    line.height = std::max(leading_, ascent + descent > 1.25 * leading_ ? ascent + descent : 0);
    line.baseline = (line.height - ascent - descent) / 2 + ascent;
    const auto isBefore = [](const InlineObject& object, int at) { return object.position < at; };
    for (auto object = std::lower_bound(objects_.begin(), objects_.end(), line.from, isBefore);
         object != objects_.end() && object->position < line.to; ++object) {
        object->left = of.cursorToX(object->position - line.from + of.textStart());
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

// --- what stands on them -----------------------------------------------------------------------

namespace {

template <class Thing>
std::span<const Thing> within(const std::vector<Thing>& all, int from, int to) {
    const auto isBefore = [](const Thing& thing, int at) { return thing.position < at; };
    const auto first = std::lower_bound(all.begin(), all.end(), from, isBefore);
    return {first, std::lower_bound(first, all.end(), to, isBefore)};
}

} // namespace

std::span<const InlineObject> Paragraph::objectsOf(int line) const {
    const auto [from, to] = rangeOfLine(line);
    return within(objects_, from, to);
}

std::span<const NoteMark> Paragraph::notesOf(int line) const {
    const auto [from, to] = rangeOfLine(line);
    return within(marks_, from, to);
}

const QTextLayout& Paragraph::layoutOf(int segment) const {
    Segment& of = segments_[static_cast<std::size_t>(segment)];
    if (of.layout) {
        Kept::all().use(of.kept, of.length);
    } else {
        of.layout = shaped(of.from, of.length);
        of.kept = Kept::all().add(*this, segment, of.length);
    }
    return *of.layout;
}

QTextLine Paragraph::drawn(int line) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    return layoutOf(of.segment).lineAt(of.index);
}

void Paragraph::paintLine(QPainter& painter, int line, QPointF topLeft) const {
    const QTextLine of = drawn(line);
    // A line knows its own x (indent and alignment); its y is the page's.
    const double top = topLeft.y() + lines_[static_cast<std::size_t>(line)].baseline - of.ascent() -
                       of.position().y();
    of.draw(&painter, {topLeft.x(), top});
    paintFormulas(painter, line, topLeft);
}

QRectF Paragraph::objectRect(int line, const InlineObject& object) const {
    const double baseline = lines_[static_cast<std::size_t>(line)].baseline;
    const double top = baseline + object.depth - object.size.height();
    return {QPointF(object.left, top), object.size};
}

const model::Run* Paragraph::runAt(int line, double x) const {
    const QTextLine found = drawn(line);
    if (x < found.naturalTextRect().left() || x > found.naturalTextRect().right())
        return nullptr;
    const Segment& segment =
        segments_[static_cast<std::size_t>(lines_[static_cast<std::size_t>(line)].segment)];
    const int position = segment.from + found.xToCursor(x, QTextLine::CursorOnCharacter);
    const std::vector<int>& starts = read(position + 1).runStarts;
    const auto behind = std::upper_bound(starts.begin(), starts.end(), position);
    return behind == starts.begin() ? nullptr : &block_->runs[behind - starts.begin() - 1];
}

QString Paragraph::text(int from, int count) const {
    return read(from + count).text.mid(from, count);
}

QString Paragraph::textOfLine(int line) const {
    const auto [from, to] = rangeOfLine(line);
    return text(from, to - from);
}

std::pair<int, int> Paragraph::rangeOfLine(int line) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    return {of.from, of.to};
}

double Paragraph::leftOf(int line, int position) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    return drawn(line).cursorToX(position - segments_[static_cast<std::size_t>(of.segment)].from);
}

Widths widthsOf(const std::shared_ptr<Materials>& materials, const model::Block& block,
                std::size_t& letters) {
    auto left = std::make_shared<model::Block>();
    left->kind = block.kind;
    left->style = block.style;
    left->style.align = schemas::Align::left;
    left->textStyle = block.textStyle;
    left->runs = block.runs;
    Paragraph whole(materials, left, unbroken);
    for (std::size_t line = 0; whole.lettersShaped() < letters && whole.makeLine(line);)
        line = whole.lines().size();
    letters -= std::min(letters, std::max<std::size_t>(whole.lettersShaped(), 1));
    return {whole.naturalWidth(), std::min(whole.leastWidth(), whole.naturalWidth())};
}

} // namespace layout
