#include "panes/outline_pane.h"

#include "panes/making_room.h"
#include "panes/outline_list.h"
#include "plain/plain.h"
#include "view/text_hand.h"
#include "view/writing.h"

#include <QComboBox>
#include <QScrollBar>
#include <QVBoxLayout>

namespace panes {

using authoring::Manuscript;
using sgml::NodeId, sgml::noNode;

namespace {

// While one types, the list follows that often.
constexpr int delayMs = 150;

} // namespace

OutlinePane::OutlinePane(view::DocumentView& view, QWidget* parent)
    : QDockWidget(tr("Outline"), parent), view_(view), list_(new OutlineList(this)),
      kind_(new QComboBox(this)) {
    setObjectName("outline");
    setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea);
    build();
    timer_.setSingleShot(true);
    timer_.setInterval(delayMs);
    connect(&timer_, &QTimer::timeout, this, &OutlinePane::follow);
    connect(&view_, &view::DocumentView::laidOut, this, &OutlinePane::followSoon);
    connect(view_.verticalScrollBar(), &QScrollBar::valueChanged, this, &OutlinePane::mark);
    connect(&view_, &view::DocumentView::writingChanged, this,
            [this] { list_->setMovable(view_.isWriting() && kind_->currentIndex() == 0); });
    connect(kind_, &QComboBox::currentIndexChanged, this, &OutlinePane::fill);
    connect(list_, &OutlineList::wanted, this, &OutlinePane::goTo);
    connect(list_, &OutlineList::left, this, [this] { view_.setFocus(); });
    connect(list_, &OutlineList::moveWanted, this,
            [this](NodeId heading, authoring::Direction direction) {
                move([=](const Manuscript& in) {
                    return authoring::moveSection(in, heading, direction);
                });
            });
    connect(list_, &OutlineList::levelWanted, this, [this](NodeId heading, int by) {
        move([=](const Manuscript& in) { return authoring::changeLevel(in, heading, by); });
    });
    connect(list_, &OutlineList::dropped, this,
            [this](NodeId heading, NodeId other, authoring::Beside where) {
                move([=](const Manuscript& in) {
                    return authoring::moveSection(in, heading, other, where);
                });
            });
}

void OutlinePane::build() {
    kind_->setObjectName("outlineKind");
    kind_->setAccessibleName(tr("What the outline lists"));
    kind_->addItems({tr("Headings"), tr("Figures"), tr("Tables")}); // as Outline::Kind
    auto* inside = new QWidget(this);
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(kind_);
    column->addWidget(list_, 1);
    setWidget(inside);
    setFocusProxy(list_);
    new MakingRoom(*this, view_);
    toggleViewAction()->setObjectName("showOutline");
    toggleViewAction()->setText(tr("Out&line"));
    toggleViewAction()->setShortcut(QKeySequence(Qt::Key_F9));
}

void OutlinePane::showEvent(QShowEvent* event) {
    QDockWidget::showEvent(event);
    follow();
}

// --- in step with the document ---------------------------------------------------------------

void OutlinePane::followSoon() {
    if (isVisible() && !timer_.isActive())
        timer_.start();
}

void OutlinePane::follow() {
    if (outline_.follow(view_.model()))
        fill();
    mark();
}

void OutlinePane::fill() {
    const int kind = std::max(0, kind_->currentIndex());
    list_->setMovable(view_.isWriting() && kind == 0);
    list_->show(outline_.entries(), static_cast<model::Outline::Kind>(kind));
}

// The last entry that begins at or before a place.
NodeId OutlinePane::entryAt(std::size_t place) const {
    const sgml::Tree& tree = view_.document().document().tree();
    const auto kind = static_cast<model::Outline::Kind>(std::max(0, kind_->currentIndex()));
    NodeId last = noNode;
    for (const model::Outline::Entry& entry : outline_.entries())
        if (entry.kind == kind && tree.holds(entry.element) &&
            tree.node(entry.element).range.from <= place)
            last = entry.element;
    return last;
}

// That of the first line that is seen well.
void OutlinePane::mark() {
    if (!isVisible() || view_.pages().pages.empty())
        return;
    const sgml::Tree& tree = view_.document().document().tree();
    const auto [page, point] =
        view_.pagePointAt({view_.viewport()->width() / 2.0, 3 * view::PagePlaces::margin});
    const auto spot = places::spotAt(view_.pages(), {page, point.y()});
    if (spot && tree.holds(spot->block->element))
        list_->mark(entryAt(tree.node(spot->block->element).range.from));
}

// --- what its entries do -----------------------------------------------------------------------

void OutlinePane::goTo(NodeId element, bool toWrite) {
    view_.goToElement(element);
    if (toWrite)
        view_.setFocus();
}

// The caret stands in the heading then, whose element is a new one.
void OutlinePane::move(const Command& command) {
    view_.settle();
    const bool isDone = view_.writing().perform(
        [&](const Manuscript& in, authoring::Selection) { return command(in); });
    if (!isDone)
        return;
    view_.settle();
    follow();
    if (const std::optional<document::Selection> caret = view_.text().cursor().selection())
        list_->select(entryAt(caret->caret));
}

} // namespace panes
