// The colour of what is chosen, and of what the pointer drags.
#pragma once

#include <QColor>

namespace controls {

inline const QColor accent(38, 110, 214);

} // namespace controls
