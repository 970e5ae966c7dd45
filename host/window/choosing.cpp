#include "window/choosing.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>

namespace window {

QString documentFilter() {
    return QCoreApplication::translate("window", "Documents (*.ens);;All files (*)");
}

QString askForFile(QWidget* parent, const QString& title, const QString& proposed,
                   const QString& filters, const QString& ending) {
    const QFileInfo file(proposed);
    QFileDialog dialog(parent, title, file.absolutePath(), filters);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending);
    dialog.selectFile(file.fileName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace window
