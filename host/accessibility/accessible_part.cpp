#include "accessibility/accessible_part.h"

#include "accessibility/accessible_table.h"
#include "accessibility/accessible_text.h"
#include "accessibility/accessible_view.h"
#include "reading/block_text.h"
#include "view/document_view.h"
#include "view/folds.h"

namespace accessibility {

using reading::Part;
using view::DocumentView;
using Kind = Part::Kind;
using schemas::ContainerRole;

namespace {

// Qt owns the interface until this takes it away.
struct Registered : Part::Companion {
    explicit Registered(QAccessibleInterface* interface)
        : id(QAccessible::registerAccessibleInterface(interface)) {}
    ~Registered() override { QAccessible::deleteAccessibleInterface(id); }
    QAccessible::Id id;
};

QAccessibleInterface* made(AccessibleView& root, Part& part) {
    switch (part.kind) {
    case Kind::text:
        return new AccessibleText(root, part);
    case Kind::table:
        return new AccessibleTable(root, part);
    case Kind::cell:
        return new AccessibleCell(root, part);
    case Kind::figure:
    case Kind::link:
        return new AccessibleActivePart(root, part);
    default:
        return nullptr;
    }
}

} // namespace

QAccessibleInterface* AccessiblePart::of(AccessibleView& root, Part& part) {
    if (part.kind == Kind::document)
        return &root;
    if (!part.companion) {
        QAccessibleInterface* own = made(root, part);
        part.companion = std::make_unique<Registered>(own ? own : new AccessiblePart(root, part));
    }
    return QAccessible::accessibleInterface(static_cast<Registered&>(*part.companion).id);
}

// --- what is around it and in it ---------------------------------------------------------------

const document::Document& AccessiblePart::document() const {
    return root_.view().document().document();
}

const std::vector<std::unique_ptr<Part>>& AccessiblePart::parts() const {
    return root_.tree().partsOf(part_);
}

QWindow* AccessiblePart::window() const { return root_.window(); }

QAccessibleInterface* AccessiblePart::parent() const { return of(root_, *part_.parent); }

QAccessibleInterface* AccessiblePart::child(int index) const {
    const auto at = static_cast<std::size_t>(index);
    return index >= 0 && at < parts().size() ? of(root_, *parts()[at]) : nullptr;
}

int AccessiblePart::childCount() const { return static_cast<int>(parts().size()); }

int AccessiblePart::indexOfChild(const QAccessibleInterface* child) const {
    const auto* inside = dynamic_cast<const AccessiblePart*>(child);
    return inside && inside->part_.parent == &part_
               ? static_cast<int>(root_.tree().indexOf(inside->part_))
               : -1;
}

QAccessibleInterface* AccessiblePart::childAt(int x, int y) const {
    for (const std::unique_ptr<Part>& part : parts()) {
        QAccessibleInterface* inside = of(root_, *part);
        if (inside->rect().contains(x, y))
            return inside;
    }
    return nullptr;
}

// --- what it is --------------------------------------------------------------------------------

namespace {

QAccessible::Role roleOf(ContainerRole role) {
    switch (role) {
    case ContainerRole::section:
        return QAccessible::Section;
    case ContainerRole::list:
        return QAccessible::List;
    case ContainerRole::item:
        return QAccessible::ListItem;
    case ContainerRole::caption:
        return QAccessible::StaticText;
    default:
        return QAccessible::Grouping;
    }
}

} // namespace

const model::Run* AccessiblePart::run() const {
    return part_.runs > 0 ? &part_.block->runs[part_.run] : nullptr;
}

document::SubdocumentId AccessiblePart::subdocument() const {
    if (part_.kind != Kind::figure)
        return document::noSubdocument;
    return run() ? run()->subdocument : part_.block->subdocument;
}

QAccessible::Role AccessiblePart::role() const {
    switch (part_.kind) {
    case Kind::text:
        if (part_.block->headingLevel > 0)
            return QAccessible::Heading;
        return part_.role == ContainerRole::none ? QAccessible::Paragraph : roleOf(part_.role);
    case Kind::contents:
        return QAccessible::List;
    case Kind::formula:
        return QAccessible::Equation;
    case Kind::figure: {
        const media::LiveSubdocument* live = root_.view().document().live(subdocument());
        if (part_.block->kind == model::BlockKind::chart)
            return QAccessible::Chart;
        return live && live->time() ? QAccessible::Animation : QAccessible::Graphic;
    }
    case Kind::separator:
        return QAccessible::Separator;
    case Kind::table:
        return QAccessible::Table;
    case Kind::cell:
        return part_.place.row < part_.block->headerRows ? QAccessible::ColumnHeader
                                                         : QAccessible::Cell;
    case Kind::note:
        return QAccessible::Note;
    case Kind::link:
        return QAccessible::Link;
    default:
        return roleOf(part_.role);
    }
}

QAccessible::State AccessiblePart::state() const {
    QAccessible::State state;
    const bool isText = part_.kind == Kind::text;
    state.focusable = isText || part_.kind == Kind::figure || part_.kind == Kind::link;
    state.focused = root_.view().hasFocus() && root_.focused() == &part_;
    state.multiLine = isText;
    state.selectableText = isText;
    state.editable = isText && root_.view().isWriting();
    state.readOnly = !root_.view().isWriting();
    state.linked = part_.kind == Kind::link;
    if (isText && part_.block->headingLevel > 0) {
        session::FoldedPages& pages = root_.view().folds().pages();
        state.expandable = pages.isFoldable(part_.element);
        state.collapsed = pages.isFolded(part_.element);
        state.expanded = state.expandable && !state.collapsed;
    }
    const QRect seen = rect();
    state.offscreen = seen.isEmpty() || !root_.rect().intersects(seen);
    return state;
}

// A section is called as its heading, a figure and a table as its caption.
QString AccessiblePart::name() const {
    const auto wordsOf = [this](const Part& part) {
        return reading::BlockText(document(), part.block).text().trimmed();
    };
    switch (part_.kind) {
    case Kind::text:
        return part_.block->headingLevel > 0 ? wordsOf(part_) : QString();
    case Kind::formula:
        return run() ? reading::wordsFor(document(), *run()) : wordsOf(part_);
    case Kind::figure:
        return run() ? reading::wordsFor(document(), *run())
                     : reading::wordsFor(document(), *part_.block);
    case Kind::note:
        return DocumentView::tr("Footnote %1").arg(QString::fromStdString(part_.note->number));
    case Kind::link: {
        QString words;
        for (std::size_t i = 0; i < part_.runs; ++i)
            words += reading::wordsFor(document(), part_.block->runs[part_.run + i]);
        return words;
    }
    case Kind::separator:
        return part_.block->kind == model::BlockKind::pageBreak ? DocumentView::tr("Page break")
                                                                : QString();
    case Kind::table:
        return part_.parent->role == ContainerRole::table ||
                       part_.parent->role == ContainerRole::figure
                   ? of(root_, *part_.parent)->text(QAccessible::Name)
                   : QString();
    case Kind::cell: {
        QStringList words;
        for (const std::shared_ptr<const model::Block>& block : *part_.flow.blocks)
            words += reading::BlockText(document(), block).text();
        return words.join(' ');
    }
    case Kind::container:
        for (const std::unique_ptr<Part>& part : parts())
            if (part->kind == Kind::text &&
                (part_.role == ContainerRole::section ? part->block->headingLevel > 0
                                                      : part->role == ContainerRole::caption))
                return wordsOf(*part);
        return {};
    default:
        return {};
    }
}

QString AccessiblePart::text(QAccessible::Text of) const {
    if (of == QAccessible::Name)
        return name();
    if (of == QAccessible::Description && role() == QAccessible::Heading)
        return DocumentView::tr("Level %1").arg(part_.block->headingLevel);
    return {};
}

// --- where it stands ---------------------------------------------------------------------------

QRect AccessiblePart::onScreen(const QRectF& rect) const {
    const QRect on = rect.toAlignedRect();
    return {root_.view().viewport()->mapToGlobal(on.topLeft()), on.size()};
}

// As its parts do; what is in a line, as its letters.
QRect AccessiblePart::rect() const {
    if (const document::SubdocumentId id = subdocument())
        return onScreen(root_.view().placeOf(id));
    if (part_.kind == Kind::link || (run() && part_.kind == Kind::formula))
        return of(root_, *part_.parent)->rect();
    if (parts().empty()) {
        const sgml::Tree& tree = document().tree();
        if (part_.element == sgml::noNode || !tree.holds(part_.element))
            return {};
        for (std::size_t i = 0; const auto& page : root_.view().pages().pages) {
            for (const layout::PlacedObject& object : page->objects)
                if (object.element == part_.element)
                    return onScreen(root_.view().inViewport(i, object.rect));
            ++i;
        }
        return {};
    }
    const QRect first = of(root_, *parts().front())->rect();
    return parts().size() == 1 ? first : first | of(root_, *parts().back())->rect();
}

// --- what is done with it ----------------------------------------------------------------------

void* AccessibleActivePart::interface_cast(QAccessible::InterfaceType type) {
    if (type == QAccessible::ActionInterface)
        return static_cast<QAccessibleActionInterface*>(this);
    return AccessiblePart::interface_cast(type);
}

QStringList AccessibleActivePart::actionNames() const { return {pressAction()}; }

void AccessibleActivePart::doAction(const QString& name) {
    if (name != pressAction())
        return;
    DocumentView& view = root().view();
    const model::Run* run = part().runs > 0 ? &part().block->runs[part().run] : nullptr;
    if (part().kind == Kind::link)
        view.follow(QString::fromStdString(run->target));
    else if (const auto id = run ? run->subdocument : part().block->subdocument)
        view.choose(id);
}

} // namespace accessibility
