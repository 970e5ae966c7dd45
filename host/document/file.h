// How a document gets to disk and back without ever being damaged.
//
// Saving: write beside the file, check every write and the sync, put the old file's permissions on
// it, rename over the old one (through symbolic links, to what they lead to), sync the folder, read
// it again and compare. Whatever call fails, the file holds the old content or the new, and "saved"
// is said only when the new content was read back. (QSaveFile says it also when the sync failed.)
#pragma once

#include <QString>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <sys/stat.h>
#include <sys/types.h>

namespace document {

// What a file looked like when it was read or written.
struct FileStamp {
    bool exists = false;
    std::uint64_t size = 0;
    std::int64_t modified = 0; // ns since the epoch
    std::uint64_t inode = 0;
    std::uint64_t hash = 0; // of its content
    bool operator==(const FileStamp&) const = default;
};

enum class FileState { noFile, unchanged, changed, removed };

// Why a document was not written though it could have been: ask the user, then say so in
// SaveOptions.
enum class Refusal {
    none,
    broken,  // faults of the format: what could not be read might be worth keeping
    changed, // another program changed or removed the file since it was read
};

struct SaveOptions {
    bool evenBroken = false;
    bool evenChanged = false;
};

struct SaveResult {
    bool saved = false;
    Refusal refusal = Refusal::none;
    QString sentence{}; // why not, in words for the user; "" when saved
    explicit operator bool() const { return saved; }
};

// The system calls of saving and reading, so that a test can make each of them fail. Results are
// those of the calls: -1 and errno.
class FileSystem {
public:
    virtual ~FileSystem() = default;
    virtual int open(const char* path, int flags, mode_t mode);
    virtual ssize_t write(int fd, const void* bytes, std::size_t size);
    virtual ssize_t read(int fd, void* bytes, std::size_t size);
    virtual int fsync(int fd);
    virtual int close(int fd);
    virtual int fchmod(int fd, mode_t mode);
    virtual int fchown(int fd, uid_t user, gid_t group);
    virtual int access(const char* path, int mode);
    virtual int fstat(int fd, struct stat* status);
    virtual int rename(const char* from, const char* to);
    virtual int unlink(const char* path);
    virtual char* realpath(const char* path, char* resolved); // resolved: PATH_MAX bytes
    [[nodiscard]] static FileSystem& real();
};

struct ReadFile {
    bool read = false;
    std::string bytes;
    FileStamp stamp;
    QString sentence; // why not
};

[[nodiscard]] ReadFile readFile(FileSystem& files, const QString& name, std::size_t longest);
// On success `stamp` is that of the new file.
[[nodiscard]] SaveResult writeFile(FileSystem& files, const QString& name, const std::string& bytes,
                                   FileStamp& stamp);
[[nodiscard]] FileState compareFile(FileSystem& files, const QString& name, const FileStamp& stamp);

} // namespace document
