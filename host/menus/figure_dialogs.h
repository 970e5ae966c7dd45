// The dialogs of the menu Figure ask for a size, and for words for those who do not see the figure.
#pragma once

#include <QSizeF>
#include <QString>

#include <optional>

class QWidget;

namespace menus {

// `now` in 1/96 inch. Gives the size that is wanted, an empty one for what the medium would like,
// or nothing when all is to stay.
[[nodiscard]] std::optional<QSizeF> askForSize(QSizeF now, QWidget* parent);
// In one line. Nothing when all is to stay.
[[nodiscard]] std::optional<QString> askForAlternative(const QString& now, QWidget* parent);

} // namespace menus
