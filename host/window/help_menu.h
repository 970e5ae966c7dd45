// The menu Help of a window.
#pragma once

#include "session/open_document.h"

#include <QMenu>

namespace window {

// `document` outlives it.
QMenu* makeHelpMenu(session::OpenDocument& document, QWidget* window);

} // namespace window
