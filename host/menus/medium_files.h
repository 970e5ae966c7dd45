// Asks for a file of a medium's own kind, as its manifest names them.
#pragma once

#include "processes/manifest.h"

class QWidget;

namespace menus {

// To be read; "": none.
[[nodiscard]] QString askForMediumFile(const media::Manifest& manifest, const QString& title,
                                       QWidget* parent);
// To be written, with the kind's ending; `folder`: where to begin. "": nowhere.
[[nodiscard]] QString askWhereToSave(const media::Manifest& manifest, const QString& folder,
                                     QWidget* parent);

} // namespace menus
