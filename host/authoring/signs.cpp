// Typed letters that become typographic signs.
#include "authoring/authoring.h"
#include "manuscript/leaves.h"
#include "manuscript/line_text.h"

#include "sgml/edit.h"
#include "typography/typed_signs.h"

namespace authoring {

using manuscript::Leaves, manuscript::LineText;

using sgml::NodeId;
using sgml::noNode;

namespace {

bool isCode(const sgml::Tree& tree, const Grammar& grammar, NodeId node) {
    for (NodeId at = node; at != noNode; at = tree.node(at).parent)
        if (tree.isElement(at) && grammar.of(tree.name(at)).role == schemas::ContainerRole::code)
            return true;
    return false;
}

} // namespace

std::optional<Step> signTyped(const Manuscript& manuscript, std::size_t caret) {
    const Leaves leaves(manuscript, caret);
    const NodeId leaf = leaves.isText() ? leaves.at(caret) : noNode;
    const sgml::Tree& tree = manuscript.document.tree();
    if (leaf == noNode || !leaves.isContent(leaf) || leaves.isVerbatim(leaf) ||
        isCode(tree, leaves.grammar(), leaf))
        return std::nullopt;
    const sgml::Unescaped unescaped = tree.unescaped(leaf);
    const std::size_t at = unescaped.textOffset(caret);
    const QString own = QString::fromStdString(unescaped.text().substr(0, at));
    const LineText line(manuscript, caret);
    const auto made = typography::signTyped(line.letters().first(line.place()),
                                            QString::fromStdString(languageAt(manuscript, caret)));
    if (!made || made->letters > own.size())
        return std::nullopt; // it would reach into another element
    const auto bytes = static_cast<std::size_t>(own.last(made->letters).toUtf8().size());
    Step step;
    step.edits = sgml::contentEdit(tree, leaf, {at - bytes, at}, made->text.toStdString());
    const std::size_t after = text::moved(caret, step.edits, text::Gravity::behind);
    step.after = {after, after};
    step.label = QStringLiteral("Typographic Sign");
    return step;
}

} // namespace authoring
