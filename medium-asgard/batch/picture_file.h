// Pixels into picture files.
#pragma once

#include "render/renderer.h"

#include <string>

namespace batch {

enum class PictureFormat { png, ppm };

// False when the file could not be written; `why` then says it.
[[nodiscard]] bool writePicture(const std::string& file, PictureFormat format,
                                const render::Image& image, std::string& why);

} // namespace batch
