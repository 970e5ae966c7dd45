#include "files/read.h"

#include <algorithm>
#include <cerrno>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace files {

std::uint64_t hashOf(std::string_view bytes) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : bytes)
        hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return hash;
}

namespace {

std::string sizeText(std::size_t bytes) {
    constexpr std::size_t kilo = 1024, mega = kilo * kilo;
    if (bytes >= mega)
        return std::to_string(bytes / mega) + " MB";
    return bytes >= kilo ? std::to_string(bytes / kilo) + " KB" : std::to_string(bytes) + " bytes";
}

std::string tooLong(std::size_t longest) {
    return "it is longer than " + sizeText(longest) + ", and no more is read";
}

void waitForBytes(int fd) {
    pollfd wanted{.fd = fd, .events = POLLIN, .revents = 0};
    static_cast<void>(::poll(&wanted, 1, -1));
}

// "" or why not.
std::string readAll(FileSystem& files, int fd, std::size_t longest, std::string& bytes) {
    char buffer[1 << 16];
    for (;;) {
        // One byte more than allowed tells a long input from one that ends here.
        const std::size_t most = std::min(sizeof buffer, longest + 1 - bytes.size());
        const ssize_t count = files.read(fd, buffer, most);
        if (count < 0 && errno == EAGAIN)
            waitForBytes(fd);
        else if (count < 0 && errno != EINTR)
            return reasonOf(errno);
        if (count < 0)
            continue;
        if (count == 0)
            return {};
        bytes.append(buffer, static_cast<std::size_t>(count));
        if (bytes.size() > longest)
            return tooLong(longest);
    }
}

FileStamp stampOf(const struct stat& status, const std::string& bytes) {
    return {.exists = true,
            .size = static_cast<std::uint64_t>(status.st_size),
            .modified =
                std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec,
            .inode = status.st_ino,
            .hash = hashOf(bytes)};
}

ReadFile readOpen(FileSystem& files, int fd, std::size_t longest, Source source) {
    ReadFile result;
    struct stat status {};
    if (files.fstat(fd, &status) != 0)
        result.reason = reasonOf(errno);
    else if (S_ISDIR(status.st_mode))
        result.reason = "it is a folder";
    else if (!S_ISREG(status.st_mode) && source == Source::file)
        result.reason = "it is not a file";
    else if (S_ISREG(status.st_mode) && static_cast<std::size_t>(status.st_size) > longest)
        result.reason = tooLong(longest);
    else
        result.reason = readAll(files, fd, longest, result.bytes);
    if (result.reason.empty() && result.bytes.empty() && S_ISFIFO(status.st_mode))
        result.reason = "it is a pipe into which nothing is written";
    result.read = result.reason.empty();
    if (result.read)
        result.stamp = stampOf(status, result.bytes);
    else
        result.bytes.clear();
    return result;
}

} // namespace

ReadFile readFile(FileSystem& files, const std::string& path, std::size_t longest, Source source) {
    // A pipe that nobody writes into opens at once this way.
    const OpenFile file(files, path, O_RDONLY | O_NONBLOCK | O_NOCTTY);
    if (file.isOpen())
        return readOpen(files, file.fd(), longest, source);
    ReadFile result;
    result.reason = reasonOf(errno);
    return result;
}

ReadFile readStandardInput(FileSystem& files, std::size_t longest) {
    ReadFile result;
    result.reason = readAll(files, STDIN_FILENO, longest, result.bytes);
    result.read = result.reason.empty();
    if (!result.read)
        result.bytes.clear();
    return result;
}

} // namespace files
