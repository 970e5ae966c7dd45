#include "session/images.h"

#include "session/picture_home.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QThreadPool>

#include <algorithm>
#include <fcntl.h>
#include <mutex>
#include <sys/stat.h>
#include <unistd.h>

namespace session {

namespace {

constexpr int decodedAtOnce = 2; // pictures that are decoded
constexpr int mostMegabytes = 512;

} // namespace

struct Images::Link {
    std::mutex mutex;
    Images* images = nullptr;
};

Images::Images(QObject* parent) : QObject(parent), link_(std::make_shared<Link>()) {
    link_->images = this;
    QImageReader::setAllocationLimit(mostMegabytes);
}

Images::~Images() {
    const std::lock_guard lock(link_->mutex);
    link_->images = nullptr;
}

void Images::setDocument(const QString& fileName) {
    folder_ = PictureHome(fileName).folder();
    paths_.clear();
}

// --- files -------------------------------------------------------------------------------------

QString Images::pathOf(const std::string& source, QString& fault) const {
    const QString name = QString::fromStdString(source);
    const QDir folder(folder_);
    const QString path = QFileInfo(folder.filePath(name)).canonicalFilePath();
    if (name.isEmpty())
        fault = tr("This image names no file.");
    else if (path.isEmpty())
        fault = tr("There is no picture %1.").arg(name);
    else if (!path.startsWith(folder.canonicalPath() + '/'))
        fault = tr("The picture %1 is not in the document's folder or below, and is not read.")
                    .arg(name);
    return fault.isEmpty() ? path : QString();
}

Images::Entry& Images::examined(const std::string& source) {
    QString fault;
    const QString path = pathOf(source, fault);
    paths_[source] = path;
    Entry& entry = entries_[path];
    Entry now;
    const QString name = QString::fromStdString(source);
    QFile file;
    struct stat status {};
    if (!fault.isEmpty()) {
        now.fault = fault;
    } else if (!openRegular(path, file, status)) {
        now.fault = tr("The picture %1 is no file that can be read.").arg(name);
    } else if (status.st_size > mostBytes) {
        now.fault = tr("The picture %1 is longer than 64 MiB and is not read.").arg(name);
    } else {
        now.stamp = {static_cast<qint64>(status.st_dev), static_cast<qint64>(status.st_ino),
                     static_cast<qint64>(status.st_size),
                     static_cast<qint64>(status.st_mtim.tv_sec) * 1'000'000'000 +
                         status.st_mtim.tv_nsec};
        if (now.stamp == entry.stamp)
            return entry;
        QImageReader reader(&file);
        reader.setDecideFormatFromContent(true);
        const bool known = isPixels(reader.format());
        now.size = known ? reader.size() : QSize();
        if (now.size.isEmpty())
            now.fault =
                tr("The file %1 is no picture that is known (PNG, JPEG, GIF, BMP, WebP, TIFF).")
                    .arg(name);
        else if (qint64{now.size.width()} * now.size.height() > mostPixels)
            now.fault =
                tr("The picture %1 has more than 64 million pixels and is not shown.").arg(name);
        if (!now.fault.isEmpty())
            now.size = {};
    }
    drop(entry);
    entry = now;
    return entry;
}

Images::Entry* Images::known(const std::string& source) {
    const auto path = paths_.find(source);
    if (path == paths_.end())
        return &examined(source);
    return &entries_[path->second];
}

QSize Images::size(const std::string& source) { return examined(source).size; }
QString Images::fault(const std::string& source) { return examined(source).fault; }

bool Images::hasFaults() const {
    return std::ranges::any_of(entries_,
                               [](const auto& one) { return !one.second.fault.isEmpty(); });
}

// --- pixels ------------------------------------------------------------------------------------

// The whole, or a half, a quarter, ... of it: as few as have the pixels that are wanted, so that a
// view that is zoomed a little decodes nothing.
QSize Images::decodedSize(QSize whole, QSize wanted) {
    const auto halfOf = [](QSize size) { return QSize(size.width() / 2, size.height() / 2); };
    QSize size = whole;
    for (QSize half = halfOf(size);
         half.width() >= wanted.width() && half.height() >= wanted.height() && !half.isEmpty();
         half = halfOf(size))
        size = half;
    return size;
}

QImage Images::decode(const Job& job) {
    QFile file;
    struct stat status {};
    if (!openRegular(job.path, file, status) || status.st_size > mostBytes)
        return {};
    QImageReader reader(&file);
    reader.setDecideFormatFromContent(true);
    const QSize size = isPixels(reader.format()) ? reader.size() : QSize();
    if (size.isEmpty() || qint64{size.width()} * size.height() > mostPixels)
        return {};
    if (job.size != size)
        reader.setScaledSize(job.size);
    const QImage image = reader.read();
    return image.isNull()
               ? image
               : image.convertToFormat(image.hasAlphaChannel() ? QImage::Format_ARGB32_Premultiplied
                                                               : QImage::Format_RGB32);
}

QImage Images::image(const std::string& source, QSize wanted) {
    Entry& entry = *known(source);
    entry.used = ++uses_;
    if (entry.size.isEmpty())
        return {};
    const QSize size = decodedSize(entry.size, wanted);
    if (entry.image.width() < size.width() && entry.asked.width() < size.width()) {
        entry.asked = size;
        queue_.push_back({paths_[source], entry.stamp, size});
        startNext();
    }
    return entry.image;
}

QImage Images::imageNow(const std::string& source, QSize wanted) {
    Entry& entry = *known(source);
    entry.used = ++uses_;
    if (entry.size.isEmpty())
        return {};
    const QSize size = decodedSize(entry.size, wanted);
    if (entry.image.width() < size.width()) {
        ++decodes_;
        const Job job{paths_[source], entry.stamp, size};
        keep(job.path, entry, decode(job));
    }
    return entry.image;
}

void Images::startNext() {
    while (running_ < decodedAtOnce && !queue_.empty()) {
        ++running_;
        ++decodes_;
        const Job job = std::move(queue_.front());
        queue_.pop_front();
        QThreadPool::globalInstance()->start([job, link = link_] {
            const QImage image = decode(job);
            const std::lock_guard lock(link->mutex);
            if (Images* const images = link->images)
                QMetaObject::invokeMethod(
                    images, [images, job, image] { images->take(job, image); },
                    Qt::QueuedConnection);
        });
    }
}

void Images::take(const Job& job, const QImage& image) {
    --running_;
    startNext();
    const auto of = entries_.find(job.path);
    if (of != entries_.end() && of->second.stamp == job.stamp) {
        if (of->second.asked == job.size)
            of->second.asked = {};
        keep(job.path, of->second, image);
    }
    Q_EMIT ready();
}

// Those that were not used for the longest time make room.
void Images::keep(const QString& path, Entry& entry, const QImage& image) {
    drop(entry);
    if (image.isNull()) {
        entry.size = {};
        entry.fault = tr("The picture %1 is damaged.").arg(QFileInfo(path).fileName());
        return;
    }
    while (kept_ > 0 && kept_ + image.sizeInBytes() > mostKept) {
        Entry* oldest = nullptr;
        for (auto& [other, one] : entries_)
            if (!one.image.isNull() && (oldest == nullptr || one.used < oldest->used))
                oldest = &one;
        drop(*oldest);
    }
    entry.image = image;
    kept_ += image.sizeInBytes();
}

void Images::drop(Entry& entry) {
    kept_ -= entry.image.sizeInBytes();
    entry.image = {};
}

} // namespace session
