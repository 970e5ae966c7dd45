#include "sgml/tree.h"

#include "sgml/parser.h"
#include "sgml/work.h"

#include <algorithm>

namespace sgml {

Tree Tree::parse(std::string bytes, const Limits& limits) {
    Tree tree;
    tree.bytes_ = std::move(bytes);
    tree.lines_ = text::Lines(tree.bytes_);
    tree.limits_ = limits;
    Parser(tree).parse();
    return tree;
}

bool Tree::isBroken() const {
    return std::any_of(faults_.begin(), faults_.end(),
                       [](const Fault& fault) { return fault.severity == Severity::error; });
}

std::string_view Tree::text(text::Range range) const {
    return std::string_view(bytes_).substr(range.from, range.size());
}

std::string_view Tree::name(NodeId id) const {
    const Node& at = nodes_[id];
    if (at.kind == NodeKind::document && at.name.empty()) {
        const NodeId element = classElement(id);
        return element == noNode ? std::string_view{} : text(nodes_[element].name);
    }
    return text(at.name);
}

std::vector<Attribute> Tree::attributes(NodeId element) const {
    const auto first = attributes_.begin() + nodes_[element].firstAttribute;
    return {first, first + nodes_[element].attributeCount};
}

std::optional<std::string_view> Tree::attribute(NodeId element, std::string_view name) const {
    const Node& at = nodes_[element];
    for (std::uint32_t i = at.firstAttribute; i < at.firstAttribute + at.attributeCount; ++i)
        if (text(attributes_[i].name) == name)
            return text(attributes_[i].value);
    return std::nullopt;
}

NodeId Tree::childElement(NodeId parent, std::string_view name) const {
    const NodeId first = nodes_[parent].firstChild;
    if (first == noNode || (isElement(first) && (name.empty() || this->name(first) == name)))
        return first;
    return nextElement(first, name);
}

NodeId Tree::nextElement(NodeId sibling, std::string_view name) const {
    for (NodeId id = nodes_[sibling].next; id != noNode;
         id = nodes_[id].next, ++work().siblingsPassed)
        if (isElement(id) && (name.empty() || this->name(id) == name))
            return id;
    return noNode;
}

NodeId Tree::content(NodeId element) const {
    for (NodeId id = nodes_[element].firstChild; id != noNode; id = nodes_[id].next)
        if (nodes_[id].kind == NodeKind::content)
            return id;
    return noNode;
}

text::Range Tree::contentRange(NodeId content) const {
    return {nodes_[content].startTag.to, nodes_[content].endTag.from};
}

Unescaped Tree::unescaped(NodeId content) const {
    const text::Range range = contentRange(content);
    return Unescaped(text(range), range.from);
}

std::string Tree::contentText(NodeId element) const {
    const NodeId id = content(element);
    return id == noNode ? std::string{} : unescaped(id).text();
}

NodeId Tree::following(NodeId id, NodeId top) const {
    return nodes_[id].firstChild != noNode ? nodes_[id].firstChild
                                           : followingSkippingChildren(id, top);
}

NodeId Tree::followingSkippingChildren(NodeId id, NodeId top) const {
    while (id != top && nodes_[id].next == noNode)
        id = nodes_[id].parent;
    return id == top ? noNode : nodes_[id].next;
}

// Places decide, except where a parent and its first child begin with the same byte.
bool Tree::isBefore(NodeId a, NodeId b) const {
    if (nodes_[a].range.from != nodes_[b].range.from)
        return nodes_[a].range.from < nodes_[b].range.from;
    for (NodeId above = nodes_[b].parent; above != noNode; above = nodes_[above].parent)
        if (above == a)
            return true;
    return false;
}

NodeId Tree::innermostAt(std::size_t offset) const {
    NodeId innermost = root();
    for (NodeId id = nodes_[innermost].firstChild; id != noNode;) {
        const bool holds = nodes_[id].range.contains(offset);
        if (holds)
            innermost = id;
        id = holds ? nodes_[id].firstChild : nodes_[id].next;
    }
    return innermost;
}

namespace {

std::string rangeText(text::Range range) {
    return " " + std::to_string(range.from) + ".." + std::to_string(range.to);
}

// One line, whatever is in it.
std::string visible(std::string_view text) {
    std::string result;
    for (const char c : text)
        if (c == '\n')
            result += "\\n";
        else if (c == '\r')
            result += "\\r";
        else if (c == '\0')
            result += "\\0";
        else
            result += c;
    return result;
}

} // namespace

std::string Tree::printed() const {
    std::string lines;
    std::vector<std::size_t> depth(nodes_.size(), 0);
    for (NodeId id = root(); id != noNode; id = following(id)) {
        const Node& at = nodes_[id];
        depth[id] = id == root() ? 0 : depth[at.parent] + 1;
        lines.append(2 * depth[id], ' ');
        if (at.kind == NodeKind::document)
            lines += "DOCUMENT " + std::string(text(at.name)) + rangeText(at.range);
        else if (at.kind == NodeKind::element)
            lines += "<" + std::string(name(id)) + ">" + rangeText(at.range);
        else if (at.kind == NodeKind::content)
            lines += "content" + rangeText(at.range) + " {" + visible(text(contentRange(id))) + "}";
        else
            lines += "stray" + rangeText(at.range) + " " + visible(text(at.range));
        if (at.kind == NodeKind::element)
            for (const Attribute& attribute : attributes(id))
                lines += " " + std::string(text(attribute.name)) + "=\"" +
                         visible(text(attribute.value)) + "\"";
        lines += '\n';
    }
    return lines;
}

bool Tree::isSame(NodeId id, const Tree& other, NodeId otherId) const {
    const Node &a = nodes_[id], &b = other.nodes_[otherId];
    return a.kind == b.kind && a.range == b.range && a.name == b.name && a.startTag == b.startTag &&
           a.endTag == b.endTag && attributes(id) == other.attributes(otherId);
}

bool Tree::operator==(const Tree& other) const {
    if (bytes_ != other.bytes_ || faults_ != other.faults_)
        return false;
    NodeId id = root(), there = root();
    while (isSame(id, other, there)) {
        const bool deeper = nodes_[id].firstChild != noNode;
        if (deeper != (other.nodes_[there].firstChild != noNode))
            return false;
        if (deeper) {
            id = nodes_[id].firstChild;
            there = other.nodes_[there].firstChild;
            continue;
        }
        // Up in both as long as neither has a next one.
        while (id != root() && there != root() && nodes_[id].next == noNode &&
               other.nodes_[there].next == noNode) {
            id = nodes_[id].parent;
            there = other.nodes_[there].parent;
        }
        if (id == root() || there == root())
            return id == there;
        id = nodes_[id].next;
        there = other.nodes_[there].next;
        if (id == noNode || there == noNode)
            return false;
    }
    return false;
}

NodeId Tree::newNode() {
    if (free_.empty()) {
        nodes_.emplace_back();
        return static_cast<NodeId>(nodes_.size() - 1);
    }
    const NodeId id = free_.back();
    free_.pop_back();
    nodes_[id] = {};
    return id;
}

} // namespace sgml
