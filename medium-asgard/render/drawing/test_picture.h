// A picture in memory, for the tests.
#pragma once

#include "drawing/drawing.h"

#include <cstddef>
#include <vector>

namespace render {

struct Picture {
    Size size;
    std::size_t stride;
    std::vector<std::byte> bytes;

    explicit Picture(Size s, std::size_t padding = 0)
        : size(s), stride(4 * static_cast<std::size_t>(s.width) + padding),
          bytes(stride * static_cast<std::size_t>(s.height), std::byte{0x5A}) {}
    Image image() { return {bytes, stride, size}; }

    // 0xRRGGBB
    unsigned at(int x, int y) const {
        const std::size_t i =
            static_cast<std::size_t>(y) * stride + 4 * static_cast<std::size_t>(x);
        return std::to_integer<unsigned>(bytes[i + 2]) << 16 |
               std::to_integer<unsigned>(bytes[i + 1]) << 8 | std::to_integer<unsigned>(bytes[i]);
    }
    int red(int x, int y) const { return static_cast<int>(at(x, y) >> 16); }
    int green(int x, int y) const { return static_cast<int>(at(x, y) >> 8 & 0xFF); }
    int blue(int x, int y) const { return static_cast<int>(at(x, y) & 0xFF); }

    template <class Condition> int count(Condition condition) const {
        int n = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                n += condition(x, y) ? 1 : 0;
        return n;
    }
    int drawn() const {
        return count([&](int x, int y) { return at(x, y) != 0xFFFFFF; });
    }
};

} // namespace render
