#include "accessibility/accessible_view.h"

#include "accessibility/accessible_part.h"
#include "excerpts/equal_ends.h"
#include "reading/block_text.h"
#include "view/document_view.h"
#include "view/text_hand.h"

#include <algorithm>

namespace accessibility {

using view::DocumentView;

AccessibleView::AccessibleView(DocumentView& view)
    : QAccessibleWidget(&view, QAccessible::Document), tree_(view.document().document()) {
    for (const auto changes :
         {&DocumentView::selectionChanged, &DocumentView::laidOut, &DocumentView::focusChanged})
        QObject::connect(&view, changes, &view, [this] { tell(); });
}

std::function<void(QAccessibleEvent&)> AccessibleView::heard;

void AccessibleView::send(QAccessibleEvent& event) {
    if (heard)
        heard(event);
    QAccessible::updateAccessibility(&event);
}

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

DocumentView& AccessibleView::view() const { return *static_cast<DocumentView*>(widget()); }

reading::ReadingTree& AccessibleView::tree() const {
    if (tree_.model() == view().model())
        return tree_;
    const auto tell = [this](QAccessible::Event type) {
        return [this, type](reading::Part& part) {
            if (!part.companion && type != QAccessible::ObjectCreated)
                return;
            QAccessibleEvent event(interfaceOf(&part), type);
            send(event);
        };
    };
    tree_.follow(view().model(),
                 {tell(QAccessible::ObjectCreated), tell(QAccessible::ObjectDestroyed),
                  [this](reading::Part& part, const std::shared_ptr<const model::Block>& before) {
                      if (part.companion)
                          tellChange(part, before);
                  }});
    return tree_;
}

QAccessibleInterface* AccessibleView::interfaceOf(reading::Part* part) const {
    return part ? AccessiblePart::of(const_cast<AccessibleView&>(*this), *part) : nullptr;
}

// --- what changes ------------------------------------------------------------------------------

// The letters that went, and those that came; of what is no text, its words.
void AccessibleView::tellChange(reading::Part& part,
                                const std::shared_ptr<const model::Block>& before) const {
    QAccessibleInterface* own = interfaceOf(&part);
    if (!own->textInterface()) {
        QAccessibleEvent event(own, QAccessible::NameChanged);
        return send(event);
    }
    const document::Document& of = view().document().document();
    const std::u16string old = reading::BlockText(of, before).text().toStdU16String();
    const std::u16string now = reading::BlockText(of, part.block).text().toStdU16String();
    const model::Ends same =
        model::equalEnds(old, now, [](char16_t a, char16_t b, bool) { return a == b; });
    const auto at = static_cast<int>(same.front);
    const auto middleOf = [&](const std::u16string& text) {
        return QString::fromStdU16String(
            text.substr(same.front, text.size() - same.front - same.back));
    };
    if (const QString gone = middleOf(old); !gone.isEmpty()) {
        QAccessibleTextRemoveEvent event(own, at, gone);
        send(event);
    }
    if (const QString come = middleOf(now); !come.isEmpty()) {
        QAccessibleTextInsertEvent event(own, at, come);
        send(event);
    }
}

void AccessibleView::tell() {
    // Edits that are not laid out yet: told when they are.
    if (!view().isLaidOut())
        return;
    if (QAccessible::isActive() || tree_.root().isOpen) // somebody listens
        tellCaret();
}

void AccessibleView::tellCaret() {
    (void)tree();
    QAccessibleInterface* on = interfaceOf(focused());
    Told now;
    now.hadFocus = view().hasFocus();
    if (on) {
        now.part = QAccessible::uniqueId(on);
        if (QAccessibleTextInterface* text = on->textInterface()) {
            now.caret = text->cursorPosition();
            text->selection(0, &now.from, &now.to);
        }
    }
    const Told before = std::exchange(told_, now);
    if (!on || now == before)
        return;
    if (now.hadFocus && (now.part != before.part || !before.hadFocus)) {
        QAccessibleEvent event(on, QAccessible::Focus);
        send(event);
    }
    if (now.caret < 0)
        return;
    if (now.part != before.part || now.caret != before.caret) {
        QAccessibleTextCursorEvent event(on, now.caret);
        send(event);
    }
    if (now.from != before.from || now.to != before.to) {
        QAccessibleTextSelectionEvent event(on, now.from, now.to);
        event.setCursorPosition(now.caret);
        send(event);
    }
}

// --- the tree ----------------------------------------------------------------------------------

reading::Part* AccessibleView::focused() const {
    if (view().chosen())
        return tree().figureOf(view().chosen());
    const std::optional<document::Selection> selection = view().text().cursor().selection();
    return selection ? tree().partAt(selection->caret) : nullptr;
}

QAccessible::State AccessibleView::state() const {
    QAccessible::State state = QAccessibleWidget::state();
    state.readOnly = !view().isWriting();
    state.editable = view().isWriting();
    return state;
}

// The parts of the document, then the widgets beside it.
QAccessibleInterface* AccessibleView::child(int index) const {
    const auto& parts = tree().partsOf(tree().root());
    const auto at = static_cast<std::size_t>(std::max(0, index));
    if (at < parts.size())
        return interfaceOf(parts[at].get());
    return QAccessibleWidget::child(index - static_cast<int>(parts.size()));
}

int AccessibleView::childCount() const {
    return static_cast<int>(tree().partsOf(tree().root()).size()) + QAccessibleWidget::childCount();
}

int AccessibleView::indexOfChild(const QAccessibleInterface* child) const {
    if (const auto* part = dynamic_cast<const AccessiblePart*>(child))
        return part->part().parent == &tree_.root() ? static_cast<int>(tree_.indexOf(part->part()))
                                                    : -1;
    const int index = QAccessibleWidget::indexOfChild(child);
    return index < 0 ? index : index + static_cast<int>(tree().partsOf(tree().root()).size());
}

QAccessibleInterface* AccessibleView::childAt(int x, int y) const {
    const QPoint point = view().viewport()->mapFromGlobal(QPoint(x, y));
    if (!view().viewport()->rect().contains(point) || view().pages().pages.empty())
        return QAccessibleWidget::childAt(x, y);
    for (const document::SubdocumentId id : view().visibleSubdocuments())
        if (view().placeOf(id).contains(point))
            return interfaceOf(tree().figureOf(id));
    const auto [page, on] = view().pagePointAt(point);
    const places::Carets carets(view().pages(), view().document().document().tree());
    const std::optional<places::Caret> caret = carets.at(page, on);
    return caret ? interfaceOf(tree().partAt(carets.placeOf(*caret))) : nullptr;
}

QAccessibleInterface* AccessibleView::focusChild() const {
    if (!view().hasFocus())
        return QAccessibleWidget::focusChild();
    QAccessibleInterface* part = interfaceOf(focused());
    return part ? part : QAccessibleWidget::focusChild();
}

} // namespace accessibility
