// Values of subdocuments in the line.
#include "authoring/commands.h"
#include "authoring/ids.h"

#include "sgml/edit.h"

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

QString isGone() {
    return QStringLiteral("The figure whose value was to be shown is not there any more.");
}

Result notThere() { return refused(isGone()); }

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
    const NodeId bearer = bearerOf(manuscript, figure);
    if (bearer == noNode)
        return std::holds_alternative<Step>(result) ? notThere() : result;
    return withId(manuscript, bearer, idOf(manuscript, figure), std::move(result), isGone());
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
