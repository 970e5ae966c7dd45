// The work done in this thread, for tests: it grows with the size of a text and no faster.
#pragma once

#include <cstddef>

namespace sgml {

struct Work {
    std::size_t siblingsPassed = 0; // looked at to find an element among them
    std::size_t bytesRead = 0;      // by the parser
    std::size_t nodesMade = 0;
};

inline Work& work() {
    static thread_local Work done;
    return done;
}

} // namespace sgml
