#include "expression/kernel.h"

#include <cstdlib>
#include <unordered_map>

namespace expression {
namespace {

std::atomic<std::size_t> kernelsMade = 0, codesCompiled = 0, bytesCompiled = 0;

// All kernels of the process. Those that no tape uses any more are let go when there are too many;
// when all are in use, more are made without being shared.
class Registry {
public:
    std::shared_ptr<Kernel> of(const Sequence& sequence) {
        const std::size_t hash = sequence.hash();
        const std::scoped_lock lock(mutex_);
        const auto [first, last] = kernels_.equal_range(hash);
        for (auto it = first; it != last; ++it)
            if (it->second->hasSequence(sequence))
                return it->second;
        if (kernels_.size() >= most)
            std::erase_if(kernels_,
                          [](const auto& entry) { return entry.second.use_count() == 1; });
        ++kernelsMade;
        auto kernel = std::make_shared<Kernel>(sequence);
        if (kernels_.size() < most)
            kernels_.emplace(hash, kernel);
        return kernel;
    }

private:
    static constexpr std::size_t most = 4096;
    std::mutex mutex_;
    std::unordered_multimap<std::size_t, std::shared_ptr<Kernel>> kernels_;
};

bool isAllowed() {
    static const bool allowed = std::getenv("ASGARD_INTERPRET") == nullptr;
    return allowed;
}

Target targetOf(Kernel::Width width) {
    return width == Kernel::Width::one ? oneAtATime() : manyAtOnce();
}

} // namespace

std::shared_ptr<Kernel> Kernel::of(const Sequence& sequence) {
    static Registry registry;
    return registry.of(sequence);
}

std::uint32_t Kernel::worthwhile(const Sequence& sequence) {
    return static_cast<std::uint32_t>(70 + 8000 / (1 + sequence.instructions.size()));
}

const Kernel::Code* Kernel::code(Purpose purpose, Width width, std::uint32_t evaluations) {
    Variant& variant =
        variants_[static_cast<std::size_t>(purpose)][static_cast<std::size_t>(width)];
    if (const Code* const code = variant.ready.load(std::memory_order_acquire))
        return code;
    if (!isAllowed() || !(variant.evaluations.fetch_add(evaluations) + evaluations >= worthwhile_ ||
                          (width == Width::many && isReady(purpose))))
        return nullptr;
    const std::scoped_lock lock(compiling_);
    if (!variant.tried)
        compile(variant, purpose, width);
    return variant.ready;
}

void Kernel::compile(Variant& variant, Purpose purpose, Width width) {
    variant.tried = true;
    const Target target = targetOf(width);
    const Routine routine = makeRoutine(sequence_, purpose, abilityOf(target));
    const std::vector<std::byte> bytes = assemble(routine, target);
    variant.memory = ExecutableMemory(bytes);
    if (!variant.memory.start())
        return;
    variant.code = {std::bit_cast<EntryPoint>(variant.memory.start()), scratchOf(routine, target)};
    variant.ready.store(&variant.code, std::memory_order_release);
    ++codesCompiled;
    bytesCompiled += bytes.size();
}

std::string Kernel::print(Purpose purpose, Width width) const {
    return makeRoutine(sequence_, purpose, abilityOf(targetOf(width))).print();
}

std::string Kernel::listing(Purpose purpose, Width width) const {
    const Target target = targetOf(width);
    if (!isAllowed())
        return {};
    return expression::listing(makeRoutine(sequence_, purpose, abilityOf(target)), target);
}

Kernel::Counts Kernel::counts() { return {kernelsMade, codesCompiled, bytesCompiled}; }

} // namespace expression
