#include "document/file.h"

#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace document {

// --- the calls ------------------------------------------------------------------------------

int FileSystem::open(const char* path, int flags, mode_t mode) { return ::open(path, flags, mode); }
ssize_t FileSystem::write(int fd, const void* bytes, std::size_t size) {
    return ::write(fd, bytes, size);
}
ssize_t FileSystem::read(int fd, void* bytes, std::size_t size) { return ::read(fd, bytes, size); }
int FileSystem::fsync(int fd) { return ::fsync(fd); }
int FileSystem::close(int fd) { return ::close(fd); }
int FileSystem::fchmod(int fd, mode_t mode) { return ::fchmod(fd, mode); }
int FileSystem::fchown(int fd, uid_t user, gid_t group) { return ::fchown(fd, user, group); }
int FileSystem::access(const char* path, int mode) { return ::access(path, mode); }
int FileSystem::fstat(int fd, struct stat* status) { return ::fstat(fd, status); }
int FileSystem::rename(const char* from, const char* to) { return ::rename(from, to); }
int FileSystem::unlink(const char* path) { return ::unlink(path); }
char* FileSystem::realpath(const char* path, char* resolved) { return ::realpath(path, resolved); }

FileSystem& FileSystem::real() {
    static FileSystem files;
    return files;
}

namespace {

// FNV-1a, 64 bit: tells contents apart, defends against nobody.
std::uint64_t hashOf(const std::string& bytes) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : bytes)
        hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return hash;
}

QString reasonOf(int error) { return QString::fromLocal8Bit(std::strerror(error)); }

// A descriptor that is closed on every way out.
class OpenFile {
public:
    OpenFile(FileSystem& files, const std::string& path, int flags, mode_t mode = 0)
        : files_(files) {
        do
            fd_ = files_.open(path.c_str(), flags | O_CLOEXEC, mode);
        while (fd_ < 0 && errno == EINTR);
    }
    ~OpenFile() {
        if (fd_ >= 0)
            files_.close(fd_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] bool isOpen() const { return fd_ >= 0; }
    [[nodiscard]] int fd() const { return fd_; }

    [[nodiscard]] bool writeAll(const std::string& bytes) const {
        for (std::size_t written = 0; written < bytes.size();) {
            const ssize_t count = files_.write(fd_, bytes.data() + written, bytes.size() - written);
            if (count < 0 && errno != EINTR)
                return false;
            if (count == 0) {
                errno = ENOSPC;
                return false;
            }
            written += count > 0 ? static_cast<std::size_t>(count) : 0;
        }
        return true;
    }

    [[nodiscard]] bool readAll(std::string& bytes, std::size_t longest) const {
        char buffer[1 << 16];
        for (;;) {
            const ssize_t count = files_.read(fd_, buffer, sizeof buffer);
            if (count < 0 && errno == EINTR)
                continue;
            if (count <= 0)
                return count == 0;
            bytes.append(buffer, static_cast<std::size_t>(count));
            if (bytes.size() > longest) {
                errno = EFBIG;
                return false;
            }
        }
    }

    [[nodiscard]] bool sync() const {
        int result;
        do
            result = files_.fsync(fd_);
        while (result < 0 && errno == EINTR);
        return result == 0;
    }

    // An error here may be the only word about bytes that did not arrive.
    [[nodiscard]] bool close() {
        const int result = files_.close(fd_);
        fd_ = -1;
        return result == 0 || errno == EINTR;
    }

private:
    FileSystem& files_;
    int fd_ = -1;
};

FileStamp stampOf(const struct stat& status, const std::string& bytes) {
    return {.exists = true,
            .size = static_cast<std::uint64_t>(status.st_size),
            .modified =
                std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec,
            .inode = status.st_ino,
            .hash = hashOf(bytes)};
}

std::string pathOf(const QString& name) { return QFile::encodeName(name).toStdString(); }

std::string folderOf(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

// Where a chain of symbolic links ends, so that saving replaces the file and not the link.
std::string resolved(FileSystem& files, const std::string& path) {
    char buffer[PATH_MAX];
    return files.realpath(path.c_str(), buffer) != nullptr ? std::string(buffer) : path;
}

} // namespace

// --- reading --------------------------------------------------------------------------------

ReadFile readFile(FileSystem& files, const QString& name, std::size_t longest) {
    ReadFile result;
    const auto refuse = [&](const QString& reason) {
        result.sentence =
            QStringLiteral("%1 cannot be read: %2.").arg(QFileInfo(name).fileName(), reason);
        return result;
    };
    const OpenFile file(files, pathOf(name), O_RDONLY | O_NONBLOCK);
    struct stat status {};
    if (!file.isOpen() || files.fstat(file.fd(), &status) != 0)
        return refuse(reasonOf(errno));
    if (S_ISDIR(status.st_mode))
        return refuse(QStringLiteral("it is a folder"));
    if (!S_ISREG(status.st_mode))
        return refuse(QStringLiteral("it is not a file"));
    if (!file.readAll(result.bytes, longest)) {
        result.bytes.clear();
        return refuse(reasonOf(errno));
    }
    result.stamp = stampOf(status, result.bytes);
    result.read = true;
    return result;
}

FileState compareFile(FileSystem& files, const QString& name, const FileStamp& stamp) {
    if (name.isEmpty() || !stamp.exists)
        return FileState::noFile;
    struct stat status {};
    {
        const OpenFile file(files, pathOf(name), O_RDONLY | O_NONBLOCK);
        if (!file.isOpen() && (errno == ENOENT || errno == ENOTDIR))
            return FileState::removed;
        if (!file.isOpen() || files.fstat(file.fd(), &status) != 0)
            return FileState::changed;
    }
    const FileStamp now = stampOf(status, {});
    if (now.size == stamp.size && now.modified == stamp.modified && now.inode == stamp.inode)
        return FileState::unchanged;
    // Touched or copied over itself: what is in it decides.
    const ReadFile again = readFile(files, name, static_cast<std::size_t>(stamp.size));
    return again.read && again.stamp.hash == stamp.hash ? FileState::unchanged : FileState::changed;
}

// --- writing --------------------------------------------------------------------------------

namespace {

// One save: the steps in their order, each with its sentence, cleaned up behind when one fails.
class Save {
public:
    Save(FileSystem& files, const QString& name, const std::string& bytes)
        : files_(files), name_(QFileInfo(name).fileName()), path_(resolved(files, pathOf(name))),
          bytes_(bytes) {}

    SaveResult run(FileStamp& stamp) {
        if (!writeBeside() || !moveOver() || !readBack(stamp))
            return {.sentence = sentence_};
        return {.saved = true};
    }

private:
    bool fail(const QString& what) {
        sentence_ = QStringLiteral("%1 was not saved: %2.").arg(name_, what);
        return false;
    }
    bool fail(const char* what, int error) {
        return fail(QString::fromUtf8(what).arg(reasonOf(error)));
    }

    // The old file's mode and owner; 0666 under the user's mask for a new one.
    bool oldStatus(struct stat& status, bool& exists) {
        const OpenFile old(files_, path_, O_RDONLY | O_NONBLOCK);
        exists = old.isOpen() && files_.fstat(old.fd(), &status) == 0;
        if (exists && !S_ISREG(status.st_mode))
            return fail(QStringLiteral("it is not a file"));
        if (!exists && errno != ENOENT)
            return fail("the old file cannot be looked at (%1)", errno);
        // Renaming over it would work, but whoever made it read-only meant it.
        if (exists && files_.access(path_.c_str(), W_OK) != 0)
            return fail("it may not be written (%1)", errno);
        return true;
    }

    bool writeBeside() {
        struct stat old {};
        bool exists = false;
        if (!oldStatus(old, exists))
            return false;
        temporary_ = freeName();
        OpenFile file(files_, temporary_, O_WRONLY | O_CREAT | O_EXCL, exists ? 0600 : 0666);
        if (!file.isOpen())
            return fail("its folder takes no new file (%1)", errno);
        if (!file.writeAll(bytes_))
            return abandon("the disk did not take it (%1)", errno);
        if (exists && !keepRights(file, old))
            return abandon("the old file's permissions cannot be kept (%1)", errno);
        if (!file.sync())
            return abandon("the disk did not confirm it (%1)", errno);
        if (!file.close())
            return abandon("the disk did not take it (%1)", errno);
        return true;
    }

    // Beside the file, since only within one file system a rename replaces at once.
    std::string freeName() {
        const std::string stem = path_ + ".part-" + std::to_string(::getpid());
        std::string name = stem;
        for (int i = 1; i < 100 && files_.access(name.c_str(), F_OK) == 0; ++i)
            name = stem + "-" + std::to_string(i);
        return name;
    }

    // Another owner is kept where the system allows it; the mode always. The mode comes last, since
    // a change of owner clears bits of it.
    bool keepRights(const OpenFile& file, const struct stat& old) {
        struct stat mine {};
        if (files_.fstat(file.fd(), &mine) != 0)
            return false;
        if (mine.st_uid != old.st_uid || mine.st_gid != old.st_gid)
            (void)files_.fchown(file.fd(), old.st_uid, old.st_gid);
        return files_.fchmod(file.fd(), old.st_mode & 07777) == 0;
    }

    bool moveOver() {
        if (files_.rename(temporary_.c_str(), path_.c_str()) != 0)
            return abandon("the new version cannot take its place (%1)", errno);
        const OpenFile folder(files_, folderOf(path_), O_RDONLY | O_DIRECTORY);
        // Some file systems cannot sync a folder, and say EINVAL; on those the rename is all there
        // is.
        if (!folder.isOpen() || (!folder.sync() && errno != EINVAL))
            return fail("the disk did not confirm it (%1); the file may hold the old version after "
                        "a power cut",
                        errno);
        return true;
    }

    bool readBack(FileStamp& stamp) {
        const ReadFile again = readFile(files_, QFile::decodeName(path_.c_str()), bytes_.size());
        if (!again.read || again.bytes != bytes_)
            return fail(QStringLiteral("what was read back is not what was written"));
        stamp = again.stamp;
        return true;
    }

    bool abandon(const char* what, int error) {
        (void)files_.unlink(temporary_.c_str());
        return fail(what, error);
    }

    FileSystem& files_;
    QString name_;
    std::string path_;
    const std::string& bytes_;
    std::string temporary_;
    QString sentence_;
};

} // namespace

SaveResult writeFile(FileSystem& files, const QString& name, const std::string& bytes,
                     FileStamp& stamp) {
    return Save(files, name, bytes).run(stamp);
}

} // namespace document
