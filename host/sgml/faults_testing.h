// Faults as tests compare them.
#pragma once

#include "sgml/fault.h"

#include <string>
#include <vector>

namespace sgml {

// One line for each: "file:line:column: error: text".
inline std::string formatted(const std::vector<Fault>& faults, const std::string& file) {
    std::string lines;
    for (const Fault& fault : faults)
        lines += formatted(fault, file) + "\n";
    return lines;
}

} // namespace sgml
