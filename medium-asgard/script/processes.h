// Processes, and the pipes between them, by system calls alone: they work inside the fences.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <sys/types.h>

namespace script {

// A child, and the descriptor by which it is ended: that needs no right to signal processes by
// their numbers, which might be anybody's.
struct Child {
    pid_t process = -1; // -1: none; 0: this is the child
    int descriptor = -1;
};

// fork() with such a descriptor, which closes itself when a program is run. Linux 5.2 and later.
// For a process with one thread; what the C library does around fork() is left out.
[[nodiscard]] Child forkChild();
// The same for a child of the parent of this process. No descriptor.
[[nodiscard]] pid_t forkSibling();

// Ends the child, if there is one, and forgets it. Returns its wait status.
int end(Child& child);

// A pipe whose ends are not among the standard descriptors, which libraries take for their own.
[[nodiscard]] bool openPipe(std::array<int, 2>& ends);
// Closes what is open.
void closeAll(std::array<int, 2>& ends);

// Reads or writes everything, over interruptions. False at the end of the pipe or an error.
bool readAll(int fd, void* bytes, std::size_t count);
bool writeAll(int fd, const void* bytes, std::size_t count);

// A process and two descriptors, through a socket that keeps messages apart. Received ones close
// themselves when a program is run.
struct Sent {
    pid_t process = -1;
    std::array<int, 2> descriptors{-1, -1};
};
bool send(int socket, const Sent& sent);
// Nothing where none comes in this time, or all senders are gone.
[[nodiscard]] std::optional<Sent> receive(int socket, int milliseconds);

} // namespace script
