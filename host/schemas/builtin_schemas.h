// The schema files of host/schemas/, compiled in: there is always one to use.
#pragma once

#include <vector>

namespace schemas {

struct BuiltInSchema {
    const char* name; // of the file
    const char* text;
};

[[nodiscard]] const std::vector<BuiltInSchema>& builtInSchemas();

} // namespace schemas
