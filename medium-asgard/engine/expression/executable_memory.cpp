#include "expression/executable_memory.h"

#include <cstring>
#include <utility>

#include <sys/mman.h>
#include <unistd.h>

namespace expression {

ExecutableMemory::ExecutableMemory(std::span<const std::byte> code) {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t size = (code.size() + page - 1) / page * page;
    if (size == 0)
        return;
    void* const memory =
        mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        return;
    std::memcpy(memory, code.data(), code.size());
    if (mprotect(memory, size, PROT_READ | PROT_EXEC) != 0) {
        munmap(memory, size);
        return;
    }
    start_ = memory;
    size_ = size;
}

ExecutableMemory::ExecutableMemory(ExecutableMemory&& other) noexcept
    : start_(std::exchange(other.start_, nullptr)), size_(std::exchange(other.size_, 0)) {}

ExecutableMemory& ExecutableMemory::operator=(ExecutableMemory&& other) noexcept {
    std::swap(start_, other.start_);
    std::swap(size_, other.size_);
    return *this;
}

ExecutableMemory::~ExecutableMemory() {
    if (start_)
        munmap(start_, size_);
}

} // namespace expression
