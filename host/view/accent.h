// The colour of what is chosen, and of what the pointer drags.
#pragma once

#include <QColor>

namespace view {

inline const QColor accent(38, 110, 214);

} // namespace view
