// A fault of a document's text: its place, its kind, and a sentence.
//
// An error means that the text is not a document of the format, and was read as well as it goes.
// A warning means that it is one, with something in it that is likely not meant.
#pragma once

#include "text/edit.h"
#include "text/places.h"

#include <string>
#include <vector>

namespace sgml {

enum class Severity { error, warning };

enum class FaultKind {
    badDocumentLine,    // no `DOCUMENT CLASS` where a document begins, or text behind it
    classMismatch,      // the class element's tag is not the class
    emptyDocument,      // no class element
    strayText,          // text that is neither tag nor content
    trailingText,       // something after the document's end
    badTag,             // a tag that is not closed, or has no name
    badAttribute,       // an attribute without name, value or quotes
    duplicateAttribute, // the first one counts
    unterminatedContent,
    missingEndTag,
    unmatchedEndTag,
    mixedContent,  // elements and braced content, or two contents, in one element
    notOfFormat,   // comments, processing instructions, self-closed tags
    nulByte,       // warning
    invalidUtf8,   // warning
    otherEncoding, // UTF-16
    limit,         // the text goes beyond a stated limit and was not read further
};

struct Fault {
    FaultKind kind = FaultKind::strayText;
    Severity severity = Severity::error;
    text::Range range{}; // what to underline; may be empty
    text::Position position{};
    std::string message{}; // one sentence, without place
    bool operator==(const Fault&) const = default;
};

// "file:line:column: error: message"
[[nodiscard]] std::string formatted(const Fault& fault, const std::string& file);

} // namespace sgml
