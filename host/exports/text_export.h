// A document as plain text: what its presentation shows, wrapped, with a line for each subdocument.
#pragma once

#include "document/document.h"
#include "model/model.h"

#include <string>

namespace exports {

using model::Model;

// Lines of at most `width` characters where the text can be broken at a blank; tables and verbatim
// lines stay as wide as they are. LIMIT: a character counts as one column wide.
[[nodiscard]] std::string exportText(const document::Document& document, const Model& model,
                                     std::size_t width = 78);

} // namespace exports
