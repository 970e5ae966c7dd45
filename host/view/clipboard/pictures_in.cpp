#include "clipboard/pictures_in.h"

#include "clipboard/copying.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QUrl>

#include <algorithm>

namespace view {

namespace {

bool isPictureFile(const QUrl& url) {
    static const QStringList endings = {"png", "jpg", "jpeg", "gif", "bmp", "webp", "tif", "tiff"};
    return url.isLocalFile() && endings.contains(QFileInfo(url.toLocalFile()).suffix().toLower());
}

bool holdsFiles(const QMimeData& data) {
    const QList<QUrl> urls = data.urls();
    return !urls.isEmpty() && std::ranges::all_of(urls, isPictureFile);
}

// As the other program spelled it, where it did.
QByteArray bytesOf(const QMimeData& data) {
    for (const auto* format : {"image/png", "image/jpeg", "image/webp", "image/gif"})
        if (QByteArray bytes = data.data(format); !bytes.isEmpty())
            return bytes;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    qvariant_cast<QImage>(data.imageData()).save(&buffer, "PNG");
    return bytes;
}

} // namespace

bool holdsPictures(const QMimeData& data) {
    if (data.hasFormat(fragmentFormat))
        return false;
    const bool hasWords = !data.hasUrls() && !data.text().trimmed().isEmpty();
    return holdsFiles(data) || (data.hasImage() && !hasWords);
}

Pictures taken(const QMimeData& data, const session::PictureHome& home) {
    Pictures pictures;
    const auto add = [&](const session::PictureHome::Kept& kept) {
        pictures.fault = kept.fault;
        if (kept.fault.isEmpty())
            pictures.sources.push_back(kept.source);
        return kept.fault.isEmpty();
    };
    if (!holdsFiles(data)) {
        add(home.keep(bytesOf(data), {}));
        return pictures;
    }
    for (const QUrl& url : data.urls())
        if (!add(home.keepFile(url.toLocalFile())))
            break;
    return pictures;
}

} // namespace view
