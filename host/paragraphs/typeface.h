// Which font does a text style of a document mean?
#pragma once

#include "schemas/style.h"

#include <QColor>
#include <QFont>
#include <QTextCharFormat>

namespace paragraphs {

[[nodiscard]] QFont fontOf(const schemas::TextStyle& style); // its pixel size is in twips
[[nodiscard]] QTextCharFormat formatOf(const schemas::TextStyle& style);
[[nodiscard]] QColor colorOf(const schemas::Color& color);

// The families that a generic one stands for, best first: what the program's package asks for, then
// what any desktop has.
[[nodiscard]] QStringList familiesOf(const std::string& family);

} // namespace paragraphs
