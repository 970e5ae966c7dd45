#include "authoring/commands.h"
#include "authoring/fields.h"
#include "manuscript/gaps.h"
#include "manuscript/leaves.h"

#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using manuscript::Leaves;

using schemas::ContainerRole;
using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

// --- what may stand where -------------------------------------------------------------------

std::vector<std::string> allowedAt(Draft& draft, Piece& parent, std::size_t index) {
    return draft.grammar().allowedAt(parent.name, draft.childrenOf(parent),
                                     draft.childrenOf(parent, index).size());
}

bool allows(Draft& draft, Piece& parent, std::size_t index, std::string_view name) {
    const std::vector<std::string> allowed = allowedAt(draft, parent, index);
    return std::find(allowed.begin(), allowed.end(), name) != allowed.end();
}

Piece* around(Draft& draft, Piece& piece, ContainerRole role) {
    Piece* at = piece.isElement() ? &piece : piece.parent;
    while (at != nullptr && draft.of(*at).role != role)
        at = at->parent;
    return at;
}

namespace {

// The elements to make in an element, outermost first, until there is one that holds text.
std::vector<std::string> wayToText(const Grammar& grammar, const std::string& name) {
    std::vector<std::string> way{name};
    while (way.size() < 4 && !grammar.of(way.back()).holdsText) {
        const std::vector<std::string> inside = grammar.allowedAt(way.back(), {}, 0);
        const auto next =
            std::find_if(inside.begin(), inside.end(), [&](const std::string& candidate) {
                return candidate != "TEXT" && grammar.of(candidate).kind == Kind::block;
            });
        if (next == inside.end())
            return {};
        way.push_back(*next);
    }
    return way;
}

void fill(Draft& draft, Piece& mark, const std::vector<std::string>& way, Piece& parent,
          std::size_t index, const Piece* like) {
    Piece* made = &parent;
    for (const std::string& name : way) {
        made = &Draft::put(*made, made == &parent ? index : 0, Draft::made(name));
        if (made->parent == &parent && like != nullptr && like->isElement())
            draft.putOnLine(*made, *like);
    }
    Draft::moveTo(mark, *made, 0);
}

} // namespace

namespace {

bool hasBefore(const Piece& piece) {
    const Piece* before = piece.previous();
    while (before != nullptr && before->isMark())
        before = before->previous();
    return before != nullptr;
}

bool hasBehind(const Piece& piece) {
    const Piece* behind = piece.next();
    while (behind != nullptr && behind->isMark())
        behind = behind->next();
    return behind != nullptr;
}

} // namespace

bool makeLine(Draft& draft, Piece& mark) {
    const std::string paragraph(draft.grammar().named(ContainerRole::paragraph));
    Piece* parent = &draft.blockOf(mark);
    if (draft.holdsText(*parent))
        return true;
    Piece* beside = &mark;
    bool isBehind = true; // nothing but the mark was before it in what is around it: in front
    for (; parent != nullptr; beside = parent, parent = parent->parent) {
        const std::size_t index = beside->index() + (isBehind ? 1 : 0);
        draft.openBeside(*beside);
        isBehind = isBehind && (hasBefore(*beside) || !hasBehind(*beside));
        const Piece* like = beside == &mark ? mark.previous() : beside;
        if (like == nullptr)
            like = mark.next();
        if (!paragraph.empty() && allows(draft, *parent, index, paragraph)) {
            fill(draft, mark, {paragraph}, *parent, index, like);
            return true;
        }
        if (!draft.isBlank(*parent))
            continue;
        for (const std::string& name : allowedAt(draft, *parent, index)) {
            const std::vector<std::string> way = wayToText(draft.grammar(), name);
            if (way.empty() || draft.grammar().of(name).kind != Kind::block)
                continue;
            fill(draft, mark, way, *parent, index, like);
            return true;
        }
    }
    return false;
}

// --- typing ---------------------------------------------------------------------------------

std::string withLineEnds(std::string_view text, bool isVerbatim) {
    std::string line(text);
    for (std::size_t at = 0; (at = line.find("\r\n", at)) != std::string::npos;)
        line.erase(at, 1);
    std::replace(line.begin(), line.end(), '\r', '\n');
    if (!isVerbatim)
        std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

namespace {

// A caret in a content: the text comes in there.
std::optional<Step> typeInContent(const Manuscript& manuscript, std::size_t caret,
                                  std::string_view text) {
    const Leaves leaves(manuscript, caret);
    const NodeId leaf = leaves.isText() ? leaves.at(caret) : noNode;
    if (leaf == noNode || !leaves.isContent(leaf))
        return std::nullopt;
    const sgml::Tree& tree = manuscript.document.tree();
    const sgml::Unescaped unescaped = tree.unescaped(leaf);
    const std::size_t at = unescaped.textOffset(caret);
    Step step;
    step.edits =
        sgml::contentEdit(tree, leaf, {at, at}, withLineEnds(text, leaves.isVerbatim(leaf)));
    const std::size_t after = text::moved(caret, step.edits, text::Gravity::behind);
    step.after = {after, after};
    return step;
}

} // namespace

Result type(const Manuscript& manuscript, Selection selection, std::string_view text) {
    const QString label = QStringLiteral("Typing");
    if (selection.isEmpty())
        if (std::optional<Step> step = typeInContent(manuscript, selection.caret, text)) {
            step->label = label;
            step->isTyping = true;
            return *std::move(step);
        }
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    if (!selection.isEmpty())
        eraseBetween(draft);
    Piece& caret = draft.first();
    if (!makeLine(draft, caret))
        return refused(QStringLiteral("Text may not stand here."));
    draft.settle(caret);
    const bool isVerbatim = draft.of(draft.blockOf(caret)).display == Display::verbatim;
    Draft::put(*caret.parent, caret.index(), Draft::madeText(withLineEnds(text, isVerbatim)));
    draft.collapse();
    return draft.result(label, true);
}

Piece* paragraphBehind(Draft& draft, Piece& block) {
    const std::string paragraph(draft.grammar().named(ContainerRole::paragraph));
    if (paragraph.empty() || !allows(draft, *block.parent, block.index() + 1, paragraph))
        return nullptr;
    Piece& made = Draft::put(*block.parent, block.index() + 1, Draft::made(paragraph));
    draft.putOnLine(made, block);
    return &made;
}

// --- Enter ----------------------------------------------------------------------------------

namespace {

class Breaker {
public:
    explicit Breaker(Draft& draft) : draft_(draft), grammar_(draft.grammar()) {}

    // "" when it is done; else the reason why not.
    QString breakLine() {
        Piece& caret = draft_.first();
        Piece& block = draft_.blockOf(caret);
        const Element& known = draft_.of(block);
        if (known.display == Display::verbatim) {
            Draft::put(*caret.parent, caret.index(), Draft::madeText("\n"));
            return {};
        }
        if (known.role == ContainerRole::heading)
            return breakHeading(block);
        if (Piece* item = around(draft_, block, ContainerRole::item);
            item != nullptr && (item == &block || block.parent == item)) {
            if (draft_.isBlank(*item))
                return leaveList(*item);
            if (item == &block || isOnly(block)) {
                draft_.split(caret, *item->parent);
                return {};
            }
        }
        if (known.role == ContainerRole::paragraph || known.role == ContainerRole::quote) {
            draft_.split(caret, *block.parent);
            return {};
        }
        return breakOther(block);
    }

private:
    [[nodiscard]] bool isAtEnd() { return draft_.isLineBlank(draft_.first(), Direction::forward); }

    [[nodiscard]] static bool isOnly(const Piece& block) {
        const Pieces& all = block.parent->children;
        return std::none_of(all.begin(), all.end(), [&](const auto& piece) {
            return piece.get() != &block && !piece->isMark();
        });
    }

    [[nodiscard]] std::string paragraph() const {
        return std::string(grammar_.named(ContainerRole::paragraph));
    }

    QString breakHeading(Piece& heading) {
        Piece* made = paragraphBehind(draft_, heading);
        if (made == nullptr)
            return QStringLiteral("A paragraph may not follow this heading.");
        Piece& right = draft_.split(draft_.first(), *heading.parent);
        if (&right != made)
            while (!right.children.empty())
                Draft::moveTo(*right.children.front(), *made, made->children.size());
        Draft::take(right);
        return {};
    }

    // The list falls in two around the empty item. The text that follows is an item of the list
    // around it, or a paragraph.
    QString leaveList(Piece& item) {
        Piece& list = *item.parent;
        if (list.parent == nullptr)
            return QStringLiteral("This item is in no list.");
        Piece* outer = around(draft_, *list.parent, ContainerRole::item);
        Piece& stop = outer == nullptr || outer->parent == nullptr ? *list.parent : *outer->parent;
        const std::string name = outer == nullptr ? paragraph() : outer->name;
        Piece& behind = draft_.split(item, stop);
        Piece& made = Draft::put(stop, behind.index(), Draft::made(name));
        draft_.putOnLine(made, behind);
        Draft::moveTo(draft_.first(), made, 0);
        draft_.collapse();
        Piece& parent = *item.parent;
        Draft::take(item);
        removeEmpty(parent, stop);
        removeEmpty(list, stop);
        return draft_.faultOf(stop);
    }

    static void removeEmpty(Piece& piece, Piece& stop) {
        Piece* at = &piece;
        while (at != &stop && at->children.empty()) {
            Piece& parent = *at->parent;
            Draft::take(*at);
            at = &parent;
        }
    }

    // Text that stands in a cell, a footnote or the like without a paragraph gets two of them. What
    // is one line only is left at its end.
    QString breakOther(Piece& block) {
        if (!paragraph().empty() && allowsOnly(block)) {
            Piece& caret = draft_.first();
            Piece &right = Draft::branch(caret, block), &first = firstOfLine(right);
            Piece& made = Draft::put(block, first.index(), Draft::made(paragraph()));
            for (Piece* next = made.next(); next != nullptr && draft_.isInLine(*next);
                 next = made.next())
                Draft::moveTo(*next, made, made.children.size());
            draft_.split(caret, block);
            return {};
        }
        if (!isAtEnd())
            return QStringLiteral("This field takes one line only.");
        for (Piece* beside = &block; beside->parent != nullptr; beside = beside->parent)
            if (Piece* made = paragraphBehind(draft_, *beside)) {
                Draft::moveTo(draft_.first(), *made, 0);
                return {};
            }
        return QStringLiteral("A paragraph may not follow here.");
    }

    [[nodiscard]] bool allowsOnly(const Piece& block) const {
        return grammar_.whyNot(block.name, {paragraph(), paragraph()}).isEmpty();
    }

    Piece& firstOfLine(Piece& piece) {
        Piece* first = &piece;
        draft_.openChildren(*piece.parent);
        while (first->previous() != nullptr && draft_.isInLine(*first->previous()))
            first = first->previous();
        return *first;
    }

    Draft& draft_;
    const Grammar& grammar_;
};

} // namespace

QString breakLine(Draft& draft) { return Breaker(draft).breakLine(); }

Result breakLine(const Manuscript& manuscript, Selection selection) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    makeCaret(draft, selection);
    if (draft.of(draft.blockOf(draft.first())).display != Display::verbatim)
        return refused(
            QStringLiteral("There are no line breaks within a paragraph of this class."));
    Draft::put(*draft.first().parent, draft.first().index(), Draft::madeText("\n"));
    return draft.result(QStringLiteral("Typing"), true);
}

Result breakParagraph(const Manuscript& manuscript, Selection selection) {
    const QString label = QStringLiteral("New Paragraph");
    if (std::optional<Step> step = goToEmptyLine(manuscript, selection))
        return *std::move(step);
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    makeCaret(draft, selection);
    const bool isInLine = draft.holdsText(draft.blockOf(draft.first()));
    if (!makeLine(draft, draft.first()))
        return refused(QStringLiteral("A paragraph may not stand here."));
    draft.collapse();
    if (!isInLine)
        return draft.result(label); // beside a unit: a paragraph is there now
    if (const QString why = breakLine(draft); !why.isEmpty()) {
        if (std::optional<Step> step = goToNextLine(manuscript, selection))
            return *std::move(step);
        return refused(why);
    }
    draft.collapse();
    return draft.result(label);
}

// --- behind the end -------------------------------------------------------------------------

// Enter leads out of lists.
Result goBehindEnd(const Manuscript& manuscript, Selection selection) {
    const std::size_t end = manuscript::everything(manuscript, selection.caret).caret;
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    Piece* last = nullptr;
    for (Piece* at = draft.first().parent; at->parent != nullptr; at = at->parent)
        last = manuscript::isClosed(draft.of(*at)) ? at : last;
    if (last == nullptr && draft.holdsText(draft.blockOf(draft.first())))
        return refused(QStringLiteral("The document ends with a line for text already."));
    Piece* made = nullptr;
    for (; last != nullptr && last->parent != nullptr && made == nullptr; last = last->parent)
        made = paragraphBehind(draft, *last);
    if (made != nullptr)
        Draft::moveTo(draft.first(), *made, 0);
    else if (!makeLine(draft, draft.first()))
        return refused(QStringLiteral("A paragraph may not follow here."));
    draft.collapse();
    return draft.result(QStringLiteral("New Paragraph"));
}

// --- into and out of an element -------------------------------------------------------------

Result typeToggled(const Manuscript& manuscript, Selection selection, std::string_view text,
                   ContainerRole role) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string name(draft.grammar().named(role));
    if (name.empty())
        return refused(QStringLiteral("This class of documents has no such element."));
    makeCaret(draft, selection);
    Piece& caret = draft.first();
    if (!makeLine(draft, caret))
        return refused(QStringLiteral("Text may not stand here."));
    draft.settle(caret);
    Piece* inside = caret.parent;
    while (draft.isInlined(*inside) && draft.of(*inside).role != role)
        inside = inside->parent;
    std::unique_ptr<Piece> piece = Draft::madeText(withLineEnds(text, false));
    if (draft.isInlined(*inside)) {
        // Between the halves of the element, which is left.
        Piece& right = draft.split(caret, *inside->parent);
        Piece& made = Draft::put(*right.parent, right.index(), Draft::made("TEXT"));
        Draft::put(made, 0, std::move(piece));
        Draft::moveTo(caret, made, 1);
        if (draft.isBlank(right))
            draft.dissolve(right);
    } else {
        Piece* made = putInLine(draft, caret, Draft::made(name));
        if (made == nullptr)
            return refused(QStringLiteral("It may not stand here."));
        Draft::put(*made, 0, std::move(piece));
        Draft::moveTo(caret, *made, 1);
    }
    draft.collapse();
    return draft.result(QStringLiteral("Typing"), true);
}

} // namespace authoring
