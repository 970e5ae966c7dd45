// Dialogs that ask for a file.
#pragma once

#include <QString>

class QWidget;

namespace window {

// Of documents, for a file dialog.
[[nodiscard]] QString documentFilter();

// Where to write; "": nowhere. The ending is put behind a name that has none before it is asked
// whether a file is to be replaced.
[[nodiscard]] QString askForFile(QWidget* parent, const QString& title, const QString& proposed,
                                 const QString& filters, const QString& ending);

} // namespace window
