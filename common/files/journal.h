// The journal: a folder of the user's that holds the texts that are not saved, so that a program
// that is killed loses no more than its last moments.
//
// Each open document has a place there: NAME.kept is all that is kept of it, replaced whole by a
// checked save; NAME.lock is locked by the process that holds the place (flock: the kernel frees it
// when that process ends, however it ends). A place whose lock is free was left behind.
//
// NAME.kept is plain: a line with the format's version, then parts, each a line "WORD LENGTH" with
// so many bytes and a line end after it, then "end CHECKSUM". A text that this program cannot read
// can be taken out with any editor. Words that are not known are skipped, so more can be kept.
#pragma once

#include "files/save.h"

#include <map>
#include <memory>
#include <variant>

namespace files {

struct Kept {
    KnownFile file{};    // that the text was read from or saved to, as it was then
    std::int64_t at = 0; // when it was kept: s since the epoch
    std::string text{};
    // Typed words that are not in the text yet, in the form of the view that shows them; the keys
    // are the caller's.
    std::map<std::string, std::string> drafts{};
    bool operator==(const Kept&) const = default;
};

// LIMIT: more than that is not read back: a text of 256 MB and drafts as long.
inline constexpr std::size_t longestKept = std::size_t{600} << 20;

[[nodiscard]] std::string encoded(const Kept& kept);
struct Unreadable {
    std::string reason;    // as the rest of a sentence: "it is damaged"
    bool forLater = false; // a newer version of the program reads it
};
[[nodiscard]] std::variant<Kept, Unreadable> decoded(std::string_view bytes);

// A place in the journal that this process holds. The text kept there stays when the object goes,
// for whoever looks what was left behind.
class Place {
public:
    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    // A free one; makes the folder, for this user alone. Or why not, as the rest of a sentence.
    using Claimed = std::variant<std::unique_ptr<Place>, std::string>;
    [[nodiscard]] static Claimed claim(FileSystem& files, const std::string& folder);
    // That of a file which is there; null: another process holds it.
    [[nodiscard]] static std::unique_ptr<Place> take(FileSystem& files, const std::string& path);

    [[nodiscard]] const std::string& path() const { return path_; } // of NAME.kept
    [[nodiscard]] std::string keep(const Kept& kept); // "" or why not; what was kept before stays
    void remove();

private:
    Place(FileSystem& files, std::string path, int lock);

    FileSystem& files_;
    std::string path_;
    int lock_;
};

struct LeftBehind {
    Kept kept;
    std::unique_ptr<Place> place; // nobody else is offered it while this is held
};

struct AllLeft {
    std::vector<LeftBehind> texts;   // the newest first
    std::vector<std::string> faults; // a sentence for each that could not be read
};

// The texts that ended processes have left. A text that its file has by now is removed.
// A damaged file is put aside under another name, so that it is told once.
[[nodiscard]] AllLeft leftBehind(FileSystem& files, const std::string& folder);

// The folder of the user's for a program's unsaved texts: XDG_STATE_HOME, else ~/.local/state.
[[nodiscard]] std::string journalFolder(const std::string& program);

} // namespace files
