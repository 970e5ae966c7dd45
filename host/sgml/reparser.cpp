#include "sgml/reparser.h"

#include <algorithm>

namespace sgml {

namespace {

bool isIn(const std::vector<NodeId>& increasing, NodeId id) {
    return std::binary_search(increasing.begin(), increasing.end(), id);
}

// The parser's reading of the next item depends on the one before.
bool isElementOrContent(NodeKind kind) {
    return kind == NodeKind::element || kind == NodeKind::content;
}

} // namespace

Change applyEdits(Tree& tree, const text::Edits& edits) { return Reparser(tree, edits).run(); }

Reparser::Reparser(Tree& tree, const text::Edits& edits) : tree_(tree), edits_(edits) {}

Change Reparser::run() {
    change_.edits = edits_;
    if (edits_.empty())
        return std::move(change_);
    const Shift shift(edits_);
    const bool follow = canFollow();
    const std::string className(tree_.text(tree_.nodes_[tree_.root()].name));
    if (follow)
        findTouches(shift);
    replaceBytes();
    if (!follow) {
        readAll();
        return std::move(change_);
    }
    const text::Range hull{edits_.front().range.from, edits_.back().range.to};
    shiftNodes(shift, hull);
    shiftAttributes(shift, hull);
    shiftFaults(shift);
    parser_.emplace(tree_);
    while (nextTouch_ < touches_.size() && !parser_->hasStopped())
        readFrom(touches_[nextTouch_].start);
    checkDocuments();
    checkEditedBytes();
    freeNodes();
    packAttributes();
    Node& root = tree_.nodes_[tree_.root()];
    root.range = {0, tree_.bytes_.size()};
    root.startTag = root.endTag = {};
    if (tree_.text(root.name) != className)
        change_.tags.push_back(tree_.root());
    tree_.faults_.insert(tree_.faults_.end(), faults_.begin(), faults_.end());
    const bool beyond = parser_->hasStopped() ||
                        tree_.nodes_.size() - tree_.free_.size() >= tree_.limits_.nodes ||
                        tree_.faults_.size() >= tree_.limits_.faults / 2;
    if (beyond)
        readAll();
    else
        tree_.sortFaults();
    return std::move(change_);
}

// A text that was read in part only, or will be, is read from its start.
bool Reparser::canFollow() const {
    std::size_t size = tree_.bytes_.size();
    for (const text::Edit& edit : edits_)
        size += edit.text.size() - edit.range.size();
    const bool partly =
        std::any_of(tree_.faults_.begin(), tree_.faults_.end(), [](const Fault& fault) {
            return fault.kind == FaultKind::limit || fault.kind == FaultKind::otherEncoding;
        });
    return !partly && !tree_.bytes_.empty() && size > 0 && size <= tree_.limits_.bytes &&
           tree_.faults_.size() < tree_.limits_.faults / 2 && edits_.front().range.from >= 2;
}

void Reparser::readAll() {
    const Limits limits = tree_.limits_;
    tree_ = Tree::parse(std::move(tree_.bytes_), limits);
    change_ = {.edits = edits_, .everything = true};
}

// --- where reading begins -------------------------------------------------------------------

void Reparser::findTouches(const Shift& shift) {
    std::size_t distance = 0;
    std::vector<std::pair<std::size_t, text::Range>> places; // before the edits, and after them
    for (const text::Edit& edit : edits_) {
        const std::size_t from = edit.range.from + distance;
        distance += edit.text.size() - edit.range.size();
        // Behind bytes that are gone without others in their place, one item is read in any case:
        // the old states before and behind those bytes have one place now.
        places.push_back(
            {edit.range.from, {from, from + std::max<std::size_t>(1, edit.text.size())}});
    }
    for (const Fault& fault : tree_.faults_) {
        const bool looksAhead =
            fault.kind == FaultKind::unterminatedContent || fault.kind == FaultKind::badAttribute;
        const std::size_t now = shift.ofStart(fault.range.from);
        if (looksAhead && now != nowhere && fault.range.from < edits_.back().range.to)
            places.push_back({fault.range.from, {now, now + 1}});
    }
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
        return std::pair(a.first, a.second.from) < std::pair(b.first, b.second.from);
    });
    for (const auto& [before, now] : places)
        touches_.push_back({startBefore(before), now});
}

// The last place at or before `offset` at which reading can begin: no byte behind it can change
// what was read before it. Offsets must not decrease from call to call.
Reparser::Start Reparser::startBefore(std::size_t offset) {
    if (path_.empty())
        path_.push_back({tree_.nodes_[tree_.root()].firstChild, {}});
    for (std::size_t depth = 0;; ++depth) {
        Step& step = path_[depth];
        bool moved = false;
        while (step.child != noNode && tree_.nodes_[step.child].range.to <= offset) {
            const NodeId child = step.child;
            if (isFirmEnd(child))
                step.start = {child, true};
            // Behind the class element, all that follows is one fault.
            step.child = depth == 0 && tree_.isElement(child) ? noNode : tree_.nodes_[child].next;
            moved = true;
        }
        if (moved)
            path_.resize(depth + 1);
        const NodeId child = path_[depth].child;
        const Start start = path_[depth].start;
        if (child == noNode || tree_.nodes_[child].range.from >= offset ||
            tree_.nodes_[child].startTag.to > offset)
            return start;
        if (path_.size() == depth + 1)
            path_.push_back(
                {tree_.nodes_[child].firstChild, isFirmStart(child) ? Start{child, false} : start});
    }
}

bool Reparser::isFirmStart(NodeId id) const {
    const Node& node = tree_.nodes_[id];
    const bool mayBeClosed = node.endTag.empty() && node.firstChild == noNode;
    return node.kind == NodeKind::element && !mayBeClosed &&
           tree_.bytes_[node.startTag.to - 1] == '>' && tree_.name(id) != "DOCUMENT";
}

bool Reparser::isFirmEnd(NodeId id) const {
    const Node& node = tree_.nodes_[id];
    if (node.kind == NodeKind::content)
        return !node.endTag.empty();
    return node.kind == NodeKind::element && !node.endTag.empty() &&
           tree_.bytes_[node.endTag.to - 1] == '>';
}

std::size_t Reparser::placeOf(const Start& start) const {
    if (start.node == noNode)
        return 0;
    const Node& node = tree_.nodes_[start.node];
    return start.isBehind ? node.endTag.to : node.startTag.to;
}

// --- reading --------------------------------------------------------------------------------

void Reparser::readFrom(const Start& start) {
    cut(start);
    std::vector<NodeId> open;
    for (const Level& level : levels_)
        open.push_back(level.node);
    const std::size_t from = placeOf(start);
    parser_->resume(from, std::move(open));
    required_ = touches_[nextTouch_++].range.to;
    OldWalk walk(tree_, levels_);
    for (bool more = true; more; more = parser_->readNext()) {
        const std::size_t at = parser_->at();
        useTouches(at);
        while (!walk.atEnd() && (walk.position() == nowhere || walk.position() < at))
            walk.advance();
        if (at < required_ || walk.atEnd() || walk.position() != at || !meets(walk))
            continue;
        join(walk);
        forgetFaults({from, at});
        change_.read.push_back({from, at});
        return;
    }
    closeLevels(0);
    forgetFaults({from, nowhere});
    change_.read.push_back({from, tree_.bytes_.size()});
    nextTouch_ = touches_.size();
}

// Takes what stands behind the start out of the tree; the levels remember it.
void Reparser::cut(const Start& start) {
    levels_.clear();
    const NodeId before = start.isBehind ? start.node : noNode;
    NodeId top = start.isBehind ? tree_.nodes_[start.node].parent : start.node;
    if (top == noNode) {
        top = tree_.root();
        tree_.nodes_[top].name = {};
    }
    NodeId child = before;
    for (NodeId id = top; id != noNode; child = id, id = tree_.nodes_[id].parent) {
        if (tree_.nodes_[id].kind == NodeKind::document) {
            forgetFaultsOf(id);
            documents_.push_back(id);
        }
        Node& node = tree_.nodes_[id];
        const NodeId rest = child == noNode ? node.firstChild : tree_.nodes_[child].next;
        levels_.push_back({.node = id,
                           .rest = rest,
                           .before = child,
                           .last = node.lastChild,
                           .endTag = node.endTag});
    }
    std::reverse(levels_.begin(), levels_.end());
    for (const Level& level : levels_) {
        tree_.nodes_[level.node].lastChild = level.before;
        NodeId& next = level.before == noNode ? tree_.nodes_[level.node].firstChild
                                              : tree_.nodes_[level.before].next;
        next = noNode;
    }
}

// Touched bytes that reading has come to must be read before an old state counts.
void Reparser::useTouches(std::size_t at) {
    for (; nextTouch_ < touches_.size() && touches_[nextTouch_].range.from <= at; ++nextTouch_)
        required_ = std::max(required_, touches_[nextTouch_].range.to);
}

bool Reparser::meets(const OldWalk& walk) const {
    // The next touched bytes are read from a place behind this one, or go on with this.
    if (nextTouch_ < touches_.size()) {
        const std::size_t next = placeOf(touches_[nextTouch_].start);
        if (next == nowhere || next <= parser_->at())
            return false;
    }
    if (!goesOnAlike(walk))
        return false;
    const std::vector<NodeId>& open = parser_->openNodes();
    const std::size_t same = walk.openLevels();
    const std::vector<NodeId> old = openBefore(walk);
    if (open.size() != same + old.size() || (same == 1 && !isClassElement(old.front(), open[1])))
        return false;
    for (std::size_t i = 0; i < open.size(); ++i) {
        const bool isLevel = i < levels_.size() && open[i] == levels_[i].node;
        if (isLevel != (i < same))
            return false;
        if (isLevel)
            continue;
        const Node& before = tree_.nodes_[old[i - same]];
        if (before.kind != tree_.nodes_[open[i]].kind ||
            (before.kind == NodeKind::element &&
             (before.name.from == nowhere || tree_.text(before.name) != tree_.name(open[i]))))
            return false;
    }
    return true;
}

// Were and are these the class element of the file? What follows it is one fault.
bool Reparser::isClassElement(NodeId old, NodeId read) const {
    NodeId element = levels_.front().rest;
    while (element != noNode && !tree_.isElement(element))
        element = tree_.nodes_[element].next;
    return element == old && tree_.classElement(tree_.root()) == read;
}

// Will the same be said of what comes next in the innermost open node?
bool Reparser::goesOnAlike(const OldWalk& walk) const {
    const NodeId top = walk.top();
    if (tree_.nodes_[top].kind != NodeKind::element)
        return false;
    if (walk.next() == noNode)
        return !walk.endTagOf(top).empty(); // else it ends behind its last child
    const auto kindOf = [&](NodeId id) {
        return id != noNode && isElementOrContent(tree_.nodes_[id].kind) ? tree_.nodes_[id].kind
                                                                         : NodeKind::stray;
    };
    return kindOf(walk.before()) == kindOf(tree_.nodes_[parser_->openNodes().back()].lastChild);
}

// The old nodes that were open inside the levels, the outermost first.
std::vector<NodeId> Reparser::openBefore(const OldWalk& walk) const {
    std::vector<NodeId> old;
    const NodeId level = levels_[walk.openLevels() - 1].node;
    for (NodeId id = walk.top(); id != level; id = tree_.nodes_[id].parent)
        old.push_back(id);
    std::reverse(old.begin(), old.end());
    return old;
}

// --- joining what was read with what stays --------------------------------------------------

void Reparser::join(const OldWalk& walk) {
    const std::vector<NodeId> open = parser_->openNodes(), old = openBefore(walk);
    const std::size_t same = walk.openLevels();
    const NodeId next = walk.next();
    closeLevels(same);
    for (std::size_t i = same - 1; i < open.size(); ++i) {
        const bool isLevel = i < same;
        const NodeId parent = isLevel ? open[i] : old[i - same];
        const NodeId inner = i + 1 < open.size() ? old[i + 1 - same] : noNode;
        const NodeId end = inner != noNode ? inner : next;
        const Joint joint{.before = isLevel ? levels_[i].before : noNode,
                          .inner = inner,
                          .after = inner != noNode ? tree_.nodes_[inner].next : next,
                          .last = isLevel ? levels_[i].last : tree_.nodes_[parent].lastChild};
        std::vector<NodeId> removed =
            siblings(isLevel ? levels_[i].rest : tree_.nodes_[parent].firstChild, end);
        std::vector<NodeId> read =
            isLevel ? readIn(levels_[i]) : siblings(tree_.nodes_[open[i]].firstChild);
        if (inner != noNode)
            read.pop_back(); // it is open, and goes on as `inner`
        if (!isLevel)
            adopt(parent, open[i]);
        replaceChildren(parent, joint, std::move(removed), std::move(read));
    }
    for (std::size_t i = 0; i + 1 < same; ++i)
        if (levels_[i].rest != noNode) {
            tree_.nodes_[levels_[i].before].next = levels_[i].rest;
            tree_.nodes_[levels_[i].node].lastChild = levels_[i].last;
        }
}

// Levels that ended while reading: what stood behind the start in them is gone.
void Reparser::closeLevels(std::size_t first) {
    for (std::size_t i = first; i < levels_.size(); ++i)
        replaceChildren(levels_[i].node, {.before = levels_[i].before}, siblings(levels_[i].rest),
                        readIn(levels_[i]));
}

std::vector<NodeId> Reparser::siblings(NodeId first, NodeId end) const {
    std::vector<NodeId> nodes;
    for (NodeId id = first; id != end; id = tree_.nodes_[id].next)
        nodes.push_back(id);
    return nodes;
}

std::vector<NodeId> Reparser::readIn(const Level& level) const {
    return siblings(level.before == noNode ? tree_.nodes_[level.node].firstChild
                                           : tree_.nodes_[level.before].next);
}

// The old node stays, with the start that was read.
void Reparser::adopt(NodeId old, NodeId read) {
    Node &node = tree_.nodes_[old], &now = tree_.nodes_[read];
    const bool isDocument = node.kind == NodeKind::document;
    const text::Range before = isDocument ? node.name : node.startTag;
    const text::Range after = isDocument ? now.name : now.startTag;
    if (isIn(editedTags_, old) || before != after)
        change_.tags.push_back(old);
    if (isDocument)
        documents_.push_back(old);
    node.range.from = now.range.from;
    node.name = now.name;
    node.startTag = now.startTag;
    std::swap(node.firstAttribute, now.firstAttribute);
    std::swap(node.attributeCount, now.attributeCount);
    spare_.push_back(read);
}

void Reparser::replaceChildren(NodeId parent, const Joint& joint, std::vector<NodeId> removed,
                               std::vector<NodeId> added) {
    std::vector<NodeId> all = added;
    keepContent(removed, added, all);
    if (joint.inner != noNode)
        all.push_back(joint.inner);
    NodeId last = joint.before;
    const auto append = [&](NodeId child) {
        (last == noNode ? tree_.nodes_[parent].firstChild : tree_.nodes_[last].next) = child;
    };
    for (const NodeId child : all) {
        append(child);
        tree_.nodes_[child].parent = parent;
        last = child;
    }
    append(joint.after);
    tree_.nodes_[parent].lastChild = joint.after != noNode ? joint.last : last;
    if (!removed.empty() || !added.empty())
        change_.children.push_back({parent, std::move(removed), std::move(added)});
}

} // namespace sgml
