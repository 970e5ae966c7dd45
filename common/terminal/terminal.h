// The texts of a program on standard output and standard error.
//
// Both programs print here and nowhere else (tests/layering/check_prints.py): a text may be a
// document's, and goes through text/printable.h.
#pragma once

#include <cstddef>
#include <string_view>

namespace terminal {

// One message on standard error, such as "asgard: there is no file a.al". Its second line and those
// after it are indented, so that a line end in it forges no other message.
void complain(std::string_view message);

// One message on standard output: what a command was asked to find.
void say(std::string_view message);

// Text of many lines that a program put together, on standard output. False: not all was written.
bool print(std::string_view text);

// Bytes of a format that other programs read (PDF, PNG), as they are, on standard output. False:
// not all was written. Not for a terminal: see isTerminal().
bool pass(std::string_view bytes);

[[nodiscard]] bool isTerminal();         // is standard output one?
[[nodiscard]] bool errorsAreATerminal(); // is standard error?

// A line on standard error that takes the place of the one before: how far a long command is. The
// destructor wipes it away.
class Progress {
public:
    Progress() = default;
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(std::string_view line);

private:
    std::size_t shown_ = 0; // columns, at most
};

} // namespace terminal
