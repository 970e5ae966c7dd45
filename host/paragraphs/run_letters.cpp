#include "paragraphs/run_letters.h"

#include "model/value_text.h"
#include "paragraphs/measure.h"
#include "text/characters.h"

#include <QFontMetricsF>
#include <algorithm>

namespace paragraphs {

namespace {

constexpr QChar noBreak(0x00A0), space(0x0020);
constexpr QChar leftToRight(0x2066), asBefore(0x2069); // around pieces of a formula: in their order
constexpr double leastBroken = 0.25;                   // of the width: what is shorter stays whole
constexpr double roomBesideNumber = 0.8;               // of the width, for a display with a number

template <class Thing> std::span<Thing> within(std::vector<Thing>& all, int from, int to) {
    const auto isBefore = [](const Thing& thing, int at) { return thing.position < at; };
    const auto first = std::lower_bound(all.begin(), all.end(), from, isBefore);
    return {first, std::lower_bound(first, all.end(), to, isBefore)};
}

} // namespace

RunLetters::RunLetters(std::shared_ptr<Materials> materials, BlockPointer block, double width,
                       bool markerInFront)
    : materials_(std::move(materials)), block_(std::move(block)), width_(width),
      markerInFront_(markerInFront) {}

RunLetters::~RunLetters() {
    if (kept_)
        Kept::texts().remove(*kept_);
}

void RunLetters::forget(int) const {
    kept_.reset();
    letters_.reset();
}

void RunLetters::finish() {
    isFinished_ = true;
    letters_.reset();
}

// --- reading -----------------------------------------------------------------------------------

const Letters& RunLetters::read(int to, std::size_t runs) const {
    if (!letters_)
        begin();
    runs = std::min(runs, block_->runs.size());
    while (letters_->runStarts.size() < runs ||
           (letters_->text.size() < to && letters_->runStarts.size() < block_->runs.size()))
        append(letters_->runStarts.size());
    const auto length = static_cast<int>(letters_->text.size());
    if (kept_)
        Kept::texts().use(*kept_, length);
    else if (isFinished_) // until then they are needed for the next line
        kept_ = Kept::texts().add(*this, 0, length);
    return *letters_;
}

void RunLetters::begin() const {
    letters_ = std::make_unique<Letters>();
    if (!markerInFront_)
        return;
    letters_->text = QString::fromStdString(block_->marker) + QChar(' ');
    letters_->ranges.push_back({.start = 0,
                                .length = static_cast<int>(letters_->text.size()),
                                .format = materials_->looks.format(block_->markerStyle),
                                .style = block_->markerStyle,
                                .blank = materials_->looks.blank(block_->markerStyle)});
}

// An image is no wider than a line.
QSizeF RunLetters::sizeNow(const model::Run& run) const {
    Sizes& sizes = materials_->sizes;
    if (!run.picture)
        return sizes.subdocument(run.subdocument);
    const double most = width_ - std::max(0.0, fromPoints(block_->style.firstLine));
    return fitted(sizes.picture(*run.picture), std::max(most, fromPoints(1)),
                  materials_->pictureHeight);
}

// A run that is read again has the size that its lines were made for.
QSizeF RunLetters::sizeOfObject(std::size_t run, int position) const {
    if (run >= runsRead_) {
        const QSizeF size = sizeNow(block_->runs[run]);
        objects_.push_back({run, position, size, 0});
        return size;
    }
    return objectAt(position).size;
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

void RunLetters::append(std::size_t index) const {
    const model::Run& run = block_->runs[index];
    if (run.formula && formulas::Font::standard())
        return appendFormula(index);
    const int start = static_cast<int>(letters_->text.size());
    letters_->runStarts.push_back(start);
    if (run.kind == model::RunKind::subdocument || run.picture)
        appendBlank(noBreak, sizeOfObject(index, start).width(), run.style);
    else if (run.value && !run.value->room.empty())
        appendNumber(run);
    else
        appendText(run);
    if (run.kind == model::RunKind::footnote && index >= runsRead_ && run.footnote)
        marks_.push_back({start, run.footnote});
    runsRead_ = std::max(runsRead_, index + 1);
}

void RunLetters::appendText(const model::Run& run) const {
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
    lettersRead_ += text.size();
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

namespace {

// As if each digit were the widest one of the font.
double widthOfRoom(const std::string& room, const QFont& font) {
    const QFontMetricsF metrics(font);
    const double zero = metrics.horizontalAdvance(QLatin1Char('0'));
    double widest = zero;
    for (char digit = '1'; digit <= '9'; ++digit)
        widest = std::max(widest, metrics.horizontalAdvance(QLatin1Char(digit)));
    return metrics.horizontalAdvance(QString::fromStdString(room)) +
           static_cast<double>(std::ranges::count(room, '0')) * (widest - zero);
}

} // namespace

// The figure space before a number that plays is as wide as what is left of its room.
void RunLetters::appendNumber(const model::Run& run) const {
    model::Run number = run;
    number.text.erase(0, model::figureSpace.size());
    const QFont font = materials_->looks.font(run.style);
    const double left = widthOfRoom(run.value->room, font) -
                        QFontMetricsF(font).horizontalAdvance(QString::fromStdString(number.text));
    appendBlank(noBreak, left, run.style);
    appendText(number);
}

// A sign of that width, which does not stretch.
LetterRange& RunLetters::appendBlank(QChar sign, double width, std::uint32_t style) const {
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

const InlineObject& RunLetters::objectAt(int position) const {
    const auto isBefore = [](const InlineObject& object, int at) { return object.position < at; };
    return *std::lower_bound(objects_.begin(), objects_.end(), position, isBefore);
}

// Each piece that stays on one line is a blank of its width, and the spaces between them are blanks
// where the line may end. The letters that are read again are those that its lines were made for.
std::shared_ptr<const formulas::Set> RunLetters::formulaOf(std::size_t run, int position) const {
    if (run < runsRead_)
        return objectAt(position).formula;
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

void RunLetters::appendFormula(std::size_t index) const {
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
            LetterRange& gap = appendBlank(space, piece.space, style);
            gap.blank = piece.space;
            gap.isGap = true;
        }
    }
    if (several)
        appendBlank(asBefore, 0, style);
    runsRead_ = std::max(runsRead_, index + 1);
}

bool RunLetters::isOf(Sizes&) const {
    return std::ranges::all_of(objects_, [this](const InlineObject& object) {
        return object.formula || sizeNow(block_->runs[object.run]) == object.size;
    });
}

std::span<InlineObject> RunLetters::objectsIn(int from, int to) const {
    return within(objects_, from, to);
}

std::span<const NoteMark> RunLetters::marksIn(int from, int to) const {
    return within(marks_, from, to);
}

// --- letters and bytes -------------------------------------------------------------------------

namespace {

// Letters of UTF-16 that a character of UTF-8 becomes, and its bytes.
struct Character {
    int letters = 1;
    std::size_t bytes = 1;
};

Character characterAt(const std::string& text, std::size_t at) {
    const std::size_t length = text::characterLength(std::string_view(text).substr(at));
    if (length == 0)
        return {};
    return {length == 4 ? 2 : 1, length};
}

} // namespace

int RunLetters::startOfRun(std::size_t run) const { return read(0, run + 1).runStarts[run]; }

int RunLetters::endOfRun(std::size_t run) const {
    if (run + 1 < block_->runs.size())
        return startOfRun(run + 1);
    return static_cast<int>(read(0, run + 1).text.size());
}

int RunLetters::letterAt(std::size_t run, std::size_t byte) const {
    const std::string& text = block_->runs[run].text;
    int letter = startOfRun(run);
    for (std::size_t at = 0; at < std::min(byte, text.size());) {
        const Character character = characterAt(text, at);
        at += character.bytes;
        if (at <= byte)
            letter += character.letters;
    }
    return letter;
}

std::size_t RunLetters::byteAt(std::size_t run, int letter) const {
    const std::string& text = block_->runs[run].text;
    std::size_t at = 0;
    for (int left = letter - startOfRun(run); left > 0 && at < text.size();) {
        const Character character = characterAt(text, at);
        at += character.bytes;
        left -= character.letters;
    }
    return at;
}

} // namespace paragraphs
