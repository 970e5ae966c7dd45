#include "sgml/fault.h"

namespace sgml {

std::string formatted(const Fault& fault, const std::string& file) {
    return file + ":" + std::to_string(fault.position.line) + ":" +
           std::to_string(fault.position.column) +
           (fault.severity == Severity::error ? ": error: " : ": warning: ") + fault.message;
}

} // namespace sgml
