#include "paragraphs/paragraph.h"

#include "paragraphs/measure.h"
#include "paragraphs/typeface.h"

#include <QPainter>
#include <algorithm>

namespace paragraphs {

namespace {

constexpr double unbroken = 4e6; // twips; a width that nothing reaches

} // namespace

Paragraph::Paragraph(std::shared_ptr<Materials> materials, BlockPointer block, double width,
                     bool markerInFront)
    : letters_(std::move(materials), std::move(block), width, markerInFront),
      leading_(fromPoints(this->materials().looks.style(firstStyle()).size) *
               this->block()->style.lineHeight) {}

Paragraph::~Paragraph() {
    for (const auto& [line, drawn] : drawn_)
        Kept::lines().remove(drawn.kept);
}

std::uint32_t Paragraph::firstStyle() const {
    return block()->runs.empty() ? block()->textStyle : block()->runs.front().style;
}

bool Paragraph::isOf(Sizes& sizes) const { return letters_.isOf(sizes); }

// --- what stands on them -----------------------------------------------------------------------

std::size_t Paragraph::lettersKept() { return Kept::texts().letters() + Kept::lines().letters(); }
std::size_t Paragraph::layoutsMade() { return layoutsMade_; }

void Paragraph::forget(int line) const { drawn_.erase(line); }

std::span<const InlineObject> Paragraph::objectsOf(int line) const {
    const auto [from, to] = rangeOfLine(line);
    return letters_.objectsIn(from, to);
}

std::span<const NoteMark> Paragraph::notesOf(int line) const {
    const auto [from, to] = rangeOfLine(line);
    return letters_.marksIn(from, to);
}

const Paragraph::Drawn& Paragraph::drawnOf(int line) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    const int length = of.end - of.from;
    const auto known = drawn_.find(line);
    if (known != drawn_.end()) {
        Kept::lines().use(known->second.kept, length);
        return known->second;
    }
    Drawn made;
    made.layout = shaped(of, made.marks);
    ++layoutsMade_;
    made.kept = Kept::lines().add(*this, line, length);
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
    const std::vector<int>& starts = letters_.read(position + 1).runStarts;
    const auto behind = std::upper_bound(starts.begin(), starts.end(), position);
    return behind == starts.begin() ? nullptr : &block()->runs[behind - starts.begin() - 1];
}

QString Paragraph::text(int from, int count) const {
    return letters_.read(from + count).text.mid(from, count);
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
    Widths widths = whole.widths();
    widths.least = std::min(widths.least, widths.natural);
    return widths;
}

} // namespace paragraphs
