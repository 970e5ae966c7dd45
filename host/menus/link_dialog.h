// The target of a link.
#pragma once

#include <QString>

#include <optional>

class QWidget;

namespace menus {

// `address`: of the link that is changed, "" for a new one. Gives the address that is wanted, ""
// for no link any more, or nothing when all is to stay.
[[nodiscard]] std::optional<QString> askForLink(const QString& address, QWidget* parent);

} // namespace menus
