// A part of a document as other programs take it from the clipboard.
#pragma once

#include "document/document.h"
#include "model/model.h"

#include <string>

namespace exports {

using model::Model;

// Lines are not wrapped. A blank line stands between two blocks, a line end between the items of a
// list and between the rows of a table; a tab between two cells. Markers, numbers and references
// are there as they are shown; footnotes stand at the end.
[[nodiscard]] std::string copiedText(const document::Document& document, const Model& model);

// HTML of the same structure: headings, paragraphs, lists, tables, emphasis, links, footnotes.
// UTF-8, a whole document.
[[nodiscard]] std::string copiedHtml(const document::Document& document, const Model& model);

} // namespace exports
