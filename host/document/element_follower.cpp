#include "document/element_follower.h"

#include <algorithm>

namespace document {

using sgml::NodeId;
using sgml::noNode;

namespace {

bool isDocument(const sgml::Tree& tree, NodeId node) {
    return tree.node(node).kind == sgml::NodeKind::document;
}

// Of the children of a node, when that of the node is known.
NodeId documentIn(const sgml::Tree& tree, NodeId node, NodeId around) {
    if (isDocument(tree, node))
        return node;
    return tree.name(node) == "DOCUMENT" ? noNode : around;
}

} // namespace

void ElementFollower::lookAtAll() {
    forgetAll();
    classes_.clear();
    lookBelow(tree().root());
}

void ElementFollower::follow(const sgml::Change& change) {
    if (change.everything) {
        lookAtAll();
        return;
    }
    for (const NodeId node : change.gone) {
        classes_.erase(node);
        forget(node);
    }
    std::vector<NodeId> nodes = change.tags;
    for (const sgml::Change::Children& children : change.children) {
        nodes.push_back(children.parent);
        for (const NodeId top : children.added)
            lookBelow(top);
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const NodeId node : nodes)
        lookAgain(node);
}

void ElementFollower::lookAgain(NodeId node) {
    if (isDocument(tree(), node))
        return lookAtDocumentAgain(node);
    ++looked_;
    look(node, documentAround(node));
    const NodeId parent = tree().node(node).parent;
    if (isDocument(tree(), parent))
        lookAtDocumentAgain(parent);
}

// The class of a document says what its elements mean.
void ElementFollower::lookAtDocumentAgain(NodeId node) {
    if (tree().name(node) != classes_[node])
        return lookBelow(node);
    ++looked_;
    lookAtDocument(node);
}

void ElementFollower::lookBelow(NodeId top) {
    struct Open {
        NodeId node, in;
    };
    std::vector<Open> open;
    const NodeId outside = top == tree().root() ? noNode : documentAround(top);
    for (NodeId node = top; node != noNode; node = tree().following(node, top)) {
        while (!open.empty() && open.back().node != tree().node(node).parent)
            open.pop_back();
        const NodeId around = open.empty() ? outside : open.back().in;
        if (isDocument(tree(), node)) {
            ++looked_;
            classes_[node] = tree().name(node);
            lookAtDocument(node);
        } else if (tree().isElement(node)) {
            ++looked_;
            look(node, around);
        }
        if (tree().node(node).firstChild != noNode)
            open.push_back({node, documentIn(tree(), node, around)});
    }
}

NodeId ElementFollower::documentAround(NodeId node) const {
    for (node = tree().node(node).parent; node != noNode; node = tree().node(node).parent) {
        if (isDocument(tree(), node))
            return node;
        if (tree().name(node) == "DOCUMENT")
            return noNode;
    }
    return noNode;
}

} // namespace document
