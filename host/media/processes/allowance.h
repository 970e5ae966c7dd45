// How much may a medium say? So much at once, and so much in each second after that.
// Messages count when they are read from the pipe, whether anybody waits for them or not: a medium
// that is read as fast as it talks still keeps the window busy. An entry of a list costs as much as
// a message. Frames cost no bytes, since acknowledgements bound them, and answers cost nothing,
// since requests do.
#pragma once

#include "ipc/wire.h"

#include <chrono>

namespace media {

class Allowance {
public:
    using Clock = std::chrono::steady_clock;

    struct Of {
        double bytes, items;
    };
    static constexpr Of atOnce{32 << 20, 20'000};
    static constexpr Of perSecond{16 << 20, 5'000};

    // False when this message is more than is left: a flood.
    [[nodiscard]] bool spend(const ipc::Decoded<ipc::ToHost>& message, std::size_t bytes,
                             Clock::time_point now);

private:
    Of left_ = atOnce;
    Clock::time_point last_{};
};

} // namespace media
