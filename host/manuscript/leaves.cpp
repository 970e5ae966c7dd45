#include "manuscript/leaves.h"

#include <algorithm>
#include <vector>

namespace manuscript {

using sgml::NodeId;
using sgml::NodeKind;
using sgml::noNode;

NodeId documentAround(const Manuscript& manuscript, std::size_t from, std::size_t to) {
    const sgml::Tree& tree = manuscript.document.tree();
    for (NodeId id = tree.innermostAt(from); id != noNode; id = tree.node(id).parent) {
        if (tree.node(id).kind != NodeKind::document)
            continue;
        const NodeId element = tree.classElement(id);
        if (element != noNode && manuscript.grammars.of(tree.name(id)) != nullptr &&
            tree.node(element).startTag.to <= from && to <= tree.node(element).endTag.from)
            return id;
    }
    return tree.root();
}

Leaves::Leaves(const Manuscript& manuscript, std::size_t offset)
    : manuscript_(manuscript), tree_(manuscript.document.tree()) {
    const NodeId document = documentAround(manuscript, offset, offset);
    top_ = tree_.classElement(document);
    grammar_ = top_ == noNode ? nullptr : manuscript.grammars.of(tree_.name(document));
    if (grammar_ == nullptr)
        return;
    for (NodeId id = tree_.innermostAt(offset); id != noNode && id != document;
         id = tree_.node(id).parent)
        if (tree_.isElement(id) &&
            grammar_->of(tree_.name(id)).display == schemas::Display::footnote &&
            tree_.node(id).startTag.to <= offset && offset <= tree_.node(id).endTag.from) {
            top_ = id;
            return;
        }
}

bool Leaves::isContent(NodeId leaf) const { return tree_.node(leaf).kind == NodeKind::content; }

bool Leaves::isUnit(NodeId leaf) const {
    if (!tree_.isElement(leaf) || leaf == top_)
        return false;
    const Kind kind = grammar_->of(tree_.name(leaf)).kind;
    return kind == Kind::unit || kind == Kind::blockUnit;
}

bool Leaves::isVerbatim(NodeId leaf) const {
    for (NodeId id = leaf; id != top_; id = tree_.node(id).parent)
        if (tree_.isElement(id) &&
            grammar_->of(tree_.name(id)).display == schemas::Display::verbatim)
            return true;
    return false;
}

bool Leaves::isLeaf(NodeId node) const {
    ++judged_;
    if (isContent(node) || isUnit(node))
        return true;
    if (!tree_.isElement(node))
        return false;
    for (NodeId child = tree_.node(node).firstChild; child != noNode;
         child = tree_.node(child).next)
        if (tree_.node(child).kind != NodeKind::stray)
            return false;
    return true;
}

std::size_t Leaves::firstPlace(NodeId leaf) const {
    if (isContent(leaf))
        return tree_.contentRange(leaf).from;
    return isUnit(leaf) ? tree_.node(leaf).range.from : tree_.node(leaf).startTag.to;
}

std::size_t Leaves::lastPlace(NodeId leaf) const {
    if (isContent(leaf))
        return tree_.contentRange(leaf).to;
    return isUnit(leaf) ? tree_.node(leaf).range.to : tree_.node(leaf).startTag.to;
}

NodeId Leaves::blockOf(NodeId leaf) const {
    if (leaf == noNode)
        return noNode;
    const auto isInlined = [this](NodeId id) {
        return id != top_ && tree_.isElement(id) &&
               grammar_->of(tree_.name(id)).kind == Kind::inlined;
    };
    NodeId block = isContent(leaf) || isUnit(leaf) ? tree_.node(leaf).parent : leaf;
    while (isInlined(block))
        block = tree_.node(block).parent;
    if (!isUnit(leaf))
        return block;
    const bool inLine = grammar_->of(tree_.name(leaf)).kind == Kind::unit &&
                        grammar_->of(tree_.name(block)).holdsText;
    return inLine ? block : leaf;
}

// --- walking --------------------------------------------------------------------------------

NodeId Leaves::previousSibling(NodeId node) const {
    NodeId before = noNode;
    for (NodeId id = tree_.node(tree_.node(node).parent).firstChild; id != node;
         id = tree_.node(id).next)
        before = id;
    return before;
}

NodeId Leaves::lastLeafIn(NodeId node) const {
    if (isLeaf(node))
        return node;
    for (NodeId child = tree_.isElement(node) ? tree_.node(node).lastChild : noNode;
         child != noNode; child = previousSibling(child))
        if (const NodeId leaf = lastLeafIn(child); leaf != noNode)
            return leaf;
    return noNode;
}

NodeId Leaves::beside(NodeId leaf, Direction direction) const {
    if (leaf == top_)
        return noNode;
    if (direction == Direction::forward) {
        NodeId id = tree_.followingSkippingChildren(leaf, top_);
        while (id != noNode && !isLeaf(id))
            id = tree_.following(id, top_);
        return id;
    }
    for (NodeId id = leaf; id != top_; id = tree_.node(id).parent)
        for (NodeId before = previousSibling(id); before != noNode;
             before = previousSibling(before))
            if (const NodeId found = lastLeafIn(before); found != noNode)
                return found;
    return noNode;
}

NodeId Leaves::outermost(Direction direction) const {
    if (isLeaf(top_))
        return top_;
    if (direction == Direction::forward)
        return lastLeafIn(top_);
    NodeId id = tree_.node(top_).firstChild;
    while (id != noNode && !isLeaf(id))
        id = tree_.following(id, top_);
    return id;
}

NodeId Leaves::nearest(std::size_t offset, Direction direction) const {
    if (!isText())
        return noNode;
    NodeId found = noNode;
    NodeId id = top_;
    while (id != noNode) {
        const text::Range range = tree_.node(id).range;
        // Going forward, a node that ends before the offset has no leaf to offer.
        if (direction == Direction::forward && range.to < offset) {
            id = tree_.followingSkippingChildren(id, top_);
            continue;
        }
        const bool isOne = isLeaf(id);
        if (isOne) {
            if (direction == Direction::forward && lastPlace(id) >= offset)
                return id;
            if (firstPlace(id) <= offset)
                found = id;
        }
        if (direction == Direction::backward && range.from > offset)
            break;
        id = isOne ? tree_.followingSkippingChildren(id, top_) : tree_.following(id, top_);
    }
    return direction == Direction::forward ? noNode : found;
}

NodeId Leaves::at(std::size_t place) const {
    NodeId id = nearest(place, Direction::forward);
    NodeId unit = noNode;
    for (; id != noNode && firstPlace(id) <= place; id = beside(id, Direction::forward)) {
        const bool isInside = place <= lastPlace(id);
        if (isInside && !isUnit(id))
            return id;
        if (unit == noNode && isInside && (place == firstPlace(id) || place == lastPlace(id)))
            unit = id;
    }
    return unit;
}

} // namespace manuscript
