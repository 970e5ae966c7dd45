#include "files/failing_files.h"
#include "files/journal_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>

#include <sys/wait.h>
#include <unistd.h>

namespace files {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Kept sample() {
    return {.file = {"/home/some one/a.ens",
                     {.exists = true, .size = 7, .modified = -3, .inode = 5, .hash = ~0ull}},
            .at = 1'700'000'000,
            .text = std::string("text 3\n\0end\n\xff", 13),
            .drafts = {{"0", "a\nb"}, {"17", ""}}};
}

class JournalTest : public testing::Test {
protected:
    [[nodiscard]] std::string journal() const { return home_.path("state/ensemble/unsaved"); }
    [[nodiscard]] std::vector<std::string> names() const {
        return home_.names("state/ensemble/unsaved");
    }
    // Keeps in a process of its own, which is then killed.
    void keepAndDie(const std::vector<Kept>& all) const {
        const pid_t child = ::fork();
        if (child == 0) {
            for (const Kept& kept : all) {
                auto claimed = Place::claim(FileSystem::real(), journal());
                auto& place = std::get<std::unique_ptr<Place>>(claimed);
                if (!place->keep(kept).empty())
                    ::_exit(1);
                static_cast<void>(place.release());
            }
            ::raise(SIGKILL);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status));
    }
    [[nodiscard]] AllLeft left() const { return leftBehind(FileSystem::real(), journal()); }
    [[nodiscard]] std::unique_ptr<Place> claimed() const {
        auto place = Place::claim(FileSystem::real(), journal());
        return std::move(std::get<std::unique_ptr<Place>>(place));
    }

    Folder home_;
};

TEST(Kept, IsReadAsItWasWritten) {
    for (const Kept& kept : {sample(), Kept{}, Kept{.text = "\n"}}) {
        const auto again = decoded(encoded(kept));
        ASSERT_TRUE(std::holds_alternative<Kept>(again));
        EXPECT_EQ(std::get<Kept>(again), kept);
    }
}

TEST(Kept, EveryCutAndEveryChangedByteIsNoticed) {
    const std::string bytes = encoded(sample());
    for (std::size_t cut = 0; cut + 1 < bytes.size(); ++cut)
        EXPECT_FALSE(std::holds_alternative<Kept>(decoded(bytes.substr(0, cut)))) << cut;
    for (std::size_t at = 0; at + 1 < bytes.size(); ++at) {
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ 1);
        EXPECT_FALSE(std::holds_alternative<Kept>(decoded(changed))) << at;
    }
}

TEST(Kept, AnyBytesAreReadOrRefused) {
    std::mt19937 random(1);
    const std::string bytes = encoded(sample());
    for (int i = 0; i < 20'000; ++i) {
        std::string changed = bytes;
        for (int n = 0; n < 3; ++n)
            changed[random() % changed.size()] = "0123456789\n e"[random() % 13];
        static_cast<void>(decoded(changed));
    }
    EXPECT_TRUE(std::get<Unreadable>(decoded("unsaved-text 2\nend 0\n")).forLater);
    EXPECT_FALSE(std::get<Unreadable>(decoded("")).forLater);
}

TEST_F(JournalTest, WhatAKilledProcessKeptIsFoundAndCanBeHeld) {
    keepAndDie({sample(), {.text = "another"}});
    const AllLeft all = left();
    ASSERT_THAT(all.texts, SizeIs(2));
    EXPECT_EQ(all.texts[0].kept, sample()); // the newest first
    EXPECT_EQ(all.texts[1].kept.text, "another");
    EXPECT_THAT(left().texts, IsEmpty()); // nobody else is offered what is held
}

TEST_F(JournalTest, IsForTheUserAlone) {
    const auto place = claimed();
    ASSERT_EQ(place->keep(sample()), "");
    struct stat status {};
    ASSERT_EQ(::stat(place->path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0600u);
    ASSERT_EQ(::stat(journal().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0700u);
}

TEST_F(JournalTest, WhatALivingProcessKeepsIsNotLeft) {
    int ready[2], done[2];
    ASSERT_EQ(::pipe(ready) + ::pipe(done), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto place = claimed();
        char byte = place->keep(sample()).empty() ? 'k' : 'f';
        static_cast<void>(::write(ready[1], &byte, 1) + ::read(done[0], &byte, 1));
        ::_exit(0);
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    ASSERT_EQ(byte, 'k');
    EXPECT_THAT(left().texts, IsEmpty());
    EXPECT_THAT(names(), SizeIs(2)); // and nothing of it was removed
    ASSERT_EQ(::write(done[1], &byte, 1), 1);
    ::waitpid(child, nullptr, 0);
    EXPECT_THAT(left().texts, SizeIs(1));
}

TEST_F(JournalTest, NothingStaysOfWhatIsRemoved) {
    {
        const auto one = claimed(), two = claimed();
        ASSERT_EQ(one->keep(sample()) + two->keep(sample()), "");
        EXPECT_NE(one->path(), two->path());
        one->remove();
        two->remove();
    }
    EXPECT_THAT(names(), IsEmpty());
    keepAndDie({sample()});
    for (LeftBehind& text : left().texts)
        text.place->remove();
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(JournalTest, DamagedTextsAreToldOnceAndForeignFilesStay) {
    keepAndDie({sample()});
    const std::string name = names()[0];
    home_.put("state/ensemble/unsaved/" + name, encoded(sample()).substr(0, 60));
    home_.put("state/ensemble/unsaved/0-0.kept", "unsaved-text 9\n");
    home_.put("state/ensemble/unsaved/notes.txt", "mine");
    const AllLeft all = left();
    EXPECT_THAT(all.texts, IsEmpty());
    ASSERT_THAT(all.faults, SizeIs(2));
    EXPECT_THAT(
        all.faults[0] + all.faults[1],
        testing::AllOf(HasSubstr("it is damaged. It is in " + journal() + "/" + name + ".damaged."),
                       HasSubstr("a newer version of this program has kept it")));
    EXPECT_THAT(left().faults, SizeIs(1));
    EXPECT_THAT(names(), testing::IsSupersetOf({name + ".damaged", std::string("0-0.kept"),
                                                std::string("notes.txt")}));
}

TEST_F(JournalTest, WhatWasSavedAtTheLastMomentIsNotLeft) {
    const std::string file = home_.put("a.ens", "the text");
    keepAndDie({{.file = {file, {}}, .text = "the text"},
                {.file = {file, {}}, .text = "the text", .drafts = {{"0", "typed"}}},
                {.file = {file, {}}, .text = "the texts"}});
    const AllLeft all = left();
    ASSERT_THAT(all.texts, SizeIs(2));
    EXPECT_EQ(all.texts[0].kept.drafts.size() + all.texts[1].kept.drafts.size(), 1u);
}

TEST_F(JournalTest, LocksAndPartsOfKilledProcessesGo) {
    claimed()->remove(); // makes the folder
    const std::string dead = std::to_string(deadProcess());
    home_.put("state/ensemble/unsaved/" + dead + "-0.lock", "");
    home_.put("state/ensemble/unsaved/" + dead + "-0.kept.part-" + dead, "half");
    EXPECT_THAT(left().texts, IsEmpty());
    EXPECT_THAT(names(), IsEmpty());
}

const std::vector<int> errors = {EIO, EINTR, ENOENT};

// To remove a file and to list a folder may fail, too.
class FailingJournal : public FailingFiles {
public:
    using FailingFiles::FailingFiles;
    int unlink(const char* path) override { return fails() ? -1 : FileSystem::unlink(path); }
    std::vector<std::string> names(const std::string& folder) override {
        return fails() ? std::vector<std::string>() : FileSystem::names(folder);
    }
};

// Does it with each call failing in turn, by each error, until no call is left to fail.
template <class Act> void withEachCallFailing(int atLeast, const Act& act) {
    int injected = 0;
    for (const int error : errors)
        for (int nth = 1;; ++nth) {
            FailingJournal files(nth, error);
            const std::string where = "call " + std::to_string(nth) + ": " + reasonOf(error);
            act(files, where);
            if (testing::Test::HasFatalFailure())
                return;
            if (!files.failed)
                break;
            ++injected;
            ASSERT_LT(nth, 1000);
        }
    EXPECT_GT(injected, atLeast);
}

TEST_F(JournalTest, AnyCallMayFailWhileItIsKept) {
    withEachCallFailing(80, [&](FileSystem& files, const std::string& where) {
        auto place = Place::claim(files, journal());
        auto* held = std::get_if<std::unique_ptr<Place>>(&place);
        if (held == nullptr) {
            ASSERT_FALSE(std::get<std::string>(place).empty()) << where;
            return;
        }
        const std::string before = (*held)->keep({.text = "one"});
        const std::string after = (*held)->keep({.text = "two"});
        const auto kept = decoded(readFile(FileSystem::real(), (*held)->path(), longestKept).bytes);
        if (before.empty() || after.empty()) {
            ASSERT_TRUE(std::holds_alternative<Kept>(kept)) << where;
            ASSERT_TRUE(!after.empty() || std::get<Kept>(kept).text == "two") << where;
        }
        static_cast<void>(::unlink((*held)->path().c_str()));
    });
}

// A text that was left is offered then, or is there for the next look; a damaged one stays, too.
TEST_F(JournalTest, AnyCallMayFailWhileItIsLookedFor) {
    const std::string file = home_.put("a.ens", "the text");
    withEachCallFailing(80, [&](FileSystem& files, const std::string& where) {
        std::filesystem::remove_all(journal());
        keepAndDie({sample(), {.file = {file, {}}, .text = "the text"}});
        const std::string damaged = encoded(sample()).substr(0, 60);
        home_.put("state/ensemble/unsaved/0-0.kept", damaged);
        const bool isOffered = [&] {
            const AllLeft all = leftBehind(files, journal());
            return std::ranges::any_of(all.texts,
                                       [](const auto& one) { return one.kept == sample(); });
        }();
        const AllLeft all = left();
        ASSERT_THAT(all.texts, SizeIs(1)) << where << ", offered before: " << isOffered;
        ASSERT_EQ(all.texts[0].kept, sample()) << where;
        ASSERT_EQ(home_.content("state/ensemble/unsaved/0-0.kept.damaged"), damaged) << where;
    });
}

// A text that was offered and is written on is replaced by its newest version, and never lost.
TEST_F(JournalTest, AnyCallMayFailWhileARecoveredTextIsWrittenOn) {
    withEachCallFailing(60, [&](FileSystem& files, const std::string& where) {
        std::filesystem::remove_all(journal());
        keepAndDie({sample()});
        AllLeft all = leftBehind(files, journal());
        if (all.texts.empty())
            return;
        std::atomic<int> told = 0;
        {
            JournalWriter writer(files, journal(), [&](const std::string&) { ++told; });
            writer.adopt(std::move(all.texts[0].place));
            writer.keep({.text = "written on"});
            writer.finish();
        }
        all = left();
        ASSERT_THAT(all.texts, SizeIs(1)) << where;
        if (told == 0)
            ASSERT_EQ(all.texts[0].kept.text, "written on") << where;
        else
            ASSERT_TRUE(all.texts[0].kept == sample() || all.texts[0].kept.text == "written on");
    });
}

// --- the writer -------------------------------------------------------------------------------

TEST_F(JournalTest, TheWriterKeepsTheNewestAndForgets) {
    JournalWriter writer(FileSystem::real(), journal(), nullptr);
    EXPECT_EQ(writer.path(), "");
    for (int i = 0; i < 100; ++i)
        writer.keep({.text = std::to_string(i)});
    const std::string path = writer.path();
    const auto kept = decoded(readFile(FileSystem::real(), path, 1000).bytes);
    EXPECT_EQ(std::get<Kept>(kept).text, "99");
    EXPECT_GT(std::get<Kept>(kept).at, 1'600'000'000);
    writer.forget();
    EXPECT_EQ(writer.path(), "");
    EXPECT_THAT(names(), IsEmpty());
}

// Counts the files that take their place.
class Counting : public FileSystem {
public:
    std::atomic<int> renames = 0;
    int rename(const char* from, const char* to) override {
        ++renames;
        return FileSystem::rename(from, to);
    }
};

TEST_F(JournalTest, TheWriterPausesBetweenTextsAndForgetsWithoutAPause) {
    Counting files;
    JournalWriter writer(files, journal(), nullptr, std::chrono::hours(1));
    writer.keep({.text = "one"});
    writer.finish();
    for (const char* text : {"two", "three", "four"})
        writer.keep({.text = text});
    EXPECT_EQ(files.renames, 1);
    const std::string path = writer.path(); // whoever waits for it has it at once
    EXPECT_EQ(files.renames, 2);
    EXPECT_EQ(std::get<Kept>(decoded(readFile(files, path, 1000).bytes)).text, "four");
    writer.keep({.text = "five"});
    writer.forget();
    EXPECT_EQ(writer.path(), "");
    EXPECT_EQ(files.renames, 2);
}

TEST_F(JournalTest, WhatTheWriterKeptStaysAndCanBeAdopted) {
    { JournalWriter(FileSystem::real(), journal(), nullptr).keep({.text = "one"}); }
    AllLeft all = left();
    ASSERT_THAT(all.texts, SizeIs(1));
    {
        JournalWriter writer(FileSystem::real(), journal(), nullptr);
        writer.adopt(std::move(all.texts[0].place));
        EXPECT_THAT(left().texts, IsEmpty());
        writer.keep({.text = "two"});
    }
    all = left();
    ASSERT_THAT(all.texts, SizeIs(1));
    EXPECT_EQ(all.texts[0].kept.text, "two");
    JournalWriter writer(FileSystem::real(), journal(), nullptr);
    writer.adopt(std::move(all.texts[0].place));
    writer.forget();
    EXPECT_THAT(names(), IsEmpty());
}

// Every write fails while `full`.
class FullDisk : public FileSystem {
public:
    std::atomic<bool> full = false;
    ssize_t write(int fd, const void* bytes, std::size_t size) override {
        errno = ENOSPC;
        return full ? -1 : FileSystem::write(fd, bytes, size);
    }
};

TEST_F(JournalTest, AFullDiskIsToldOnceAndTheLastTextStays) {
    FullDisk disk;
    std::vector<std::string> told;
    JournalWriter writer(disk, journal(), [&](const std::string& s) { told.push_back(s); });
    writer.keep({.text = "one"});
    const std::string path = writer.path();
    disk.full = true;
    for (const char* text : {"two", "three"}) {
        writer.keep({.text = text});
        writer.finish();
    }
    ASSERT_THAT(told, SizeIs(1));
    EXPECT_THAT(told[0], HasSubstr("Unsaved changes cannot be kept in " + journal()));
    EXPECT_THAT(told[0], HasSubstr("No space left on device"));
    EXPECT_EQ(std::get<Kept>(decoded(readFile(disk, path, 1000).bytes)).text, "one");
    EXPECT_THAT(names(), SizeIs(2)); // no half of a file
    disk.full = false;
    writer.keep({.text = "four"});
    writer.finish();
    EXPECT_EQ(std::get<Kept>(decoded(readFile(disk, path, 1000).bytes)).text, "four");
    disk.full = true;
    writer.keep({.text = "five"});
    writer.finish();
    EXPECT_THAT(told, SizeIs(2));
}

TEST(Journal, LiesInTheUsersStateFolder) {
    ::setenv("XDG_STATE_HOME", "/some/state", 1);
    EXPECT_EQ(journalFolder("ensemble"), "/some/state/ensemble/unsaved");
    ::setenv("XDG_STATE_HOME", "relative", 1);
    ::setenv("HOME", "/home/one", 1);
    EXPECT_EQ(journalFolder("ensemble"), "/home/one/.local/state/ensemble/unsaved");
}

} // namespace
} // namespace files
