// A script's commands as a scene: every option read, checked and given its default.
//
// A pure function of the text and the recording of its evaluation. An element that is wrong keeps
// its name, so that what refers to it is not wrong as well; the scene of a text with errors is not
// for use.
#pragma once

#include "scene/diagnostic.h"
#include "scene/scene.h"
#include "script/structure.h"
#include "script/wire.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace script {

struct MadeScene {
    scene::Scene scene;
    std::vector<scene::Diagnostic> diagnostics; // not ordered
};

// `finished`: the script ran to its end. What it did not come to is then not called unknown.
[[nodiscard]] MadeScene makeScene(std::string_view text, const Structure& structure,
                                  const Recording& recording, bool finished,
                                  const std::map<std::string, double>& parameters);

} // namespace script
