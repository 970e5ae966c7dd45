// The system calls of reading, saving and keeping, so that a test can make each of them fail.
// Results are those of the calls: -1 and errno.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <sys/types.h>

namespace files {

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
    virtual int mkdir(const char* path, mode_t mode);
    virtual int flock(int fd, int operation);
    virtual int rename(const char* from, const char* to);
    // Each of two files takes the other's name, at once.
    virtual int exchange(const char* one, const char* other);
    virtual int unlink(const char* path);
    virtual char* realpath(const char* path, char* resolved); // resolved: PATH_MAX bytes
    // The names in a folder, in no order; none when it cannot be read.
    virtual std::vector<std::string> names(const std::string& folder);
    [[nodiscard]] static FileSystem& real();
};

// "No such file or directory".
[[nodiscard]] std::string reasonOf(int error);
// "b" of "a/b"; "a/" or "./" is the folder.
[[nodiscard]] std::string nameOf(const std::string& path);
[[nodiscard]] std::string folderOf(const std::string& path);

// A descriptor that is closed on every way out.
class OpenFile {
public:
    OpenFile(FileSystem& files, const std::string& path, int flags, mode_t mode = 0);
    ~OpenFile();
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] bool isOpen() const { return fd_ >= 0; }
    [[nodiscard]] int fd() const { return fd_; }
    [[nodiscard]] bool writeAll(const std::string& bytes) const;
    [[nodiscard]] bool sync() const;
    // An error here may be the only word about bytes that did not arrive.
    [[nodiscard]] bool close();
    [[nodiscard]] int release(); // whoever calls it closes it

private:
    FileSystem& files_;
    int fd_ = -1;
};

} // namespace files
