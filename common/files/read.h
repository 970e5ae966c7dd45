// The one way in: everything that a user names is read with a limit, so that no input, however long
// or without end, takes more memory than that.
#pragma once

#include "files/file_system.h"

#include <cstdint>
#include <string>

namespace files {

// The state of a file when it was read or written.
struct FileStamp {
    bool exists = false;
    std::uint64_t size = 0;
    std::int64_t modified = 0; // ns since the epoch
    std::uint64_t inode = 0;
    std::uint64_t hash = 0; // of its content
    bool operator==(const FileStamp&) const = default;
};

// FNV-1a, 64 bit: tells contents apart, defends against nobody.
[[nodiscard]] std::uint64_t hashOf(std::string_view bytes);

struct ReadFile {
    bool read = false;
    std::string bytes{};
    FileStamp stamp{};
    std::string reason{}; // why not, as the rest of a sentence: "it is a folder"
};

enum class Source {
    file,   // a regular file only: what opens a document by itself may not wait for a pipe
    stream, // also a pipe or a device, of which the limit's bytes are read and no more
};

// LIMIT: of a pipe that someone holds open and never writes into, the end is waited for: whoever
// started the command ends it.
[[nodiscard]] ReadFile readFile(FileSystem& files, const std::string& path, std::size_t longest,
                                Source source = Source::file);
[[nodiscard]] ReadFile readStandardInput(FileSystem& files, std::size_t longest);

} // namespace files
