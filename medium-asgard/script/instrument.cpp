#include "script/instrument.h"

#include "script/commands.h"

#include <charconv>

namespace script {

std::string markFor(std::string_view text) {
    for (int low = 0x80; low < 0xc0; ++low) {
        const std::string mark{'\xee', '\x80', static_cast<char>(low)};
        if (text.find(mark) == std::string_view::npos)
            return mark;
    }
    return {'\xee', '\x81', '\x80'}; // a text with 64 private characters has no places
}

std::string instrumented(std::string_view text, const Structure& structure, std::string_view mark) {
    std::string out;
    out.reserve(text.size() + structure.commands.size() * 12);
    std::size_t copied = 0;
    for (const Command& command : structure.commands) {
        const bool ownOfTcl = isTclCommand(command.name(text));
        if (ownOfTcl && command.substituted)
            continue;
        const std::size_t from = command.range.from;
        out.append(text.substr(copied, from - copied));
        copied = from;
        char digits[24];
        const auto end = std::to_chars(digits, digits + sizeof digits, from).ptr;
        out.append(mark).append(" ").append(digits, end);
        out.append(ownOfTcl ? ";" : " ");
    }
    out.append(text.substr(copied));
    return out;
}

std::string withoutMarks(std::string_view text, std::string_view mark) {
    std::string out;
    while (true) {
        const std::size_t at = text.find(mark);
        if (at == std::string_view::npos)
            return out.append(text);
        out.append(text.substr(0, at));
        text.remove_prefix(at + mark.size());
        if (text.starts_with(' '))
            text.remove_prefix(1);
        while (!text.empty() && text.front() >= '0' && text.front() <= '9')
            text.remove_prefix(1);
        if (text.starts_with(' ') || text.starts_with(';'))
            text.remove_prefix(1);
    }
}

std::string withPlainContinuations(std::string_view text) {
    std::string out(text);
    for (std::size_t at = 0; at + 2 < out.size(); ++at) {
        if (out[at] != '\\')
            continue;
        if (out[at + 1] == '\r' && out[at + 2] == '\n') {
            out[at + 1] = '\n';
            out[at + 2] = ' ';
        }
        ++at; // the character that this backslash escapes
    }
    return out;
}

} // namespace script
