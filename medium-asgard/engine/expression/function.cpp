#include "expression/function.h"

#include <cassert>

namespace expression {

const Kernel::Code* Function::codeFor(Purpose purpose) const {
    const Use& use = shared_->uses[static_cast<std::size_t>(purpose)];
    if (const auto* const code = use.code.load(std::memory_order_acquire))
        return code;
    return askFor(purpose);
}

const Kernel::Code* Function::askFor(Purpose purpose) const {
    Use& use = shared_->uses[static_cast<std::size_t>(purpose)];
    if (use.evaluations.fetch_add(1, std::memory_order_relaxed) + 1 < batch)
        return nullptr;
    std::call_once(shared_->asked,
                   [this] { shared_->kernel = Kernel::of(shared_->tape.sequence()); });
    const std::uint32_t evaluations = use.evaluations.exchange(0, std::memory_order_relaxed);
    const auto* const code = shared_->kernel->code(purpose, Kernel::Width::one, evaluations);
    use.code.store(code, std::memory_order_release);
    return code;
}

bool Function::run(Purpose purpose, std::span<const double> in, std::span<double> out,
                   Scratch& scratch, std::span<const Decision> decisions) const {
    const auto* const code = codeFor(purpose);
    if (!code)
        return false;
    if (scratch.size() < code->scratch)
        scratch.resize(code->scratch);
    code->entry(in.data(), out.data(), tape().constants().data(), decisions.data(), scratch.data());
    return true;
}

void Function::evaluate(std::span<const double> in, std::span<double> out, Scratch& scratch) const {
    assert(in.size() == tape().inputs() && out.size() == tape().outputs());
    if (!run(Purpose::values, in, out, scratch, {}))
        tape().evaluate(in, out, scratch);
}

void Function::evaluate(std::span<const double> in, std::span<double> out, Scratch& scratch,
                        std::span<const Decision> decisions) const {
    assert(in.size() == tape().inputs() && out.size() == tape().outputs() &&
           decisions.size() == tape().decisions());
    if (!run(Purpose::valuesOnBranches, in, out, scratch, decisions))
        tape().evaluate(in, out, scratch, decisions, {});
}

void Function::guards(std::span<const double> in, std::span<double> guards, Scratch& scratch,
                      std::span<const Decision> decisions) const {
    assert(in.size() == tape().inputs() && guards.size() == tape().decisions() &&
           decisions.size() == tape().decisions());
    if (run(Purpose::guards, in, guards, scratch, decisions))
        return;
    const std::size_t slots = tape().sequence().slots();
    if (scratch.size() < slots + tape().outputs())
        scratch.resize(slots + tape().outputs());
    tape().evaluate(in, std::span(scratch).subspan(slots, tape().outputs()), scratch, decisions,
                    guards);
}

} // namespace expression
