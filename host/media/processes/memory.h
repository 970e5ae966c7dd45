// How much memory do media take, and which of them must go when all take too much?
#pragma once

#include <cstddef>
#include <optional>
#include <sys/types.h>
#include <vector>

namespace media {

// Bytes that a process and its children hold for themselves: not the programs and libraries that
// processes share. 0 when there is no such process.
[[nodiscard]] std::size_t memoryOf(pid_t process);

// Of the media that hold so much, the one that must end: none while all together hold at most
// `most`, else the one that holds the most.
[[nodiscard]] std::optional<std::size_t> tooLarge(const std::vector<std::size_t>& held,
                                                  std::size_t most);

// Another one fits beside media that hold so much, and `unmeasured` ones of which that is not known
// yet: each of these and the new one may come to hold as much as the largest.
[[nodiscard]] bool hasRoom(const std::vector<std::size_t>& held, std::size_t unmeasured,
                           std::size_t most);

// The memory that all media may hold together by default: 1.5 GiB, or half of the machine's memory.
[[nodiscard]] std::size_t usualMemory();

} // namespace media
