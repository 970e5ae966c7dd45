// Values of subdocuments in the line.
#include "authoring/commands.h"
#include "authoring/ids.h"

#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

namespace {

// The element that bears its ID; noNode: it is none.
NodeId bearerOf(const Manuscript& manuscript, NodeId figure) {
    const document::Subdocument* of =
        manuscript.document.subdocument(manuscript.document.subdocumentOf(figure));
    return of == nullptr ? noNode : of->classElement;
}

Attributes attributesOf(const std::string& id, const document::ValueUse& use) {
    return {{"OF", id},
            {"EXPRESSION", use.expression},
            {"FORMAT", use.digits == document::Digits{} ? "" : document::spelled(use.digits)},
            {"TIME", use.time ? document::spelledTime(*use.time) : ""}};
}

Result notThere() {
    return refused(QStringLiteral("The figure whose value was to be shown is not there any more."));
}

} // namespace

std::string idOf(const Manuscript& manuscript, NodeId figure) {
    const sgml::Tree& tree = manuscript.document.tree();
    const NodeId bearer = bearerOf(manuscript, figure);
    if (bearer == noNode)
        return {};
    const std::string id(tree.attribute(bearer, "ID").value_or(""));
    return id.empty() ? freeId(idsOf(tree), tree.name(bearer)) : id;
}

Result withIdOf(const Manuscript& manuscript, NodeId figure, Result result) {
    auto* step = std::get_if<Step>(&result);
    if (step == nullptr)
        return result;
    const sgml::Tree& tree = manuscript.document.tree();
    const NodeId bearer = bearerOf(manuscript, figure);
    if (bearer == noNode)
        return notThere();
    if (!tree.attribute(bearer, "ID").value_or("").empty())
        return result;
    for (text::Edit& edit : sgml::attributeEdit(tree, bearer, "ID", idOf(manuscript, figure))) {
        const bool isErased = std::ranges::any_of(step->edits, [&](const text::Edit& other) {
            return other.range.from <= edit.range.from && edit.range.to <= other.range.to &&
                   other.range.size() > 0;
        });
        if (isErased)
            return notThere();
        const std::size_t at = text::moved(edit.range.from, step->edits, text::Gravity::before);
        for (std::size_t* place : {&step->after.anchor, &step->after.caret})
            if (*place > at)
                *place += edit.text.size() - edit.range.size();
        step->edits.push_back(std::move(edit));
    }
    text::putInOrder(step->edits);
    return result;
}

Result insertValue(const Manuscript& manuscript, Selection selection, NodeId figure,
                   const document::ValueUse& use) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string id = idOf(manuscript, figure);
    if (id.empty())
        return notThere();
    makeCaret(draft, selection);
    const std::string name(draft.grammar().named(Display::value));
    if (name.empty())
        return refused(QStringLiteral("This class of documents shows no values of figures."));
    std::string attributes;
    for (const auto& [attribute, value] : attributesOf(id, use))
        if (!value.empty())
            attributes += " " + sgml::attributeText(attribute, value);
    const Piece* made = putInLine(draft, draft.first(), Draft::made(name, attributes));
    if (made == nullptr)
        return refused(mayNotStand(draft.grammar(), name));
    Draft::moveTo(draft.first(), *made->parent, made->index() + 1);
    draft.collapse();
    return withIdOf(manuscript, figure, draft.result(QStringLiteral("Value")));
}

Result changeValue(const Manuscript& manuscript, Selection selection, NodeId element, NodeId figure,
                   const document::ValueUse& use) {
    const std::string id = idOf(manuscript, figure);
    if (id.empty())
        return notThere();
    return withIdOf(manuscript, figure,
                    setAttributes(manuscript, selection, element, attributesOf(id, use),
                                  QStringLiteral("Value")));
}

} // namespace authoring
