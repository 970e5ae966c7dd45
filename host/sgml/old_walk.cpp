#include "sgml/old_walk.h"

namespace sgml {

OldWalk::OldWalk(const Tree& tree, const std::vector<Level>& levels)
    : tree_(tree), levels_(levels) {
    enterLevel(levels.size() - 1);
    while (!atEnd() && !isBetweenItems())
        step();
}

void OldWalk::advance() {
    do
        step();
    while (!atEnd() && !isBetweenItems());
}

void OldWalk::enterLevel(std::size_t level) {
    level_ = level;
    node_ = levels_[level].rest;
    atNodeEnd_ = false;
    if (node_ != noNode)
        return;
    node_ = levels_[level].node;
    atNodeEnd_ = true;
    level_ = level == 0 ? noLevel : level - 1;
}

bool OldWalk::isLevel() const {
    return atNodeEnd_ && level_ + 1 < levels_.size() && levels_[level_ + 1].node == node_;
}

void OldWalk::step() {
    if (!atNodeEnd_) {
        const NodeId child = tree_.node(node_).firstChild;
        atNodeEnd_ = child == noNode;
        if (child != noNode)
            node_ = child;
        return;
    }
    if (isLevel()) {
        enterLevel(level_);
        return;
    }
    const NodeId next = tree_.node(node_).next;
    if (next != noNode) {
        node_ = next;
        atNodeEnd_ = false;
        return;
    }
    node_ = tree_.node(node_).parent;
    if (node_ == levels_[level_].node)
        level_ = level_ == 0 ? noLevel : level_ - 1;
}

bool OldWalk::isBetweenItems() const {
    const Node& node = tree_.node(node_);
    if (node.kind == NodeKind::document || node.kind == NodeKind::stray)
        return false;
    if (atNodeEnd_)
        return !endTagOf(node_).empty();
    // A <DOCUMENT> tag and the line behind it are one item. A tag may have closed itself.
    const bool opensDocument =
        node.firstChild != noNode && tree_.node(node.firstChild).kind == NodeKind::document;
    const bool mayBeClosed = node.endTag.empty() && node.firstChild == noNode;
    return node.kind == NodeKind::element && !opensDocument && !mayBeClosed;
}

std::size_t OldWalk::position() const {
    return atNodeEnd_ ? endTagOf(node_).to : tree_.node(node_).startTag.to;
}

NodeId OldWalk::top() const {
    if (!atNodeEnd_)
        return node_;
    return isLevel() ? levels_[level_].node : tree_.node(node_).parent;
}

NodeId OldWalk::next() const {
    if (!atNodeEnd_)
        return tree_.node(node_).firstChild;
    return isLevel() ? levels_[level_].rest : tree_.node(node_).next;
}

text::Range OldWalk::endTagOf(NodeId open) const {
    if (isLevel() && open == node_)
        return levels_[level_ + 1].endTag;
    if (level_ != noLevel && open == levels_[level_].node)
        return levels_[level_].endTag;
    return tree_.node(open).endTag;
}

} // namespace sgml
