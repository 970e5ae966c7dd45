#include "computing/bell.h"

#include <cstdint>

#include <sys/eventfd.h>
#include <unistd.h>

namespace computing {

Bell::Bell() : descriptor_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

Bell::~Bell() { close(descriptor_); }

void Bell::ring() const {
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = write(descriptor_, &one, sizeof one);
}

void Bell::hear() const {
    std::uint64_t count = 0;
    [[maybe_unused]] const auto drained = read(descriptor_, &count, sizeof count);
}

} // namespace computing
