#include "wrong_usage.h"

#include "script/suggestion.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

namespace asgard {
namespace {

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

bool isOption(const std::string& word) {
    return word.size() > 1 && word[0] == '-' &&
           (word[1] == '-' || std::isalpha(static_cast<unsigned char>(word[1])) != 0);
}

std::string withoutValue(const std::string& word) { return word.substr(0, word.find('=')); }

std::vector<std::string> commandsOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands(nullptr))
        names.push_back(command->get_name());
    return names;
}

std::string didYouMean(const std::string& word, const std::vector<std::string>& existing) {
    const std::string near = script::nearest(word, existing);
    return near.empty() ? "" : "; did you mean " + quoted(near) + "?";
}

std::string unknownCommand(const CLI::App& app, const std::string& word) {
    const std::vector<std::string> commands = commandsOf(app);
    const std::string near = didYouMean(word, commands);
    std::string all;
    for (const std::string& command : commands)
        all += (all.empty() ? "" : ", ") + command;
    return "there is no command " + quoted(word) +
           (near.empty() ? " (commands: " + all + ")" : near);
}

// "": all of them exist.
std::string unknownOption(const CLI::App& command, const std::vector<std::string>& words,
                          const std::string& subject) {
    std::vector<std::string> existing;
    for (const CLI::Option* option : command.get_options())
        if (option->get_name().starts_with("--"))
            existing.push_back(option->get_name());
    for (const std::string& word : words) {
        if (word == "--")
            break;
        const std::string name = withoutValue(word);
        if (isOption(word) && !command.get_option_no_throw(name))
            return subject + " has no option " + quoted(name) + didYouMean(name, existing);
    }
    return "";
}

std::string wishOf(const CLI::Option* option) {
    const std::string type = option ? option->get_type_name() : "";
    return type == "FLOAT" ? "a number" : type == "INT" ? "a whole number" : "a value";
}

// "Could not convert: --accuracy = abc"
std::string unreadableValue(const CLI::App& command, const std::string& message) {
    const auto colon = message.find(": "), equals = message.find(" = ");
    if (colon == std::string::npos || equals == std::string::npos)
        return message;
    const std::string name = message.substr(colon + 2, equals - colon - 2);
    return name + " wants " + wishOf(command.get_option_no_throw(name)) + ", not " +
           quoted(message.substr(equals + 3));
}

// "SCENE is required", "--fixed-step requires --method", "--at: 1 required TEXT missing"
std::string missing(const CLI::App& command, CLI::ExitCodes kind, const std::string& message,
                    const std::string& subject) {
    const std::string first = message.substr(0, message.find_first_of(": "));
    if (kind == CLI::ExitCodes::RequiredError)
        return subject + " wants " + first + ", and it is not there";
    if (kind == CLI::ExitCodes::RequiresError)
        return first + " wants " + message.substr(message.rfind(' ') + 1) + " beside it";
    return first + " wants " + wishOf(command.get_option_no_throw(first)) +
           ", and nothing follows it";
}

} // namespace

std::string misspeltCommand(const CLI::App& app, const std::string& word) {
    std::error_code ignored;
    if (word.empty() || word == "-" || std::filesystem::exists(word, ignored))
        return "";
    const std::string near = didYouMean(word, commandsOf(app));
    return near.empty() ? "" : "there is no file and no command " + quoted(word) + near;
}

std::string wrongUsage(const CLI::App& app, const CLI::ParseError& error,
                       std::span<char* const> argv) {
    const std::vector<std::string> words(argv.begin(), argv.end());
    const auto parsed = app.get_subcommands();
    const CLI::App& command = parsed.empty() ? app : *parsed.front();
    const std::string subject = command.get_name();
    std::error_code ignored;
    if (parsed.empty() && words.size() > 1 && !isOption(words[0]) &&
        !std::filesystem::exists(words[0], ignored))
        return unknownCommand(app, words[0]);
    if (std::string unknown = unknownOption(command, words, subject); !unknown.empty())
        return unknown;
    const auto kind = static_cast<CLI::ExitCodes>(error.get_exit_code());
    const std::string message = error.what();
    if (kind == CLI::ExitCodes::ExtrasError)
        return subject + " takes one SCENE, and " + quoted(words.back()) + " is one too many";
    if (kind == CLI::ExitCodes::ConversionError)
        return unreadableValue(command, message);
    if (kind == CLI::ExitCodes::RequiredError || kind == CLI::ExitCodes::RequiresError ||
        kind == CLI::ExitCodes::ArgumentMismatch)
        return missing(command, kind, message, subject);
    return message;
}

} // namespace asgard
