// A fault in the text of an expression, and its place.
#pragma once

#include <cstddef>
#include <string>

namespace expression {

struct SyntaxError {
    std::size_t from = 0, to = 0; // bytes of the text that are wrong
    std::string message;          // one sentence
    std::string suggestion;
};

} // namespace expression
