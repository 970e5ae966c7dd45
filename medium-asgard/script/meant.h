// The words that newcomers write as commands and options, and what the language has for them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace script {

// "write joint NAME -type hinge ..." for "hinge"; "" where nothing is known of the word.
[[nodiscard]] std::string meantBy(std::string_view command);
// All words that meantBy() knows.
[[nodiscard]] std::vector<std::string> meantWords();
// "the velocity is -init_dpos {vx vy vz}" for "-init_vel", where that is one of the existing
// options.
[[nodiscard]] std::string meantByOption(std::string_view option,
                                        std::span<const std::string> existing);

} // namespace script
