#include "collision/box_tree.h"

namespace collision {

namespace {

double surface(const geometry::Box& box) {
    const auto d = box.sizes();
    return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
}

} // namespace

BoxTree::Index BoxTree::make(const geometry::Box& box) {
    Index index = 0;
    if (free_.empty()) {
        index = static_cast<Index>(nodes_.size());
        nodes_.emplace_back();
    } else {
        index = free_.back();
        free_.pop_back();
        nodes_[index] = {};
    }
    nodes_[index].box = box;
    return index;
}

// Down from the root, into the child whose box grows less, as long as that is cheaper than staying.
BoxTree::Index BoxTree::siblingFor(const geometry::Box& box) const {
    Index at = root_;
    while (nodes_[at].left != nothing) {
        const Node& node = nodes_[at];
        const double own = surface(node.box), together = surface(node.box.merged(box));
        const double passedDown = 2 * (together - own);
        const auto costOf = [&](Index child) {
            const Node& c = nodes_[child];
            const double grown = surface(c.box.merged(box));
            return passedDown + grown - (c.left == nothing ? 0 : surface(c.box));
        };
        const double left = costOf(node.left), right = costOf(node.right);
        if (2 * together < left && 2 * together < right)
            break;
        at = left <= right ? node.left : node.right;
    }
    return at;
}

void BoxTree::put(std::size_t owner, const geometry::Box& box) {
    if (contains(owner))
        remove(owner);
    const Index leaf = make(box);
    nodes_[leaf].owner = owner;
    leafOf_[owner] = leaf;
    if (root_ == nothing) {
        root_ = leaf;
        return;
    }
    const Index sibling = siblingFor(box);
    const Index above = nodes_[sibling].parent;
    const Index joint = make(nodes_[sibling].box.merged(box));
    nodes_[joint].parent = above;
    nodes_[joint].left = sibling;
    nodes_[joint].right = leaf;
    nodes_[sibling].parent = nodes_[leaf].parent = joint;
    replaceChild(above, sibling, joint);
    refit(above);
}

void BoxTree::replaceChild(Index parent, Index old, Index now) {
    if (parent == nothing)
        root_ = now;
    else
        (nodes_[parent].left == old ? nodes_[parent].left : nodes_[parent].right) = now;
}

void BoxTree::remove(std::size_t owner) {
    const Index leaf = leafOf_[owner];
    leafOf_[owner] = nothing;
    free_.push_back(leaf);
    const Index joint = nodes_[leaf].parent;
    if (joint == nothing) {
        root_ = nothing;
        return;
    }
    const Index sibling = nodes_[joint].left == leaf ? nodes_[joint].right : nodes_[joint].left;
    const Index above = nodes_[joint].parent;
    nodes_[sibling].parent = above;
    replaceChild(above, joint, sibling);
    free_.push_back(joint);
    refit(above);
}

// Up from the node as far as boxes change.
void BoxTree::refit(Index node) {
    for (; node != nothing; node = nodes_[node].parent) {
        Node& n = nodes_[node];
        const geometry::Box box = nodes_[n.left].box.merged(nodes_[n.right].box);
        if (box.min() == n.box.min() && box.max() == n.box.max())
            return;
        n.box = box;
        rotate(node);
    }
}

// A child changes places with a child of its sibling where the sibling's box shrinks by that.
void BoxTree::rotate(Index node) {
    const Index left = nodes_[node].left, right = nodes_[node].right;
    if (!tryRotation(node, left, right))
        (void)tryRotation(node, right, left);
}

bool BoxTree::tryRotation(Index node, Index child, Index other) {
    if (nodes_[other].left == nothing)
        return false;
    const double now = surface(nodes_[other].box);
    const Index a = nodes_[other].left, b = nodes_[other].right;
    const double withoutA = surface(nodes_[child].box.merged(nodes_[b].box));
    const double withoutB = surface(nodes_[child].box.merged(nodes_[a].box));
    if (now <= withoutA && now <= withoutB)
        return false;
    const Index up = withoutA <= withoutB ? a : b;
    const Index stays = up == a ? b : a;
    replaceChild(node, child, up);
    replaceChild(other, up, child);
    nodes_[up].parent = node;
    nodes_[child].parent = other;
    nodes_[other].box = nodes_[child].box.merged(nodes_[stays].box);
    return true;
}

void BoxTree::overlapping(const geometry::Box& box, std::vector<std::size_t>& owners) const {
    if (root_ == nothing)
        return;
    stack_.assign(1, root_);
    while (!stack_.empty()) {
        const Node& node = nodes_[stack_.back()];
        stack_.pop_back();
        ++visits_;
        if (!node.box.intersects(box))
            continue;
        if (node.left == nothing)
            owners.push_back(node.owner);
        else {
            stack_.push_back(node.left);
            stack_.push_back(node.right);
        }
    }
}

} // namespace collision
