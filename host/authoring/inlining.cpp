// Elements in a line: emphasis, links, and what stands between letters.
#include "authoring/commands.h"
#include "authoring/wrapper.h"
#include "manuscript/leaves.h"
#include "manuscript/places.h"

#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using manuscript::place, manuscript::placeBeside;

using schemas::ContainerRole;
using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

namespace {

// The word around a caret; the caret itself where it stands in none.
Selection withWord(const Manuscript& manuscript, Selection selection) {
    if (!selection.isEmpty())
        return selection;
    // The places of words have the blanks between them, too.
    const auto unlessBlank = [&](Selection word) {
        const std::string_view bytes = manuscript.document.tree().text({word.anchor, word.caret});
        return bytes.find_first_of(" \t\r\n") == bytes.npos ? word : selection;
    };
    const std::size_t caret = selection.caret;
    const std::size_t end =
        placeBeside(manuscript, caret, Direction::forward, Unit::word).value_or(caret);
    const std::size_t start =
        placeBeside(manuscript, end, Direction::backward, Unit::word).value_or(caret);
    if (start <= caret && caret <= end)
        return unlessBlank({start, end});
    // Right behind a word, the way forward leads to the end of the next one.
    const std::size_t before =
        placeBeside(manuscript, caret, Direction::backward, Unit::word).value_or(caret);
    const bool endsHere =
        placeBeside(manuscript, before, Direction::forward, Unit::word).value_or(caret) == caret;
    return endsHere ? unlessBlank({before, caret}) : selection;
}

// A command without a selection leaves none: the caret stays in its word, or at the end of it where
// it was.
Result caretKept(Result result, Selection before, Selection word) {
    auto* step = std::get_if<Step>(&result);
    if (step == nullptr || !before.isEmpty())
        return result;
    const std::size_t caret = before.caret;
    const bool isTouched = std::ranges::any_of(step->edits, [caret](const text::Edit& edit) {
        return edit.range.from <= caret && caret <= edit.range.to;
    });
    if (!isTouched)
        step->after.caret = text::moved(caret, step->edits, text::Gravity::behind);
    else if (caret == word.anchor)
        step->after.caret = step->after.anchor;
    step->after.anchor = step->after.caret;
    return result;
}

} // namespace

bool isMarked(const Manuscript& manuscript, Selection selection, ContainerRole role) {
    Draft draft(manuscript, selection);
    if (!draft.obstacle().isEmpty())
        return false;
    const Wrapper::Wanted wanted = [&](const Piece& piece) { return draft.of(piece).role == role; };
    if (!selection.isEmpty()) {
        const Wrapper wrapper(draft, wanted);
        return wrapper.hasText() && wrapper.isAllInside();
    }
    for (Piece* at = draft.caret().parent; at != nullptr && draft.isInlined(*at); at = at->parent)
        if (wanted(*at))
            return true;
    return false;
}

Result toggle(const Manuscript& manuscript, Selection selection, ContainerRole role) {
    const Selection word = withWord(manuscript, selection);
    Draft draft(manuscript, word);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string name(draft.grammar().named(role));
    if (name.empty())
        return refused(QStringLiteral("This class of documents has no such element."));
    Wrapper wrapper(draft, [&](const Piece& piece) { return draft.of(piece).role == role; });
    if (!wrapper.hasText())
        return refused(QStringLiteral("Select the text first."));
    if (wrapper.isAllInside())
        wrapper.unwrap();
    else
        wrapper.wrap(name, {});
    const QString label = role == ContainerRole::emphasis ? QStringLiteral("Emphasis")
                          : role == ContainerRole::strong ? QStringLiteral("Strong Emphasis")
                                                          : QStringLiteral("Code");
    return caretKept(draft.result(label), selection, word);
}

namespace {

// Its address is its text.
Result insertLink(const Manuscript& manuscript, Selection selection, std::string_view target) {
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    std::unique_ptr<Piece> piece = Draft::made(std::string(draft.grammar().named(Display::link)),
                                               " " + sgml::attributeText("TO", target));
    Draft::put(*piece, 0, Draft::madeText(target));
    Piece* made = putInLine(draft, draft.first(), std::move(piece));
    if (made == nullptr)
        return refused(QStringLiteral("A link may not stand here."));
    Draft::moveTo(draft.first(), *made->parent, made->index() + 1);
    draft.collapse();
    return draft.result(QStringLiteral("Link"));
}

} // namespace

std::optional<LinkAround> linkAround(const Manuscript& manuscript, Selection selection) {
    const sgml::Tree& tree = manuscript.document.tree();
    const Grammar* grammar = manuscript.grammars.of(tree.name(tree.root()));
    const std::size_t first = std::min(selection.anchor, selection.caret);
    const std::size_t last = std::max(selection.anchor, selection.caret);
    for (NodeId id = tree.innermostAt(first); grammar != nullptr && id != noNode;
         id = tree.node(id).parent) {
        if (!tree.isElement(id) || grammar->of(tree.name(id)).display != Display::link)
            continue;
        const text::Range range = tree.node(id).range;
        if (last > range.to)
            return std::nullopt;
        const auto from = place(manuscript, tree.node(id).startTag.to, Direction::forward);
        const auto to = place(manuscript, range.to, Direction::backward);
        if (!from || !to || *from > *to)
            return std::nullopt;
        return LinkAround{std::string(tree.attribute(id, "TO").value_or(std::string_view())),
                          {*from, *to}};
    }
    return std::nullopt;
}

Result link(const Manuscript& manuscript, Selection selection, std::string_view target) {
    const Selection word = withWord(manuscript, selection);
    Draft draft(manuscript, word);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string name(draft.grammar().named(Display::link));
    if (name.empty())
        return refused(QStringLiteral("This class of documents has no links."));
    Wrapper wrapper(draft,
                    [&](const Piece& piece) { return draft.of(piece).display == Display::link; });
    if (!wrapper.hasText())
        return target.empty() ? refused(QStringLiteral("There is no link here."))
                              : insertLink(manuscript, selection, target);
    wrapper.unwrap();
    if (!target.empty())
        wrapper.wrap(name, " " + sgml::attributeText("TO", target));
    return caretKept(draft.result(QStringLiteral("Link")), selection, word);
}

Piece* putInLine(Draft& draft, Piece& mark, std::unique_ptr<Piece> piece) {
    if (!makeLine(draft, mark))
        return nullptr;
    draft.settle(mark);
    while (!allows(draft, *mark.parent, mark.index(), piece->name)) {
        if (!draft.isInlined(*mark.parent))
            return nullptr;
        draft.split(mark, *mark.parent->parent);
        Draft::moveTo(mark, *mark.parent->parent, mark.parent->index());
    }
    return &Draft::put(*mark.parent, mark.index(), std::move(piece));
}

Result insertFootnote(const Manuscript& manuscript, Selection selection) {
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string name(draft.grammar().named(Display::footnote));
    if (name.empty())
        return refused(QStringLiteral("This class of documents has no footnotes."));
    Piece* note = putInLine(draft, draft.first(), Draft::made(name));
    if (note == nullptr)
        return refused(QStringLiteral("A footnote may not stand here."));
    Draft::moveTo(draft.first(), *note, 0);
    draft.collapse();
    if (!makeLine(draft, draft.first()))
        return refused(QStringLiteral("This class of documents has no text in footnotes."));
    draft.collapse();
    return draft.result(QStringLiteral("Footnote"));
}

} // namespace authoring
