// A part of a document taken apart, so that a command can rearrange it, and put together again as
// edits of the bytes.
//
// A draft is a tree of pieces: elements, text, the marks of the selection, and rests, which are
// nodes of the document that the command has not opened. A draft keeps parts of the document
// as ranges of bytes; so what a command has not touched is not in
// its edits.
//
//     <P>{one two}</P>    with the caret before "two":
//     element P: text "one ", mark caret, text "two"
//
// Text stands directly in its element, braces and the elements TEXT that a mixture of text and
// elements needs are put in by edits(). An element TEXT of the document stays one.
#pragma once

#include "authoring/authoring.h"
#include "sgml/tree.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace authoring {

struct Piece;
using Pieces = std::vector<std::unique_ptr<Piece>>;

// Blanks between tags: those of the document, or new ones.
struct Gap {
    text::Range kept{};
    std::string fresh{};
};

struct Piece {
    Piece() { ++made; }
    static thread_local std::size_t made; // how many this thread has made, for tests

    enum class Kind { element, text, mark, rest };
    Kind kind = Kind::element;
    Piece* parent = nullptr;
    Pieces children{}; // of an element
    Gap gap{};         // before it
    Gap tail{};        // element: before its end tag

    std::string name{};                // element
    std::string attributes{};          // element: ` TO="a"`, behind those of `start`
    bool isRespelled = false;          // `attributes` are all of them
    sgml::NodeId start = sgml::noNode; // element: whose start tag it keeps
    sgml::NodeId end = sgml::noNode;   // element: whose end tag it keeps
    sgml::NodeId node = sgml::noNode;  // text: the content it is from; rest: the first node
    sgml::NodeId last = sgml::noNode;  // rest: the last node
    text::Range kept{};                // text: its bytes, as they are spelled
    std::string fresh{};               // text that is new, as it is spelled
    std::string raw{};                 // element: all of its bytes, when it is written as it is
    std::size_t mark = 0;              // 0: the anchor, 1: the caret
    bool isCopied = false;             // moved: written where it stands now, deleted where it was

    [[nodiscard]] bool isElement() const { return kind == Kind::element; }
    [[nodiscard]] bool isMark() const { return kind == Kind::mark; }
    [[nodiscard]] bool isText() const { return kind == Kind::text; }
    [[nodiscard]] bool isEmptyText() const { return isText() && kept.empty() && fresh.empty(); }
    [[nodiscard]] std::size_t index() const; // among its parent's children
    [[nodiscard]] Piece* next() const;       // beside it, null for none
    [[nodiscard]] Piece* previous() const;
};

class Draft {
public:
    // Of the document of text that both ends of the selection are in; the marks stand in it.
    Draft(const Manuscript& manuscript, Selection selection);

    // Why there is no draft; "" when there is one. Without one, call nothing else.
    [[nodiscard]] QString obstacle() const;

    [[nodiscard]] Piece& root() { return *root_; } // the class element
    [[nodiscard]] const Grammar& grammar() const { return *grammar_; }
    [[nodiscard]] const sgml::Tree& tree() const { return tree_; }
    [[nodiscard]] Piece& anchor() { return *marks_[0]; }
    [[nodiscard]] Piece& caret() { return *marks_[1]; }
    // The one of both marks that comes first, and the other.
    [[nodiscard]] Piece& first() { return *marks_[anchorFirst_ ? 0 : 1]; }
    [[nodiscard]] Piece& second() { return *marks_[anchorFirst_ ? 1 : 0]; }

    // --- looking
    [[nodiscard]] const Element& of(const Piece& piece) const; // what the element is for a writer
    [[nodiscard]] bool isUnit(const Piece& piece) const;
    [[nodiscard]] bool isInlined(const Piece& piece) const; // an inlined element or text
    // Stands in a line: text, an inlined element, a mark, or a unit in an element that holds text.
    [[nodiscard]] bool isInLine(const Piece& piece) const;
    [[nodiscard]] bool holdsText(const Piece& element) const;
    // The innermost element around a piece that is not inlined; itself if it is one.
    [[nodiscard]] Piece& blockOf(Piece& piece) const;
    // The piece of `ancestor`'s children that holds `piece` or is it.
    [[nodiscard]] static Piece& branch(Piece& piece, const Piece& ancestor);
    [[nodiscard]] static Piece& common(Piece& one, Piece& other);
    // Has the element neither text nor a unit in it? Marks and empty elements do not count.
    [[nodiscard]] bool isBlank(const Piece& piece) const;
    // The same of the pieces of the line before and behind a piece.
    [[nodiscard]] bool isLineBlank(Piece& at, Direction direction);
    // The element piece of a node; opens what holds it.
    Piece& opened(sgml::NodeId element);
    // Is the node within the draft's class element, and within no document in it?
    [[nodiscard]] bool isInside(sgml::NodeId node) const;
    // Takes every rest among the element's children apart.
    void openChildren(Piece& element);
    // One rest: its nodes come to stand beside each other as pieces.
    void openRestAll(Piece& rest);
    // Opens the pieces beside one, marks and empty texts not counted.
    void openBeside(Piece& piece);
    [[nodiscard]] std::string attribute(const Piece& element, std::string_view name) const;

    // The attributes of an element as another one may have them: an ID names one only.
    [[nodiscard]] std::string attributesWithoutId(const Piece& element) const;

    // Sets an attribute; "" removes it.
    void setAttribute(Piece& element, std::string_view name, std::string_view value) const;

    // --- changing
    static std::unique_ptr<Piece> made(std::string name, std::string attributes = {});
    static std::unique_ptr<Piece> madeText(std::string_view plain);
    static Piece& put(Piece& parent, std::size_t index, std::unique_ptr<Piece> piece);
    static std::unique_ptr<Piece> take(Piece& piece);
    static void moveTo(Piece& piece, Piece& parent, std::size_t index);
    // Blanks as between blocks: a line end and the blanks that `like` has before it.
    void putOnLine(Piece& piece, const Piece& like);
    // Splits all elements between the piece and `stop`, so that the piece is the first in the new
    // one, a child of `stop` which has no ID. Returns that one, or the piece itself.
    Piece& split(Piece& before, Piece& stop);
    // Is it an element TEXT without attributes, which is no more than content in braces?
    [[nodiscard]] bool isPlainText(const Piece& piece) const;
    // The first with the children of the second, where both are alike and only marks are between;
    // else the second.
    Piece* joinedWith(Piece& one, Piece& other);
    // Puts the children of an element in its place.
    static void dissolve(Piece& element);
    // Removes inlined elements at a mark that have become empty, up to the block, which keeps an
    // empty text; brings together what is alike on both sides of the mark.
    void tidy(Piece& mark);
    // Moves a mark from between two tags into the text beside it, where there is some.
    void settle(Piece& mark);
    void standBefore(Piece& mark, const Piece* before, Piece* behind) const;
    [[nodiscard]] bool isLineEmpty(const Piece& mark) const;
    // Both marks at the caret, which is one of them where they are apart: the first.
    void collapse();

    // --- the result
    // The first reason against the draft, "" when it is as valid as the document was.
    [[nodiscard]] QString fault() const;
    // The same of one element and its children.
    [[nodiscard]] QString faultOf(const Piece& element) const;
    // Has it a fault that it had not in the document?
    [[nodiscard]] bool isBroken(const Piece& element) const {
        return !isUnchanged(element) && !wasFaulty(element) && !faultOf(element).isEmpty();
    }
    // The names of its first `count` pieces, for the grammar.
    [[nodiscard]] Grammar::Children
    childrenOf(const Piece& element, std::size_t count = static_cast<std::size_t>(-1)) const;
    // The step, or the reason against it.
    [[nodiscard]] Result result(QString label, bool isTyping = false);

private:
    [[nodiscard]] std::unique_ptr<Piece> rest(sgml::NodeId first, sgml::NodeId last) const;
    [[nodiscard]] std::unique_ptr<Piece> element(sgml::NodeId node) const;
    Piece& openIn(Piece& parent, sgml::NodeId child);
    Piece& openRest(Piece& whole, sgml::NodeId before, sgml::NodeId child);
    [[nodiscard]] bool isEntered(sgml::NodeId node, text::Range selection) const;
    void putMark(std::size_t number, std::size_t offset, text::Range selection);
    void putMarkBehind(std::unique_ptr<Piece> mark, Piece& parent, sgml::NodeId before);
    void putMarkInText(std::unique_ptr<Piece> mark, Piece& parent, std::size_t offset);
    [[nodiscard]] std::string blanksOf(const Gap& gap) const;
    [[nodiscard]] std::string attributesOf(const Piece& element) const;
    [[nodiscard]] bool isAlike(const Piece& one, const Piece& other) const;
    void merge(Piece& left, Piece& right);
    bool mergeAround(Piece& at);
    void mergeBeside(Piece& mark);
    static void dropEmptyTexts(Piece& element);
    void dropNeedlessTexts(Piece& element);
    [[nodiscard]] bool isUnchanged(const Piece& element) const;
    [[nodiscard]] bool wasFaulty(const Piece& element) const;

    const Manuscript& manuscript_;
    const sgml::Tree& tree_;
    const Grammar* grammar_ = nullptr;
    std::unique_ptr<Piece> root_;
    std::array<Piece*, 2> marks_{};
    bool anchorFirst_ = true;
};

} // namespace authoring
