// Steps that several commands share: erasing between the marks of a draft, lines to write in.
#pragma once

#include "authoring/draft.h"

namespace authoring {

// Removes what stands between the marks, and joins what remains of two lines. The marks stand at
// the place then, side by side or, where lines are not joined, each at its end.
void eraseBetween(Draft& draft);
// Removes the selection, if there is one; both marks are one caret then.
void makeCaret(Draft& draft, const Selection& selection);
// May the lines of both marks become one?
[[nodiscard]] bool mayJoin(Draft& draft);
// Makes a line for text at the mark: the one it stands in, or a new paragraph beside its block.
// False: none may stand there.
[[nodiscard]] bool makeLine(Draft& draft, Piece& mark);

// A paragraph behind a block; null when none may stand there.
Piece* paragraphBehind(Draft& draft, Piece& block);

// Enter at the first mark; "" when it is done, else the reason why not.
[[nodiscard]] QString breakLine(Draft& draft);
// Line ends as one LF each in preformatted text, as blanks elsewhere.
[[nodiscard]] std::string withLineEnds(std::string_view text, bool isVerbatim);

[[nodiscard]] std::vector<std::string> allowedAt(Draft& draft, Piece& parent, std::size_t index);
[[nodiscard]] bool allows(Draft& draft, Piece& parent, std::size_t index, std::string_view name);

// The innermost element around a piece with that role, or null.
[[nodiscard]] Piece* around(Draft& draft, Piece& piece, schemas::ContainerRole role);

// Puts an element in before the mark, out of the inlined elements that may not hold it. Null:
// nothing around the mark may.
Piece* putInLine(Draft& draft, Piece& mark, std::unique_ptr<Piece> piece);

// Puts a block in between the two halves of the line at the mark, or beside it, or beside what is
// around it. It takes the place of an empty paragraph. Null: it may stand nowhere there, and the
// caller still has it.
Piece* putBlock(Draft& draft, Piece& mark, std::unique_ptr<Piece>&& piece);

// "A figure may not stand here."
[[nodiscard]] QString mayNotStand(const Grammar& grammar, std::string_view name);

// The same step, with which an element gets that ID if it has none. Refused with `isErased` where
// the step takes the element away.
[[nodiscard]] Result withId(const Manuscript& manuscript, sgml::NodeId element,
                            const std::string& id, Result result, const QString& isErased);

[[nodiscard]] inline Refusal refused(const QString& why) { return Refusal{why}; }

} // namespace authoring
