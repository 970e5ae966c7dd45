#include "files/save.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <climits>
#include <csignal>
#include <optional>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace files {

namespace {

constexpr std::string_view partEnding = ".part-", backupEnding = "~";

// The end of a chain of symbolic links, so that saving replaces the file and not the link.
std::string resolved(FileSystem& files, const std::string& path) {
    char buffer[PATH_MAX];
    return files.realpath(path.c_str(), buffer) != nullptr ? std::string(buffer) : path;
}

std::string changedSentence(const std::string& name) {
    return "Another program has changed " + name + " since it was read.";
}

// One save: the steps in their order, each with its sentence, cleaned up behind when one fails.
class Save {
public:
    Save(FileSystem& files, const std::string& path, const std::string& bytes, mode_t mode)
        : files_(files), name_(nameOf(path)), path_(resolved(files, path)), bytes_(bytes),
          mode_(mode) {}

    SaveResult run(FileStamp& stamp) {
        if (!writeBeside() || !moveOver() || !confirm() || !readBack(stamp))
            return {.saved = false, .refusal = Refusal::none, .sentence = sentence_};
        return {.saved = true};
    }

    // The old file becomes the backup. With `known`: if it is still the one that it was then.
    SaveResult runWithBackup(FileStamp& stamp, const FileStamp* known) {
        SaveResult result{.saved = false};
        if (writeBeside() && exchange(known, result.refusal) && confirm() && readBack(stamp))
            return {.saved = true};
        result.sentence = sentence_;
        return result;
    }

private:
    bool fail(const std::string& what) {
        sentence_ = name_ + " was not saved: " + what + ".";
        return false;
    }
    bool fail(const std::string& what, int error) {
        return fail(what + " (" + reasonOf(error) + ")");
    }

    // The old file's mode and owner; `mode_` under the user's mask for a new one.
    bool oldStatus(struct stat& status, bool& exists) {
        const OpenFile old(files_, path_, O_RDONLY | O_NONBLOCK);
        exists = old.isOpen() && files_.fstat(old.fd(), &status) == 0;
        if (exists && !S_ISREG(status.st_mode))
            return fail("it is not a file");
        if (!exists && errno != ENOENT)
            return fail("the old file cannot be looked at", errno);
        // Renaming over it would work, but whoever made it read-only meant it.
        if (exists && files_.access(path_.c_str(), W_OK) != 0)
            return fail("it may not be written", errno);
        return true;
    }

    bool writeBeside() {
        struct stat old {};
        if (!oldStatus(old, exists_))
            return false;
        temporary_ = freeName();
        OpenFile file(files_, temporary_, O_WRONLY | O_CREAT | O_EXCL, exists_ ? 0600 : mode_);
        if (!file.isOpen())
            return fail("its folder takes no new file", errno);
        if (!file.writeAll(bytes_))
            return abandon("the disk did not take it", errno);
        if (exists_ && !keepRights(file, old))
            return abandon("the old file's permissions cannot be kept", errno);
        if (!file.sync())
            return abandon("the disk did not confirm it", errno);
        if (!file.close())
            return abandon("the disk did not take it", errno);
        return true;
    }

    // Beside the file, since only within one file system a rename replaces at once.
    std::string freeName() {
        const std::string stem = path_ + std::string(partEnding) + std::to_string(::getpid());
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
            static_cast<void>(files_.fchown(file.fd(), old.st_uid, old.st_gid));
        return files_.fchmod(file.fd(), old.st_mode & 07777) == 0;
    }

    bool moveOver() {
        return files_.rename(temporary_.c_str(), path_.c_str()) == 0 ||
               abandon("the new version cannot take its place", errno);
    }

    // `refusal`: changed, when the file is no longer the known one.
    bool exchange(const FileStamp* known, Refusal& refusal) {
        if (!exists_)
            return moveOver();
        waitForOthers();
        if (files_.exchange(temporary_.c_str(), path_.c_str()) != 0)
            return exchangeIsMissing(errno)
                       ? moveOverIf(known, refusal)
                       : abandon("the new version cannot take its place", errno);
        // From here on `temporary_` is the old file.
        if (!isKnown(temporary_, known)) {
            if (files_.exchange(temporary_.c_str(), path_.c_str()) != 0)
                return keepTheirs();
            return refuse(refusal);
        }
        if (files_.rename(temporary_.c_str(), (path_ + std::string(backupEnding)).c_str()) != 0)
            static_cast<void>(files_.unlink(temporary_.c_str()));
        return true;
    }

    // The other program's text cannot get its name back. It becomes the backup: a part of a save
    // would be removed one day.
    bool keepTheirs() {
        const int error = errno;
        const std::string backup = path_ + std::string(backupEnding);
        const bool moved = files_.rename(temporary_.c_str(), backup.c_str()) == 0;
        return fail("another program has just written it, and its text is in " +
                        nameOf(moved ? backup : temporary_),
                    error);
    }

    // Of our programs one at a time exchanges a file of a folder and reads it back. Nobody waits
    // for one that hangs.
    void waitForOthers() {
        constexpr int tries = 100, pause = 10'000; // us
        folder_.emplace(files_, folderOf(path_), O_RDONLY | O_DIRECTORY);
        for (int i = 0; i < tries && folder_->isOpen(); ++i) {
            if (files_.flock(folder_->fd(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
                return;
            ::usleep(pause);
        }
    }

    // Removed meanwhile, or a file system that cannot do it.
    static bool exchangeIsMissing(int error) {
        return error == ENOENT || error == EINVAL || error == ENOSYS || error == EOPNOTSUPP;
    }

    bool moveOverIf(const FileStamp* known, Refusal& refusal) {
        return isKnown(path_, known) ? moveOver() : refuse(refusal);
    }

    bool isKnown(const std::string& path, const FileStamp* known) {
        return known == nullptr || compareFile(files_, {path, *known}) != FileState::changed;
    }

    bool refuse(Refusal& refusal) {
        static_cast<void>(files_.unlink(temporary_.c_str()));
        refusal = Refusal::changed;
        sentence_ = changedSentence(name_);
        return false;
    }

    bool confirm() {
        if (!folder_)
            folder_.emplace(files_, folderOf(path_), O_RDONLY | O_DIRECTORY);
        // Some file systems cannot sync a folder, and say EINVAL; on those the rename is all there
        // is.
        if (!folder_->isOpen() || (!folder_->sync() && errno != EINVAL)) {
            const std::string reason = reasonOf(errno);
            return fail("the disk did not confirm it (" + reason +
                        "); the file may hold the old version after a power cut");
        }
        return true;
    }

    bool readBack(FileStamp& stamp) {
        const ReadFile again = readFile(files_, path_, bytes_.size());
        if (!again.read || again.bytes != bytes_)
            return fail("what was read back is not what was written");
        stamp = again.stamp;
        return true;
    }

    bool abandon(const std::string& what, int error) {
        static_cast<void>(files_.unlink(temporary_.c_str()));
        return fail(what, error);
    }

    FileSystem& files_;
    std::string name_, path_;
    const std::string& bytes_;
    mode_t mode_;
    bool exists_ = false; // a file from before
    std::string temporary_, sentence_;
    std::optional<OpenFile> folder_; // locked from the exchange to the end
};

// How many names the file has; 0 when there is none, or nobody can tell.
std::size_t namesOfFile(FileSystem& files, const std::string& path) {
    const OpenFile file(files, path, O_RDONLY | O_NONBLOCK);
    struct stat status {};
    if (!file.isOpen() || files.fstat(file.fd(), &status) != 0)
        return 0;
    return static_cast<std::size_t>(status.st_nlink);
}

bool isAlive(pid_t process) { return ::kill(process, 0) == 0 || errno != ESRCH; }

} // namespace

SaveResult writeFile(FileSystem& files, const std::string& path, const std::string& bytes,
                     FileStamp& stamp, mode_t mode) {
    return Save(files, path, bytes, mode).run(stamp);
}

SaveResult saveFile(FileSystem& files, const std::string& path, const std::string& bytes,
                    KnownFile& known, const SaveOptions& options) {
    const auto refuse = [](Refusal refusal, const std::string& sentence) {
        return SaveResult{.saved = false, .refusal = refusal, .sentence = sentence};
    };
    const bool isOwn = isSameFile(files, path, known.path);
    if (isOwn && !options.evenChanged && compareFile(files, known) == FileState::changed)
        return refuse(Refusal::changed, changedSentence(nameOf(path)));
    const std::size_t names = options.evenLinked ? 1 : namesOfFile(files, path);
    if (names > 1)
        return refuse(Refusal::linked,
                      nameOf(path) + " has " + std::to_string(names) +
                          " names (hard links). Saving gives this name a file of its own; under " +
                          (names > 2 ? "the other names" : "the other name") +
                          " the old text stays.");
    removeAbandonedParts(files, path);
    const FileStamp then = known.stamp;
    const bool isWatched = isOwn && !options.evenChanged && then.exists;
    SaveResult result =
        Save(files, path, bytes, 0666).runWithBackup(known.stamp, isWatched ? &then : nullptr);
    if (result)
        known.path = path;
    return result;
}

std::string backupOf(FileSystem& files, const std::string& path) {
    return resolved(files, path) + std::string(backupEnding);
}

FileState compareFile(FileSystem& files, const KnownFile& known) {
    if (known.path.empty() || !known.stamp.exists)
        return FileState::noFile;
    struct stat status {};
    {
        const OpenFile file(files, known.path, O_RDONLY | O_NONBLOCK);
        if (!file.isOpen() && (errno == ENOENT || errno == ENOTDIR))
            return FileState::removed;
        if (!file.isOpen() || files.fstat(file.fd(), &status) != 0)
            return FileState::changed;
    }
    const FileStamp& then = known.stamp;
    const std::int64_t modified =
        std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
    if (static_cast<std::uint64_t>(status.st_size) == then.size && modified == then.modified &&
        status.st_ino == then.inode)
        return FileState::unchanged;
    // Touched or copied over itself: what is in it decides.
    const ReadFile now = readFile(files, known.path, static_cast<std::size_t>(then.size));
    return now.read && now.stamp.hash == then.hash ? FileState::unchanged : FileState::changed;
}

bool isSameFile(FileSystem& files, const std::string& one, const std::string& other) {
    if (one.empty() || other.empty())
        return false;
    return one == other || resolved(files, one) == resolved(files, other);
}

void removeAbandonedParts(FileSystem& files, const std::string& path) {
    const std::string file = resolved(files, path), folder = folderOf(file);
    const std::string stem = nameOf(file) + std::string(partEnding);
    for (const std::string& name : files.names(folder)) {
        if (!name.starts_with(stem))
            continue;
        pid_t process = 0;
        const char* const last = name.data() + name.size();
        const auto [end, error] = std::from_chars(name.data() + stem.size(), last, process);
        const bool ours = error == std::errc{} && process > 0 && (end == last || *end == '-');
        if (ours && !isAlive(process))
            static_cast<void>(files.unlink((folder + name).c_str()));
    }
}

} // namespace files
