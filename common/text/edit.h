// Changes of a text: which bytes become which, forwards and back, and where a place is afterwards.
//
// Every edit of a list is in offsets of the text before all of them. A list is ordered when its
// ranges ascend and do not overlap; an insertion may touch another edit.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace text {

// Bytes [from, to).
struct Range {
    std::size_t from = 0;
    std::size_t to = 0;
    [[nodiscard]] std::size_t size() const { return to - from; }
    [[nodiscard]] bool empty() const { return to == from; }
    [[nodiscard]] bool contains(std::size_t offset) const { return from <= offset && offset < to; }
    bool operator==(const Range&) const = default;
};

struct Edit {
    Range range;
    std::string text; // what comes in the range's place
    [[nodiscard]] bool empty() const { return range.empty() && text.empty(); }
    bool operator==(const Edit&) const = default;
};

using Edits = std::vector<Edit>;

[[nodiscard]] bool areOrdered(const Edits& edits, std::size_t size);

// Edits that are not ordered change nothing: no text is better than one with parts lost or twice.
[[nodiscard]] std::string applied(std::string_view text, const Edits& edits);

// The edits that undo them, in offsets of the text after.
[[nodiscard]] Edits inverse(std::string_view text, const Edits& edits);

// Orders a list; an insertion stands before what is replaced from the same place on.
void putInOrder(Edits& edits);

// The first that begins at this place; the end of the list, where none does.
[[nodiscard]] Edits::iterator startingAt(Edits& edits, std::size_t place);

// Takes the edit into the list, once. False: another of the list changes the same bytes otherwise.
[[nodiscard]] bool join(Edits& edits, const Edit& edit);

// The side to which a place between two bytes goes when text comes in exactly there.
enum class Gravity {
    before, // it stays before the new text, as the end of a selection does
    behind, // it goes behind the new text, as a caret does
};

// The new offset of a place between two bytes. A replaced range keeps its ends: a place at one
// of them stays at that end of the new text. A place inside goes to the end that `gravity` names.
[[nodiscard]] std::size_t moved(std::size_t place, const Edits& edits, Gravity gravity);

// The new offset of the byte at `offset`; nothing when it was replaced.
[[nodiscard]] std::optional<std::size_t> movedByte(std::size_t offset, const Edits& edits);

} // namespace text
