#include "files/failing_files.h"
#include "files/save.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

namespace files {
namespace {

using testing::ElementsAre;

const std::string oldBytes = "DOCUMENT A\n<A>{old}</A>\n";
const std::string newBytes = "DOCUMENT A\n<A>{" + std::string(500, 'n') + "}</A>\n";

KnownFile read(const std::string& path) {
    return {path, readFile(FileSystem::real(), path, 10'000).stamp};
}

// If any call fails, the file is the old one or the new one, and "saved" is never said falsely.
TEST(Save, EveryCallMayFail) {
    const Folder folder;
    int injected = 0;
    const auto isOld = [&](const std::string& name) { return folder.content(name) == oldBytes; };
    for (const int error : {ENOSPC, EIO, EDQUOT, EROFS, EACCES}) {
        for (int nth = 1;; ++nth) {
            KnownFile known = read(folder.put("a.ens", oldBytes));
            FailingFiles files(nth, error);
            const SaveResult result = saveFile(files, known.path, newBytes, known);
            const std::string now = folder.content("a.ens");
            ASSERT_TRUE(now == oldBytes || now == newBytes) << "call " << nth;
            if (result) {
                ASSERT_EQ(now, newBytes) << "call " << nth;
            } else {
                ASSERT_FALSE(result.sentence.empty());
            }
            const bool hasBackup = folder.names().size() == 2;
            ASSERT_EQ(folder.names(), hasBackup ? std::vector<std::string>({"a.ens", "a.ens~"})
                                                : std::vector<std::string>({"a.ens"}))
                << "something is left behind by call " << nth;
            ASSERT_TRUE(!hasBackup || (isOld("a.ens~") && now == newBytes)) << "call " << nth;
            ASSERT_TRUE(hasBackup || files.failed);
            static_cast<void>(::unlink(folder.path("a.ens~").c_str()));
            if (!files.failed)
                break;
            ++injected;
        }
    }
    EXPECT_GT(injected, 100);
}

TEST(Save, AnInterruptedCallIsTriedAgain) {
    const Folder folder;
    for (int nth = 1;; ++nth) {
        const std::string path = folder.put("a.ens", oldBytes);
        FailingFiles files(nth, EINTR);
        FileStamp stamp;
        const SaveResult result = writeFile(files, path, newBytes, stamp);
        const std::string now = folder.content("a.ens");
        ASSERT_TRUE(now == oldBytes || now == newBytes);
        ASSERT_TRUE(!result || now == newBytes);
        if (!files.failed)
            break;
    }
}

TEST(Save, KeepsPermissionsAndFollowsLinks) {
    const Folder folder;
    const std::string path = folder.put("a.ens", oldBytes), link = folder.path("link.ens");
    ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    ASSERT_EQ(::symlink("a.ens", link.c_str()), 0);
    FileStamp stamp;
    ASSERT_TRUE(writeFile(FileSystem::real(), link, newBytes, stamp));
    EXPECT_EQ(folder.content("a.ens"), newBytes);
    struct stat status {};
    ASSERT_EQ(::lstat(link.c_str(), &status), 0);
    EXPECT_TRUE(S_ISLNK(status.st_mode));
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0640u);
    EXPECT_EQ(folder.names().size(), 2u);
}

TEST(Save, SaysWhyInAPlainSentence) {
    const Folder folder;
    FileStamp stamp;
    EXPECT_EQ(writeFile(FileSystem::real(), folder.path("none/a.ens"), newBytes, stamp).sentence,
              "a.ens was not saved: its folder takes no new file (No such file or directory).");
}

TEST(Save, WhatAnotherProgramChangedIsNotOverwrittenUnasked) {
    const Folder folder;
    KnownFile known = read(folder.put("a.al", oldBytes));
    EXPECT_EQ(compareFile(FileSystem::real(), known), FileState::unchanged);
    folder.put("a.al", "another's");
    EXPECT_EQ(compareFile(FileSystem::real(), known), FileState::changed);
    const SaveResult result = saveFile(FileSystem::real(), known.path, newBytes, known);
    EXPECT_EQ(result.refusal, Refusal::changed);
    EXPECT_EQ(result.sentence, "Another program has changed a.al since it was read.");
    EXPECT_EQ(folder.content("a.al"), "another's");
    // Under another name of the same file, too; a file that is not the known one is replaced.
    EXPECT_EQ(saveFile(FileSystem::real(), folder.path("./a.al"), newBytes, known).refusal,
              Refusal::changed);
    KnownFile other = known;
    EXPECT_TRUE(saveFile(FileSystem::real(), folder.path("b.al"), newBytes, other));
    EXPECT_EQ(other.path, folder.path("b.al"));
    EXPECT_TRUE(saveFile(FileSystem::real(), known.path, newBytes, known, {.evenChanged = true}));
    EXPECT_EQ(compareFile(FileSystem::real(), known), FileState::unchanged);
    ASSERT_EQ(::unlink(known.path.c_str()), 0);
    EXPECT_EQ(compareFile(FileSystem::real(), known), FileState::removed);
    EXPECT_TRUE(saveFile(FileSystem::real(), known.path, newBytes, known));
}

TEST(Save, OtherNamesOfTheFileAreNotLeftBehindUnasked) {
    const Folder folder;
    KnownFile known = read(folder.put("a.al", oldBytes));
    ASSERT_EQ(::link(known.path.c_str(), folder.path("b.al").c_str()), 0);
    const SaveResult result = saveFile(FileSystem::real(), known.path, newBytes, known);
    EXPECT_EQ(result.refusal, Refusal::linked);
    EXPECT_EQ(result.sentence,
              "a.al has 2 names (hard links). Saving gives this name a file of its own; under the "
              "other name the old text stays.");
    EXPECT_EQ(folder.content("a.al"), oldBytes);
    ASSERT_TRUE(saveFile(FileSystem::real(), known.path, newBytes, known, {.evenLinked = true}));
    EXPECT_EQ(folder.content("a.al"), newBytes);
    EXPECT_EQ(folder.content("b.al"), oldBytes);
    ASSERT_EQ(::unlink(folder.path("a.al~").c_str()), 0);
    EXPECT_TRUE(saveFile(FileSystem::real(), known.path, oldBytes, known)); // one name each now
}

TEST(Save, PartsOfKilledSavesGo) {
    const Folder folder;
    KnownFile known = read(folder.put("a.al", oldBytes));
    const std::string dead = std::to_string(deadProcess()), mine = std::to_string(::getpid());
    for (const std::string& name :
         {"a.al.part-" + dead, "a.al.part-" + dead + "-1", "a.al.part-" + mine + "-7",
          "b.al.part-" + dead, std::string("a.al.part-x"), std::string("a.al.part-")})
        folder.put(name, "half");
    ASSERT_TRUE(saveFile(FileSystem::real(), known.path, newBytes, known));
    EXPECT_THAT(folder.names(), ElementsAre("a.al", "a.al.part-", "a.al.part-" + mine + "-7",
                                            "a.al.part-x", "a.al~", "b.al.part-" + dead));
}

TEST(Save, TheVersionBeforeIsTheBackup) {
    const Folder folder;
    KnownFile known = read(folder.put("a.al", oldBytes));
    ASSERT_EQ(::symlink("a.al", folder.path("link.al").c_str()), 0);
    const std::string backup = backupOf(FileSystem::real(), folder.path("link.al"));
    EXPECT_EQ(nameOf(backup), "a.al~");
    ASSERT_TRUE(saveFile(FileSystem::real(), folder.path("link.al"), newBytes, known));
    EXPECT_EQ(folder.content("a.al~"), oldBytes);
    ASSERT_TRUE(saveFile(FileSystem::real(), known.path, "third", known));
    EXPECT_EQ(folder.content("a.al~"), newBytes);
    // A text that is overwritten by choice is kept, too; a new file has nothing before it.
    folder.put("a.al", "another's");
    ASSERT_TRUE(saveFile(FileSystem::real(), known.path, "fourth", known, {.evenChanged = true}));
    EXPECT_EQ(folder.content("a.al~"), "another's");
    ASSERT_TRUE(saveFile(FileSystem::real(), folder.path("new.al"), "first", known));
    EXPECT_THAT(folder.names(), ElementsAre("a.al", "a.al~", "link.al", "new.al"));
}

// Another program writes the file just before a call of the save, whichever that is.
class OvertakenFiles : public FailingFiles {
public:
    OvertakenFiles(int nth, std::string path)
        : FailingFiles(-1, 0), nth_(nth), path_(std::move(path)) {}
    int fsync(int fd) override { return act(), FailingFiles::fsync(fd); }
    int access(const char* path, int mode) override {
        return act(), FailingFiles::access(path, mode);
    }
    int exchange(const char* one, const char* other) override {
        return act(), FailingFiles::exchange(one, other);
    }
    int rename(const char* from, const char* to) override {
        return act(), FailingFiles::rename(from, to);
    }
    bool acted = false;

private:
    void act() {
        if (++count_ != nth_)
            return;
        acted = true;
        std::ofstream(path_ + ".theirs", std::ios::binary) << "another's";
        ASSERT_EQ(::rename((path_ + ".theirs").c_str(), path_.c_str()), 0);
    }
    int nth_, count_ = 0;
    std::string path_;
};

TEST(Save, WhatAnotherProgramWritesMeanwhileIsNotLost) {
    const Folder folder;
    int overtaken = 0;
    for (int nth = 1;; ++nth) {
        KnownFile known = read(folder.put("a.al", oldBytes));
        OvertakenFiles files(nth, known.path);
        const SaveResult result = saveFile(files, known.path, newBytes, known);
        if (!files.acted)
            break;
        const std::string now = folder.content("a.al");
        EXPECT_EQ(now, "another's") << "call " << nth;
        // Theirs came after ours, or ours was refused.
        EXPECT_TRUE(result.refusal == Refusal::changed || folder.content("a.al~") == oldBytes);
        overtaken += result.refusal == Refusal::changed ? 1 : 0;
        static_cast<void>(::unlink(folder.path("a.al~").c_str()));
        EXPECT_THAT(folder.names(), ElementsAre("a.al"));
    }
    EXPECT_GT(overtaken, 2);
}

// Another program writes the file before the exchange, which cannot be taken back.
class StuckExchange : public FileSystem {
public:
    int exchange(const char* one, const char* other) override {
        if (++count_ > 1) {
            errno = EIO;
            return -1;
        }
        std::ofstream(other, std::ios::binary) << "another's";
        return FileSystem::exchange(one, other);
    }

private:
    int count_ = 0;
};

TEST(Save, TheirTextIsTheBackupWhereItCannotGetItsNameBack) {
    const Folder folder;
    KnownFile known = read(folder.put("a.al", oldBytes));
    StuckExchange files;
    const SaveResult result = saveFile(files, known.path, newBytes, known);
    EXPECT_FALSE(result);
    EXPECT_THAT(result.sentence, testing::HasSubstr("its text is in a.al~"));
    EXPECT_EQ(folder.content("a.al~"), "another's");
    EXPECT_THAT(folder.names(), ElementsAre("a.al", "a.al~"));
}

} // namespace
} // namespace files
