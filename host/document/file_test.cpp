#include "document/document.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QTemporaryDir>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace document {

namespace {

std::string contentOf(const QString& path) {
    std::ifstream file(path.toStdString(), std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

void put(const QString& path, const std::string& bytes) {
    std::ofstream(path.toStdString(), std::ios::binary) << bytes;
}

// Fails its nth call with an error, or with half of a write; counts all of them.
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
    int rename(const char* from, const char* to) override {
        return fails() ? -1 : FileSystem::rename(from, to);
    }
    int unlink(const char* path) override { return FileSystem::unlink(path); }
    char* realpath(const char* path, char* resolved) override {
        return fails() ? nullptr : FileSystem::realpath(path, resolved);
    }

private:
    bool fails() {
        if (++calls != nth_)
            return false;
        failed = true;
        errno = error_;
        return true;
    }
    int nth_, error_;
};

const std::string oldBytes = "DOCUMENT A\n<A>{old}</A>\n";
const std::string newBytes = "DOCUMENT A\n<A>{" + std::string(500, 'n') + "}</A>\n";

} // namespace

// Whatever call fails, the file is the old one or the new one, and "saved" is never said falsely.
TEST(Save, EveryCallMayFail) {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ens");
    int injected = 0;
    for (const int error : {ENOSPC, EIO, EDQUOT, EROFS, EACCES}) {
        for (int nth = 1;; ++nth) {
            put(path, oldBytes);
            FailingFiles files(nth, error);
            FileStamp stamp;
            const SaveResult result = writeFile(files, path, newBytes, stamp);
            const std::string now = contentOf(path);
            ASSERT_TRUE(now == oldBytes || now == newBytes) << "call " << nth;
            if (result) {
                ASSERT_EQ(now, newBytes) << "call " << nth;
            } else {
                ASSERT_FALSE(result.sentence.isEmpty());
            }
            ASSERT_LE(QDir(folder.path()).entryList(QDir::Files).size(), 1)
                << "nothing is left behind by call " << nth;
            if (!files.failed)
                break;
            ++injected;
        }
    }
    EXPECT_GT(injected, 100);
}

TEST(Save, AnInterruptedCallIsTriedAgain) {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ens");
    for (int nth = 1;; ++nth) {
        put(path, oldBytes);
        FailingFiles files(nth, EINTR);
        FileStamp stamp;
        const SaveResult result = writeFile(files, path, newBytes, stamp);
        ASSERT_TRUE(contentOf(path) == oldBytes || contentOf(path) == newBytes);
        ASSERT_TRUE(!result || contentOf(path) == newBytes);
        if (!files.failed)
            break;
    }
}

TEST(Save, KeepsPermissionsAndFollowsLinks) {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ens"), link = folder.filePath("link.ens");
    put(path, oldBytes);
    ASSERT_EQ(::chmod(path.toStdString().c_str(), 0640), 0);
    ASSERT_EQ(::symlink("a.ens", link.toStdString().c_str()), 0);
    FileStamp stamp;
    ASSERT_TRUE(writeFile(FileSystem::real(), link, newBytes, stamp));
    EXPECT_EQ(contentOf(path), newBytes);
    struct stat status {};
    ASSERT_EQ(::lstat(link.toStdString().c_str(), &status), 0);
    EXPECT_TRUE(S_ISLNK(status.st_mode));
    ASSERT_EQ(::stat(path.toStdString().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0640u);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 2);
}

TEST(Save, SaysWhyInAPlainSentence) {
    QTemporaryDir folder;
    FileStamp stamp;
    const SaveResult result =
        writeFile(FileSystem::real(), folder.filePath("none/a.ens"), newBytes, stamp);
    EXPECT_EQ(result.sentence,
              "a.ens was not saved: its folder takes no new file (No such file or directory).");
    EXPECT_EQ(readFile(FileSystem::real(), folder.path(), 100).sentence.section(' ', 1),
              "cannot be read: it is a folder.");
}

TEST(Save, ADocumentKnowsWhetherItIsModifiedAndWhetherItsFileChanged) {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ens");
    put(path, "DOCUMENT A\n<A><DOCUMENT>DOCUMENT B\n<B><S>{old}</S></B></DOCUMENT></A>\n");
    auto loaded = Document::load(path);
    ASSERT_NE(loaded.document, nullptr);
    Document& document = *loaded.document;
    EXPECT_EQ(document.fileState(), FileState::unchanged);
    const SubdocumentId id = document.subdocuments()[0];
    document.editText(id, 0, {{{0, 3}, "new"}}, "Edit");
    EXPECT_TRUE(document.isModified());
    ASSERT_TRUE(document.save());
    EXPECT_FALSE(document.isModified());
    EXPECT_EQ(contentOf(path), document.bytes());
    document.undo(); // the stack outlives saving
    EXPECT_TRUE(document.isModified());
    put(path, "DOCUMENT A\n<A></A>\n");
    EXPECT_EQ(document.fileState(), FileState::changed);
    EXPECT_EQ(document.save().refusal, Refusal::changed);
    EXPECT_EQ(contentOf(path), "DOCUMENT A\n<A></A>\n");
    ASSERT_TRUE(document.save({.evenChanged = true}));
    ASSERT_TRUE(QFile::remove(path));
    EXPECT_EQ(document.fileState(), FileState::removed);
}

TEST(Save, ABrokenDocumentIsNotOverwrittenUnasked) {
    QTemporaryDir folder;
    const QString path = folder.filePath("a.ens");
    put(path, "DOCUMENT A\n<A>{never closed\n");
    auto loaded = Document::load(path);
    ASSERT_TRUE(loaded.document->isBroken());
    EXPECT_EQ(loaded.document->save().refusal, Refusal::broken);
    EXPECT_TRUE(loaded.document->saveAs(folder.filePath("b.ens")));
    EXPECT_TRUE(loaded.document->saveAs(path));
    auto again = Document::load(path);
    EXPECT_EQ(again.document->saveAs(folder.filePath("./a.ens")).refusal, Refusal::broken);
    EXPECT_TRUE(again.document->save({.evenBroken = true}));
}

TEST(Save, AMissingFileIsASentence) {
    const auto loaded = Document::load("/nonexistent/x.ens");
    EXPECT_EQ(loaded.document, nullptr);
    EXPECT_EQ(loaded.failure, "x.ens cannot be read: No such file or directory.");
}

} // namespace document
