// Numbers and texts out of a fuzzer's bytes: numbers from the end, so that what stands at the front
// is a text as it would be in a file. Past the end numbers are 0 and texts empty.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace fuzz {

class Input {
public:
    Input(const std::uint8_t* data, std::size_t size)
        : rest_(reinterpret_cast<const char*>(data), size) {}

    [[nodiscard]] bool atEnd() const { return rest_.empty(); }
    // 0..bound - 1, of two bytes.
    std::size_t below(std::size_t bound) {
        std::size_t number = 0;
        for (int i = 0; i < 2 && !rest_.empty(); ++i) {
            number = number << 8 | static_cast<unsigned char>(rest_.back());
            rest_.remove_suffix(1);
        }
        return bound == 0 ? 0 : number % bound;
    }
    // What stands last, of so many bytes at most.
    std::string_view last(std::size_t most) {
        const std::size_t size = std::min(most, rest_.size());
        const std::string_view text = rest_.substr(rest_.size() - size);
        rest_.remove_suffix(size);
        return text;
    }
    // All that is left.
    std::string_view rest() {
        const std::string_view text = rest_;
        rest_ = {};
        return text;
    }

private:
    std::string_view rest_;
};

} // namespace fuzz
