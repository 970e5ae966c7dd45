// Everything that is wrong with a document itself, in order of place. session::OpenDocument adds
// faults that media find in their texts, and faults of named files.
#pragma once

#include "document/document.h"
#include "schemas/schemas.h"

#include <string>
#include <vector>

namespace document {

// Faults of the format, what its schemas do not allow, references to nothing. `media`: classes that
// some installed medium serves; what is wrong inside their texts, only the media know.
[[nodiscard]] std::vector<sgml::Fault>
documentFaults(const Document& document, const schemas::Schemas& schemas, const QStringList& media);

// What the schemas do not allow in a document and in its nested documents, as warnings in order of
// place. A class without a schema is a warning unless it is among `media`.
[[nodiscard]] std::vector<sgml::Fault> structureFaults(const Document& document,
                                                       const schemas::Schemas& schemas,
                                                       const QStringList& media);

// An element that shows the picture of a file, or drives a parameter of a subdocument: these are
// sound only if the file and the parameter are there.
struct ImageUse {
    text::Range range;
    std::string source;
};
struct SliderUse {
    text::Range range;
    SubdocumentId subdocument = noSubdocument;
    std::string parameter;
};
[[nodiscard]] std::vector<ImageUse> imageUses(const Document& document,
                                              const schemas::Schemas& schemas);
[[nodiscard]] std::vector<SliderUse> sliderUses(const Document& document,
                                                const schemas::Schemas& schemas);

// In order of place; each with the line and column of its range. Reads the text once.
void placeFaults(std::vector<sgml::Fault>& faults, std::string_view bytes);

} // namespace document
