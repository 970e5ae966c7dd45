// The language of text: the attribute LANG of its element, or of one around it.
#include "authoring/commands.h"
#include "authoring/wrapper.h"
#include "manuscript/leaves.h"
#include "manuscript/places.h"

#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using manuscript::Leaves, manuscript::lineAround, manuscript::widened;

using sgml::NodeId;
using sgml::noNode;

namespace {

constexpr std::string_view languageAttribute = "LANG";

std::string languageOf(const sgml::Tree& tree, NodeId node) {
    for (NodeId at = node; at != noNode; at = tree.node(at).parent)
        if (tree.isElement(at))
            if (const auto own = tree.attribute(at, languageAttribute); own && !own->empty())
                return std::string(*own);
    return {};
}

// The edits that give an element the language; it says none itself where that is the one around it.
void say(const sgml::Tree& tree, NodeId element, const std::string& language, text::Edits& edits) {
    const bool isAround = languageOf(tree, tree.node(element).parent) == language;
    for (text::Edit& edit : isAround
                                ? sgml::attributeRemoval(tree, element, languageAttribute)
                                : sgml::attributeEdit(tree, element, languageAttribute, language))
        edits.push_back(std::move(edit));
}

Step stepOf(text::Edits edits, Selection selection) {
    std::ranges::sort(edits, {}, [](const text::Edit& edit) { return edit.range.from; });
    Step step;
    step.after = {text::moved(selection.anchor, edits, text::Gravity::before),
                  text::moved(selection.caret, edits, text::Gravity::before)};
    step.edits = std::move(edits);
    step.label = QStringLiteral("Language");
    return step;
}

// The paragraphs, headings, items and the like that a selection touches.
std::vector<NodeId> blocksIn(const Manuscript& manuscript, Selection selection) {
    const std::size_t first = std::min(selection.anchor, selection.caret);
    const std::size_t last = std::max(selection.anchor, selection.caret);
    const Leaves leaves(manuscript, first);
    std::vector<NodeId> blocks;
    if (!leaves.isText())
        return blocks;
    for (NodeId leaf = leaves.at(first); leaf != noNode && leaves.firstPlace(leaf) <= last;
         leaf = leaves.beside(leaf, Direction::forward)) {
        const NodeId block = leaves.blockOf(leaf);
        if (!leaves.isVerbatim(leaf) && (blocks.empty() || blocks.back() != block))
            blocks.push_back(block);
    }
    return blocks;
}

// Letters within a line, in an element TEXT of their own.
Result setInLine(const Manuscript& manuscript, Selection selection, const std::string& language,
                 const std::string& around) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    Wrapper wrapper(draft, [&](const Piece& piece) {
        return piece.name == "TEXT" && !draft.attribute(piece, languageAttribute).empty();
    });
    wrapper.unwrap();
    if (language != around)
        wrapper.wrap("TEXT", " " + sgml::attributeText(languageAttribute, language));
    return draft.result(QStringLiteral("Language"));
}

} // namespace

std::string languageAt(const Manuscript& manuscript, std::size_t place) {
    const sgml::Tree& tree = manuscript.document.tree();
    return languageOf(tree, tree.innermostAt(place));
}

Result setLanguage(const Manuscript& manuscript, Selection selection, std::string_view language) {
    selection = widened(manuscript, selection);
    const sgml::Tree& tree = manuscript.document.tree();
    const std::vector<NodeId> blocks = blocksIn(manuscript, selection);
    if (blocks.empty())
        return refused(QStringLiteral("There is no text here that has a language."));
    const std::string wanted(language);
    if (blocks.size() == 1 && !selection.isEmpty()) {
        const Selection line = lineAround(manuscript, selection.caret);
        const auto [first, last] = std::minmax(selection.anchor, selection.caret);
        if (first > line.anchor || last < line.caret)
            return setInLine(manuscript, selection, wanted, languageOf(tree, blocks.front()));
    }
    text::Edits edits;
    for (const NodeId block : blocks)
        say(tree, block, wanted, edits);
    return stepOf(std::move(edits), selection);
}

Result setDocumentLanguage(const Manuscript& manuscript, Selection selection,
                           std::string_view language) {
    const sgml::Tree& tree = manuscript.document.tree();
    const NodeId top = tree.classElement(tree.root());
    if (top == noNode)
        return refused(QStringLiteral("The document is empty."));
    text::Edits edits;
    say(tree, top, std::string(language), edits);
    return stepOf(std::move(edits), selection);
}

} // namespace authoring
