// Offsets of a text as lines and columns.
#pragma once

#include "scene/diagnostic.h"

#include <string_view>
#include <vector>

namespace script {

struct Place {
    int line = 1;   // from 1
    int column = 1; // from 1, in characters
};

class Places {
public:
    explicit Places(std::string_view text);
    [[nodiscard]] Place at(std::size_t offset) const;
    // Fills in the lines and columns of a diagnostic from its range.
    void locate(scene::Diagnostic& diagnostic) const;

private:
    std::string_view text_;
    [[nodiscard]] std::size_t charactersBefore(std::size_t offset) const;
    static constexpr std::size_t blockSize = 256;
    std::vector<std::size_t> lines_;  // where each starts
    std::vector<std::size_t> blocks_; // characters before each block of bytes
};

} // namespace script
