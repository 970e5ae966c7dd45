#include "panes/outline_list.h"

#include "plain/plain.h"

#include <QContextMenuEvent>
#include <QDropEvent>
#include <QHeaderView>
#include <QMenu>
#include <algorithm>
#include <map>
#include <set>

namespace panes {

using authoring::Beside, authoring::Direction;
using model::Outline;
using sgml::NodeId, sgml::noNode;

namespace {

constexpr int elementRole = Qt::UserRole;

QKeyCombination keysOf(const QKeyEvent& event) {
    constexpr auto counted = Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier;
    return QKeyCombination(event.modifiers() & counted, static_cast<Qt::Key>(event.key()));
}

const QKeyCombination upKeys = Qt::ALT | Qt::Key_Up, downKeys = Qt::ALT | Qt::Key_Down,
                      inKeys = Qt::ALT | Qt::SHIFT | Qt::Key_Right,
                      outKeys = Qt::ALT | Qt::SHIFT | Qt::Key_Left;

} // namespace

OutlineList::OutlineList(QWidget* parent) : QTreeWidget(parent) {
    setObjectName("outlineList");
    setHeaderHidden(true);
    setUniformRowHeights(true);
    setTextElideMode(Qt::ElideRight);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Outline"));
    setDropIndicatorShown(true);
    connect(this, &QTreeWidget::itemClicked, this,
            [this](QTreeWidgetItem* item) { Q_EMIT wanted(elementOf(item), false); });
    connect(this, &QTreeWidget::itemActivated, this,
            [this](QTreeWidgetItem* item) { Q_EMIT wanted(elementOf(item), true); });
}

NodeId OutlineList::elementOf(const QTreeWidgetItem* item) {
    return item ? item->data(0, elementRole).toUInt() : noNode;
}

NodeId OutlineList::current() const { return elementOf(currentItem()); }

void OutlineList::setMovable(bool on) {
    isMovable_ = on;
    setDragDropMode(on ? QAbstractItemView::InternalMove : QAbstractItemView::NoDragDrop);
}

// --- the entries -------------------------------------------------------------------------------

void OutlineList::show(const std::vector<Outline::Entry>& entries, Outline::Kind kind) {
    std::vector<Outline::Entry> shown;
    std::ranges::copy_if(entries, std::back_inserter(shown),
                         [kind](const Outline::Entry& one) { return one.kind == kind; });
    setRootIsDecorated(kind == Outline::Kind::heading);
    if (!isSameShape(shown)) {
        fill(shown);
    } else {
        for (std::size_t i = 0; i < shown.size(); ++i)
            if (shown[i].text != entries_[i].text)
                setText(i, shown[i].text);
    }
    entries_ = std::move(shown);
}

bool OutlineList::isSameShape(const std::vector<Outline::Entry>& entries) const {
    const auto isSame = [](const Outline::Entry& a, const Outline::Entry& b) {
        return a.kind == b.kind && a.level == b.level && a.element == b.element;
    };
    return std::ranges::equal(entries, entries_, isSame);
}

// An entry is inside the last one before it that is of an outer level.
void OutlineList::fill(const std::vector<Outline::Entry>& entries) {
    std::set<NodeId> folded;
    for (const QTreeWidgetItem* item : items_)
        if (item->childCount() > 0 && !item->isExpanded())
            folded.insert(elementOf(item));
    const NodeId last = current();
    const QSignalBlocker quiet(this);
    clear();
    items_.clear();
    std::vector<std::pair<int, QTreeWidgetItem*>> around;
    for (const Outline::Entry& entry : entries) {
        while (!around.empty() && around.back().first >= entry.level)
            around.pop_back();
        auto* item =
            around.empty() ? new QTreeWidgetItem(this) : new QTreeWidgetItem(around.back().second);
        ++rowsMade_;
        item->setData(0, elementRole, entry.element);
        around.emplace_back(entry.level, item);
        items_.push_back(item);
        setText(items_.size() - 1, entry.text);
    }
    for (QTreeWidgetItem* item : items_) {
        item->setExpanded(!folded.contains(elementOf(item)));
        if (last != noNode && elementOf(item) == last)
            setCurrentItem(item);
    }
}

void OutlineList::setText(std::size_t index, const std::string& text) {
    const QString shown = QString::fromStdString(text).simplified();
    items_[index]->setText(0, shown.isEmpty() ? tr("(empty)") : shown);
    items_[index]->setToolTip(0, plain::tip(shown));
}

void OutlineList::mark(NodeId element) {
    if (!hasFocus() || !currentItem())
        select(element);
}

// An entry inside a folded one is shown by that.
void OutlineList::select(NodeId element) {
    const auto found = std::ranges::find(entries_, element, &Outline::Entry::element);
    QTreeWidgetItem* item = found == entries_.end()
                                ? nullptr
                                : items_[static_cast<std::size_t>(found - entries_.begin())];
    QTreeWidgetItem* shown = item;
    for (QTreeWidgetItem* at = item; at != nullptr; at = at->parent())
        if (at->parent() && !at->parent()->isExpanded())
            shown = at->parent();
    if (shown == currentItem())
        return;
    setCurrentItem(shown);
    if (shown)
        scrollToItem(shown);
}

// --- commands ----------------------------------------------------------------------------------

void OutlineList::command(const QKeyCombination& keys) {
    if (keys == upKeys)
        Q_EMIT moveWanted(current(), Direction::backward);
    else if (keys == downKeys)
        Q_EMIT moveWanted(current(), Direction::forward);
    else if (keys == inKeys)
        Q_EMIT levelWanted(current(), 1);
    else if (keys == outKeys)
        Q_EMIT levelWanted(current(), -1);
}

void OutlineList::keyPressEvent(QKeyEvent* event) {
    const QKeyCombination keys = keysOf(*event);
    const bool isCommand = keys == upKeys || keys == downKeys || keys == inKeys || keys == outKeys;
    if (isCommand && isMovable_ && currentItem())
        command(keys);
    else if (event->key() == Qt::Key_Escape)
        Q_EMIT left();
    else
        QTreeWidget::keyPressEvent(event);
}

void OutlineList::contextMenuEvent(QContextMenuEvent* event) {
    if (!currentItem())
        return;
    auto* menu = new QMenu(this);
    menu->setObjectName("outlineMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const NodeId element = current();
    menu->addAction(tr("&Go There"), this, [this, element] { Q_EMIT wanted(element, true); });
    if (isMovable_) {
        menu->addSeparator();
        const auto add = [&](const QString& text, const QKeyCombination& keys) {
            menu->addAction(plain::ours(text), this, [this, keys] { command(keys); })
                ->setShortcut(QKeySequence(keys));
        };
        add(tr("Move &Up"), upKeys);
        add(tr("Move &Down"), downKeys);
        add(tr("A Level &In"), inKeys);
        add(tr("A Level &Out"), outKeys);
    }
    menu->addSeparator();
    menu->addAction(tr("&Unfold All"), this, &QTreeWidget::expandAll);
    menu->addAction(tr("&Fold All"), this, &QTreeWidget::collapseAll);
    menu->popup(event->globalPos());
}

// The list follows the document, which is what changes.
void OutlineList::dropEvent(QDropEvent* event) {
    const NodeId other = elementOf(itemAt(event->position().toPoint()));
    const NodeId moved = current();
    const DropIndicatorPosition where = dropIndicatorPosition();
    event->setDropAction(Qt::IgnoreAction);
    event->accept();
    setState(NoState);
    if (!isMovable_ || moved == noNode || moved == other)
        return;
    if (other == noNode)
        Q_EMIT dropped(moved,
                       items_.empty() ? noNode : elementOf(topLevelItem(topLevelItemCount() - 1)),
                       Beside::behind);
    else
        Q_EMIT dropped(moved, other,
                       where == OnItem      ? Beside::inside
                       : where == AboveItem ? Beside::before
                                            : Beside::behind);
}

} // namespace panes
