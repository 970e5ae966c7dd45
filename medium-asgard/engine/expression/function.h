// A tape that is evaluated many times: interpreted at first, by machine code as soon as that pays.
// Same numbers as the tape's, bit for bit (of a NaN, that it is one).
//
// A function never changes but for its counts; any number of threads may evaluate it, each with a
// scratch of its own. Copies are the same function.
#pragma once

#include "expression/kernel.h"
#include "expression/tape.h"

#include <memory>
#include <span>

namespace expression {

class Function {
public:
    Function() : Function(Tape()) {}
    explicit Function(Tape tape) : shared_(std::make_shared<Shared>(std::move(tape))) {}

    [[nodiscard]] const Tape& tape() const { return shared_->tape; }
    [[nodiscard]] std::size_t decisions() const { return tape().decisions(); }

    using Scratch = Tape::Scratch;

    // As of Tape; `out` must not overlap `in`.
    void evaluate(std::span<const double> in, std::span<double> out, Scratch& scratch) const {
        if (!run(Purpose::values, Width::one, in, out, scratch, {}))
            tape().evaluate(in, out, scratch);
    }
    void evaluate(std::span<const double> in, std::span<double> out, Scratch& scratch,
                  std::span<const Decision> decisions) const;
    // The guards alone, on the branches given.
    void guards(std::span<const double> in, std::span<double> guards, Scratch& scratch,
                std::span<const Decision> decisions) const;

    // The machine code itself, for loops that evaluate nothing else; none as long as there is none.
    // It lives as long as the function.
    struct Code {
        EntryPoint entry = nullptr;
        const double* constants = nullptr;
        void operator()(const double* in, double* out, double* scratch) const {
            entry(in, out, constants, nullptr, scratch);
        }
    };
    [[nodiscard]] Code code(Scratch& scratch) const {
        const auto* const code =
            used(Purpose::values, Width::one).code.load(std::memory_order_acquire);
        if (!code)
            return {};
        if (scratch.size() < code->scratch)
            scratch.resize(code->scratch);
        return {code->entry, tape().constants().data()};
    }

    // Many instances in one call, each with its own inputs: lanes() of them, in arrays with lanes()
    // entries for each index (in[i * lanes() + k] is input i of instance k; decisions likewise).
    // Instances that are not needed may repeat another. Same bits as one at a time.
    [[nodiscard]] static unsigned lanes(); // 4, 2, or 1 where the processor has no more to give
    void evaluateLanes(std::span<const double> in, std::span<double> out, Scratch& scratch) const;
    // There is machine code for that. It is made when this is asked, if there is some for one at a
    // time.
    [[nodiscard]] bool hasCodeForLanes() const {
        return used(Purpose::values, Width::one).code.load(std::memory_order_acquire) != nullptr &&
               codeFor(Purpose::values, Width::many) != nullptr;
    }
    void evaluateLanes(std::span<const double> in, std::span<double> out, Scratch& scratch,
                       std::span<const Decision> decisions) const;

private:
    using Width = Kernel::Width;
    struct Use {
        std::atomic<const Kernel::Code*> code = nullptr;
        std::atomic<std::uint32_t> evaluations = 0; // not yet told to the kernel
    };
    struct Shared {
        explicit Shared(Tape t);
        Tape tape;
        std::vector<double> spread;             // the tape's constants, lanes() times each
        std::array<std::array<Use, 2>, 3> uses; // by purpose and width
        std::once_flag asked;
        std::shared_ptr<Kernel> kernel;
    };
    // Asked of the kernel only now and then, so that what is evaluated rarely costs nothing more.
    static constexpr std::uint32_t batch = 20;
    [[nodiscard]] const Use& used(Purpose purpose, Width width) const {
        return shared_->uses[static_cast<std::size_t>(purpose)][static_cast<std::size_t>(width)];
    }
    [[nodiscard]] const Kernel::Code* codeFor(Purpose purpose, Width width) const {
        const auto* const code = used(purpose, width).code.load(std::memory_order_acquire);
        return code ? code : askFor(purpose, width);
    }
    [[nodiscard]] const Kernel::Code* askFor(Purpose purpose, Width width) const;
    // Within the loops of integrators: nothing between them and the code.
    bool run(Purpose purpose, Width width, std::span<const double> in, std::span<double> out,
             Scratch& scratch, std::span<const Decision> decisions) const {
        const auto* const code = codeFor(purpose, width);
        if (!code)
            return false;
        if (scratch.size() < code->scratch)
            scratch.resize(code->scratch);
        const double* const constants =
            width == Width::one ? tape().constants().data() : shared_->spread.data();
        code->entry(in.data(), out.data(), constants, decisions.data(), scratch.data());
        return true;
    }
    void interpretLanes(std::span<const double> in, std::span<double> out, Scratch& scratch,
                        std::span<const Decision> decisions) const;

    std::shared_ptr<Shared> shared_;
};

} // namespace expression
