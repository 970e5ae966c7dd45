// HTML of other programs as a fragment of a document: its structure in the elements of a class.
#pragma once

#include "manuscript/grammar.h"

#include <QString>

#include <string>

namespace view {

// Paragraphs, headings with their sections, lists, tables, emphasis, code and links; where the
// class has no element for one of these, its text stays. Colours, fonts and pictures are left out.
// "": there is no text in it.
[[nodiscard]] std::string fragmentOf(const QString& html, const manuscript::Grammar& grammar);

// LIMIT: of longer HTML the plain text is pasted.
inline constexpr qsizetype longestHtml = 4'000'000;

} // namespace view
