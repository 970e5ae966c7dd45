// The commands and words of a scene's text, without evaluating anything.
//
// Editors highlight by them, evaluation is instrumented by them, and they give every value its
// place in the text. Reading follows Tcl's rules for commands, words and substitutions (Tcl(n))
// exactly, and goes into nested scripts: command substitutions, also inside expressions, and the
// words of Tcl's control commands that are scripts. Never recurses deeper than `maximumDepth`.
//
// LIMIT: scripts handed to commands that an author defines are words to us, not scripts; elements
// that they make have no place in the text of their own.
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace script {

using scene::Range;

// Deeper nesting of scripts is left to Tcl, and has no places.
constexpr int maximumDepth = 100;

struct Word {
    Range range;          // with its braces or quotes
    Range content;        // without them
    bool literal = false; // the content is the value: no $, no [, no backslash that is substituted
    bool braced = false;
    bool quoted = false;
    bool expanded = false; // {*} before it (part of range, not of content), its words not known
    bool fromList = false; // one of the words of {*}{a b ...}
};

struct Command {
    Range range; // from the first byte of the first word to the last of the last
    std::vector<Word> words;
    int parent = -1;          // index of the command in whose word this one stands
    bool substituted = false; // in brackets: its result becomes part of that word
    // The name as written; "" when it is computed.
    [[nodiscard]] std::string_view name(std::string_view text) const;
};

struct Fault { // what keeps the text from being a script
    Range range;
    std::string message;
};

struct Structure {
    std::vector<Command> commands; // by where they start; outer before inner
    std::vector<Range> comments;
    std::vector<Fault> faults; // at most one per script; all that precedes it is there

    // The innermost command that holds this byte, or null.
    [[nodiscard]] const Command* at(std::size_t offset) const;
    // The command that starts there, or null; of several the outermost.
    [[nodiscard]] const Command* startingAt(std::size_t offset) const;
};

[[nodiscard]] Structure structureOf(std::string_view text);
// How many this thread has made: each goes through a whole text.
[[nodiscard]] std::size_t structuresMade();

// One element of a Tcl list: its place in the list's text and its value.
struct Element {
    Range range;          // with braces or quotes
    Range content;        // without
    bool literal = false; // the content is the value
    std::string value;
};

struct ElementList {
    std::vector<Element> elements;
    std::string fault; // "" when the text is a list
    Range faultRange;
};

// Tcl's rules for lists. Stops at the first fault, and after `most` elements.
[[nodiscard]] ElementList elementsOf(std::string_view list, std::size_t most = 200'000);

} // namespace script
