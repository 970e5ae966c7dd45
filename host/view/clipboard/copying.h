// A part of a document on the clipboard: as plain text, as HTML, and as bytes of our own format.
#pragma once

#include "document/document.h"
#include "model/model.h"

#include <QMimeData>
#include <memory>

namespace view {

// exports::fragment()
inline constexpr auto fragmentFormat = "application/x-ensemble-fragment";

// The content of an interval of the document's bytes.
[[nodiscard]] std::unique_ptr<QMimeData> copied(const document::Document& document,
                                                const model::Model& model, text::Range interval);
// The same of cells of one table, row by row.
[[nodiscard]] std::unique_ptr<QMimeData> copied(const document::Document& document,
                                                const model::Model& model,
                                                const std::vector<sgml::NodeId>& cells);

} // namespace view
