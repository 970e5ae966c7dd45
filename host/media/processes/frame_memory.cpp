#include "processes/frame_memory.h"

#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace media {

namespace {

constexpr std::int64_t page = 4096;
constexpr std::int64_t mostPixels = 16384;

std::int64_t roundUp(std::int64_t bytes) { return (bytes + page - 1) / page * page; }

} // namespace

FrameMemory::FrameMemory() {
    descriptor_ = memfd_create("frames", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (descriptor_ < 0 || ftruncate(descriptor_, capacity) != 0)
        return;
    if (fcntl(descriptor_, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0)
        return;
    void* mapped = mmap(nullptr, capacity, PROT_READ, MAP_SHARED, descriptor_, 0);
    data_ = mapped == MAP_FAILED ? nullptr : static_cast<const uchar*>(mapped);
}

FrameMemory::~FrameMemory() {
    if (data_)
        munmap(const_cast<uchar*>(data_), capacity);
    if (descriptor_ >= 0)
        close(descriptor_);
}

std::optional<Slot> FrameMemory::allocate(int width, int height) {
    if (width <= 0 || height <= 0 || width > mostPixels || height > mostPixels)
        return std::nullopt;
    Slot slot;
    slot.stride = std::int64_t{width} * 4;
    slot.bytes = roundUp(slot.stride * height);
    for (const auto& [offset, bytes] : used_) { // first fit, in order of offset
        if (offset - slot.offset >= slot.bytes)
            break;
        slot.offset = offset + bytes;
    }
    if (slot.offset + slot.bytes > capacity)
        return std::nullopt;
    used_[slot.offset] = slot.bytes;
    return slot;
}

void FrameMemory::free(const Slot& slot) {
    if (used_.erase(slot.offset) == 0)
        return;
    // A failure only leaves the pages in use until the process ends.
    static_cast<void>(fallocate(descriptor_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                                slot.offset, slot.bytes));
}

std::int64_t FrameMemory::bytesInUse() const {
    std::int64_t sum = 0;
    for (const auto& [offset, bytes] : used_)
        sum += bytes;
    return sum;
}

QImage FrameMemory::picture(const Slot& slot, std::int64_t width, std::int64_t height) const {
    if (!data_ || width <= 0 || height <= 0 || width > mostPixels || height > mostPixels ||
        width * 4 > slot.stride || height * slot.stride > slot.bytes)
        return {};
    QImage image(static_cast<int>(width), static_cast<int>(height), QImage::Format_RGB32);
    for (int y = 0; y < height; ++y)
        std::memcpy(image.scanLine(y), data_ + slot.offset + y * slot.stride, width * 4);
    return image;
}

} // namespace media
