#include "view/folds.h"

#include "paragraphs/measure.h"
#include "places/carets.h"
#include "view/document_view.h"
#include "view/text_hand.h"

#include <QApplication>
#include <QScrollBar>
#include <algorithm>

namespace view {

using sgml::NodeId;

namespace {

constexpr int promptMs = 12; // what nobody notices; the rest follows

QString counted(std::size_t count, const QString& one, const QString& many) {
    return QStringLiteral("%1 %2").arg(count).arg(count == 1 ? one : many);
}

// "2 sections, 7 paragraphs, 1 figure"
QString hiddenWords(const model::SectionCounts& counts) {
    QStringList parts;
    const auto add = [&](std::size_t count, const QString& one, const QString& many) {
        if (count > 0)
            parts << counted(count, one, many);
    };
    add(counts.sections, Folds::tr("section"), Folds::tr("sections"));
    add(counts.paragraphs, Folds::tr("paragraph"), Folds::tr("paragraphs"));
    add(counts.figures, Folds::tr("figure"), Folds::tr("figures"));
    add(counts.tables, Folds::tr("table"), Folds::tr("tables"));
    return parts.isEmpty() ? QStringLiteral("…") : parts.join(QStringLiteral(", "));
}

} // namespace

Folds::Folds(DocumentView& view) : view_(view), pages_(view.document()) {}

// --- commands ----------------------------------------------------------------------------------

NodeId Folds::headingHere() {
    const auto innermostAt = [this](std::size_t place) {
        const std::vector<NodeId> around = pages_.headingsAround(place);
        return around.empty() ? sgml::noNode : around.back();
    };
    const document::Document& document = view_.document().document();
    if (const document::Subdocument* figure = document.subdocument(view_.chosen()))
        return innermostAt(document.tree().node(figure->element).range.from);
    const std::optional<QRectF> caret = view_.text().caretRect();
    if (caret && (view_.isWriting() || caret->intersects(view_.viewport()->rect())))
        return innermostAt(view_.text().cursor().selection()->caret);
    if (const std::optional<ReadingPlace> reading = view_.readingPlace())
        if (const NodeId heading = innermostAt(reading->place); heading != sgml::noNode)
            return heading;
    for (const Mark& mark : marks()) // the first that is seen
        if (pages_.isFoldable(mark.heading))
            return mark.heading;
    return sgml::noNode;
}

void Folds::toggle(NodeId heading) {
    const bool folds = !pages_.isFolded(heading);
    if (folds)
        bringIntoView(heading);
    pages_.setFolded(heading, folds);
    if (folds)
        moveCaretOut();
    pages_.settle(promptMs);
    view_.viewport()->update();
}

void Folds::foldAll() {
    if (const std::optional<ReadingPlace> reading = view_.readingPlace())
        if (const std::vector<NodeId> around = pages_.headingsAround(reading->place);
            !around.empty())
            bringIntoView(around.front());
    pages_.foldAll();
    moveCaretOut();
    pages_.settle(promptMs);
    view_.viewport()->update();
}

void Folds::unfoldAll() {
    pages_.unfoldAll();
    pages_.settle(promptMs);
    view_.viewport()->update();
}

// The words at the top of the view stay there when pages change: the heading is among them then.
void Folds::bringIntoView(NodeId heading) {
    const sgml::Tree& tree = view_.document().document().tree();
    const places::Carets carets(view_.pages(), tree);
    const auto caret = carets.of(tree.node(heading).startTag.to, view_.currentPage());
    if (!caret)
        return;
    const double top = view_.inViewport(caret->page, carets.rectOf(*caret)).top();
    constexpr double edge = 4;
    QScrollBar* bar = view_.verticalScrollBar();
    if (top < 0)
        bar->setValue(bar->value() + static_cast<int>(std::floor(top - edge)));
}

// It would be in what is hidden: it goes to the end of the heading.
void Folds::moveCaretOut() {
    TextCursor& cursor = view_.text().cursor();
    const std::optional<document::Selection> selection = cursor.selection();
    if (!selection)
        return;
    NodeId heading = pages_.hiding(selection->caret);
    if (heading == sgml::noNode)
        heading = pages_.hiding(selection->anchor);
    if (heading == sgml::noNode)
        return;
    const sgml::Tree& tree = view_.document().document().tree();
    const places::Carets carets(view_.pages(), tree);
    if (const auto end = carets.of(tree.node(heading).endTag.from, view_.currentPage()))
        cursor.moveTo(carets, *end, false);
}

// --- what leads into a section -----------------------------------------------------------------

void Folds::reveal(std::size_t place) {
    if (pages_.reveal(place))
        pages_.settle();
}

void Folds::reveal(const std::string& anchor) {
    if (pages_.reveal(anchor))
        pages_.settle();
}

// Generated text, such as a number, stands where its block does.
void Folds::reveal(const places::Found& found) {
    const sgml::Tree& tree = view_.document().document().tree();
    if (const auto place = places::placesOf(found, model::RunPlaces(tree)))
        return reveal(place->from);
    const NodeId element = found.parts.front().paragraph->block()->element;
    if (tree.holds(element))
        reveal(tree.node(element).range.from);
}

void Folds::followCaret() {
    if (const auto selection = view_.text().cursor().selection())
        reveal(selection->caret);
}

bool Folds::opensBefore(const text::Edits& edits, text::Range selected) {
    const bool wouldChangePart = pages_.revealTouched(edits, selected);
    if (wouldChangePart)
        pages_.settle();
    return wouldChangePart;
}

// --- how headings are marked -------------------------------------------------------------------

QFont Folds::font() const {
    QFont font = QApplication::font();
    constexpr double usual = 12, least = 9, most = 18;
    font.setPixelSize(static_cast<int>(std::clamp(usual * view_.zoom(), least, most)));
    return font;
}

// Of all headings that are seen. An audience sees none.
std::vector<Folds::Mark> Folds::marks() {
    std::vector<Mark> result;
    if (view_.spread() == Spread::single || view_.pages().pages.empty())
        return result;
    const auto [first, end] = view_.seenPages();
    for (std::size_t page = first; page < end; ++page)
        addMarks(result, page);
    return result;
}

void Folds::addMarks(std::vector<Mark>& marks, std::size_t page) {
    const layout::TextPiece* last = nullptr;
    const auto finish = [&] {
        if (last != nullptr && marks.back().isFolded)
            addWords(marks.back(), page, *last);
        last = nullptr;
    };
    for (const layout::Piece& piece : view_.pages().pages[page]->pieces) {
        const auto* text = std::get_if<layout::TextPiece>(&piece);
        if (!text || text->isRepeated)
            continue;
        const model::Block& block = *text->paragraph->block();
        const QRectF line = view_.inViewport(
            page, {text->at, QSizeF(text->paragraph->width(), text->letters().height)});
        if (last != nullptr && last->paragraph == text->paragraph) {
            marks.back().around |= line;
            last = text;
            continue;
        }
        finish();
        if (block.headingLevel <= 0 || text->line > 0)
            continue;
        constexpr double wide = 20, gap = 3;
        const double column = paragraphs::fromPoints(block.style.markerWidth);
        const double markers = view_.inViewport(page, {0, 0, column, 0}).width();
        Mark& mark = marks.emplace_back();
        mark.heading = block.element;
        mark.isFolded = pages_.isFolded(block.element);
        mark.triangle = {line.left() - markers - gap - wide, line.top(), wide, line.height()};
        mark.around = line | mark.triangle;
        last = text;
    }
    finish();
}

// Behind the heading's last letter, as many as there is room for on the page.
void Folds::addWords(Mark& mark, std::size_t page, const layout::TextPiece& last) {
    const auto [from, to] = last.paragraph->rangeOfLine(last.line);
    const double end = last.at.x() + last.paragraph->leftOf(last.line, to);
    const QRectF line = view_.inViewport(page, {end, last.at.y(), 0, last.letters().height});
    const QRectF paper = view_.inViewport(page, {QPointF(), view_.pages().size});
    constexpr double gap = 12, inset = 7;
    const QFontMetricsF metrics(font());
    const double room = paper.right() - line.left() - 2 * gap - 2 * inset;
    const QString all = hiddenWords(pages_.counts(mark.heading));
    mark.hidden = metrics.horizontalAdvance(all) <= room ? all : QStringLiteral("…");
    const double height = std::min(metrics.height() + 4, line.height());
    mark.words = {line.left() + gap, line.center().y() - height / 2,
                  metrics.horizontalAdvance(mark.hidden) + 2 * inset, height};
    mark.around |= mark.words;
}

void Folds::paint(QPainter& painter) {
    if (hovered_ == sgml::noNode && !pages_.foldsAny())
        return;
    const QColor paper = view_.pages().paper;
    const bool isDark = paper.lightness() < 128;
    const QColor ink = isDark ? QColor(200, 203, 208) : QColor(90, 96, 104);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    for (const Mark& mark : marks()) {
        if (!mark.isFolded && mark.heading != hovered_)
            continue;
        const double half = std::clamp(5 * view_.zoom(), 3.5, 8.0);
        const QPointF at = mark.triangle.center();
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        if (mark.isFolded) // points to what is hidden behind it, else down to what is under it
            painter.drawPolygon(QPolygonF{at + QPointF(-half * 0.6, -half),
                                          at + QPointF(half * 0.8, 0),
                                          at + QPointF(-half * 0.6, half)});
        else
            painter.drawPolygon(QPolygonF{at + QPointF(-half, -half * 0.6),
                                          at + QPointF(0, half * 0.8),
                                          at + QPointF(half, -half * 0.6)});
        if (mark.words.isEmpty())
            continue;
        QColor faint = ink;
        faint.setAlphaF(mark.heading == hovered_ ? 0.24F : 0.12F);
        painter.setBrush(faint);
        painter.drawRoundedRect(mark.words, mark.words.height() / 2, mark.words.height() / 2);
        painter.setPen(ink);
        painter.drawText(mark.words, Qt::AlignCenter | Qt::TextDontClip, mark.hidden);
    }
    painter.restore();
}

// --- the pointer -------------------------------------------------------------------------------

const Folds::Mark* Folds::markAt(const std::vector<Mark>& marks, QPointF point) const {
    const auto found = std::ranges::find_if(marks, [&](const Mark& mark) {
        return mark.triangle.contains(point) || mark.words.contains(point);
    });
    return found == marks.end() ? nullptr : &*found;
}

void Folds::hover(QPointF point) {
    const std::vector<Mark> all = marks();
    const auto found =
        std::ranges::find_if(all, [&](const Mark& mark) { return mark.around.contains(point); });
    const bool isOne = found != all.end() && pages_.isFoldable(found->heading);
    const NodeId now = isOne ? found->heading : sgml::noNode;
    if (std::exchange(hovered_, now) != now)
        view_.viewport()->update();
}

bool Folds::isOver(QPointF point) {
    const std::vector<Mark> all = marks();
    const Mark* mark = markAt(all, point);
    return mark != nullptr && pages_.isFoldable(mark->heading);
}

bool Folds::press(QPointF point) {
    const std::vector<Mark> all = marks();
    const Mark* mark = markAt(all, point);
    if (mark == nullptr || !pages_.isFoldable(mark->heading))
        return false;
    toggle(mark->heading);
    return true;
}

QString Folds::tipAt(QPointF point) {
    const std::vector<Mark> all = marks();
    const Mark* mark = markAt(all, point);
    if (mark == nullptr || !pages_.isFoldable(mark->heading))
        return {};
    return mark->isFolded ? tr("Unfold this section") : tr("Fold this section, in this view alone");
}

} // namespace view
