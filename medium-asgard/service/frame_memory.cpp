#include "service/frame_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace service {

MappedSlot::~MappedSlot() { munmap(mapping_, mapped_); }

std::variant<FrameMemory, std::string> FrameMemory::of(const ipc::SharedMemory& shared) {
    struct stat status {};
    const int descriptor = static_cast<int>(shared.fd);
    if (descriptor <= STDERR_FILENO || fstat(descriptor, &status) != 0)
        return "frames.fd is not open in this process";
    const int seals = fcntl(descriptor, F_GET_SEALS);
    if (seals < 0 || (seals & F_SEAL_SHRINK) == 0)
        return "frames.fd is not a memory file sealed against shrinking";
    if (shared.bytes > status.st_size)
        return "frames.bytes is more than the memory holds";
    FrameMemory memory;
    memory.descriptor_ = descriptor;
    memory.bytes_ = shared.bytes;
    return memory;
}

std::variant<std::shared_ptr<const MappedSlot>, std::string>
FrameMemory::map(const ipc::Slot& slot, ipc::Integer width, ipc::Integer height) const {
    if (slot.stride < 4 * width)
        return "a slot's stride is less than 4 bytes per pixel";
    // Sizes and strides are bounded by the protocol, so this cannot overflow.
    const ipc::Integer length = slot.stride * height;
    if (slot.offset > bytes_ || length > bytes_ - slot.offset)
        return "a slot reaches beyond the shared memory";
    const ipc::Integer page = sysconf(_SC_PAGESIZE);
    const ipc::Integer lead = slot.offset % page;
    const auto mapped = static_cast<std::size_t>(lead + length);
    void* mapping = mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_,
                         static_cast<off_t>(slot.offset - lead));
    if (mapping == MAP_FAILED)
        return "a slot of the shared memory cannot be mapped";
    const std::span<std::byte> pixels(static_cast<std::byte*>(mapping) + lead,
                                      static_cast<std::size_t>(length));
    return std::make_shared<const MappedSlot>(mapping, mapped, pixels);
}

} // namespace service
