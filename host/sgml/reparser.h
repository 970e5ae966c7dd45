// Makes a tree follow an edit of its bytes by reading no more than the edit can have changed.
//
// Method. The parser's state between two items of the text is the nodes that are open there
// (parser.h). For each edit, reading resumes behind the last item before it that no later byte can
// change, and goes on until it meets an old state: the same rest of the text, the same nodes open,
// and what will be said of the next item the same. From there on the old nodes are right, except
// for the places of their bytes, which were moved before. An edit that breaks the structure meets
// no old state until an enclosing element ends, in the end at none.
//
// If a start tag was read again and then an old state is met inside the element (an attribute
// changed), the element stays, with its children. So does a content whose text changed.
//
// Some faulty items look far ahead: a brace or a quote that is never closed. They are read again
// with every edit behind them.
#pragma once

#include "sgml/change.h"
#include "sgml/old_walk.h"
#include "sgml/parser.h"

#include <optional>

namespace sgml {

class Reparser {
public:
    Reparser(Tree& tree, const text::Edits& edits);
    // The tree's bytes, nodes and faults are those of the edited text.
    [[nodiscard]] Change run();

private:
    // A place at which reading can begin: behind the start tag of `node`, or behind all of it;
    // without a node, at the start of the text.
    struct Start {
        NodeId node = noNode;
        bool isBehind = false;
    };
    // Bytes of the edited text that must be read again.
    struct Touch {
        Start start;
        text::Range range;
    };
    struct Step { // of the search for starts, which goes through the text once
        NodeId child = noNode;
        Start start;
    };

    [[nodiscard]] bool canFollow() const;
    void findTouches(const Shift& shift);
    [[nodiscard]] Start startBefore(std::size_t offset);
    [[nodiscard]] bool isFirmStart(NodeId id) const;
    [[nodiscard]] bool isFirmEnd(NodeId id) const;
    [[nodiscard]] std::size_t placeOf(const Start& start) const;

    void replaceBytes();
    void shiftNodes(const Shift& shift, text::Range hull);
    void shiftNode(NodeId id, const Shift& shift);
    void shiftAttributes(const Shift& shift, text::Range hull);
    void shiftFaults(const Shift& shift);

    void readFrom(const Start& start);
    void cut(const Start& start);
    void useTouches(std::size_t at);
    [[nodiscard]] bool meets(const OldWalk& walk) const;
    [[nodiscard]] bool isClassElement(NodeId old, NodeId read) const;
    [[nodiscard]] bool goesOnAlike(const OldWalk& walk) const;
    [[nodiscard]] std::vector<NodeId> openBefore(const OldWalk& walk) const;

    void join(const OldWalk& walk);
    void closeLevels(std::size_t first);
    void adopt(NodeId old, NodeId read);
    struct Joint { // in a parent's children: before, read or inner, then after
        NodeId before = noNode;
        NodeId inner = noNode; // an old child that stays, whose start was read again
        NodeId after = noNode, last = noNode;
    };
    void replaceChildren(NodeId parent, const Joint& joint, std::vector<NodeId> removed,
                         std::vector<NodeId> added);
    [[nodiscard]] std::vector<NodeId> siblings(NodeId first, NodeId end = noNode) const;
    [[nodiscard]] std::vector<NodeId> readIn(const Level& level) const;
    void keepContent(std::vector<NodeId>& removed, std::vector<NodeId>& added,
                     std::vector<NodeId>& all);

    void forgetFaults(text::Range read);
    void forgetFaultsOf(NodeId document);
    void checkEditedBytes();
    void checkDocuments();
    void freeNodes();
    void packAttributes();
    void readAll();

    Tree& tree_;
    const text::Edits& edits_;
    std::optional<Parser> parser_; // of the edited text
    Change change_;
    std::vector<Step> path_;
    std::vector<Touch> touches_;
    std::size_t nextTouch_ = 0;
    std::size_t required_ = 0; // no old state is met before this place
    std::vector<Level> levels_;
    std::vector<NodeId> editedTags_, editedTexts_; // with edits in their bytes; increasing
    std::vector<NodeId> spare_;                    // were read, and live on in an old node
    std::vector<NodeId> documents_;                // to be checked when all is read
    std::vector<Fault> faults_;                    // that stay
};

} // namespace sgml
