#include "view/accessible_view.h"

#include "view/document_view.h"
#include "view/text_hand.h"

#include <algorithm>

namespace view {

AccessibleView::AccessibleView(DocumentView& view)
    : QAccessibleWidget(&view, QAccessible::Document) {}

void AccessibleView::install() {
    static const bool isInstalled = [] {
        QAccessible::installFactory([](const QString&, QObject* object) -> QAccessibleInterface* {
            auto* view = qobject_cast<DocumentView*>(object);
            return view ? new AccessibleView(*view) : nullptr;
        });
        return true;
    }();
    Q_UNUSED(isInstalled)
}

void AccessibleView::tell(DocumentView& view) {
    if (!QAccessible::isActive())
        return;
    auto* own = dynamic_cast<AccessibleView*>(QAccessible::queryAccessibleInterface(&view));
    if (own == nullptr)
        return;
    QAccessibleTextCursorEvent caret(&view, own->cursorPosition());
    QAccessible::updateAccessibility(&caret);
    int start = 0, end = 0;
    own->selection(0, &start, &end);
    QAccessibleTextSelectionEvent selected(&view, start, end);
    selected.setCursorPosition(own->cursorPosition());
    QAccessible::updateAccessibility(&selected);
}

DocumentView& AccessibleView::view() const { return *static_cast<DocumentView*>(widget()); }

const ShownText& AccessibleView::shown() const {
    view().settle();
    if (!shown_ || !shown_->isOf(view().model()))
        shown_ = std::make_unique<ShownText>(view().document().document(), view().model());
    return *shown_;
}

void* AccessibleView::interface_cast(QAccessible::InterfaceType type) {
    if (type == QAccessible::TextInterface)
        return static_cast<QAccessibleTextInterface*>(this);
    return QAccessibleWidget::interface_cast(type);
}

QAccessible::State AccessibleView::state() const {
    QAccessible::State state = QAccessibleWidget::state();
    state.multiLine = true;
    state.selectableText = true;
    state.readOnly = !view().isWriting();
    state.editable = view().isWriting();
    return state;
}

QString AccessibleView::text(QAccessible::Text of) const { return QAccessibleWidget::text(of); }

void AccessibleView::selection(int index, int* start, int* end) const {
    const text::Range all = view().text().cursor().interval();
    *start = *end = 0;
    if (index != 0 || all.empty())
        return;
    *start = shown().letterAt(all.from);
    *end = shown().letterAt(all.to);
}

int AccessibleView::selectionCount() const { return view().text().cursor().selects() ? 1 : 0; }

void AccessibleView::addSelection(int start, int end) { setSelection(0, start, end); }

void AccessibleView::removeSelection(int index) {
    if (index == 0 && selectionCount() > 0)
        setCursorPosition(cursorPosition());
}

void AccessibleView::setSelection(int index, int start, int end) {
    const std::optional<std::size_t> from = shown().placeOf(start), to = shown().placeOf(end);
    if (index == 0 && from && to)
        view().text().cursor().set({*from, *to});
}

int AccessibleView::cursorPosition() const {
    const std::optional<document::Selection> selection = view().text().cursor().selection();
    return selection ? shown().letterAt(selection->caret) : 0;
}

void AccessibleView::setCursorPosition(int position) { setSelection(0, position, position); }

QString AccessibleView::text(int start, int end) const {
    return shown().text().mid(start, end - start);
}

int AccessibleView::characterCount() const { return static_cast<int>(shown().text().size()); }

QRect AccessibleView::characterRect(int offset) const {
    const std::optional<std::size_t> place = shown().placeOf(offset);
    const layout::Carets carets(view().pages(), view().document().document().tree());
    const std::optional<layout::Caret> caret = place ? carets.of(*place, 0) : std::nullopt;
    if (!caret)
        return {};
    const layout::Caret next = carets.moved(*caret, layout::Move::right);
    QRectF rect = carets.rectOf(*caret);
    if (next.page == caret->page && next.piece == caret->piece)
        rect.setRight(std::max(rect.left(), carets.rectOf(next).left()));
    const QRect on = view().inViewport(caret->page, rect).toAlignedRect();
    return {view().viewport()->mapToGlobal(on.topLeft()), on.size()};
}

int AccessibleView::offsetAtPoint(const QPoint& point) const {
    if (view().pages().pages.empty())
        return -1;
    const auto [page, on] = view().pagePointAt(view().viewport()->mapFromGlobal(point));
    const layout::Carets carets(view().pages(), view().document().document().tree());
    const std::optional<layout::Caret> caret = carets.at(page, on);
    return caret ? shown().letterAt(carets.placeOf(*caret)) : -1;
}

void AccessibleView::scrollToSubstring(int start, int) {
    setCursorPosition(start);
    view().text().showCaret();
}

QString AccessibleView::attributes(int, int* start, int* end) const {
    *start = 0;
    *end = characterCount();
    return {};
}

} // namespace view
