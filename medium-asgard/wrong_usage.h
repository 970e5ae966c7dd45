// The fault of a command line, in one sentence that names the wrong word and the expected one.
#pragma once

#include <span>
#include <string>

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace asgard {

// Of an error that parsing these words (without the program's name) has thrown:
//     there is no command "simulte"; did you mean "simulate"?
//     simulate has no option "--acuracy"; did you mean "--accuracy"?
//     --accuracy wants a number, not "abc"
[[nodiscard]] std::string wrongUsage(const CLI::App& app, const CLI::ParseError& error,
                                     std::span<char* const> words);

// A word alone is a scene to open; this says that it is a misspelt command. "": it is none.
[[nodiscard]] std::string misspeltCommand(const CLI::App& app, const std::string& word);

} // namespace asgard
