// References: to which elements they may lead, how they name them, how they come in and change.
#include "authoring/commands.h"
#include "authoring/ids.h"
#include "manuscript/line_text.h"
#include "schemas/number_pattern.h"
#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

namespace {

// Some elements have a number only with an attribute, such as a formula that stands alone.
bool isNumbered(const sgml::Tree& tree, const Grammar& grammar, NodeId element) {
    const Element& known = grammar.of(tree.name(element));
    const auto& variants = grammar.variants(tree.name(element));
    const bool isPlain = std::none_of(variants.begin(), variants.end(), [&](const auto& variant) {
        return tree.attribute(element, variant.attribute) == variant.value;
    });
    return known.isNumbered && (known.kind != Kind::unit || variants.empty() || !isPlain);
}

// The kind of references that show the number alone.
std::optional<Grammar::Variant> kindByNumber(const Grammar* grammar) {
    if (grammar != nullptr)
        for (const auto& kind : grammar->variants(grammar->named(Display::reference)))
            if (kind.refersByNumber)
                return kind;
    return std::nullopt;
}

const Grammar* grammarOf(const Manuscript& manuscript, NodeId element) {
    const sgml::Tree& tree = manuscript.document.tree();
    NodeId around = element;
    while (around != noNode && tree.node(around).kind != sgml::NodeKind::document)
        around = tree.node(around).parent;
    return around == noNode ? nullptr : manuscript.grammars.of(tree.name(around));
}

// Of the letters that end there: "eq" of "by eq. ", which has a point behind it.
struct LastWord {
    QString word;
    bool hasPoint = false;
};

LastWord lastWord(const QString& line) {
    LastWord last;
    qsizetype end = line.size();
    for (; end > 0 && (line[end - 1].isSpace() || line[end - 1] == '.'); --end)
        last.hasPoint = last.hasPoint || line[end - 1] == '.';
    qsizetype from = end;
    while (from > 0 && line[from - 1].isLetter())
        --from;
    last.word = line.mid(from, end - from);
    return last;
}

} // namespace

Result changeReference(const Manuscript& manuscript, Selection selection, NodeId reference,
                       NodeId target, ReferBy by) {
    const QString isGone = QStringLiteral("The target of the reference is not in this document.");
    const sgml::Tree& tree = manuscript.document.tree();
    if (!tree.holds(target) || !tree.isElement(target))
        return refused(isGone);
    std::string id(tree.attribute(target, "ID").value_or(""));
    if (id.empty())
        id = freeId(idsOf(tree), tree.name(target));
    Attributes attributes{{"TO", id}};
    if (const auto kind = kindByNumber(grammarOf(manuscript, reference)))
        attributes.emplace_back(kind->attribute, by == ReferBy::number ? kind->value : "");
    return withId(
        manuscript, target, id,
        setAttributes(manuscript, selection, reference, attributes, QStringLiteral("Reference")),
        isGone);
}

Result insertReference(const Manuscript& manuscript, Selection selection, NodeId target,
                       ReferBy by) {
    const sgml::Tree& tree = manuscript.document.tree();
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string name(draft.grammar().named(Display::reference));
    if (name.empty())
        return refused(QStringLiteral("This class of documents has no references."));
    if (!tree.holds(target) || !tree.isElement(target) || !draft.isInside(target))
        return refused(QStringLiteral("The target of the reference is not in this document."));
    std::string id(tree.attribute(target, "ID").value_or(""));
    if (id.empty()) {
        id = freeId(idsOf(tree), tree.name(target));
        draft.opened(target).attributes += " " + sgml::attributeText("ID", id);
    }
    std::string attributes = " " + sgml::attributeText("TO", id);
    if (const auto kind = kindByNumber(&draft.grammar()); kind && by == ReferBy::number)
        attributes += " " + sgml::attributeText(kind->attribute, kind->value);
    if (putInLine(draft, draft.first(), Draft::made(name, attributes)) == nullptr)
        return refused(mayNotStand(draft.grammar(), name));
    draft.collapse();
    return draft.result(QStringLiteral("Reference"));
}

ReferBy refersBy(const Manuscript& manuscript, NodeId reference) {
    const auto kind = kindByNumber(grammarOf(manuscript, reference));
    const sgml::Tree& tree = manuscript.document.tree();
    return kind && tree.attribute(reference, kind->attribute) == kind->value
               ? ReferBy::number
               : ReferBy::kindAndNumber;
}

std::string referredAs(const Manuscript& manuscript, NodeId target) {
    const sgml::Tree& tree = manuscript.document.tree();
    const Grammar* grammar = grammarOf(manuscript, target);
    if (!kindByNumber(grammar))
        return {};
    for (const auto& kind : grammar->variants(tree.name(target)))
        if (!kind.reference.empty() && tree.attribute(target, kind.attribute) == kind.value)
            return std::string(schemas::wordsBefore(kind.reference));
    return grammar->of(tree.name(target)).referredAs;
}

// LIMIT: in the presentation's language.
ReferBy fittingAt(const Manuscript& manuscript, std::size_t place, NodeId target) {
    const QString kind = QString::fromStdString(referredAs(manuscript, target));
    const manuscript::LineText line(manuscript, place);
    const auto [word, hasPoint] = lastWord(line.letters().left(line.place()));
    constexpr qsizetype least = 2;
    // A point behind the whole word ends a sentence.
    const auto begins = [&, hasPoint = hasPoint](const QString& one) {
        return one.size() >= least && kind.startsWith(one, Qt::CaseInsensitive) &&
               !(hasPoint && one.size() == kind.size());
    };
    const bool isPlural = word.endsWith('s', Qt::CaseInsensitive) && begins(word.chopped(1));
    return begins(word) || isPlural ? ReferBy::number : ReferBy::kindAndNumber;
}

std::vector<NodeId> targets(const Manuscript& manuscript) {
    const sgml::Tree& tree = manuscript.document.tree();
    std::vector<NodeId> found;
    const Grammar* grammar = manuscript.grammars.of(tree.name(tree.root()));
    if (grammar == nullptr)
        return found;
    for (NodeId id = tree.following(tree.root()); id != noNode;) {
        const bool isElement = tree.isElement(id);
        if (isElement && (isNumbered(tree, *grammar, id) ||
                          (tree.attribute(id, "ID") && tree.name(id) != "DOCUMENT")))
            found.push_back(id);
        id = isElement && tree.name(id) == "DOCUMENT" ? tree.followingSkippingChildren(id)
                                                      : tree.following(id);
    }
    return found;
}

} // namespace authoring
