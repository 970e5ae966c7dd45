#include "accessibility/accessible_text.h"

#include "accessibility/accessible_view.h"
#include "view/document_view.h"
#include "view/text_hand.h"

#include <algorithm>

namespace accessibility {

using view::DocumentView;

void* AccessibleText::interface_cast(QAccessible::InterfaceType type) {
    if (type == QAccessible::TextInterface)
        return static_cast<QAccessibleTextInterface*>(this);
    return AccessiblePart::interface_cast(type);
}

const reading::BlockText& AccessibleText::letters() const {
    if (!letters_ || letters_->block() != part().block)
        letters_ = std::make_unique<reading::BlockText>(document(), part().block);
    return *letters_;
}

QString AccessibleText::text(int start, int end) const {
    return letters().text().mid(start, end - start);
}

int AccessibleText::characterCount() const { return static_cast<int>(letters().text().size()); }

// --- the caret, and what is selected -----------------------------------------------------------

int AccessibleText::cursorPosition() const {
    if (root().view().chosen() || root().focused() != &part())
        return -1;
    return letters().letterAt(root().view().text().cursor().selection()->caret);
}

void AccessibleText::setCursorPosition(int position) { setSelection(0, position, position); }

void AccessibleText::selection(int index, int* start, int* end) const {
    *start = *end = 0;
    const text::Range all = root().view().text().cursor().interval();
    const std::optional<std::size_t> first = letters().placeOf(0);
    const std::optional<std::size_t> last = letters().placeOf(characterCount());
    if (index != 0 || all.empty() || !first || !last || all.to <= *first || all.from >= *last)
        return;
    *start = all.from <= *first ? 0 : letters().letterAt(all.from);
    *end = all.to >= *last ? characterCount() : letters().letterAt(all.to);
}

int AccessibleText::selectionCount() const {
    int start = 0, end = 0;
    selection(0, &start, &end);
    return start < end ? 1 : 0;
}

void AccessibleText::addSelection(int start, int end) { setSelection(0, start, end); }

void AccessibleText::removeSelection(int index) {
    if (index == 0 && selectionCount() > 0)
        setCursorPosition(std::max(0, cursorPosition()));
}

// In text without a letter its element is the place.
void AccessibleText::setSelection(int index, int start, int end) {
    DocumentView& view = root().view();
    view.settle();
    (void)root().tree();
    std::optional<std::size_t> from = letters().placeOf(start), to = letters().placeOf(end);
    const sgml::Tree& tree = document().tree();
    if (!from && tree.holds(part().element))
        from = to = tree.node(part().element).startTag.to;
    if (index != 0 || !from || !to)
        return;
    view.choose(document::noSubdocument);
    view.text().cursor().set({*from, *to});
}

// --- places ------------------------------------------------------------------------------------

places::Carets AccessibleText::carets() const { return {root().view().pages(), document().tree()}; }

std::optional<places::Caret> AccessibleText::caretAt(int letter) const {
    const std::optional<std::size_t> place = letters().placeOf(letter);
    return place ? carets().of(*place, root().view().currentPage()) : std::nullopt;
}

QRect AccessibleText::characterRect(int offset) const {
    const std::optional<places::Caret> caret = caretAt(offset);
    if (!caret)
        return {};
    const places::Carets carets = this->carets();
    const places::Caret next = carets.moved(*caret, places::Move::right);
    QRectF rect = carets.rectOf(*caret);
    if (next.page == caret->page && next.piece == caret->piece)
        rect.setRight(std::max(rect.left(), carets.rectOf(next).left()));
    return onScreen(root().view().inViewport(caret->page, rect));
}

// From its first line to its last one; on several pages those on the first.
QRect AccessibleText::rect() const {
    const std::optional<places::Caret> first = caretAt(0), last = caretAt(characterCount());
    if (!first || !last)
        return {};
    const places::Carets carets = this->carets();
    const auto lineOf = [&](const places::Caret& at) {
        const auto end = [&](places::Move move) { return carets.rectOf(carets.moved(at, move)); };
        return end(places::Move::lineStart) | end(places::Move::lineEnd);
    };
    QRectF rect = lineOf(*first);
    if (first->page == last->page)
        rect |= lineOf(*last);
    else
        rect.setBottom(root().view().pages().size.height());
    return onScreen(root().view().inViewport(first->page, rect));
}

int AccessibleText::offsetAtPoint(const QPoint& point) const {
    const DocumentView& view = root().view();
    if (view.pages().pages.empty())
        return -1;
    const auto [page, on] = view.pagePointAt(view.viewport()->mapFromGlobal(point));
    const std::optional<places::Caret> caret = carets().at(page, on);
    const std::size_t place = caret ? carets().placeOf(*caret) : 0;
    return caret && root().tree().partAt(place) == &part() ? letters().letterAt(place) : -1;
}

void AccessibleText::scrollToSubstring(int start, int) {
    setCursorPosition(start);
    root().view().text().showCaret();
}

// --- lines of the page -------------------------------------------------------------------------

AccessibleText::Line AccessibleText::lineAt(int letter) const {
    const Line all{0, characterCount()};
    const std::optional<places::Caret> caret = caretAt(letter);
    if (!caret)
        return all;
    const places::Carets carets = this->carets();
    const auto letterOf = [&](places::Move move) {
        return letters().letterAt(carets.placeOf(carets.moved(*caret, move)));
    };
    Line line{letterOf(places::Move::lineStart), letterOf(places::Move::lineEnd)};
    // The marker, and what else is generated, goes with the text beside it.
    const auto first = letters().placeOf(0), last = letters().placeOf(all.to);
    if (first && line.from <= letters().letterAt(*first))
        line.from = 0;
    if (last && line.to >= letters().letterAt(*last))
        line.to = all.to;
    return line;
}

QString AccessibleText::give(Line line, int* start, int* end) const {
    *start = line.from;
    *end = line.to;
    return text(line.from, line.to);
}

QString AccessibleText::textAtOffset(int offset, QAccessible::TextBoundaryType boundary, int* start,
                                     int* end) const {
    if (boundary != QAccessible::LineBoundary)
        return QAccessibleTextInterface::textAtOffset(offset, boundary, start, end);
    return give(lineAt(offset), start, end);
}

QString AccessibleText::textBeforeOffset(int offset, QAccessible::TextBoundaryType boundary,
                                         int* start, int* end) const {
    if (boundary != QAccessible::LineBoundary)
        return QAccessibleTextInterface::textBeforeOffset(offset, boundary, start, end);
    const int from = lineAt(offset).from;
    return give(from == 0 ? Line{} : lineAt(from - 1), start, end);
}

QString AccessibleText::textAfterOffset(int offset, QAccessible::TextBoundaryType boundary,
                                        int* start, int* end) const {
    if (boundary != QAccessible::LineBoundary)
        return QAccessibleTextInterface::textAfterOffset(offset, boundary, start, end);
    const int to = lineAt(offset).to;
    const Line none{characterCount(), characterCount()};
    return give(to >= characterCount() ? none : lineAt(to + 1), start, end);
}

// --- looks -------------------------------------------------------------------------------------

// As IAccessible2 spells them.
QString AccessibleText::attributes(int offset, int* start, int* end) const {
    *start = 0;
    *end = characterCount();
    for (const reading::BlockText::Part& part : letters().parts()) {
        if (offset >= part.to) {
            *start = part.to;
            continue;
        }
        if (offset < part.from) { // the marker
            *end = part.from;
            return {};
        }
        *start = part.from;
        *end = part.to;
        const schemas::TextStyle& style = (*root().tree().model()->textStyles)[part.run->style];
        QString all = QStringLiteral("font-family:%1;font-size:%2pt;")
                          .arg(QString::fromStdString(style.family).replace(';', ' '))
                          .arg(style.size);
        all += style.bold ? QStringLiteral("font-weight:bold;") : QString();
        all += style.italic ? QStringLiteral("font-style:italic;") : QString();
        all += style.underline ? QStringLiteral("text-underline-style:solid;") : QString();
        if (!style.language.empty())
            all += QStringLiteral("language:%1;").arg(QString::fromStdString(style.language));
        return all;
    }
    return {};
}

} // namespace accessibility
