// A document inside the document, of a medium or of text: what the host must know of it.
#pragma once

#include "sgml/tree.h"

#include <cstdint>
#include <optional>
#include <string>

namespace document {

// Stays the same through every edit, undo and redo, as long as the <DOCUMENT> element is there;
// never used for another one in the life of the Document.
using SubdocumentId = std::uint32_t;
inline constexpr SubdocumentId noSubdocument = 0;

enum class Placement { unspecified, left, center, right, inlined };

struct Subdocument {
    SubdocumentId id = noSubdocument;
    std::string className;                    // names the medium
    std::string storage;                      // tag of the storage element; "" when there is none
    bool hasText = false;                     // the storage element holds content in braces
    int revision = 0;                         // grows with each change of its text
    sgml::NodeId element = sgml::noNode;      // <DOCUMENT>
    sgml::NodeId classElement = sgml::noNode; // <ANIMATION>; noNode in a broken document
    sgml::NodeId content = sgml::noNode;      // the storage element's content, if it has any

    // Attributes of the class element, nothing where they are missing or senseless.
    std::string name;                             // ID
    std::optional<double> width, height;          // 1/96 inch
    Placement placement = Placement::unspecified; // ALIGN
    std::optional<double> poster;                 // s
    std::string alternative;                      // ALT
    std::string presentation; // PRESENTATION: as what its medium shows it; "": as it does usually
};

// LIMIT: lengths of attributes, in 1/96 inch: what no paper and no screen reaches.
inline constexpr double longestLength = 20'000;

// The number that an attribute holds, in C's notation; nothing for what is none or out of bounds.
[[nodiscard]] std::optional<double> numberIn(std::optional<std::string_view> attribute,
                                             double least, double most);

} // namespace document
