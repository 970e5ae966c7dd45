// Everything that is wrong with a document, in order of place: `ensemble --check`.
#pragma once

#include "document/document.h"
#include "document/schemas.h"

#include <string>
#include <vector>

namespace document {

// Faults of the format, what its schemas do not allow, references to nothing. `media`: classes that
// some installed medium serves; what is wrong inside their texts, only the media know.
[[nodiscard]] std::vector<sgml::Fault>
documentFaults(const Document& document, const Schemas& schemas, const QStringList& media);

// What a medium found at a place in a subdocument's text, as a fault of the document's file.
[[nodiscard]] sgml::Fault subdocumentFault(const Document& document, SubdocumentId id,
                                           sgml::Severity severity, sgml::Position inText,
                                           std::string message);

void sortByPlace(std::vector<sgml::Fault>& faults);

// One line for each: "file:line:column: error: text".
[[nodiscard]] std::string formatted(const std::vector<sgml::Fault>& faults,
                                    const std::string& file);

} // namespace document
