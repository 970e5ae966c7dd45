#include "sgml/random_document.h"

#include <array>
#include <string_view>

namespace sgml {

namespace {

constexpr std::array<std::string_view, 12> names = {"CMEMO", "REPORT",    "BODY",    "PARAGRAPH",
                                                    "TEXT",  "EMPH",      "SECTION", "FIGURE",
                                                    "a",     "x-y_z.1:q", "LIST",    "ANIMATION"};
constexpr std::array<std::string_view, 26> pieces = {"a",
                                                     " ",
                                                     "\n",
                                                     "\r\n",
                                                     "\r",
                                                     "\\",
                                                     "{",
                                                     "}",
                                                     "\\\\",
                                                     "\xC3\xA9",
                                                     "\xE2\x82\xAC",
                                                     "\xF0\x9F\x8E\xB2",
                                                     "<",
                                                     ">",
                                                     "</",
                                                     "\"",
                                                     "&",
                                                     "=",
                                                     "\t",
                                                     "word",
                                                     "b1 -init_pos",
                                                     "0.5",
                                                     "</TEXT>",
                                                     "<TEXT>",
                                                     "DOCUMENT",
                                                     "\\n"};
constexpr std::array<std::string_view, 22> intruders = {"<",           ">",
                                                        "{",           "}",
                                                        "\\",          "\"",
                                                        "</",          "</TEXT>",
                                                        "<TEXT>",      "DOCUMENT",
                                                        "DOCUMENT X",  "<DOCUMENT>",
                                                        "</DOCUMENT>", std::string_view("\0", 1),
                                                        "\xFF",        "\xC3",
                                                        "<!--",        "-->",
                                                        "/>",          "\xEF\xBB\xBF",
                                                        "=",           " A=\"1\""};

} // namespace

std::string RandomDocument::blanks() {
    constexpr std::array<std::string_view, 7> kinds = {"", "", "", "\n", " ", "\r\n", "\t\n "};
    return std::string(kinds[below(kinds.size())]);
}

std::string RandomDocument::text(std::size_t longest) {
    std::string result;
    for (std::size_t count = below(longest + 1); count > 0; --count)
        result += pieces[below(pieces.size())];
    return result;
}

std::string RandomDocument::spelling(int depth) {
    std::string result;
    for (std::size_t count = below(6); count > 0; --count) {
        if (depth > 0 && below(4) == 0) {
            result += "{" + spelling(depth - 1) + "}";
        } else if (below(3) == 0) {
            result += "\\n"; // a bare backslash, which stands for itself
        } else {
            for (const char c : text(3)) {
                if (c == '{' || c == '}' || c == '\\')
                    result += '\\';
                result += c;
            }
        }
    }
    return result;
}

std::string RandomDocument::attributes() {
    std::string result;
    for (std::size_t i = below(3); i > 0; --i)
        result += " A" + std::to_string(i) + "=\"{v<>" + std::to_string(below(100)) + "\"";
    return result;
}

std::string RandomDocument::nestedDocument(int depth) {
    const std::string name(names[below(names.size())]);
    return "<DOCUMENT" + attributes() + ">" + blanks() + "DOCUMENT " + name + "\n<" + name +
           attributes() + ">" + element(depth - 1) + "</" + name + ">" + blanks() + "</DOCUMENT>";
}

std::string RandomDocument::element(int depth) {
    if (depth > 0 && below(5) == 0)
        return nestedDocument(depth);
    const std::string name(names[below(names.size())]);
    std::string inside;
    if (depth <= 0 || below(3) == 0) {
        inside = blanks() + "{" + spelling(2) + "}" + blanks();
    } else {
        for (std::size_t i = below(4); i > 0; --i)
            inside += blanks() + element(depth - 1);
    }
    return "<" + name + attributes() + blanks() + ">" + inside + "</" + name + blanks() + ">";
}

std::string RandomDocument::sound() {
    const std::string name(names[below(names.size())]);
    std::string result = below(8) == 0 ? "\xEF\xBB\xBF" : "";
    result += blanks() + "DOCUMENT " + name + "\n<" + name + attributes() + ">";
    for (std::size_t i = below(5); i > 0; --i)
        result += blanks() + element(4);
    return result + "</" + name + ">" + blanks();
}

std::string RandomDocument::mutatedOnce(std::string document) {
    const std::size_t at = below(document.size() + 1);
    const std::size_t length = below(12);
    switch (below(5)) {
    case 0:
        return document.substr(0, at);
    case 1:
        return document.erase(at, length);
    case 2:
        return document.insert(at, document.substr(below(document.size() + 1), length));
    case 3:
        if (at < document.size())
            document[at] = static_cast<char>(below(256));
        return document;
    default:
        return document.insert(at, intruders[below(intruders.size())]);
    }
}

std::string RandomDocument::mutated(std::string document) {
    for (std::size_t count = 1 + below(3); count > 0; --count)
        document = mutatedOnce(std::move(document));
    return document;
}

} // namespace sgml
