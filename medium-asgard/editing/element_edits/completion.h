// The words that can stand at a place of a text: commands, options, names of elements.
//
// The text may be anything that is being typed: the text before the place decides, by Tcl's rules.
// Names come from the text itself and from the last good scene, so that a body just typed is
// offered to the force below it.
#pragma once

#include "element_edits/options.h"

#include "scene/scene.h"
#include "script/structure.h"

#include <string>
#include <string_view>
#include <vector>

namespace editing {

struct Completion {
    std::size_t from = 0; // the bytes [from, place) are the beginning of each word
    std::vector<std::string> words;
    std::string hint;   // what is wanted here, "" when nothing is known
    bool whole = false; // what stands there is a word that can stand there, too
};

[[nodiscard]] Completion completionAt(std::string_view text, std::size_t place,
                                      const scene::Scene& scene);
// For who has the text's structure.
[[nodiscard]] Completion completionAt(std::string_view text, const script::Structure& structure,
                                      std::size_t place, const scene::Scene& scene);

} // namespace editing
