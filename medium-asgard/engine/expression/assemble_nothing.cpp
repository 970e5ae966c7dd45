// For processors that nothing generates code for.
#include "expression/assemble.h"

namespace expression {

Target oneAtATime() { return {}; }
Target manyAtOnce() { return {}; }
Ability abilityOf(Target /*target*/) { return {}; }
std::vector<std::byte> assemble(const Routine& /*routine*/, Target /*target*/) { return {}; }
std::string listing(const Routine& /*routine*/, Target /*target*/) { return {}; }
std::size_t scratchOf(const Routine& /*routine*/, Target /*target*/) { return 0; }

} // namespace expression
