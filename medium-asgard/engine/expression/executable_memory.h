// Memory that holds machine code. It is written first and made executable then: no page is ever
// both, and none is shared with other code. Where the system refuses (a fence, a policy, no memory
// left), `start` is null and everything goes on without.
#pragma once

#include <cstddef>
#include <span>

namespace expression {

class ExecutableMemory {
public:
    ExecutableMemory() = default;
    explicit ExecutableMemory(std::span<const std::byte> code);
    ExecutableMemory(ExecutableMemory&& other) noexcept;
    ExecutableMemory& operator=(ExecutableMemory&& other) noexcept;
    ExecutableMemory(const ExecutableMemory&) = delete;
    ExecutableMemory& operator=(const ExecutableMemory&) = delete;
    ~ExecutableMemory();

    [[nodiscard]] const void* start() const { return start_; }
    [[nodiscard]] std::size_t size() const { return size_; } // whole pages

private:
    void* start_ = nullptr;
    std::size_t size_ = 0;
};

} // namespace expression
