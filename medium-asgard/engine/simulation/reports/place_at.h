// The place of an element in the text.
#pragma once

#include "scene/diagnostic.h"
#include "scene/scene.h"

#include <string>

namespace simulation {

// At the option's word where it is known; "": at the command.
void placeAt(const scene::Source& source, const std::string& option, scene::Diagnostic& said);

} // namespace simulation
