// Which bytes of a source are what, and the colours that say so.
#pragma once

#include "sgml/tree.h"

#include <QColor>

#include <functional>

namespace source {

enum class Kind : std::uint8_t {
    word,      // of the format: DOCUMENT and the class
    tag,       // of an element; the selector of a presentation
    attribute, // its name; the name of a property
    value,     // of an attribute, of a property
    scene,     // the text of a medium
    stray,     // what cannot be read
    comment,
};

// The parts without a mark are text.
struct Mark {
    text::Range range;
    Kind kind = Kind::tag;
    bool operator==(const Mark&) const = default;
};

// In order and apart from each other, of the nodes that reach into a range. `isText`: documents of
// that class are text, others a medium's.
[[nodiscard]] std::vector<Mark> marksOf(const sgml::Tree& tree, text::Range range,
                                        const std::function<bool(std::string_view)>& isText);

// On a background that is dark or light; at least 4.5 to 1.
[[nodiscard]] QColor colorOf(Kind kind, bool isDark);
// Behind the line where the pages are.
[[nodiscard]] QColor bandColor(bool isDark);
// Of line numbers.
[[nodiscard]] QColor numberColor(bool isDark);

} // namespace source
