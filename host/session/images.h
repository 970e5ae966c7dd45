// The pictures of a document that are files: in its own folder or below, and from nowhere else.
//
// A file is opened without waiting, read only when it is a regular one, and within limits. Its size
// comes from its header; the picture itself is decoded in another thread, once for each file and
// change of it, at the resolution that is needed, and kept for all views and for paper while there
// is room.
#pragma once

#include <QImage>
#include <QObject>
#include <QSize>

#include <deque>
#include <map>
#include <memory>
#include <string>

namespace session {

class Images : public QObject {
    Q_OBJECT

public:
    explicit Images(QObject* parent = nullptr);
    ~Images() override;

    // The document's file. Without one there are no pictures.
    void setDocument(const QString& fileName);

    // As the file's header says now, in pixels; empty: there is no picture, and fault() says why. A
    // file of which only the header is sound is found out when it is decoded.
    [[nodiscard]] QSize size(const std::string& source);
    [[nodiscard]] QString fault(const std::string& source);

    // The image as far as it is there, at once, null when nothing is. If it has fewer pixels than
    // are wanted, more are asked for, and ready() tells.
    [[nodiscard]] QImage image(const std::string& source, QSize wanted);
    // The same, decoded here and now if it must be.
    [[nodiscard]] QImage imageNow(const std::string& source, QSize wanted);
    [[nodiscard]] bool hasFaults() const; // of those that were asked for
    [[nodiscard]] bool isWaiting() const { return running_ > 0 || !queue_.empty(); }
    [[nodiscard]] int decodes() const { return decodes_; } // so far

    // LIMIT: of a file; of a picture; of what is kept decoded.
    static constexpr qint64 mostBytes = qint64{64} << 20;
    static constexpr qint64 mostPixels = 64'000'000;
    static constexpr qint64 mostKept = qint64{256} << 20; // bytes

Q_SIGNALS:
    void ready(); // one more is there

private:
    struct Stamp {
        qint64 device = 0, inode = 0, bytes = 0, changed = 0;
        bool operator==(const Stamp&) const = default;
    };
    struct Entry {
        Stamp stamp;
        QSize size;
        QString fault;
        QImage image;
        QSize asked; // of what is being decoded
        quint64 used = 0;
    };
    struct Job {
        QString path;
        Stamp stamp;
        QSize size;
    };
    struct Link; // to this object, for threads that may outlive it

    Entry& examined(const std::string& source);
    [[nodiscard]] QString pathOf(const std::string& source, QString& fault) const;
    [[nodiscard]] Entry* known(const std::string& source);
    static QSize decodedSize(QSize whole, QSize wanted);
    static QImage decode(const Job& job);
    void startNext();
    void take(const Job& job, const QImage& image);
    void keep(const QString& path, Entry& entry, const QImage& image);
    void drop(Entry& entry);

    QString folder_;
    std::map<std::string, QString> paths_; // by source; "": none
    std::map<QString, Entry> entries_;     // by path
    std::deque<Job> queue_;
    int running_ = 0;
    int decodes_ = 0;
    quint64 uses_ = 0;
    qint64 kept_ = 0; // bytes of all entries
    std::shared_ptr<Link> link_;
};

} // namespace session
