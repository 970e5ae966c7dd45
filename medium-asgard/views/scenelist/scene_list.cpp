#include "scenelist/scene_list.h"

#include "editing/changes.h"
#include "plain/plain.h"
#include "scenelist/element_label.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace views {

using editing::Element;
using editing::Kind;

namespace {

constexpr int kindRole = Qt::UserRole, indexRole = Qt::UserRole + 1;

std::optional<Element> elementOf(const QTreeWidgetItem& item) {
    const QVariant kind = item.data(0, kindRole);
    if (!kind.isValid())
        return std::nullopt;
    return Element{static_cast<Kind>(kind.toInt()), item.data(0, indexRole).toULongLong()};
}

// A ring parts it from the row, which is of any colour where it is selected.
QIcon swatch(QRgb color, const QPalette& palette) {
    QPixmap pixels(24, 24);
    pixels.fill(Qt::transparent);
    QPainter painter(&pixels);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette.color(QPalette::Base));
    painter.drawEllipse(QRectF(0, 0, 24, 24));
    painter.setPen(QPen(QColor(128, 128, 128), 1.5));
    painter.setBrush(QColor(color));
    painter.drawEllipse(QRectF(4, 4, 16, 16));
    return QIcon(pixels);
}

// An eye, closed where the body is hidden.
QIcon eye(bool isOpen, const QPalette& palette) {
    QPixmap pixels(32, 32);
    pixels.fill(Qt::transparent);
    QPainter painter(&pixels);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette.color(isOpen ? QPalette::Text : QPalette::PlaceholderText), 2.4,
                        Qt::SolidLine, Qt::RoundCap));
    QPainterPath lid;
    lid.moveTo(4, 16);
    lid.quadTo(16, 28, 28, 16);
    if (isOpen)
        lid.quadTo(16, 4, 4, 16);
    painter.drawPath(lid);
    if (isOpen) {
        painter.setBrush(palette.color(QPalette::Text));
        painter.drawEllipse(QPointF(16, 16), 3.6, 3.6);
    }
    return QIcon(pixels);
}

} // namespace

SceneList::SceneList(SceneDocument& document, SceneListActions actions, QWidget* parent)
    : QWidget(parent), document_(document), actions_(std::move(actions)), commands_(document),
      filter_(new QLineEdit), order_(new QComboBox), tree_(new QTreeWidget),
      fault_(plain::label()) {
    setObjectName(QStringLiteral("sceneList"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(6);
    auto* line = new QHBoxLayout;
    filter_->setPlaceholderText(tr("Filter"));
    filter_->setAccessibleName(tr("Filter of the scene list"));
    filter_->setClearButtonEnabled(true);
    order_->addItem(tr("By kind"));
    order_->addItem(tr("By text"));
    order_->setAccessibleName(tr("Order of the scene list"));
    filter_->setMinimumWidth(filter_->fontMetrics().averageCharWidth() * 10);
    line->addWidget(filter_, 1);
    line->addWidget(order_);
    column->addLayout(line);
    buildTree();
    column->addWidget(tree_, 1);
    fault_->setWordWrap(true);
    fault_->hide();
    column->addWidget(fault_);
    soon_.setSingleShot(true);
    soon_.setInterval(30); // a drag changes the scene often
    connect(&soon_, &QTimer::timeout, this, &SceneList::refresh);
    connect(filter_, &QLineEdit::textChanged, this, &SceneList::narrow);
    connect(order_, &QComboBox::activated, this, [this] {
        entries_ = entries(); // the scene may be another than a moment ago
        rebuild();
    });
    connect(&document_, &SceneDocument::sceneChanged, this, [this] {
        if (isVisible())
            soon_.start();
    });
    connect(&document_, &SceneDocument::selectionChanged, this, [this] {
        say({});
        if (isVisible())
            showSelection();
    });
    refresh();
}

void SceneList::buildTree() {
    tree_->setObjectName(QStringLiteral("elements"));
    tree_->setAccessibleName(tr("Elements of the scene"));
    tree_->setHeaderHidden(true);
    tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    tree_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
    tree_->setContextMenuPolicy(Qt::CustomContextMenu);
    tree_->setUniformRowHeights(true);
    tree_->setIndentation(14);
    tree_->setColumnCount(2);
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    connect(tree_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item, int column) {
        const auto element = elementOf(*item);
        if (column == 1 && element && element->kind == Kind::body && actions_.hide)
            actions_.hide(*element, !actions_.isHidden(*element));
    });
    tree_->installEventFilter(this);
    tree_->viewport()->installEventFilter(this);
    connect(tree_, &QTreeWidget::itemSelectionChanged, this, &SceneList::takeSelection);
    connect(tree_, &QTreeWidget::itemChanged, this, &SceneList::rename);
    connect(tree_, &QTreeWidget::itemDoubleClicked, this,
            [this](QTreeWidgetItem* item, int column) {
                if (const auto element = elementOf(*item); element && column == 0)
                    actions_.openValues(*element);
            });
    connect(tree_, &QWidget::customContextMenuRequested, this, [this](const QPoint& place) {
        QTreeWidgetItem* item = tree_->itemAt(place);
        if (const auto element = item ? elementOf(*item) : std::nullopt)
            actions_.showMenu(*element, tree_->viewport()->mapToGlobal(place));
    });
}

void SceneList::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

QTreeWidgetItem* SceneList::itemOf(const Element& element) const {
    for (QTreeWidgetItemIterator at(tree_); *at; ++at)
        if (elementOf(**at) == element)
            return *at;
    return nullptr;
}

QString SceneList::fault() const { return fault_->isHidden() ? QString() : fault_->text(); }

std::vector<SceneList::Entry> SceneList::entries() const {
    const scene::Scene& scene = *document_.shown().scene;
    std::vector<Entry> entries;
    for (const Element& element : editing::elementsOf(scene)) {
        const auto color = colorOf(scene, element);
        entries.push_back({element, labelOf(scene, element), groupOf(scene, element),
                           QString::fromStdString(editing::describe(scene, element)),
                           editing::sourceOf(scene, element)->command.from,
                           color ? color->rgb() : 0});
    }
    std::vector<Entry*> inText;
    inText.reserve(entries.size());
    for (Entry& entry : entries)
        inText.push_back(&entry);
    std::ranges::stable_sort(inText, {}, &Entry::place);
    for (std::size_t i = 0; i < inText.size(); ++i)
        inText[i]->place = i;
    return entries;
}

void SceneList::refresh() {
    std::vector<Entry> now = entries();
    if (now == entries_ && tree_->topLevelItemCount() > 0)
        return showSelection();
    entries_ = std::move(now);
    rebuild();
}

QTreeWidgetItem* SceneList::addEntry(const Entry& entry, QTreeWidgetItem* group) {
    auto* item = new QTreeWidgetItem(QStringList{entry.label});
    item->setData(0, kindRole, static_cast<int>(entry.element.kind));
    item->setData(0, indexRole, QVariant::fromValue<qulonglong>(entry.element.index));
    item->setToolTip(0, plain::tip(entry.tip));
    if (!editing::nameOf(*document_.shown().scene, entry.element).empty())
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    if (entry.color != 0)
        item->setIcon(0, swatch(entry.color, palette()));
    showEye(item);
    if (group)
        group->addChild(item);
    else
        tree_->addTopLevelItem(item);
    return item;
}

void SceneList::showEye(QTreeWidgetItem* item) {
    const auto element = elementOf(*item);
    if (!element || element->kind != Kind::body || !actions_.isHidden)
        return;
    const bool isHidden = actions_.isHidden(*element);
    item->setIcon(1, eye(!isHidden, palette()));
    item->setToolTip(1, isHidden ? tr("Hidden in the picture; a click shows it")
                                 : tr("A click hides it in the picture"));
    item->setData(1, Qt::AccessibleTextRole, isHidden ? tr("hidden") : tr("shown"));
    item->setForeground(0, palette().color(isHidden ? QPalette::PlaceholderText : QPalette::Text));
}

void SceneList::showHidden() {
    isBuilding_ = true;
    for (QTreeWidgetItemIterator at(tree_); *at; ++at)
        showEye(*at);
    isBuilding_ = false;
}

// Groups that were folded stay so.
void SceneList::rebuild() {
    QStringList folded;
    for (int i = 0; i < tree_->topLevelItemCount(); ++i)
        if (const QTreeWidgetItem* one = tree_->topLevelItem(i);
            one->childCount() > 0 && !one->isExpanded())
            folded << one->data(0, Qt::UserRole + 2).toString();
    isBuilding_ = true;
    tree_->clear();
    std::vector<Entry> all = entries_;
    const bool byKind = order_->currentIndex() == 0;
    if (!byKind)
        std::ranges::stable_sort(all, {}, &Entry::place);
    std::map<QString, QTreeWidgetItem*> groups;
    for (const Entry& entry : all) {
        QTreeWidgetItem*& group = groups[entry.group];
        if (byKind && !group) {
            group = new QTreeWidgetItem(tree_);
            group->setFlags(Qt::ItemIsEnabled);
            group->setData(0, Qt::UserRole + 2, entry.group);
        }
        addEntry(entry, group);
    }
    for (const auto& [name, group] : groups)
        if (group) {
            group->setText(0, tr("%1 (%2)").arg(name).arg(group->childCount()));
            group->setExpanded(!folded.contains(name));
        }
    isBuilding_ = false;
    narrow();
    showSelection();
}

// Groups without a match go, too.
void SceneList::narrow() {
    const QString wanted = filter_->text().trimmed();
    const auto matches = [&](const QTreeWidgetItem& item) {
        return wanted.isEmpty() || item.text(0).contains(wanted, Qt::CaseInsensitive);
    };
    for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* top = tree_->topLevelItem(i);
        bool any = matches(*top) && elementOf(*top).has_value();
        const bool all = matches(*top); // "spring" shows all springs
        for (int j = 0; j < top->childCount(); ++j) {
            const bool shown = all || matches(*top->child(j));
            top->child(j)->setHidden(!shown);
            any = any || shown;
        }
        top->setHidden(!any);
    }
}

void SceneList::showSelection() {
    if (isBuilding_)
        return;
    isBuilding_ = true;
    const auto& selected = document_.selected();
    QTreeWidgetItem* first = nullptr;
    for (QTreeWidgetItemIterator at(tree_); *at; ++at) {
        const auto element = elementOf(**at);
        const bool is = element && std::ranges::find(selected, *element) != selected.end();
        if ((*at)->isSelected() != is)
            (*at)->setSelected(is);
        if (is && !first)
            first = *at;
    }
    if (first && !tree_->hasFocus()) {
        tree_->setCurrentItem(first, 0, QItemSelectionModel::NoUpdate);
        tree_->scrollToItem(first);
    }
    isBuilding_ = false;
}

void SceneList::takeSelection() {
    if (isBuilding_)
        return;
    std::vector<Element> elements;
    for (const QTreeWidgetItem* item : tree_->selectedItems())
        if (const auto element = elementOf(*item))
            elements.push_back(*element);
    document_.select(std::move(elements));
}

void SceneList::rename(QTreeWidgetItem* item) {
    const auto element = elementOf(*item);
    if (isBuilding_ || !element)
        return;
    const QString name = item->text(0).trimmed();
    isBuilding_ = true; // what is there until the text says so
    item->setText(0, labelOf(*document_.shown().scene, *element));
    isBuilding_ = false;
    commands_.rename(*element, name, [this](const QString& why) { say(why); });
}

void SceneList::say(const QString& why) {
    fault_->setText(why);
    fault_->setVisible(!why.isEmpty());
}

bool SceneList::eventFilter(QObject* watched, QEvent* event) {
    if (watched == tree_->viewport() && event->type() == QEvent::MouseButtonPress) {
        const bool extends = static_cast<QMouseEvent*>(event)->modifiers() != Qt::NoModifier ||
                             tree_->selectedItems().size() > 1; // one of them is meant
        tree_->setEditTriggers(extends ? QAbstractItemView::EditKeyPressed
                                       : QAbstractItemView::EditKeyPressed |
                                             QAbstractItemView::SelectedClicked);
    }
    const bool isShortcut = event->type() == QEvent::ShortcutOverride;
    if (watched != tree_ || (event->type() != QEvent::KeyPress && !isShortcut))
        return QWidget::eventFilter(watched, event);
    const auto* pressed = static_cast<QKeyEvent*>(event);
    const int key = pressed->key();
    if (isShortcut) { // it has its ways through the rows; letters are the window's, as everywhere
        constexpr int ways[] = {Qt::Key_Up,     Qt::Key_Down,  Qt::Key_Left,   Qt::Key_Right,
                                Qt::Key_Home,   Qt::Key_End,   Qt::Key_PageUp, Qt::Key_PageDown,
                                Qt::Key_Return, Qt::Key_Enter, Qt::Key_Delete};
        const bool isOurs = !(pressed->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) &&
                            std::ranges::find(ways, key) != std::end(ways);
        event->setAccepted(isOurs);
        return isOurs;
    }
    if (key == Qt::Key_Delete && !document_.selected().empty()) {
        actions_.remove(document_.selected());
        return true;
    }
    const QTreeWidgetItem* item = tree_->currentItem();
    const auto element = item ? elementOf(*item) : std::nullopt;
    const bool asks = (key == Qt::Key_Return || key == Qt::Key_Enter) && element;
    if (asks)
        actions_.openValues(*element);
    return asks || QWidget::eventFilter(watched, event);
}

} // namespace views
