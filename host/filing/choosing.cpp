#include "filing/choosing.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace filing {

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

QString fileNameOf(const QString& title) {
    constexpr qsizetype longest = 80;
    QString name;
    for (const QChar c : title.simplified())
        name += c.isPrint() && !QStringLiteral("/\\:*?\"<>|").contains(c) ? c : QChar(' ');
    name = name.simplified();
    while (name.startsWith('.'))
        name.remove(0, 1);
    if (name.size() > longest) {
        const qsizetype blank = name.lastIndexOf(' ', longest);
        name.truncate(blank > 0 ? blank : longest);
    }
    name = name.trimmed();
    return name.isEmpty() ? QCoreApplication::translate("window", "Untitled") : name;
}

namespace {

constexpr auto folderSetting = "folders/documents";

} // namespace

QString folderUsedLast() {
    const QString last = QSettings().value(folderSetting).toString();
    return !last.isEmpty() && QFileInfo(last).isDir()
               ? last
               : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void rememberFolderOf(const QString& file) {
    QSettings().setValue(folderSetting, QFileInfo(file).absolutePath());
}

} // namespace filing
