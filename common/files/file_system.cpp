#include "files/file_system.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <sys/file.h>
#include <unistd.h>

namespace files {

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
int FileSystem::mkdir(const char* path, mode_t mode) { return ::mkdir(path, mode); }
int FileSystem::flock(int fd, int operation) { return ::flock(fd, operation); }
int FileSystem::rename(const char* from, const char* to) { return ::rename(from, to); }
int FileSystem::exchange(const char* one, const char* other) {
    return ::renameat2(AT_FDCWD, one, AT_FDCWD, other, RENAME_EXCHANGE);
}
int FileSystem::unlink(const char* path) { return ::unlink(path); }
char* FileSystem::realpath(const char* path, char* resolved) { return ::realpath(path, resolved); }

std::vector<std::string> FileSystem::names(const std::string& folder) {
    std::vector<std::string> result;
    DIR* stream = ::opendir(folder.c_str());
    if (stream == nullptr)
        return result;
    while (const dirent* entry = ::readdir(stream))
        result.emplace_back(entry->d_name);
    ::closedir(stream);
    return result;
}

FileSystem& FileSystem::real() {
    static FileSystem files;
    return files;
}

std::string reasonOf(int error) { return std::generic_category().message(error); }

std::string nameOf(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::string folderOf(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "./" : path.substr(0, slash + 1);
}

OpenFile::OpenFile(FileSystem& files, const std::string& path, int flags, mode_t mode)
    : files_(files) {
    do
        fd_ = files_.open(path.c_str(), flags | O_CLOEXEC, mode);
    while (fd_ < 0 && errno == EINTR);
}

OpenFile::~OpenFile() {
    if (fd_ >= 0)
        files_.close(fd_);
}

bool OpenFile::writeAll(const std::string& bytes) const {
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

bool OpenFile::sync() const {
    int result;
    do
        result = files_.fsync(fd_);
    while (result < 0 && errno == EINTR);
    return result == 0;
}

bool OpenFile::close() {
    const int result = files_.close(std::exchange(fd_, -1));
    return result == 0 || errno == EINTR;
}

int OpenFile::release() { return std::exchange(fd_, -1); }

} // namespace files
