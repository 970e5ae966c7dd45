// System calls for tests of what saves: the nth fails. To remove a file and to list a folder never
// fail here: what a failed save leaves behind could not be tested else.
#pragma once

#include "files/file_system.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>

namespace files {

// Fails its nth call with an error; writes come in pieces of 100 bytes. Counts all of them.
class FailingFiles : public FileSystem {
public:
    FailingFiles(int nth, int error) : nth_(nth), error_(error) {}
    int calls = 0;
    bool failed = false;

    int open(const char* path, int flags, mode_t mode) override {
        return fails() ? -1 : FileSystem::open(path, flags, mode);
    }
    ssize_t write(int fd, const void* bytes, std::size_t size) override {
        return fails() ? -1 : FileSystem::write(fd, bytes, std::min<std::size_t>(size, 100));
    }
    ssize_t read(int fd, void* bytes, std::size_t size) override {
        return fails() ? -1 : FileSystem::read(fd, bytes, size);
    }
    int fsync(int fd) override { return fails() ? -1 : FileSystem::fsync(fd); }
    int close(int fd) override {
        const bool fail = fails();
        const int result = FileSystem::close(fd); // the descriptor is gone in any case
        errno = fail ? error_ : errno;
        return fail ? -1 : result;
    }
    int fchmod(int fd, mode_t mode) override { return fails() ? -1 : FileSystem::fchmod(fd, mode); }
    int fchown(int fd, uid_t user, gid_t group) override {
        return fails() ? -1 : FileSystem::fchown(fd, user, group);
    }
    int access(const char* path, int mode) override {
        return fails() ? -1 : FileSystem::access(path, mode);
    }
    int fstat(int fd, struct stat* status) override {
        return fails() ? -1 : FileSystem::fstat(fd, status);
    }
    int mkdir(const char* path, mode_t mode) override {
        return fails() ? -1 : FileSystem::mkdir(path, mode);
    }
    int flock(int fd, int operation) override {
        return fails() ? -1 : FileSystem::flock(fd, operation);
    }
    int rename(const char* from, const char* to) override {
        return fails() ? -1 : FileSystem::rename(from, to);
    }
    int exchange(const char* one, const char* other) override {
        return fails() ? -1 : FileSystem::exchange(one, other);
    }
    char* realpath(const char* path, char* resolved) override {
        return fails() ? nullptr : FileSystem::realpath(path, resolved);
    }

protected:
    bool fails() {
        if (++calls != nth_)
            return false;
        failed = true;
        errno = error_;
        return true;
    }

private:
    int nth_, error_;
};

// A folder of a test's own, with what it puts there.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string path(const std::string& name = {}) const {
        return name.empty() ? path_ : path_ + "/" + name;
    }
    std::string put(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }
    [[nodiscard]] std::string content(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        std::ostringstream bytes;
        bytes << file.rdbuf();
        return bytes.str();
    }
    [[nodiscard]] std::vector<std::string> names(const std::string& under = {}) const {
        std::vector<std::string> all = FileSystem::real().names(path(under));
        std::erase_if(all, [](const auto& name) { return name == "." || name == ".."; });
        std::ranges::sort(all);
        return all;
    }

private:
    std::string path_;
};

// The number of a process that is no more.
[[nodiscard]] pid_t deadProcess();

} // namespace files
