// Dialogs that ask how many rows and columns a new table has, and how wide a column is.
#pragma once

#include "authoring/authoring.h"

class QWidget;

namespace menus {

// Nothing: no table is wanted after all.
[[nodiscard]] std::optional<authoring::NewTable> askForTable(bool hasHeaders, QWidget* parent);
// In points; 0: automatic. Nothing: it stays.
[[nodiscard]] std::optional<double> askForWidth(double now, QWidget* parent);

} // namespace menus
