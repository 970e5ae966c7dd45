// The memory that a process keeps of a motion: a motion that needs more stops and says so.
//
// It is a property of the process, as its address space is, and is set before the first motion.
// Counted are the steps and impacts of each run, as solution/kept_bytes.h does. Two or three runs
// are kept at a time while they are compared, and one or two that are shown.
#pragma once

#include <cstddef>

namespace simulation {

// 80 MB are about 250,000 steps of a body that turns, or a million hits of balls on a line.
inline constexpr std::size_t usualBytes = 80'000'000;

[[nodiscard]] std::size_t mostBytes(); // of one run
void setMostBytes(std::size_t bytes);

} // namespace simulation
