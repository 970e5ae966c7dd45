#include "manuscript/gaps.h"

#include "manuscript/leaves.h"

namespace manuscript {

using schemas::ContainerRole;
using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

bool isClosed(const Element& element) {
    return element.display == Display::table || element.display == Display::verbatim ||
           element.role == ContainerRole::table || element.role == ContainerRole::figure;
}

namespace {

bool isClosedBlock(const sgml::Tree& tree, const Grammar& grammar, NodeId node) {
    return node != noNode && tree.isElement(node) && tree.name(node) != "DOCUMENT" &&
           isClosed(grammar.of(tree.name(node)));
}

NodeId siblingOf(const sgml::Tree& tree, NodeId node, Direction direction) {
    if (direction == Direction::forward)
        return tree.node(node).next;
    NodeId before = noNode;
    for (NodeId one = tree.node(tree.node(node).parent).firstChild; one != node;
         one = tree.node(one).next)
        before = one;
    return before;
}

} // namespace

Sides sidesOf(const Manuscript& manuscript, std::size_t gap) {
    const sgml::Tree& tree = manuscript.document.tree();
    const NodeId around = tree.innermostAt(gap);
    Sides sides;
    if (around == noNode)
        return sides;
    NodeId parent = around;
    if (tree.node(around).range.from == gap && around != tree.root())
        parent = tree.node(around).parent;
    for (NodeId one = tree.node(parent).firstChild; one != noNode; one = tree.node(one).next) {
        if (tree.node(one).range.to <= gap)
            sides.before = one;
        else if (tree.node(one).range.from >= gap && sides.behind == noNode)
            sides.behind = one;
    }
    return sides;
}

bool isGap(const Manuscript& manuscript, std::size_t place) {
    const sgml::Tree& tree = manuscript.document.tree();
    const NodeId around = tree.innermostAt(place);
    if (around == noNode || tree.node(around).kind == sgml::NodeKind::content)
        return false;
    const Leaves leaves(manuscript, place);
    const Sides sides = sidesOf(manuscript, place);
    return leaves.isText() && isClosedBlock(tree, leaves.grammar(), sides.before) &&
           isClosedBlock(tree, leaves.grammar(), sides.behind) &&
           tree.node(sides.before).range.to == place;
}

std::optional<std::size_t> gapBeside(const Manuscript& manuscript, std::size_t place,
                                     Direction direction) {
    const sgml::Tree& tree = manuscript.document.tree();
    const Leaves leaves(manuscript, place);
    if (!leaves.isText())
        return std::nullopt;
    for (NodeId node = tree.innermostAt(place); node != noNode && node != tree.root();
         node = tree.node(node).parent) {
        if (!isClosedBlock(tree, leaves.grammar(), node))
            continue;
        const NodeId beside = siblingOf(tree, node, direction);
        if (isClosedBlock(tree, leaves.grammar(), beside))
            return tree.node(direction == Direction::forward ? node : beside).range.to;
        if (beside != noNode)
            return std::nullopt;
    }
    return std::nullopt;
}

} // namespace manuscript
