// How a text gets to disk without the file ever being damaged.
//
// Saving: write beside the file, check every write and the sync, put the old file's permissions on
// it, exchange it with the old one (through symbolic links, with what they lead to), sync the
// folder, read it again and compare. If a call fails, the file holds the old content or the
// new, and "saved" is said only when the new content was read back. (QSaveFile says it also when
// the sync failed.)
//
// The file that the exchange gave out is looked at: when another program wrote it since it was
// read, even in the last moment, the exchange is taken back. Else it is the backup, FILE~. LIMIT: a
// program that had opened the old file before, and writes into it afterwards, writes the backup. A
// file system that exchanges no files (some of a network) makes no backup, and the last look at the
// file is the one before the rename.
#pragma once

#include "files/read.h"

namespace files {

// The file that a text was read from or saved to, as it was then.
struct KnownFile {
    std::string path{}; // "": none yet
    FileStamp stamp{};
    bool operator==(const KnownFile&) const = default;
};

enum class FileState { noFile, unchanged, changed, removed };

// Why a text was not written though it could have been: ask the user, then say so in SaveOptions.
enum class Refusal {
    none,
    broken,  // what could not be read of it might be worth keeping (the caller's to say)
    changed, // another program changed the file since it was read
    linked,  // the file has other names (hard links), which would keep the old text
};

struct SaveOptions {
    bool evenBroken = false;
    bool evenChanged = false;
    bool evenLinked = false;
};

struct SaveResult {
    bool saved = false;
    Refusal refusal = Refusal::none;
    std::string sentence{}; // why not, in words for the user; "" when saved
    explicit operator bool() const { return saved; }
};

// Writes `bytes` to `path`. `known` is what the caller read or saved last; when that is the file at
// `path`, another program's change of it is refused. On success `known` is the new file.
[[nodiscard]] SaveResult saveFile(FileSystem& files, const std::string& path,
                                  const std::string& bytes, KnownFile& known,
                                  const SaveOptions& options = {});
// The place where saveFile() keeps the version before, and the path that leads to it through
// symbolic links.
[[nodiscard]] std::string backupOf(FileSystem& files, const std::string& path);
// Writes without looking at what was there, and without a backup; `mode` is that of a file that was
// not.
[[nodiscard]] SaveResult writeFile(FileSystem& files, const std::string& path,
                                   const std::string& bytes, FileStamp& stamp, mode_t mode = 0666);
[[nodiscard]] FileState compareFile(FileSystem& files, const KnownFile& known);
[[nodiscard]] bool isSameFile(FileSystem& files, const std::string& one, const std::string& other);

// A program that is killed while it saves leaves its half of a file, NAME.part-PROCESS. Removes
// those of `path` whose process is no more.
// LIMIT: a process of another machine that shares the folder looks like none. Its save then fails
// with a sentence and leaves the old file.
void removeAbandonedParts(FileSystem& files, const std::string& path);

} // namespace files
