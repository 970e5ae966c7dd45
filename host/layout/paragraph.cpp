#include "layout/paragraph.h"

#include "layout/measure.h"
#include "layout/typeface.h"

#include <QPainter>
#include <algorithm>

namespace layout {

namespace {

constexpr double unbroken = 4e6; // twips; a width that nothing reaches
constexpr QChar blank(0x00A0);

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
    KeptPlace add(const Paragraph& of, int line, int letters) {
        items_.push_front({&of, line, static_cast<std::size_t>(letters)});
        letters_ += items_.front().letters;
        while (letters_ > mostKept && items_.size() > 1) {
            const KeptItem last = items_.back();
            last.of->forget(last.line); // removes it
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

void Paragraph::forget(int line) const {
    if (line == ofLetters) {
        Kept::all().remove(*letters_->kept);
        letters_.reset();
        return;
    }
    Kept::all().remove(drawn_.at(line).kept);
    drawn_.erase(line);
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
    for (const auto& [line, drawn] : drawn_)
        Kept::all().remove(drawn.kept);
}

// --- letters -----------------------------------------------------------------------------------

// As far as that letter, and so many runs.
const Paragraph::Letters& Paragraph::read(int to, std::size_t runs) const {
    if (!letters_) {
        letters_ = std::make_unique<Letters>();
        if (markerInFront_) {
            letters_->text = QString::fromStdString(block_->marker) + QChar(' ');
            letters_->ranges.push_back({.start = 0,
                                        .length = static_cast<int>(letters_->text.size()),
                                        .format = materials_->looks.format(block_->markerStyle),
                                        .style = block_->markerStyle,
                                        .blank = materials_->looks.blank(block_->markerStyle)});
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

// An image is no wider than a line.
QSizeF Paragraph::sizeNow(const model::Run& run) const {
    Sizes& sizes = materials_->sizes;
    if (!run.picture)
        return sizes.subdocument(run.subdocument);
    const double most = width_ - std::max(0.0, fromPoints(block_->style.firstLine));
    return fitted(sizes.picture(*run.picture), std::max(most, fromPoints(1)),
                  materials_->pictureHeight);
}

// What is read again has the size that its lines were made for.
QSizeF Paragraph::sizeOfObject(std::size_t run, int position) const {
    if (run >= runsRead_) {
        const QSizeF size = sizeNow(block_->runs[run]);
        objects_.push_back({run, position, size, 0});
        return size;
    }
    const auto isBefore = [](const InlineObject& object, int at) { return object.position < at; };
    return std::lower_bound(objects_.begin(), objects_.end(), position, isBefore)->size;
}

namespace {

// Goes from right to left, or says where letters go.
bool mayTurn(QChar letter) {
    switch (letter.direction()) {
    case QChar::DirR:
    case QChar::DirAL:
    case QChar::DirAN:
    case QChar::DirRLE:
    case QChar::DirRLO:
    case QChar::DirRLI:
    case QChar::DirFSI:
    case QChar::DirLRE:
    case QChar::DirLRO:
        return true;
    default:
        return letter.isSurrogate(); // not looked into
    }
}

} // namespace

void Paragraph::append(std::size_t index) const {
    const model::Run& run = block_->runs[index];
    if (run.formula && formulas::Font::standard())
        return appendFormula(index);
    const int start = static_cast<int>(letters_->text.size());
    letters_->runStarts.push_back(start);
    if (run.kind == model::RunKind::subdocument || run.picture)
        appendBlank(blank, sizeOfObject(index, start).width(), run.style);
    else
        appendText(run);
    if (run.kind == model::RunKind::footnote && index >= runsRead_ && run.footnote)
        marks_.push_back({start, run.footnote});
    runsRead_ = std::max(runsRead_, index + 1);
}

void Paragraph::appendText(const model::Run& run) const {
    QString text = run.kind == model::RunKind::lineBreak
                       ? QString(QChar(QChar::LineSeparator))
                       : QString::fromStdString(run.text).replace(QLatin1Char('\n'),
                                                                  QChar(QChar::LineSeparator));
    const bool isVerbatim = block_->kind == model::BlockKind::verbatim;
    if (!isVerbatim)
        text.replace(QLatin1Char('\t'), QLatin1Char(' '));
    letters_->isMixed = letters_->isMixed || std::ranges::any_of(text, mayTurn);
    const auto start = static_cast<int>(letters_->text.size());
    const auto length = static_cast<int>(text.size());
    letters_->text += text;
    if (letters_->lastStyle == run.style)
        letters_->ranges.back().length += length;
    else
        letters_->ranges.push_back({.start = start,
                                    .length = length,
                                    .format = materials_->looks.format(run.style),
                                    .style = run.style,
                                    .blank = isVerbatim ? 0 : materials_->looks.blank(run.style)});
    letters_->lastStyle = run.style;
}

// A sign of that width, which does not stretch.
Paragraph::Range& Paragraph::appendBlank(QChar sign, double width, std::uint32_t style) const {
    QTextCharFormat format = materials_->looks.format(style);
    QFont font = format.font();
    font.setPixelSize(1);
    font.setLetterSpacing(QFont::AbsoluteSpacing, std::max(0.0, width));
    format.setFont(font);
    letters_->ranges.push_back({.start = static_cast<int>(letters_->text.size()),
                                .length = 1,
                                .format = format,
                                .style = style});
    letters_->text += sign;
    letters_->lastStyle.reset();
    return letters_->ranges.back();
}

bool Paragraph::isOf(Sizes&) const {
    return std::ranges::all_of(objects_, [this](const InlineObject& object) {
        return object.formula || sizeNow(block_->runs[object.run]) == object.size;
    });
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

const Paragraph::Drawn& Paragraph::drawnOf(int line) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    const int length = of.end - of.from;
    const auto known = drawn_.find(line);
    if (known != drawn_.end()) {
        Kept::all().use(known->second.kept, length);
        return known->second;
    }
    Drawn made;
    made.layout = shaped(of, made.marks);
    ++Kept::all().layoutsMade;
    made.kept = Kept::all().add(*this, line, length);
    return drawn_.emplace(line, std::move(made)).first->second;
}

int Paragraph::inLayout(int line, int letter) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    return std::clamp(letter, of.from, of.end) - of.from + drawnOf(line).marks;
}

int Paragraph::fromLayout(int line, int position) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    return std::clamp(of.from + position - drawnOf(line).marks, of.from, of.end);
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
    const int position = fromLayout(line, found.xToCursor(x, QTextLine::CursorOnCharacter));
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
    return drawn(line).cursorToX(inLayout(line, position));
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
    return {whole.naturalWidth(), std::min(whole.leastWidth(), whole.naturalWidth()),
            whole.numberWidth()};
}

} // namespace layout
