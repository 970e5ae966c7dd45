// The words that newcomers write as commands, and what the language has for them.
#pragma once

#include <string>
#include <string_view>

namespace script {

// "write joint NAME -type hinge ..." for "hinge"; "" where nothing is known of the word.
[[nodiscard]] std::string meantBy(std::string_view command);

} // namespace script
