#include "files/failing_files.h"
#include "files/read.h"

#include <gtest/gtest.h>

#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace files {
namespace {

ReadFile read(const std::string& path, std::size_t longest, Source source = Source::stream) {
    return readFile(FileSystem::real(), path, longest, source);
}

TEST(Read, StopsAtItsLimit) {
    const Folder folder;
    const std::string path = folder.put("a", std::string(1000, 'a'));
    EXPECT_TRUE(read(path, 1000).read);
    EXPECT_EQ(read(path, 999).reason, "it is longer than 999 bytes, and no more is read");
    EXPECT_EQ(read(path, 999).bytes, "");
    EXPECT_EQ(read(folder.put("empty", ""), 10).bytes, "");
    EXPECT_TRUE(read(folder.path("empty"), 10).read);
}

// Counts what is read of it.
class CountingReads : public FileSystem {
public:
    std::size_t bytes = 0;
    ssize_t read(int fd, void* to, std::size_t size) override {
        const ssize_t count = FileSystem::read(fd, to, size);
        bytes += count > 0 ? static_cast<std::size_t>(count) : 0;
        return count;
    }
};

TEST(Read, AnInputWithoutEndIsReadUpToTheLimit) {
    CountingReads files;
    const ReadFile zeros = readFile(files, "/dev/zero", 8 << 20, Source::stream);
    EXPECT_EQ(zeros.reason, "it is longer than 8 MB, and no more is read");
    EXPECT_EQ(files.bytes, (8u << 20) + 1);
}

TEST(Read, OnlyFilesWhereOnlyFilesAreWanted) {
    const Folder folder;
    ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(read("/dev/zero", 10, Source::file).reason, "it is not a file");
    EXPECT_EQ(read(folder.path("pipe"), 10, Source::file).reason, "it is not a file");
    EXPECT_EQ(read(folder.path(), 10).reason, "it is a folder");
    EXPECT_EQ(read(folder.path("none"), 10).reason, "No such file or directory");
    EXPECT_EQ(read(folder.path("pipe"), 10).reason, "it is a pipe into which nothing is written");
}

TEST(Read, APipeIsReadToItsEnd) {
    const Folder folder;
    const std::string path = folder.path("pipe"), text(100'000, 'x');
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    // The writer opens first, as a shell does for `asgard check <(make-scene)`.
    const int holds = ::open(path.c_str(), O_RDWR);
    std::thread writer([&] {
        const int fd = ::open(path.c_str(), O_WRONLY);
        for (std::size_t done = 0; done < text.size();)
            done += static_cast<std::size_t>(
                std::max<ssize_t>(0, ::write(fd, text.data() + done, text.size() - done)));
        ::close(holds);
        ::close(fd);
    });
    const ReadFile all = read(path, 200'000);
    writer.join();
    EXPECT_EQ(all.bytes, text) << all.reason;
}

} // namespace
} // namespace files
