#include "source/presentation_draft.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace source {

QString ownPresentation(const QString& name) {
    return QDir(schemas::Schemas::standardFolders().first()).filePath(name);
}

bool hasOwnPresentation(const QString& name) { return QFileInfo::exists(ownPresentation(name)); }

QString putOwnPresentationAside(const QString& name) {
    QFile own(ownPresentation(name));
    QFile::remove(own.fileName() + '~');
    return own.rename(own.fileName() + '~') ? QString() : own.errorString();
}

PresentationDraft::PresentationDraft(const schemas::Schemas::File& file, const QString& own)
    : name_(file.name), saved_(file.text) {
    file_.path = QFile::encodeName(QDir(own).filePath(name_)).toStdString();
    files::ReadFile read =
        files::readFile(files::FileSystem::real(), file_.path, schemas::Schemas::longestFile);
    if (!read.read)
        return;
    file_.stamp = read.stamp;
    saved_ = std::move(read.bytes);
    isCopy_ = false;
}

QString PresentationDraft::path() const { return QFile::decodeName(file_.path.c_str()); }

files::SaveResult PresentationDraft::save(const std::string& text, files::SaveOptions options) {
    QDir().mkpath(QFileInfo(path()).path());
    files::SaveResult result =
        files::saveFile(files::FileSystem::real(), file_.path, text, file_, options);
    if (!result)
        return result;
    saved_ = text;
    isCopy_ = false;
    return result;
}

} // namespace source
