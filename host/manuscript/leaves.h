// The leaves that a caret can stand in or beside, in the document's order.
//
// A leaf is a content, an element without content, or a unit. A flow is a part of a document whose
// leaves follow each other for somebody who writes: all of it, a footnote, or a nested document of
// text; footnotes and nested documents are units of the flow around them.
#pragma once

#include "manuscript/places.h"
#include "sgml/tree.h"

namespace manuscript {

// The innermost document of text whose class element has all of [from, to] between its tags; the
// whole document when there is none.
[[nodiscard]] sgml::NodeId documentAround(const Manuscript& manuscript, std::size_t from,
                                          std::size_t to);

class Leaves {
public:
    // Of the innermost flow around the offset.
    Leaves(const Manuscript& manuscript, std::size_t offset);

    [[nodiscard]] bool isText() const { return grammar_ != nullptr; } // else there are no leaves
    [[nodiscard]] sgml::NodeId top() const { return top_; }
    [[nodiscard]] const Grammar& grammar() const { return *grammar_; }

    // The leaf that a place belongs to: the content that it is in, else the one that begins or ends
    // there; noNode when it is no place.
    [[nodiscard]] sgml::NodeId at(std::size_t place) const;
    [[nodiscard]] sgml::NodeId beside(sgml::NodeId leaf, Direction direction) const;
    [[nodiscard]] sgml::NodeId outermost(Direction direction) const; // last going forward
    // The nearest leaf with a place at or beyond the offset.
    [[nodiscard]] sgml::NodeId nearest(std::size_t offset, Direction direction) const;
    // How many nodes were looked at, whether they are leaves.
    [[nodiscard]] std::size_t judged() const { return judged_; }

    // The places of a leaf: all between two characters of a content; both ends of a unit.
    [[nodiscard]] std::size_t firstPlace(sgml::NodeId leaf) const;
    [[nodiscard]] std::size_t lastPlace(sgml::NodeId leaf) const;
    [[nodiscard]] bool isContent(sgml::NodeId leaf) const;
    [[nodiscard]] bool isUnit(sgml::NodeId leaf) const;
    [[nodiscard]] bool isVerbatim(sgml::NodeId leaf) const;
    // The element whose line the leaf is in; a unit that is a block of its own.
    [[nodiscard]] sgml::NodeId blockOf(sgml::NodeId leaf) const;

private:
    [[nodiscard]] bool isLeaf(sgml::NodeId node) const;
    [[nodiscard]] sgml::NodeId previousSibling(sgml::NodeId node) const;
    [[nodiscard]] sgml::NodeId lastLeafIn(sgml::NodeId node) const;

    const Manuscript& manuscript_;
    const sgml::Tree& tree_;
    const Grammar* grammar_ = nullptr;
    sgml::NodeId top_ = sgml::noNode;
    mutable std::size_t judged_ = 0;
};

} // namespace manuscript
