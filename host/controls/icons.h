// Small line icons for the names that media and menus ask for, drawn by the program itself, so that
// they are there without an icon theme and have the window's text colour.
#pragma once

#include <QIcon>
#include <QString>

namespace controls {

// `name`: as the freedesktop icon names. A null icon when neither the program nor the theme has it.
[[nodiscard]] QIcon iconNamed(const QString& name);

} // namespace controls
