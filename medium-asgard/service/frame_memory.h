// The host's memory for frames, seen by this process one slot at a time.
//
// The host made it and may be wrong about it: a slot is mapped only when it lies inside what the
// memory really holds, and only memory that cannot shrink is used, so that writing never faults.
#pragma once

#include "ipc/messages.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <variant>

namespace service {

// Writable rows of a picture in the host's memory; unmapped when the last user lets go.
class MappedSlot {
public:
    MappedSlot(void* mapping, std::size_t mapped, std::span<std::byte> pixels)
        : mapping_(mapping), mapped_(mapped), pixels_(pixels) {}
    ~MappedSlot();
    MappedSlot(const MappedSlot&) = delete;
    MappedSlot& operator=(const MappedSlot&) = delete;

    [[nodiscard]] std::span<std::byte> pixels() const { return pixels_; }

private:
    void* mapping_;
    std::size_t mapped_;
    std::span<std::byte> pixels_;
};

class FrameMemory {
public:
    // The memory, or the sentence that says why it cannot be used.
    [[nodiscard]] static std::variant<FrameMemory, std::string> of(const ipc::SharedMemory& shared);

    [[nodiscard]] std::variant<std::shared_ptr<const MappedSlot>, std::string>
    map(const ipc::Slot& slot, ipc::Integer width, ipc::Integer height) const;

private:
    int descriptor_ = -1;
    ipc::Integer bytes_ = 0;
};

} // namespace service
