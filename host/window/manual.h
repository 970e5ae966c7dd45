// The manual of keys and buttons: the page docs/reading.md, which goes with the program.
#pragma once

class QWidget;

namespace window {

// In a window of its own, beside the one that asked; one at a time. Escape closes it.
void showManual(QWidget* asked);

} // namespace window
