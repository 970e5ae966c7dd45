// Machine code that all tapes with the same sequence of operations share.
//
// Code depends on what is computed from what; constants are data. A thousand pendulums of different
// lengths are one kernel, made once for the process, however many threads ask for it.
//
// When code is made is decided by counts: after as many evaluations as would have saved by then
// what making it costs. The bits are equal, so nobody can tell when it happened, except by the
// clock. With ASGARD_INTERPRET set in the environment nothing is compiled.
#pragma once

#include "expression/assemble.h"
#include "expression/executable_memory.h"
#include "expression/tape.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

namespace expression {

class Kernel {
public:
    struct Code {
        EntryPoint entry;
        std::size_t scratch; // doubles that it wants
    };
    enum class Width : std::uint8_t { one, many }; // many: manyAtOnce().lanes

    explicit Kernel(Sequence sequence) : sequence_(std::move(sequence)) {}
    [[nodiscard]] bool hasSequence(const Sequence& other) const { return sequence_ == other; }

    // The kernel of that sequence: the one there is, or a new one.
    [[nodiscard]] static std::shared_ptr<Kernel> of(const Sequence& sequence);

    // The code, once that many evaluations more make it worthwhile; null before, and where no code
    // can be had. For many at once it is worthwhile as soon as there is code for one. Safe from any
    // thread; the code lives as long as the kernel.
    [[nodiscard]] const Code* code(Purpose purpose, Width width, std::uint32_t evaluations);

    // Measured (decision 42): making code costs as much as interpreting 8000 operations, and as
    // much as 70 evaluations.
    [[nodiscard]] static std::uint32_t worthwhile(const Sequence& sequence);

    // The steps of the code, as text.
    [[nodiscard]] std::string print(Purpose purpose, Width width) const;
    // The instructions for it on this processor; empty: there is no code.
    [[nodiscard]] std::string listing(Purpose purpose, Width width) const;

    struct Counts {
        std::size_t made = 0;     // kernels; all others were shared
        std::size_t compiled = 0; // codes
        std::size_t bytes = 0;    // of machine code, ever
    };
    [[nodiscard]] static Counts counts();

private:
    struct Variant {
        std::atomic<const Code*> ready = nullptr;
        std::atomic<std::uint32_t> evaluations = 0;
        bool tried = false; // under the mutex
        Code code{};
        ExecutableMemory memory;
    };
    [[nodiscard]] bool isReady(Purpose purpose) const { // for one at a time
        const auto& variant = variants_[static_cast<std::size_t>(purpose)][0];
        return variant.ready.load(std::memory_order_acquire) != nullptr;
    }
    void compile(Variant& variant, Purpose purpose, Width width);

    const Sequence sequence_;
    const std::uint32_t worthwhile_ = worthwhile(sequence_);
    std::array<std::array<Variant, 2>, 3> variants_;
    std::mutex compiling_;
};

} // namespace expression
