// The work done in this thread, for tests: it grows with the size of a text and no faster.
#pragma once

#include <cstddef>

namespace sgml {

struct Work {
    std::size_t siblingsPassed = 0; // looked at to find an element among them
};

inline Work& work() {
    static thread_local Work done;
    return done;
}

} // namespace sgml
