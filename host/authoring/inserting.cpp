// Blocks that come in at the caret, captions, references.
#include "authoring/commands.h"
#include "authoring/ids.h"
#include "manuscript/grammar.h"
#include "manuscript/leaves.h"

#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using manuscript::called;

using schemas::ContainerRole;
using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

QString mayNotStand(const Grammar& grammar, std::string_view name) {
    QString what = called(grammar, name);
    what[0] = what[0].toUpper();
    return QStringLiteral("%1 may not stand here.").arg(what);
}

Piece* putBlock(Draft& draft, Piece& mark, std::unique_ptr<Piece>&& piece) {
    Piece& line = draft.blockOf(mark);
    const bool atStart = draft.isLineBlank(mark, Direction::backward);
    const bool atEnd = draft.isLineBlank(mark, Direction::forward);
    const bool isEmptyParagraph =
        draft.of(line).role == ContainerRole::paragraph && draft.isBlank(line);
    for (Piece* at = &mark; at->parent != nullptr; at = at->parent) {
        Piece& parent = *at->parent;
        draft.openBeside(*at);
        // In front of a line at whose start the mark stands, else behind it.
        const bool before = atStart && !atEnd;
        if (draft.isInlined(parent) ||
            !allows(draft, parent, at->index() + (before ? 0 : 1), piece->name))
            continue;
        if (at != &mark && !atStart && !atEnd)
            draft.split(mark, parent);
        Piece& made = Draft::put(parent, at->index() + (before ? 0 : 1), std::move(piece));
        draft.putOnLine(made, at == &mark ? parent : *at);
        if (before && !at->isMark())
            std::swap(made.gap, at->gap);
        if (isEmptyParagraph && at == &line) {
            made.gap = line.gap;
            for (Piece* moved : {&draft.second(), &draft.first()})
                Draft::moveTo(*moved, parent, made.index() + 1);
            Draft::take(line);
        }
        return &made;
    }
    return nullptr;
}

namespace {

// A table and a footnote are on pages as they fall. "": a page may end there.
QString whyNoPageEnds(Draft& draft, std::string_view name) {
    for (const Piece* at = draft.first().parent; at != nullptr; at = at->parent) {
        const Display display = draft.of(*at).display;
        if (display != Display::table && display != Display::footnote)
            continue;
        QString what = called(draft.grammar(), name);
        what[0] = what[0].toUpper();
        return QStringLiteral("%1 may not stand in %2.")
            .arg(what, called(draft.grammar(), at->name));
    }
    return {};
}

} // namespace

Result insertBlock(const Manuscript& manuscript, Selection selection, std::string_view name,
                   std::string_view attributes) {
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    if (!draft.grammar().knows(name))
        return refused(QStringLiteral("This class of documents has no such element."));
    if (name == "DOCUMENT" || draft.grammar().of(name).kind == Kind::inlined)
        return refused(mayNotStand(draft.grammar(), name));
    const bool endsPage = draft.grammar().of(name).display == Display::pageBreak;
    const bool isAtEnd = draft.isLineBlank(draft.first(), Direction::forward);
    if (const QString why = endsPage ? whyNoPageEnds(draft, name) : QString(); !why.isEmpty())
        return refused(why);
    Piece* made =
        putBlock(draft, draft.first(), Draft::made(std::string(name), std::string(attributes)));
    if (made == nullptr)
        return refused(mayNotStand(draft.grammar(), name));
    if (!draft.isUnit(*made)) {
        Draft::moveTo(draft.first(), *made, 0);
        if (!makeLine(draft, draft.first()))
            return refused(mayNotStand(draft.grammar(), name));
        draft.collapse();
    } else if (Piece* line = endsPage && isAtEnd ? paragraphBehind(draft, *made) : nullptr) {
        Draft::moveTo(draft.first(), *line, 0);
        draft.collapse();
    }
    return draft.result(QStringLiteral("Insert"));
}

namespace {

// The line that was empty goes on below what stands alone in it, and not above.
void goOnBelow(Piece& alone) {
    Piece& line = *alone.parent;
    for (std::size_t i = alone.index(); i-- > 0;)
        if (line.children[i]->isEmptyText())
            Draft::take(*line.children[i]);
    Draft::put(line, alone.index() + 1, Draft::madeText({}));
}

} // namespace

Result insertFormula(const Manuscript& manuscript, Selection selection, std::string_view source,
                     std::string_view kind) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    makeCaret(draft, selection);
    const std::string name(draft.grammar().named(Display::formula));
    if (name.empty())
        return refused(QStringLiteral("This class of documents has no formulas."));
    const bool wasEmpty = !kind.empty() && draft.isLineBlank(draft.first(), Direction::backward) &&
                          draft.isLineBlank(draft.first(), Direction::forward);
    std::unique_ptr<Piece> formula = Draft::made(name, std::string(kind));
    Draft::put(*formula, 0, Draft::madeText(source));
    Piece* made = kind.empty() ? putInLine(draft, draft.first(), std::move(formula))
                               : putBlock(draft, draft.first(), std::move(formula));
    if (made == nullptr)
        return refused(mayNotStand(draft.grammar(), name));
    Draft::moveTo(draft.first(), *made->parent, made->index() + 1);
    draft.collapse();
    if (wasEmpty && draft.holdsText(*made->parent))
        goOnBelow(*made);
    return draft.result(QStringLiteral("Formula"));
}

Result setText(const Manuscript& manuscript, NodeId element, std::string_view text) {
    const sgml::Tree& tree = manuscript.document.tree();
    if (!tree.holds(element) || !tree.isElement(element))
        return refused(QStringLiteral("What was to be changed is not there any more."));
    const NodeId content = tree.content(element);
    if (content == noNode && tree.node(element).firstChild != noNode)
        return refused(QStringLiteral("This holds more than text."));
    Step step;
    const std::size_t start = tree.node(element).startTag.to;
    if (content == noNode)
        step.edits = {{{start, start}, "{" + sgml::escaped(text) + "}"}};
    else
        step.edits =
            sgml::contentEdit(tree, content, {0, tree.unescaped(content).text().size()}, text);
    const std::size_t after =
        text::moved(tree.node(element).range.to, step.edits, text::Gravity::behind);
    step.after = {after, after};
    step.label = QStringLiteral("Formula");
    return step;
}

Result insertCaption(const Manuscript& manuscript, Selection selection) {
    Draft draft(manuscript, {selection.caret, selection.caret});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string caption(draft.grammar().named(ContainerRole::caption));
    for (Piece* at = draft.first().parent; at != nullptr; at = at->parent) {
        if (caption.empty() || !draft.grammar().mayHold(at->name, caption))
            continue;
        draft.openChildren(*at);
        const auto isCaption = [&](const auto& child) {
            return child->isElement() && child->name == caption;
        };
        const auto known = std::find_if(at->children.begin(), at->children.end(), isCaption);
        Piece* made = known == at->children.end() ? nullptr : known->get();
        for (std::size_t i = at->children.size() + 1; made == nullptr && i-- > 0;)
            if (allows(draft, *at, i, caption)) {
                made = &Draft::put(*at, i, Draft::made(caption));
                if (i > 0)
                    draft.putOnLine(*made, *at);
            }
        if (made == nullptr)
            continue;
        Draft::moveTo(draft.first(), *made, made->children.size());
        draft.collapse();
        return draft.result(QStringLiteral("Caption"));
    }
    return refused(QStringLiteral("Nothing here takes a caption."));
}

// --- references -----------------------------------------------------------------------------

namespace {} // namespace

Result withId(const Manuscript& manuscript, NodeId element, const std::string& id, Result result,
              const QString& isErased) {
    auto* step = std::get_if<Step>(&result);
    const sgml::Tree& tree = manuscript.document.tree();
    if (step == nullptr || !tree.attribute(element, "ID").value_or("").empty())
        return result;
    for (text::Edit& edit : sgml::attributeEdit(tree, element, "ID", id)) {
        const bool goes = std::ranges::any_of(step->edits, [&](const text::Edit& other) {
            return other.range.from <= edit.range.from && edit.range.to <= other.range.to &&
                   other.range.size() > 0;
        });
        if (goes)
            return refused(isErased);
        const std::size_t at = text::moved(edit.range.from, step->edits, text::Gravity::before);
        for (std::size_t* place : {&step->after.anchor, &step->after.caret})
            if (*place > at)
                *place += edit.text.size() - edit.range.size();
        step->edits.push_back(std::move(edit));
    }
    text::putInOrder(step->edits);
    return result;
}

// --- moving ---------------------------------------------------------------------------------

Result moveElement(const Manuscript& manuscript, NodeId element, NodeId beside, Direction side) {
    const sgml::Tree& tree = manuscript.document.tree();
    if (!tree.holds(element) || !tree.holds(beside) || !tree.isElement(element) ||
        !tree.isElement(beside))
        return refused(QStringLiteral("What was to be moved is not there any more."));
    for (NodeId id = beside; id != noNode; id = tree.node(id).parent)
        if (id == element)
            return refused(QStringLiteral("An element cannot be moved into itself."));
    const std::size_t at = tree.node(element).startTag.to;
    const std::size_t place = manuscript::place(manuscript, at, Direction::forward).value_or(at);
    Draft draft(manuscript, {place, place});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    if (!draft.isInside(element) || !draft.isInside(beside))
        return refused(QStringLiteral("What was to be moved is in another document."));
    Piece& moved = draft.opened(element);
    Piece& other = draft.opened(beside);
    moved.isCopied = true;
    Draft::moveTo(moved, *other.parent, other.index() + (side == Direction::forward ? 1 : 0));
    return draft.result(QStringLiteral("Move"));
}

// --- what is allowed ------------------------------------------------------------------------

std::vector<std::string> allowedAt(const Manuscript& manuscript, std::size_t place) {
    Draft draft(manuscript, {place, place});
    if (!draft.obstacle().isEmpty())
        return {};
    std::vector<std::string> names;
    for (Piece* at = &draft.first(); at->parent != nullptr; at = at->parent)
        for (const std::string& name : allowedAt(draft, *at->parent, at->index() + 1))
            if (name != "TEXT" && std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
    return names;
}

} // namespace authoring
