#include "expression/function.h"

#include <algorithm>
#include <cassert>

namespace expression {

Function::Shared::Shared(Tape t) : tape(std::move(t)) {
    for (const double x : tape.constants())
        spread.insert(spread.end(), lanes(), x);
}

unsigned Function::lanes() { return manyAtOnce().lanes; }

const Kernel::Code* Function::askFor(Purpose purpose, Width width) const {
    Use& use = shared_->uses[static_cast<std::size_t>(purpose)][static_cast<std::size_t>(width)];
    const std::uint32_t instances = width == Width::many ? lanes() : 1;
    if (use.evaluations.fetch_add(instances, std::memory_order_relaxed) + instances < batch)
        return nullptr;
    std::call_once(shared_->asked,
                   [this] { shared_->kernel = Kernel::of(shared_->tape.sequence()); });
    const std::uint32_t evaluations = use.evaluations.exchange(0, std::memory_order_relaxed);
    const auto* const code = shared_->kernel->code(purpose, width, evaluations);
    use.code.store(code, std::memory_order_release);
    return code;
}

void Function::evaluate(std::span<const double> in, std::span<double> out, Scratch& scratch,
                        std::span<const Decision> decisions) const {
    assert(in.size() == tape().inputs() && out.size() == tape().outputs() &&
           decisions.size() == tape().decisions());
    if (!run(Purpose::valuesOnBranches, Width::one, in, out, scratch, decisions))
        tape().evaluate(in, out, scratch, decisions, {});
}

void Function::guards(std::span<const double> in, std::span<double> guards, Scratch& scratch,
                      std::span<const Decision> decisions) const {
    assert(in.size() == tape().inputs() && guards.size() == tape().decisions() &&
           decisions.size() == tape().decisions());
    if (run(Purpose::guards, Width::one, in, guards, scratch, decisions))
        return;
    const std::size_t slots = tape().sequence().slots();
    if (scratch.size() < slots + tape().outputs())
        scratch.resize(slots + tape().outputs());
    tape().evaluate(in, std::span(scratch).subspan(slots, tape().outputs()), scratch, decisions,
                    guards);
}

void Function::evaluateLanes(std::span<const double> in, std::span<double> out,
                             Scratch& scratch) const {
    if (!run(Purpose::values, Width::many, in, out, scratch, {}))
        interpretLanes(in, out, scratch, {});
}

void Function::evaluateLanes(std::span<const double> in, std::span<double> out, Scratch& scratch,
                             std::span<const Decision> decisions) const {
    assert(decisions.size() == lanes() * tape().decisions());
    if (!run(Purpose::valuesOnBranches, Width::many, in, out, scratch, decisions))
        interpretLanes(in, out, scratch, decisions);
}

// One instance after the other; without decisions the branches follow from the values.
void Function::interpretLanes(std::span<const double> in, std::span<double> out, Scratch& scratch,
                              std::span<const Decision> decisions) const {
    const std::size_t width = lanes();
    assert(in.size() == width * tape().inputs() && out.size() == width * tape().outputs());
    std::vector<double> own(tape().inputs()), result(tape().outputs());
    std::vector<Decision> branches(decisions.size() / width);
    for (std::size_t lane = 0; lane < width; ++lane) {
        for (std::size_t i = 0; i < own.size(); ++i)
            own[i] = in[i * width + lane];
        for (std::size_t i = 0; i < branches.size(); ++i)
            branches[i] = decisions[i * width + lane];
        if (decisions.empty())
            tape().evaluate(own, result, scratch);
        else
            tape().evaluate(own, result, scratch, branches, {});
        for (std::size_t i = 0; i < result.size(); ++i)
            out[i * width + lane] = result[i];
    }
}

} // namespace expression
