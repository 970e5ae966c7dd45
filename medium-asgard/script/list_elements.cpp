// Tcl's lists: elements in braces, in quotes, or bare with backslashes (Tcl_SplitList).
#include "script/structure.h"

#include <cstdint>

namespace script {

namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\v' || c == '\f' || c == '\r';
}

void appendUtf8(std::string& out, std::uint32_t code) {
    if (code > 0x10ffff)
        code = 0xfffd;
    if (code < 0x80) {
        out += static_cast<char>(code);
    } else if (code < 0x800) {
        out += static_cast<char>(0xc0 | (code >> 6));
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else if (code < 0x10000) {
        out += static_cast<char>(0xe0 | (code >> 12));
        out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else {
        out += static_cast<char>(0xf0 | (code >> 18));
        out += static_cast<char>(0x80 | ((code >> 12) & 0x3f));
        out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    }
}

int digit(char c, int base) {
    const int value = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : 99;
    return value < base ? value : -1;
}

std::size_t number(std::string_view text, std::size_t at, int base, int most, std::uint32_t& code) {
    code = 0;
    for (int i = 0; i < most && at < text.size() && digit(text[at], base) >= 0; ++i, ++at)
        code = code * static_cast<std::uint32_t>(base) +
               static_cast<std::uint32_t>(digit(text[at], base));
    return at;
}

// The backslash sequence that starts at `at`; returns the position after it.
std::size_t backslash(std::string_view text, std::size_t at, std::string& out) {
    if (at + 1 >= text.size()) {
        out += '\\';
        return text.size();
    }
    const char c = text[at + 1];
    constexpr std::string_view letters = "abfnrtv";
    constexpr std::string_view controls = "\a\b\f\n\r\t\v";
    if (const auto known = letters.find(c); known != std::string_view::npos) {
        out += controls[known];
        return at + 2;
    }
    if (c == '\n') {
        at += 2;
        while (at < text.size() && (text[at] == ' ' || text[at] == '\t'))
            ++at;
        out += ' ';
        return at;
    }
    const int digits = c == 'x' ? 2 : c == 'u' ? 4 : c == 'U' ? 8 : 0;
    std::uint32_t code = 0;
    if (digits > 0) {
        const std::size_t after = number(text, at + 2, 16, digits, code);
        if (after > at + 2) {
            appendUtf8(out, code);
            return after;
        }
    } else if (digit(c, 8) >= 0) {
        const std::size_t after = number(text, at + 1, 8, 3, code);
        appendUtf8(out, code & 0xff);
        return after;
    }
    out += c;
    return at + 2;
}

struct ListReader {
    std::string_view text;
    ElementList& list;

    void fail(std::size_t from, std::string message) {
        list.fault = std::move(message);
        list.faultRange = {from, from + 1};
    }

    std::size_t braced(std::size_t from, Element& element) {
        int level = 1;
        std::size_t at = from + 1;
        element.literal = true;
        for (; at < text.size(); ++at) {
            if (text[at] == '{')
                ++level;
            else if (text[at] == '}' && --level == 0)
                break;
            else if (text[at] == '\\' && at + 1 < text.size())
                ++at;
        }
        if (at >= text.size()) {
            fail(from, "a brace of this list is never closed");
            return text.size();
        }
        element.content = {from + 1, at};
        element.value = text.substr(from + 1, at - from - 1);
        return at + 1;
    }

    std::size_t plain(std::size_t from, bool quoted, Element& element) {
        std::size_t at = from + (quoted ? 1 : 0);
        const std::size_t start = at;
        element.literal = true;
        while (at < text.size() && (quoted ? text[at] != '"' : !isBlank(text[at]))) {
            if (text[at] == '\\') {
                element.literal = false;
                at = backslash(text, at, element.value);
            } else {
                element.value += text[at++];
            }
        }
        if (quoted && at >= text.size()) {
            fail(from, "a quote of this list is never closed");
            return text.size();
        }
        element.content = {start, at};
        return quoted ? at + 1 : at;
    }
};

} // namespace

ElementList elementsOf(std::string_view text, std::size_t most) {
    ElementList list;
    ListReader reader{text, list};
    std::size_t at = 0;
    while (list.fault.empty()) {
        while (at < text.size() && isBlank(text[at]))
            ++at;
        if (at >= text.size())
            break;
        if (list.elements.size() >= most) {
            reader.fail(at, "this list is too long");
            break;
        }
        Element element;
        const std::size_t from = at;
        const bool braced = text[at] == '{';
        const bool quoted = text[at] == '"';
        at = braced ? reader.braced(at, element) : reader.plain(at, quoted, element);
        if (list.fault.empty() && (braced || quoted) && at < text.size() && !isBlank(text[at]))
            reader.fail(at, braced ? "a blank is missing after a closing brace of this list"
                                   : "a blank is missing after a closing quote of this list");
        element.range = {from, at};
        if (list.fault.empty())
            list.elements.push_back(std::move(element));
    }
    return list;
}

} // namespace script
