// The memory of this process: a motion that gets nowhere must not take all that the machine has.
#pragma once

#include <cstddef>

namespace computing {

[[nodiscard]] std::size_t residentBytes(); // 0: unknown
void returnFreeMemory();                   // to the system, what was freed and is held for reuse

} // namespace computing
