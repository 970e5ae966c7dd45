#include "document/check.h"

#include "document/model.h"

#include <algorithm>

namespace document {

std::vector<sgml::Fault> documentFaults(const Document& document, const Schemas& schemas,
                                        const QStringList& media) {
    std::vector<sgml::Fault> faults = document.faults();
    const std::vector<sgml::Fault> structure = structureFaults(document, schemas, media);
    faults.insert(faults.end(), structure.begin(), structure.end());
    const Model model = buildModel(document, schemas.presentation(document.className()), schemas);
    faults.insert(faults.end(), model.warnings.begin(), model.warnings.end());
    sortByPlace(faults);
    return faults;
}

sgml::Fault subdocumentFault(const Document& document, SubdocumentId id, sgml::Severity severity,
                             sgml::Position inText, std::string message) {
    sgml::Fault fault;
    fault.severity = severity;
    fault.position = document.filePosition(id, inText);
    const std::size_t offset = sgml::offsetOf(document.bytes(), fault.position);
    fault.range = {offset, offset};
    fault.message = std::move(message);
    return fault;
}

void sortByPlace(std::vector<sgml::Fault>& faults) {
    std::stable_sort(faults.begin(), faults.end(), [](const sgml::Fault& a, const sgml::Fault& b) {
        return a.position < b.position;
    });
}

std::string formatted(const std::vector<sgml::Fault>& faults, const std::string& file) {
    std::string lines;
    for (const sgml::Fault& fault : faults)
        lines += sgml::formatted(fault, file) + "\n";
    return lines;
}

} // namespace document
