#include "authoring/commands.h"
#include "authoring/table_draft.h"
#include "manuscript/leaves.h"
#include "manuscript/places.h"

#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using manuscript::Leaves, manuscript::placeBeside, manuscript::lineAround;

using schemas::ContainerRole;
using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

namespace {

class Eraser {
public:
    explicit Eraser(Draft& draft) : draft_(draft) {}

    void removeBetween() {
        Piece& a = draft_.first();
        Piece& b = draft_.second();
        Piece& top = Draft::common(a, b);
        removeBeside(a, top, Direction::forward);
        removeBeside(b, top, Direction::backward);
        Piece& from = Draft::branch(a, top);
        Piece& to = Draft::branch(b, top);
        removeAll(top, from.index() + 1, to.index());
    }

    // The line of the second mark goes on behind the first one.
    void join() {
        Piece& a = draft_.first();
        Piece& b = draft_.second();
        Piece& line = draft_.blockOf(b);
        Piece& top = Draft::common(a, b);
        draft_.openChildren(line);
        std::vector<Piece*> run;
        for (Piece* piece = &Draft::branch(b, line); piece != nullptr && draft_.isInLine(*piece);
             piece = piece->next())
            run.push_back(piece);
        Piece& onto = draft_.blockOf(a);
        std::size_t index = Draft::branch(a, onto).index() + 1;
        for (Piece* piece : run)
            Draft::moveTo(*piece, onto, index++);
        joined_ = run.back();
        if (&line != &top)
            settleRest(line, top);
    }

private:
    void removeBeside(Piece& mark, Piece& top, Direction direction) {
        for (Piece* level = &mark; level->parent != &top; level = level->parent) {
            Piece& parent = *level->parent;
            if (direction == Direction::forward)
                removeAll(parent, level->index() + 1, parent.children.size());
            else
                removeAll(parent, 0, level->index());
        }
    }

    // The children [from, to). Cells and rows stay, and so do the fields of a form: they lose their
    // text.
    void removeAll(Piece& parent, std::size_t from, std::size_t to) {
        for (std::size_t i = to; i-- > from;)
            if (parent.children[i]->kind == Piece::Kind::rest) {
                const std::size_t before = parent.children.size();
                draft_.openRestAll(*parent.children[i]);
                to += parent.children.size() - before;
            }
        const Display display = draft_.of(parent).display;
        const bool isGrid = display == Display::table || display == Display::row;
        for (std::size_t i = from; i < to; ++i) {
            Piece& piece = *parent.children[i];
            if (isGrid || isField(piece))
                clear(piece);
        }
        const auto goes = [&](const std::unique_ptr<Piece>& piece) {
            return !piece->isMark() && !isGrid && !isField(*piece);
        };
        const auto at = [&](std::size_t i) {
            return parent.children.begin() + static_cast<std::ptrdiff_t>(i);
        };
        parent.children.erase(std::remove_if(at(from), at(to), goes), at(to));
    }

    [[nodiscard]] bool isField(const Piece& piece) const {
        if (!piece.isElement())
            return false;
        const Element& known = draft_.of(piece);
        return known.display == Display::block && known.role == ContainerRole::none &&
               known.kind == Kind::block && known.holdsText;
    }

    void clear(Piece& piece) {
        if (!piece.isElement())
            return;
        draft_.openChildren(piece);
        if (draft_.holdsText(piece)) {
            piece.children.clear();
            return;
        }
        for (const auto& child : piece.children)
            clear(*child);
    }

    // Elements that the joined line has left: empty ones are removed, and those that are not valid
    // without the line follow it.
    void settleRest(Piece& line, Piece& top) {
        Piece* at = &line;
        while (at != &top) {
            Piece& parent = *at->parent;
            const bool isLine = at == &line;
            if (at->children.empty())
                Draft::take(*at);
            else if (isLine || !draft_.faultOf(*at).isEmpty())
                follow(*at);
            at = &parent;
        }
    }

    // The element's children come to stand behind the joined line, as far inside as they may.
    void follow(Piece& element) {
        Pieces children;
        while (!element.children.empty())
            children.push_back(Draft::take(*element.children.front()));
        Draft::take(element);
        if (children.empty())
            return;
        Piece* level = joined_->parent;
        Piece* beside = joined_;
        joined_ = children.back().get(); // what follows later follows these
        for (;;) {
            const std::size_t index = beside->index() + 1, count = children.size();
            for (std::size_t i = 0; i < count; ++i)
                Draft::put(*level, index + i, std::move(children[i]));
            if (draft_.faultOf(*level).isEmpty() || level->parent == nullptr)
                return;
            for (std::size_t i = 0; i < count; ++i)
                children[i] = Draft::take(*level->children[index]);
            beside = level;
            level = level->parent;
        }
    }

    Draft& draft_;
    Piece* joined_ = nullptr; // the last piece of what was joined
};

bool isLine(const Draft& draft, const Piece& piece) {
    const ContainerRole role = draft.of(piece).role;
    return draft.holdsText(piece) &&
           (role == ContainerRole::paragraph || role == ContainerRole::heading ||
            role == ContainerRole::item || role == ContainerRole::quote);
}

bool isWithin(const Piece& inner, const Piece& outer) {
    const Piece* at = &inner;
    while (at != nullptr && at != &outer)
        at = at->parent;
    return at != nullptr;
}

// Is a cell, a figure or the like between a piece and one that is around it?
bool isFenced(const Draft& draft, const Piece& inner, const Piece& outer) {
    for (const Piece* at = &inner; at != &outer; at = at->parent) {
        const Element& known = draft.of(*at);
        if (known.display == Display::cell || known.display == Display::row ||
            known.display == Display::table || known.display == Display::footnote ||
            known.role == ContainerRole::figure)
            return true;
    }
    return false;
}

// A figure that lost what it shows goes, too.
void pruneFigure(Draft& draft, Piece& mark) {
    Piece* figure = around(draft, mark, ContainerRole::figure);
    if (figure == nullptr || !draft.isBroken(*figure))
        return;
    const std::size_t index = figure->index();
    for (Piece* other : {&draft.second(), &draft.first()})
        if (around(draft, *other, ContainerRole::figure) == figure)
            Draft::moveTo(*other, *figure->parent, index);
    Draft::take(*figure);
}

} // namespace

bool mayJoin(Draft& draft) {
    Piece& a = draft.first();
    Piece& b = draft.second();
    Piece& one = draft.blockOf(a);
    Piece& other = draft.blockOf(b);
    Piece& top = Draft::common(a, b);
    // Blocks in an inlined element, which no class allows.
    if (!isWithin(one, top) || !isWithin(other, top))
        return false;
    if (&one == &other || isFenced(draft, one, top) || isFenced(draft, other, top))
        return false;
    return (isLine(draft, one) || (&one == &top && draft.holdsText(one))) &&
           (isLine(draft, other) || (&other == &top && draft.holdsText(other)));
}

void eraseBetween(Draft& draft) {
    if (TableDraft(draft).clear())
        return;
    const bool joins = mayJoin(draft);
    Eraser eraser(draft);
    eraser.removeBetween();
    if (joins)
        eraser.join();
    pruneFigure(draft, draft.first());
    pruneFigure(draft, draft.second());
}

void makeCaret(Draft& draft, const Selection& selection) {
    if (!selection.isEmpty())
        eraseBetween(draft);
    draft.collapse();
}

namespace {

Result eraseSelection(const Manuscript& manuscript, Selection selection, const QString& label,
                      bool isTyping) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    eraseBetween(draft);
    draft.collapse();
    return draft.result(label, isTyping);
}

// Both places in one content, which keeps some text: its bytes between them.
std::optional<Step> eraseInContent(const Manuscript& manuscript, Selection selection) {
    const sgml::Tree& tree = manuscript.document.tree();
    const std::size_t from = std::min(selection.anchor, selection.caret),
                      to = std::max(selection.anchor, selection.caret);
    const Leaves leaves(manuscript, from);
    const NodeId leaf = leaves.isText() ? leaves.at(from) : noNode;
    if (leaf == noNode || !leaves.isContent(leaf) || to > leaves.lastPlace(leaf))
        return std::nullopt;
    if (from == leaves.firstPlace(leaf) && to == leaves.lastPlace(leaf))
        return std::nullopt;
    const sgml::Unescaped text = tree.unescaped(leaf);
    Step step;
    step.edits = sgml::contentEdit(tree, leaf, {text.textOffset(from), text.textOffset(to)}, {});
    const std::size_t after = text::moved(from, step.edits, text::Gravity::before);
    step.after = {after, after};
    return step;
}

} // namespace

namespace {

// "" when what is between the places is within a line, or in two lines that may be joined.
QString whyNotJoined(const Manuscript& manuscript, Selection selection) {
    const Leaves leaves(manuscript, selection.caret);
    if (leaves.blockOf(leaves.at(selection.caret)) == leaves.blockOf(leaves.at(selection.anchor)))
        return {};
    Draft draft(manuscript, selection);
    if (QString why = draft.obstacle(); !why.isEmpty())
        return why;
    if (mayJoin(draft))
        return {};
    return QStringLiteral("The lines on both sides of the caret cannot be joined.");
}

} // namespace

namespace {

// Is the caret at the start of the first item of a list?
bool beginsList(const Manuscript& manuscript, Selection selection) {
    if (lineAround(manuscript, selection.caret).anchor != selection.caret)
        return false;
    Draft draft(manuscript, selection);
    if (!draft.obstacle().isEmpty())
        return false;
    Piece& line = draft.blockOf(draft.first());
    Piece* item = draft.of(line).role == ContainerRole::item ? &line : line.parent;
    if (item == nullptr || item->parent == nullptr || draft.of(*item).role != ContainerRole::item ||
        draft.of(*item->parent).role != ContainerRole::list)
        return false;
    draft.openBeside(*item);
    const Piece& first = item == &line ? Draft::branch(draft.first(), *item) : line;
    const auto isNothing = [](const Piece* before) {
        while (before != nullptr && (before->isMark() || before->isEmptyText()))
            before = before->previous();
        return before == nullptr;
    };
    return isNothing(item->previous()) && isNothing(first.previous());
}

} // namespace

Result erase(const Manuscript& manuscript, Selection selection, Direction direction, Unit unit) {
    const bool isTyping = selection.isEmpty();
    if (isTyping && direction == Direction::backward && beginsList(manuscript, selection))
        return outdentItems(manuscript, selection);
    if (isTyping) {
        const std::optional<std::size_t> beside =
            placeBeside(manuscript, selection.caret, direction, unit);
        if (!beside)
            return refused(direction == Direction::forward
                               ? QStringLiteral("The text ends here.")
                               : QStringLiteral("The text begins here."));
        selection.anchor = *beside;
        // A figure, a formula, a footnote may be much work: the first key selects it.
        const Leaves leaves(manuscript, selection.caret);
        const NodeId leaf = leaves.at(*beside);
        if (leaf != noNode && leaves.isUnit(leaf))
            return Step{.after = direction == Direction::forward
                                     ? Selection{leaves.firstPlace(leaf), leaves.lastPlace(leaf)}
                                     : Selection{leaves.lastPlace(leaf), leaves.firstPlace(leaf)},
                        .label = QStringLiteral("Selection")};
        if (const QString why = whyNotJoined(manuscript, selection); !why.isEmpty())
            return refused(why);
    }
    const QString label = isTyping ? QStringLiteral("Typing") : QStringLiteral("Erasing");
    if (std::optional<Step> step = eraseInContent(manuscript, selection)) {
        step->label = label;
        step->isTyping = isTyping;
        return *std::move(step);
    }
    return eraseSelection(manuscript, selection, label, isTyping);
}

} // namespace authoring
