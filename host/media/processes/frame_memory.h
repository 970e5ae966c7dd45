// Where do a medium's pictures lie?
// One sealed memfd per process, made before the process starts and inherited by it: sparse, and
// sealed against shrinking, growing and further seals, so that reading it can never fault and
// punching holes never fails, whatever the medium does. The host maps it read-only, hands out
// slots, and punches holes where it frees them.
#pragma once

#include <QImage>
#include <cstdint>
#include <map>
#include <optional>

namespace media {

struct Slot {
    std::int64_t offset = 0;
    std::int64_t stride = 0;
    std::int64_t bytes = 0;
};

class FrameMemory {
public:
    static constexpr std::int64_t capacity = std::int64_t{256} << 20;

    FrameMemory();
    ~FrameMemory();
    FrameMemory(const FrameMemory&) = delete;
    FrameMemory& operator=(const FrameMemory&) = delete;

    [[nodiscard]] bool isValid() const { return data_ != nullptr; }
    [[nodiscard]] int descriptor() const { return descriptor_; }

    // Room for one picture of that many device pixels; nothing when there is none left.
    [[nodiscard]] std::optional<Slot> allocate(int width, int height);
    void free(const Slot& slot);
    [[nodiscard]] std::int64_t bytesInUse() const;

    // A copy of the picture in `slot`; a null image when it does not fit into the slot. The copy is
    // what makes a last picture survive its medium, and a medium that goes on drawing harmless.
    [[nodiscard]] QImage picture(const Slot& slot, std::int64_t width, std::int64_t height) const;

private:
    int descriptor_ = -1;
    const uchar* data_ = nullptr;
    std::map<std::int64_t, std::int64_t> used_; // offset -> bytes
};

} // namespace media
