// The places between two items of a text at which reading could go on as it did before an edit: a
// walk over the nodes behind the place where reading anew began, in document order.
#pragma once

#include "sgml/shift.h"

namespace sgml {

// A node that was open where reading anew began.
struct Level {
    NodeId node = noNode;
    NodeId rest = noNode;   // its first child behind that place, before the edit
    NodeId before = noNode; // its last child before that place
    NodeId last = noNode;   // its last child at all, before the edit
    text::Range endTag{};   // before the edit, shifted
};

class OldWalk {
public:
    OldWalk(const Tree& tree, const std::vector<Level>& levels);

    [[nodiscard]] bool atEnd() const { return level_ == noLevel; }
    void advance();
    // The place at which the parser stood, in offsets after the edit; nowhere when the edit
    // replaced that place.
    [[nodiscard]] std::size_t position() const;

    // At that place: the innermost open node, the node last read in it, and the next one.
    [[nodiscard]] NodeId top() const;
    [[nodiscard]] NodeId before() const { return atNodeEnd_ ? node_ : noNode; }
    [[nodiscard]] NodeId next() const;
    [[nodiscard]] text::Range endTagOf(NodeId open) const;
    // How many of the levels were open.
    [[nodiscard]] std::size_t openLevels() const { return level_ + 1; }

private:
    static constexpr std::size_t noLevel = static_cast<std::size_t>(-1);
    void step();
    void enterLevel(std::size_t level);
    [[nodiscard]] bool isBetweenItems() const;
    [[nodiscard]] bool isLevel() const; // at the end of a level's own node

    const Tree& tree_;
    const std::vector<Level>& levels_;
    NodeId node_ = noNode;
    bool atNodeEnd_ = false; // behind the node; else behind its start tag
    std::size_t level_ = 0;  // the innermost level that is open
};

} // namespace sgml
