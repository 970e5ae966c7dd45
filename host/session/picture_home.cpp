#include "session/picture_home.h"

#include "files/journal.h"
#include "files/save.h"
#include "session/images.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <QObject>

#include <fcntl.h>
#include <unistd.h>

namespace session {

namespace {

constexpr auto picturesFolder = "pictures";

// A name that every file system takes, without blanks: "Photo of a ball.JPG" is "photo-of-a-ball".
QString stemOf(const QString& name) {
    constexpr qsizetype longest = 40;
    QString stem;
    for (const QChar c : QFileInfo(name).completeBaseName().toLower()) {
        const bool isPlain = c.unicode() < 128 && c.isLetterOrNumber();
        if (isPlain)
            stem += c;
        else if (!stem.isEmpty() && !stem.endsWith('-'))
            stem += '-';
    }
    stem = stem.left(longest);
    while (stem.endsWith('-'))
        stem.chop(1);
    return stem.isEmpty() ? QStringLiteral("picture") : stem;
}

// The ending for the bytes; "": documents do not show them.
QString endingOf(const QByteArray& bytes) {
    QBuffer buffer;
    buffer.setData(bytes);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer);
    reader.setDecideFormatFromContent(true);
    const QByteArray format = reader.format();
    const QSize size = isPixels(format) ? reader.size() : QSize();
    if (size.isEmpty() || qint64{size.width()} * size.height() > Images::mostPixels)
        return {};
    return format == "jpeg" ? QStringLiteral("jpg") : QString::fromLatin1(format);
}

bool isInside(const QString& folder, const QString& path) {
    return path.startsWith(QDir(folder).canonicalPath() + '/');
}

} // namespace

PictureHome::PictureHome(const QString& fileName, const QString& unsaved)
    : folder_(fileName.isEmpty() ? unsaved : QFileInfo(fileName).absoluteDir().path()) {}

QString PictureHome::usualFolder() {
    return QDir::cleanPath(QString::fromStdString(files::journalFolder("ensemble")) +
                           "/../unsaved-pictures");
}

PictureHome::Kept PictureHome::keep(const QByteArray& bytes, const QString& name) const {
    const QString shown = name.isEmpty()
                              ? QObject::tr("The picture")
                              : QObject::tr("The picture %1").arg(QFileInfo(name).fileName());
    if (bytes.size() > Images::mostBytes)
        return {{}, QObject::tr("%1 is longer than 64 MiB and is not taken.").arg(shown)};
    const QString ending = endingOf(bytes);
    if (ending.isEmpty())
        return {
            {},
            QObject::tr("%1 is in no format that is known (PNG, JPEG, GIF, BMP, WebP, TIFF), or "
                        "has more than 64 million pixels.")
                .arg(shown)};
    constexpr int digits = 10;
    const QByteArray sum =
        QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex().left(digits);
    const QString source =
        QStringLiteral("%1/%2-%3.%4")
            .arg(QLatin1String(picturesFolder), stemOf(name), QString::fromLatin1(sum), ending);
    const QString path = QDir(folder_).filePath(source);
    if (!QFileInfo::exists(path)) {
        if (!QDir().mkpath(QFileInfo(path).absolutePath()))
            return {{},
                    QObject::tr("The folder %1 for the document's pictures cannot be made.")
                        .arg(QFileInfo(path).absolutePath())};
        files::FileStamp stamp;
        const files::SaveResult saved =
            files::writeFile(files::FileSystem::real(), QFile::encodeName(path).toStdString(),
                             bytes.toStdString(), stamp);
        if (!saved)
            return {{}, QString::fromStdString(saved.sentence)};
    }
    return {source.toStdString(), {}};
}

PictureHome::Kept PictureHome::keepFile(const QString& path) const {
    QString fault;
    const QByteArray bytes = pictureBytes(path, fault);
    return fault.isEmpty() ? keep(bytes, path) : Kept{{}, fault};
}

// A file outside of the folder that a stranger's name leads to is left where it is.
QStringList PictureHome::bring(const std::vector<std::string>& sources, const QString& from) const {
    QStringList faults;
    if (from.isEmpty() || QDir(from) == QDir(folder_))
        return faults;
    for (const std::string& source : sources) {
        const QString name = QString::fromStdString(source);
        const QString clean = QDir::cleanPath(name);
        const QString old = QFileInfo(QDir(from).filePath(name)).canonicalFilePath();
        const QString to = QDir(folder_).filePath(clean);
        if (name.isEmpty() || QDir::isAbsolutePath(name) || clean.startsWith(QLatin1String("..")) ||
            old.isEmpty() || !isInside(from, old) || QFileInfo::exists(to))
            continue;
        QString fault;
        const QByteArray bytes = pictureBytes(old, fault);
        files::FileStamp stamp;
        if (fault.isEmpty() && !QDir().mkpath(QFileInfo(to).absolutePath()))
            fault = QObject::tr("The folder %1 cannot be made.").arg(QFileInfo(to).absolutePath());
        if (fault.isEmpty())
            fault = QString::fromStdString(files::writeFile(files::FileSystem::real(),
                                                            QFile::encodeName(to).toStdString(),
                                                            bytes.toStdString(), stamp)
                                               .sentence);
        if (!fault.isEmpty())
            faults << QObject::tr("The picture %1 was not copied: %2").arg(name, fault);
    }
    return faults;
}

// --- files -------------------------------------------------------------------------------------

bool isPixels(const QByteArray& format) {
    static const QList<QByteArray> formats = {"png", "jpeg", "jpg", "gif", "bmp", "webp", "tiff"};
    return formats.contains(format);
}

bool openRegular(const QString& path, QFile& file, struct stat& status) {
    const int fd =
        ::open(QFile::encodeName(path).constData(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (fd < 0)
        return false;
    if (::fstat(fd, &status) == 0 && S_ISREG(status.st_mode) &&
        file.open(fd, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle))
        return true;
    ::close(fd);
    return false;
}

QByteArray pictureBytes(const QString& path, QString& fault) {
    const QString name = QFileInfo(path).fileName();
    QFile file;
    struct stat status {};
    if (!openRegular(path, file, status))
        fault = QObject::tr("The picture %1 is no file that can be read.").arg(name);
    else if (status.st_size > Images::mostBytes)
        fault = QObject::tr("The picture %1 is longer than 64 MiB and is not read.").arg(name);
    return fault.isEmpty() ? file.read(Images::mostBytes + 1) : QByteArray();
}

} // namespace session
