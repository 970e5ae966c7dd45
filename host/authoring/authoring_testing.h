// Documents written short, for tests: `|` is the caret, `[` the anchor of a selection, and the
// names of elements are shortened. Braces are those of the format.
//
//     <P>{One[ two|}</P>
#pragma once

#include "authoring/authoring.h"

#include "schemas/schemas.h"

#include <array>
#include <string>
#include <utility>

namespace authoring {

inline constexpr std::array<std::pair<std::string_view, std::string_view>, 12> shortNames = {
    {{"P", "PARAGRAPH"},
     {"T", "TEXT"},
     {"E", "EMPH"},
     {"B", "STRONG"},
     {"S", "SECTION"},
     {"H", "HEADING"},
     {"L", "LIST"},
     {"I", "ITEM"},
     {"V", "VERBATIM"},
     {"F", "FOOTNOTE"},
     {"R", "ROW"},
     {"C", "CELL"}}};

// Replaces the names in tags, `from` by `to`.
inline std::string renamed(std::string text, bool shorten) {
    for (const auto& [brief, full] : shortNames) {
        const std::string_view from = shorten ? full : brief, to = shorten ? brief : full;
        for (const std::string open : {"<", "</"})
            for (const char end : {'>', ' '}) {
                const std::string tag = open + std::string(from) + end;
                for (std::size_t at = 0; (at = text.find(tag, at)) != std::string::npos;)
                    text.replace(at, tag.size(), open + std::string(to) + end);
            }
    }
    return text;
}

struct Marked {
    std::string bytes;
    Selection selection;
};

inline Marked readMarks(std::string text) {
    Marked marked;
    const std::size_t anchor = text.find('[');
    if (anchor != std::string::npos)
        text.erase(anchor, 1);
    marked.selection.caret = text.find('|');
    text.erase(marked.selection.caret, 1);
    marked.selection.anchor = anchor == std::string::npos       ? marked.selection.caret
                              : anchor > marked.selection.caret ? anchor - 1
                                                                : anchor;
    marked.bytes = std::move(text);
    return marked;
}

inline std::string withMarks(std::string bytes, Selection selection) {
    const auto [anchor, caret] = selection;
    if (anchor > caret)
        bytes.insert(anchor, "[");
    bytes.insert(caret, "|");
    if (anchor < caret)
        bytes.insert(anchor, "[");
    return bytes;
}

inline const schemas::Schemas& testSchemas() {
    static const schemas::Schemas all = schemas::Schemas::builtIn();
    return all;
}

inline const Grammars& testGrammars() {
    static const Grammars all(testSchemas());
    return all;
}

} // namespace authoring
