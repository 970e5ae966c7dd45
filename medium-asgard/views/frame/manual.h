// The manual in a window of its own.
#pragma once

#include <QString>

namespace views {

// At a chapter, or at its beginning. One at a time; it closes with the last other window.
void showManual(const QString& chapter = {});

} // namespace views
