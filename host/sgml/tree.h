// The lossless tree of a document: the file's bytes, and nodes that say which bytes are what.
//
// Every byte of the file belongs to bytes(), whether it was understood or not; writing a tree is
// writing bytes(). Nodes live in one array and refer to each other by number, so that no walk and
// no destruction recurses: a document may be nested 20,000 elements deep. A node keeps its number
// through every edit that it outlives (change.h), so numbers say nothing of the document's order:
// following() and isBefore() do.
//
//   document   `DOCUMENT CLASS` and the class element. Node 0 is the file's own; a nested one
//              is the child of its <DOCUMENT> element.
//   element    its tags, attributes, and its children: elements, or one content, or nothing.
//   content    `{...}`, braces included.
//   stray      bytes that are none of these; each comes with a fault.
#pragma once

#include "sgml/escape.h"
#include "sgml/fault.h"
#include "text/edit.h"
#include "text/lines.h"
#include "text/places.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sgml {

using NodeId = std::uint32_t;
inline constexpr NodeId noNode = 0xFFFFFFFF;

enum class NodeKind : std::uint8_t { document, element, content, stray };

struct Attribute {
    text::Range name{};
    text::Range value{}; // between the quotes
    text::Range whole{}; // name, `=` and quotes
    bool operator==(const Attribute&) const = default;
};

struct Node {
    NodeKind kind = NodeKind::element;
    NodeId parent = noNode;
    NodeId firstChild = noNode;
    NodeId lastChild = noNode;
    NodeId next = noNode;
    text::Range range{}; // all of it, tags or braces included
    text::Range
        name{}; // element: its name in the start tag; document: its class in the DOCUMENT line
    text::Range startTag{}; // element only
    text::Range endTag{};   // element only; empty when it is missing
    std::uint32_t firstAttribute = 0;
    std::uint32_t attributeCount = 0;
};

// LIMIT: what is read of one file. Beyond it the bytes are kept, and a fault says where reading
// stopped.
struct Limits {
    std::size_t bytes = std::size_t{256} << 20;
    std::size_t nodes = 2'000'000;
    std::size_t depth = 20'000;  // nested elements
    std::size_t attributes = 64; // of one element
    std::size_t faults = 1'000;  // that are listed; the last one says how many more there are
};

class Tree {
public:
    // Never fails: what cannot be understood is kept as stray bytes, and listed in faults().
    [[nodiscard]] static Tree parse(std::string bytes, const Limits& limits = {});

    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] const std::vector<Fault>& faults() const { return faults_; } // in order of place
    [[nodiscard]] bool isBroken() const; // an error among the faults

    // Every number of a node is less. Numbers of nodes that are gone are among them.
    [[nodiscard]] std::size_t size() const { return nodes_.size(); }
    [[nodiscard]] bool holds(NodeId id) const {
        return id == root() || (id < nodes_.size() && nodes_[id].parent != noNode);
    }
    [[nodiscard]] const Node& node(NodeId id) const { return nodes_[id]; }
    [[nodiscard]] NodeId root() const { return 0; } // the file's document node
    [[nodiscard]] bool isElement(NodeId id) const { return nodes_[id].kind == NodeKind::element; }

    [[nodiscard]] std::string_view text(text::Range range) const;
    // An element's tag, or a document's class (its class element's tag when the line is missing).
    [[nodiscard]] std::string_view name(NodeId id) const;
    [[nodiscard]] std::vector<Attribute> attributes(NodeId element) const;
    [[nodiscard]] std::optional<std::string_view> attribute(NodeId element,
                                                            std::string_view name) const;

    // The first child element of that name (any, when it is empty) or noNode.
    [[nodiscard]] NodeId childElement(NodeId parent, std::string_view name = {}) const;
    [[nodiscard]] NodeId nextElement(NodeId sibling, std::string_view name = {}) const;
    [[nodiscard]] NodeId classElement(NodeId document) const { return childElement(document); }
    // The element's braced content or noNode.
    [[nodiscard]] NodeId content(NodeId element) const;
    // The bytes between the braces, as spelled, and what they stand for.
    [[nodiscard]] text::Range contentRange(NodeId content) const;
    [[nodiscard]] Unescaped unescaped(NodeId content) const;
    // Of an element: the text of its content, "" without one.
    [[nodiscard]] std::string contentText(NodeId element) const;

    // The next node in document order within `top`, or noNode: for (id = top; id != noNode; ...).
    [[nodiscard]] NodeId following(NodeId id, NodeId top = 0) const;
    // The same without going into `id`.
    [[nodiscard]] NodeId followingSkippingChildren(NodeId id, NodeId top = 0) const;
    // Does `a` come before `b` in document order? A parent comes before its children.
    [[nodiscard]] bool isBefore(NodeId a, NodeId b) const;
    // The innermost node that holds the byte at `offset`.
    [[nodiscard]] NodeId innermostAt(std::size_t offset) const;

    // Of a byte: reads its line. Of many, which ascend: reads a line once.
    [[nodiscard]] text::Position position(std::size_t offset) const {
        return lines_.at(offset, bytes_);
    }
    [[nodiscard]] std::vector<text::Position>
    positions(const std::vector<std::size_t>& offsets) const {
        return lines_.at(offsets, bytes_);
    }

    // One line per node: indented kind, name, byte range, attributes, content (for tests and logs).
    [[nodiscard]] std::string printed() const;

    // The same bytes, read as the same nodes with the same places and faults; numbers may differ.
    bool operator==(const Tree& other) const;

private:
    friend class Parser;
    friend class Reparser;
    NodeId newNode();
    void sortFaults();
    [[nodiscard]] bool isSame(NodeId id, const Tree& other, NodeId otherId) const;

    std::string bytes_;
    text::Lines lines_; // of the bytes
    std::vector<Node> nodes_;
    std::vector<NodeId> free_; // numbers of nodes that are gone
    std::vector<Attribute> attributes_;
    std::size_t unusedAttributes_ = 0; // of nodes that are gone
    std::vector<Fault> faults_;
    Limits limits_;
};

// Finds the lines and columns of faults that are in order of place.
void placeFaults(std::vector<Fault>& faults, const Tree& tree);

} // namespace sgml
