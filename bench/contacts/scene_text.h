// A case in the scene language, as a teacher writes it.
#pragma once

#include "cases.h"

namespace bench::contacts {

[[nodiscard]] std::string sceneText(const Case& scene);

} // namespace bench::contacts
