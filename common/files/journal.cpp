#include "files/journal.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <optional>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace files {

namespace {

constexpr std::string_view keptEnding = ".kept", lockEnding = ".lock", damagedEnding = ".damaged";
constexpr std::string_view format = "unsaved-text ", version = "1", draftWord = "draft:";

std::string lockOf(const std::string& path) {
    return path.substr(0, path.size() - keptEnding.size()) + std::string(lockEnding);
}

template <class Number> std::optional<Number> numberIn(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

// --- one text as bytes ------------------------------------------------------------------------

void append(std::string& to, std::string_view word, std::string_view bytes) {
    to.append(word).append(" ").append(std::to_string(bytes.size())).append("\n");
    to.append(bytes).append("\n");
}

std::string stampText(const FileStamp& stamp) {
    return std::to_string(stamp.size) + " " + std::to_string(stamp.modified) + " " +
           std::to_string(stamp.inode) + " " + std::to_string(stamp.hash);
}

std::string_view upTo(std::string_view& rest, char end) {
    const std::size_t at = rest.find(end);
    const std::string_view first = rest.substr(0, at);
    rest.remove_prefix(at == std::string_view::npos ? rest.size() : at + 1);
    return first;
}

bool readStamp(std::string_view text, FileStamp& stamp) {
    const auto size = numberIn<std::uint64_t>(upTo(text, ' '));
    const auto modified = numberIn<std::int64_t>(upTo(text, ' '));
    const auto inode = numberIn<std::uint64_t>(upTo(text, ' '));
    const auto hash = numberIn<std::uint64_t>(text);
    if (!size || !modified || !inode || !hash)
        return false;
    stamp = {.exists = true, .size = *size, .modified = *modified, .inode = *inode, .hash = *hash};
    return true;
}

bool readPart(Kept& kept, std::string_view word, std::string_view bytes) {
    if (word == "file")
        kept.file.path = bytes;
    else if (word == "text")
        kept.text = bytes;
    else if (word.starts_with(draftWord))
        kept.drafts.emplace(word.substr(draftWord.size()), bytes);
    else if (word == "stamp")
        return readStamp(bytes, kept.file.stamp);
    else if (word == "at") {
        const auto at = numberIn<std::int64_t>(bytes);
        kept.at = at.value_or(0);
        return at.has_value();
    }
    return true;
}

} // namespace

// A key with a blank or a line end would end its line: keys are the program's own words.
std::string encoded(const Kept& kept) {
    std::string bytes(format);
    bytes.append(version).append("\n");
    append(bytes, "at", std::to_string(kept.at));
    append(bytes, "file", kept.file.path);
    if (kept.file.stamp.exists)
        append(bytes, "stamp", stampText(kept.file.stamp));
    for (const auto& [key, draft] : kept.drafts)
        append(bytes, std::string(draftWord) + key, draft);
    append(bytes, "text", kept.text);
    const std::string sum = std::to_string(hashOf(bytes));
    return bytes.append("end ").append(sum).append("\n");
}

std::variant<Kept, Unreadable> decoded(std::string_view bytes) {
    const std::string_view all = bytes;
    if (!bytes.starts_with(format))
        return Unreadable{"it is no unsaved text"};
    bytes.remove_prefix(format.size());
    if (upTo(bytes, '\n') != version)
        return Unreadable{"a newer version of this program has kept it", true};
    const Unreadable damaged{"it is damaged"};
    Kept kept;
    bool hasText = false;
    for (;;) {
        const std::size_t here = all.size() - bytes.size();
        std::string_view line = upTo(bytes, '\n');
        const std::string_view word = upTo(line, ' ');
        const auto number = numberIn<std::uint64_t>(line);
        if (!number)
            return damaged;
        if (word == "end") {
            if (*number != hashOf(all.substr(0, here)) || !hasText)
                return damaged;
            return kept;
        }
        if (*number >= bytes.size() || bytes[*number] != '\n' ||
            !readPart(kept, word, bytes.substr(0, *number)))
            return damaged;
        hasText = hasText || word == "text";
        bytes.remove_prefix(*number + 1);
    }
}

// --- places -----------------------------------------------------------------------------------

namespace {

// The lock's descriptor; -1 and errno when another process has it, or it cannot be made.
int lockFile(FileSystem& files, const std::string& path) {
    OpenFile file(files, path, O_RDWR | O_CREAT | O_NOFOLLOW, 0600);
    if (!file.isOpen() || files.flock(file.fd(), LOCK_EX | LOCK_NB) != 0)
        return -1;
    // Its last holder may have removed it since it was opened here.
    const OpenFile now(files, path, O_RDONLY | O_NOFOLLOW);
    struct stat held {
    }, there{};
    if (!now.isOpen() || files.fstat(file.fd(), &held) != 0 || files.fstat(now.fd(), &there) != 0 ||
        held.st_ino != there.st_ino) {
        errno = EWOULDBLOCK;
        return -1;
    }
    return file.release();
}

// "" or why not.
std::string makeFolder(FileSystem& files, const std::string& folder) {
    for (std::size_t at = 1; at < folder.size(); ++at)
        if (folder[at] == '/')
            static_cast<void>(files.mkdir(folder.substr(0, at).c_str(), 0700));
    static_cast<void>(files.mkdir(folder.c_str(), 0700));
    const OpenFile made(files, folder, O_RDONLY | O_DIRECTORY);
    struct stat status {};
    if (!made.isOpen() || files.fstat(made.fd(), &status) != 0)
        return reasonOf(errno);
    if (status.st_uid != ::geteuid())
        return "the folder is another user's";
    if ((status.st_mode & 0777) != 0700 && files.fchmod(made.fd(), 0700) != 0)
        return reasonOf(errno);
    return {};
}

bool isThere(FileSystem& files, const std::string& path) {
    return files.access(path.c_str(), F_OK) == 0;
}

} // namespace

Place::Place(FileSystem& files, std::string path, int lock)
    : files_(files), path_(std::move(path)), lock_(lock) {}

Place::~Place() {
    if (!isThere(files_, path_)) // else it is left behind, and so is its lock's name
        static_cast<void>(files_.unlink(lockOf(path_).c_str()));
    static_cast<void>(files_.close(lock_)); // last: with it goes the claim
}

Place::Claimed Place::claim(FileSystem& files, const std::string& folder) {
    if (const std::string fault = makeFolder(files, folder); !fault.empty())
        return fault;
    constexpr int most = 10'000;
    int error = 0;
    for (int i = 0; i < most; ++i) {
        const std::string path = folder + "/" + std::to_string(::getpid()) + "-" +
                                 std::to_string(i) + std::string(keptEnding);
        if (isThere(files, path))
            continue;
        const int lock = lockFile(files, lockOf(path));
        error = errno;
        if (lock >= 0 && !isThere(files, path))
            return std::unique_ptr<Place>(new Place(files, path, lock));
        if (lock >= 0)
            static_cast<void>(files.close(lock));
        else if (error != EWOULDBLOCK)
            break;
    }
    return reasonOf(error);
}

std::unique_ptr<Place> Place::take(FileSystem& files, const std::string& path) {
    const int lock = lockFile(files, lockOf(path));
    if (lock < 0)
        return nullptr;
    return std::unique_ptr<Place>(new Place(files, path, lock));
}

std::string Place::keep(const Kept& kept) {
    FileStamp stamp;
    return writeFile(files_, path_, encoded(kept), stamp, 0600).sentence;
}

void Place::remove() { static_cast<void>(files_.unlink(path_.c_str())); }

// --- what was left ----------------------------------------------------------------------------

namespace {

// It was saved, and the program ended before it could forget it.
bool isSaved(FileSystem& files, const Kept& kept) {
    if (!kept.drafts.empty() || kept.file.path.empty())
        return false;
    const ReadFile file = readFile(files, kept.file.path, kept.text.size());
    return file.read && file.bytes == kept.text;
}

class Search {
public:
    Search(FileSystem& files, std::string folder) : files_(files), folder_(std::move(folder)) {}

    AllLeft run() {
        const std::vector<std::string> names = files_.names(folder_);
        for (const std::string& name : names)
            if (name.ends_with(keptEnding))
                look(folder_ + "/" + name);
        for (const std::string& name : names)
            if (name.ends_with(lockEnding))
                tidy(folder_ + "/" + name.substr(0, name.size() - lockEnding.size()) +
                     std::string(keptEnding));
        std::ranges::stable_sort(
            all_.texts, [](const auto& a, const auto& b) { return a.kept.at > b.kept.at; });
        return std::move(all_);
    }

private:
    void look(const std::string& path) {
        std::unique_ptr<Place> place = Place::take(files_, path);
        if (!place || !isThere(files_, path))
            return; // its process lives, or has just done with it
        removeAbandonedParts(files_, path);
        const ReadFile file = readFile(files_, path, longestKept);
        if (!file.read)
            return complain(path, file.reason, path);
        auto kept = decoded(file.bytes);
        if (const auto* fault = std::get_if<Unreadable>(&kept)) {
            const std::string aside = path + std::string(damagedEnding);
            const bool moved = !fault->forLater && files_.rename(path.c_str(), aside.c_str()) == 0;
            return complain(path, fault->reason, moved ? aside : path);
        }
        auto& text = std::get<Kept>(kept);
        if (isSaved(files_, text))
            place->remove();
        else
            all_.texts.push_back({std::move(text), std::move(place)});
    }

    // A process that was killed before it had kept anything leaves its lock.
    void tidy(const std::string& path) {
        if (isThere(files_, path))
            return;
        removeAbandonedParts(files_, path);
        static_cast<void>(Place::take(files_, path)); // which goes, and its lock's name with it
    }

    void complain(const std::string& path, const std::string& why, const std::string& where) {
        all_.faults.push_back("The unsaved text " + nameOf(path) + " cannot be read: " + why +
                              ". It is in " + where + ".");
    }

    FileSystem& files_;
    std::string folder_;
    AllLeft all_;
};

} // namespace

AllLeft leftBehind(FileSystem& files, const std::string& folder) {
    return Search(files, folder).run();
}

std::string journalFolder(const std::string& program) {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name); // NOLINT(concurrency-mt-unsafe)
        return std::string(value == nullptr ? "" : value);
    };
    std::string state = variable("XDG_STATE_HOME");
    if (!state.starts_with('/')) // the specification's rule for what is no absolute path
        state = variable("HOME") + "/.local/state";
    return state + "/" + program + "/unsaved";
}

} // namespace files
