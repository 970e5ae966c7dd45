#include "menus/medium_files.h"

#include <QFileDialog>
#include <QFileInfo>

namespace menus {

namespace {

// The title is the manifest's: a parenthesis of its own would be taken for endings.
QString filters(const media::Manifest& manifest) {
    QString all = QFileDialog::tr("All files (*)");
    if (manifest.fileEndings.isEmpty())
        return all;
    QString title = manifest.filesTitle;
    title.remove('(').remove(')').remove(';');
    QStringList patterns;
    for (const QString& ending : manifest.fileEndings)
        patterns << "*." + ending;
    return QStringLiteral("%1 (%2);;%3").arg(title, patterns.join(' '), all);
}

} // namespace

QString askForMediumFile(const media::Manifest& manifest, const QString& title, QWidget* parent) {
    return QFileDialog::getOpenFileName(parent, title, {}, filters(manifest));
}

QString askWhereToSave(const media::Manifest& manifest, const QString& folder, QWidget* parent) {
    QFileDialog dialog(parent, QFileDialog::tr("Save a Copy"), folder, filters(manifest));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(manifest.fileEndings.value(0));
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace menus
