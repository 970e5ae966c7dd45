// Dialogs that ask for a file.
#pragma once

#include <QString>

class QWidget;

namespace filing {

// Of documents, for a file dialog.
[[nodiscard]] QString documentFilter();

// The file to write; "": none. The ending is put behind a name that has none before it is asked
// whether a file is to be replaced.
[[nodiscard]] QString askForFile(QWidget* parent, const QString& title, const QString& proposed,
                                 const QString& filters, const QString& ending);

// A name of a file, without its ending: the title less what file systems do not take.
[[nodiscard]] QString fileNameOf(const QString& title);
// The folder that was used last: it is proposed for a document that has no file yet, and for its
// PDF.
[[nodiscard]] QString folderUsedLast();
void rememberFolderOf(const QString& file);

} // namespace filing
