// Lines and columns of a diagnostic.
#pragma once

#include "scene/diagnostic.h"
#include "text/places.h"

namespace script {

// Fills them in from the diagnostic's range.
void locate(const text::Places& places, scene::Diagnostic& diagnostic);

} // namespace script
