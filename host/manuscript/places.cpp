#include "manuscript/leaves.h"
#include "manuscript/text_units.h"

#include <algorithm>

namespace manuscript {

using sgml::NodeId;
using sgml::noNode;

namespace {

// The place in a content that is nearest to the offset, going in the direction.
std::size_t snappedIn(const Leaves& leaves, const sgml::Tree& tree, NodeId content,
                      std::size_t offset, Direction direction) {
    const text::Range range = tree.contentRange(content);
    if (offset <= range.from || offset >= range.to)
        return std::clamp(offset, range.from, range.to);
    const sgml::Unescaped text = tree.unescaped(content);
    std::size_t inText = text.textOffset(offset);
    // Behind the backslash of an escape is inside of a character.
    if (direction == Direction::forward && text.fileOffset(inText) < offset)
        ++inText;
    const TextUnits units(text.text(), !leaves.isVerbatim(content));
    return text.fileOffset(units.snapped(inText, direction));
}

// Within the leaf; the same place at its end.
std::size_t besideIn(const Leaves& leaves, const sgml::Tree& tree, NodeId leaf, std::size_t from,
                     Direction direction, Unit unit) {
    if (leaves.isUnit(leaf))
        return direction == Direction::forward ? leaves.lastPlace(leaf) : leaves.firstPlace(leaf);
    if (!leaves.isContent(leaf))
        return from;
    const sgml::Unescaped text = tree.unescaped(leaf);
    const TextUnits units(text.text(), !leaves.isVerbatim(leaf));
    return text.fileOffset(units.beside(text.textOffset(from), direction, unit));
}

} // namespace

std::optional<std::size_t> place(const Manuscript& manuscript, std::size_t offset,
                                 Direction direction) {
    const sgml::Tree& tree = manuscript.document.tree();
    const Leaves leaves(manuscript, offset);
    const NodeId leaf = leaves.isText() ? leaves.nearest(offset, direction) : noNode;
    if (leaf == noNode)
        return std::nullopt;
    if (leaves.isContent(leaf))
        return snappedIn(leaves, tree, leaf, offset, direction);
    if (direction == Direction::forward)
        return leaves.firstPlace(leaf) >= offset ? leaves.firstPlace(leaf) : leaves.lastPlace(leaf);
    return leaves.lastPlace(leaf) <= offset ? leaves.lastPlace(leaf) : leaves.firstPlace(leaf);
}

std::optional<std::size_t> placeBeside(const Manuscript& manuscript, std::size_t from,
                                       Direction direction, Unit unit) {
    const sgml::Tree& tree = manuscript.document.tree();
    const Leaves leaves(manuscript, from);
    NodeId leaf = leaves.isText() ? leaves.at(from) : noNode;
    if (leaf == noNode)
        return std::nullopt;
    const NodeId block = leaves.blockOf(leaf);
    std::size_t at = from;
    // Places at the ends of leaves of one line are one place for a reader.
    while ((at = besideIn(leaves, tree, leaf, at, direction, unit)) == from) {
        leaf = leaves.beside(leaf, direction);
        if (leaf == noNode)
            return std::nullopt;
        at = from =
            direction == Direction::forward ? leaves.firstPlace(leaf) : leaves.lastPlace(leaf);
        if (leaves.blockOf(leaf) != block)
            break;
    }
    return at;
}

Selection widened(const Manuscript& manuscript, Selection selection) {
    const sgml::Tree& tree = manuscript.document.tree();
    for (;;) {
        const Leaves anchor(manuscript, selection.anchor), caret(manuscript, selection.caret);
        if (!anchor.isText() || !caret.isText() || anchor.top() == caret.top())
            return selection;
        // The flow that does not hold the other one is left; the file's own flow never is.
        const text::Range range = tree.node(anchor.top()).range;
        const text::Range other = tree.node(caret.top()).range;
        const auto isFiles = [&](NodeId top) { return tree.node(top).parent == tree.root(); };
        // In a damaged file a footnote may stand behind the document: neither flow can be left.
        if (isFiles(anchor.top()) && isFiles(caret.top()))
            return {selection.anchor, selection.anchor};
        const bool leavesCaret =
            (range.from <= other.from && other.to <= range.to) || isFiles(anchor.top());
        NodeId unit = leavesCaret ? caret.top() : anchor.top();
        if (tree.node(tree.node(unit).parent).kind == sgml::NodeKind::document)
            unit = tree.node(tree.node(unit).parent).parent;
        std::size_t& end = leavesCaret ? selection.caret : selection.anchor;
        const bool isLast = end > (leavesCaret ? selection.anchor : selection.caret);
        end = isLast ? tree.node(unit).range.to : tree.node(unit).range.from;
    }
}

Selection lineAround(const Manuscript& manuscript, std::size_t place) {
    const Leaves leaves(manuscript, place);
    const NodeId leaf = leaves.isText() ? leaves.at(place) : noNode;
    if (leaf == noNode)
        return {place, place};
    const auto endOf = [&](Direction direction) {
        NodeId last = leaf;
        for (NodeId next = last; next != noNode && leaves.blockOf(next) == leaves.blockOf(leaf);
             next = leaves.beside(next, direction))
            last = next;
        return direction == Direction::forward ? leaves.lastPlace(last) : leaves.firstPlace(last);
    };
    return {endOf(Direction::backward), endOf(Direction::forward)};
}

Selection everything(const Manuscript& manuscript, std::size_t place) {
    const Leaves leaves(manuscript, place);
    const NodeId first = leaves.isText() ? leaves.outermost(Direction::backward) : noNode;
    if (first == noNode)
        return {place, place};
    return {leaves.firstPlace(first), leaves.lastPlace(leaves.outermost(Direction::forward))};
}

} // namespace manuscript
