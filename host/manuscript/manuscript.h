// A document that is written, and what is selected in it.
#pragma once

#include "document/document.h"
#include "manuscript/grammar.h"

namespace manuscript {

// Bytes of the document, each a place where a caret may stand (place()): in the character data of
// a content, in an element that is empty, or beside an element that is one unit.
using document::Selection;

// The document that is written, and the grammars of its classes. Both outlive it.
struct Manuscript {
    const document::Document& document;
    const Grammars& grammars;
};

enum class Direction { backward, forward };
enum class Unit { character, word }; // a character is a grapheme cluster (Unicode, annex 29)

} // namespace manuscript
