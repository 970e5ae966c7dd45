// A document as plain text: its blocks below each other, wrapped, with markers, tables and
// footnotes.
#pragma once

#include "document/model.h"

#include <QString>

namespace paper {

inline constexpr int textColumns = 78;

// `named` gives the words that stand for a subdocument.
[[nodiscard]] QString plainText(const document::Model& model,
                                const std::function<QString(document::SubdocumentId)>& named);

} // namespace paper
