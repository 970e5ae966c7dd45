// Figures: nested documents that come in, go, and get other attributes.
#include "authoring/commands.h"

#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using schemas::ContainerRole;
using sgml::NodeId;
using sgml::noNode;

namespace {

std::unique_ptr<Piece> embeddedPiece(const EmbeddedText& embedded) {
    std::unique_ptr<Piece> document = Draft::made("DOCUMENT");
    std::string attributes;
    for (const auto& [name, value] : embedded.attributes)
        attributes += " " + sgml::attributeText(name, value);
    document->raw = "<DOCUMENT>\nDOCUMENT " + embedded.className + "\n<" + embedded.className +
                    attributes + ">\n" + sgml::elementText(embedded.storage, embedded.text) +
                    "\n</" + embedded.className + ">\n</DOCUMENT>";
    return document;
}

// An empty one behind what the figure has; null: the class has none there.
Piece* putCaption(Draft& draft, Piece& figure) {
    const std::string name(draft.grammar().named(ContainerRole::caption));
    if (name.empty() || !allows(draft, figure, figure.children.size(), name))
        return nullptr;
    Piece& made = Draft::put(figure, figure.children.size(), Draft::made(name));
    made.gap.fresh = figure.tail.fresh = "\n";
    return &made;
}

QString notThere() { return QStringLiteral("What was to be changed is not there any more."); }

bool isElementOf(const sgml::Tree& tree, NodeId node) {
    return node != noNode && tree.holds(node) && tree.isElement(node);
}

} // namespace

Result insertFigure(const Manuscript& manuscript, Selection selection,
                    const EmbeddedText& embedded) {
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string name(draft.grammar().named(ContainerRole::figure));
    Piece* const figure =
        name.empty() ? nullptr : putBlock(draft, draft.first(), Draft::made(name));
    Piece* made = nullptr;
    if (figure != nullptr) {
        made = &Draft::put(*figure, 0, embeddedPiece(embedded));
        made->gap.fresh = figure->tail.fresh = "\n";
    } else {
        made = putBlock(draft, draft.first(), embeddedPiece(embedded));
    }
    if (made == nullptr)
        return refused(QStringLiteral("A figure may not stand here."));
    if (Piece* const caption = figure == nullptr ? nullptr : putCaption(draft, *figure))
        Draft::moveTo(draft.first(), *caption, 0);
    else
        Draft::moveTo(draft.first(), *made->parent, made->index() + 1);
    draft.collapse();
    return draft.result(QStringLiteral("Figure"));
}

NodeId wholeFigure(const Manuscript& manuscript, NodeId element) {
    const sgml::Tree& tree = manuscript.document.tree();
    const Grammar* grammar = nullptr;
    for (NodeId id = tree.node(element).parent; id != noNode && grammar == nullptr;
         id = tree.node(id).parent)
        if (tree.node(id).kind == sgml::NodeKind::document)
            grammar = manuscript.grammars.of(tree.name(id));
    const NodeId around = tree.node(element).parent;
    if (grammar == nullptr || !tree.isElement(around) ||
        grammar->of(tree.name(around)).role != ContainerRole::figure)
        return element;
    for (NodeId id = tree.node(around).firstChild; id != noNode; id = tree.node(id).next)
        if (id != element && tree.isElement(id) &&
            grammar->of(tree.name(id)).role != ContainerRole::caption)
            return element; // it shows something else, too
    return around;
}

Result removeElement(const Manuscript& manuscript, NodeId element, const QString& label) {
    const sgml::Tree& tree = manuscript.document.tree();
    if (!isElementOf(tree, element))
        return refused(notThere());
    const std::size_t at = tree.node(element).range.from;
    Draft draft(manuscript, {at, at});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    if (!draft.isInside(element))
        return refused(notThere());
    Piece& gone = draft.opened(element);
    for (Piece* mark : {&draft.first(), &draft.second()})
        Draft::moveTo(*mark, *gone.parent, gone.index());
    Draft::take(gone);
    draft.collapse();
    return draft.result(label);
}

Result setAttributes(const Manuscript& manuscript, Selection selection, sgml::NodeId element,
                     const Attributes& attributes, const QString& label) {
    const sgml::Tree& tree = manuscript.document.tree();
    if (!tree.holds(element) || !tree.isElement(element))
        return refused(QStringLiteral("What was to be changed is not there any more."));
    Step step;
    for (const auto& [name, value] : attributes)
        for (text::Edit& edit : value.empty() ? sgml::attributeRemoval(tree, element, name)
                                              : sgml::attributeEdit(tree, element, name, value)) {
            const auto same =
                std::find_if(step.edits.begin(), step.edits.end(), [&](const text::Edit& other) {
                    return other.range.from == edit.range.from && other.range.to == edit.range.to;
                });
            if (same == step.edits.end())
                step.edits.push_back(std::move(edit));
            else
                same->text += edit.text; // both behind the last attribute
        }
    std::sort(step.edits.begin(), step.edits.end(), [](const text::Edit& a, const text::Edit& b) {
        return std::pair(a.range.from, a.range.to) < std::pair(b.range.from, b.range.to);
    });
    const auto follow = [&](std::size_t place) {
        return text::moved(place, step.edits, text::Gravity::before);
    };
    step.after = {follow(selection.anchor), follow(selection.caret)};
    step.label = label;
    return step;
}

} // namespace authoring
