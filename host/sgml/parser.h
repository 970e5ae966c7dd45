// Reads a document's text into a tree. Method: one pass over the bytes with an explicit stack of
// the nodes that are open; every loop either moves on in the text or closes a node, so the time is
// linear in the text whatever it holds. Recovery, in the order in which it is tried:
//
//   an end tag whose element is open further out closes what lies between (missing end tags);
//   an end tag that nothing open answers to is stray;
//   content that is never closed ends before the next end tag of an open element;
//   a tag that is never closed ends before the next `<`; an attribute value, at the end of its
//   line; anything else is stray up to the next `<` or `{`.
//
// Between two items (tags, contents, strays) the whole state is the nodes that are open, what the
// innermost of them holds so far, and the place. So reading can begin at any such place of a text
// whose nodes before it are known: resume().
#pragma once

#include "sgml/tree.h"

#include <unordered_map>
#include <unordered_set>

namespace sgml {

class Parser {
public:
    explicit Parser(Tree& tree);
    void parse();

    // Goes on at `at`, between two items, inside these nodes, the outermost first. The tree holds
    // what stands before `at`, and nothing behind it.
    void resume(std::size_t at, std::vector<NodeId> open);
    // Reads blanks and one item. False: the text has ended, and all nodes are closed.
    bool readNext();
    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] const std::vector<NodeId>& openNodes() const { return open_; }
    [[nodiscard]] bool hasStopped() const { return stopped_; } // at a limit
    // Adds the faults of a document that show only when all of it is read.
    void checkDocument(NodeId document);
    // The faults of bytes [from, to): their encoding alone.
    void checkBytes(text::Range range);

private:
    void begin();
    [[nodiscard]] bool atEnd() const { return at_ >= text_.size(); }
    [[nodiscard]] char here() const { return text_[at_]; }
    [[nodiscard]] bool startsHere(std::string_view token) const;
    [[nodiscard]] NodeId top() const { return open_.back(); }
    void skipBlanks();
    text::Range readName();

    void readItem();
    void readDocumentLine();
    void readStartTag();
    void readAttributes(NodeId element);
    bool readAttribute(NodeId element);
    text::Range readAttributeValue(text::Range name);
    text::Range unquotedValue(text::Range name);
    void keepAttribute(NodeId element, const Attribute& attribute);
    void finishStartTag(NodeId element);
    void readEndTag();
    void readContent();
    [[nodiscard]] std::size_t closingBraceOf(std::size_t open);
    [[nodiscard]] std::size_t endOfUnclosedContent() const;
    void readMarkup();
    void readStray(FaultKind kind, std::string message);

    NodeId addNode(NodeKind kind, text::Range range);
    void checkPlace(NodeKind kind, std::size_t at);
    void checkPlaceInDocument(NodeId document, NodeKind kind, std::size_t at);
    [[nodiscard]] bool isComplete(NodeId document) const { return complete_.contains(document); }
    void open(NodeId node);
    void close(std::size_t end, text::Range endTag);
    [[nodiscard]] std::size_t endOfTop() const;
    void closeMissing(text::Range endTag);
    void closeAllAtEnd();
    void stop(std::string message);

    void fault(FaultKind kind, text::Range range, std::string message,
               Severity severity = Severity::error);
    bool checkEncoding();
    void countUnlisted();

    Tree& tree_;
    std::string_view text_;
    const Limits& limits_;
    std::size_t at_ = 0;
    std::vector<NodeId> open_;
    std::size_t elementDepth_ = 0;
    std::unordered_map<std::string_view, int> openNames_;
    std::unordered_set<NodeId> complete_; // documents that have their class element
    std::size_t nodes_ = 1;               // that were read
    std::vector<std::size_t> unclosed_;
    bool unclosedKnown_ = false;
    bool noMoreQuotes_ = false;
    bool trailingReported_ = false;
    bool stopped_ = false;
    std::size_t unlisted_ = 0;
};

} // namespace sgml
