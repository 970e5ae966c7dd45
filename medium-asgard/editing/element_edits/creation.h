// New elements as new lines of a scene's text.
//
// A new element is written as its author writes such elements: behind the last of its kind, or
// where its kind belongs, but always behind what it names; named like the others, with a name that
// nothing in the text has. All other bytes stay.
#pragma once

#include "editing/element.h"
#include "text/edit.h"

#include <string>
#include <vector>

namespace editing {

struct NewElement {
    Kind kind = Kind::body;
    std::string name;               // "": the kind has none
    std::vector<std::string> words; // "-init_pos", "{1 2 3}", as they are written
    std::vector<Element> behind;    // what it names
    std::string shape = {};         // of a body: written as the author does, with -shape or without
    std::string command = {};       // "": that of its kind
};

// The edits, in order; one at most for each place.
[[nodiscard]] text::Edits created(const std::string& text, const scene::Scene& scene,
                                  const std::vector<NewElement>& elements);

// Expressions can read it as a name; and nothing of the scene or the language has it.
[[nodiscard]] bool isName(const std::string& name);
[[nodiscard]] bool isFreeName(const scene::Scene& scene, const std::string& name);

// The name with another number behind it: "rod2" for "rod", "b4" for "b1" where b2 and b3 are
// taken, by something of the scene, a word of the text or one of `taken`.
[[nodiscard]] std::string numberedName(const std::string& text, const scene::Scene& scene,
                                       const std::string& name,
                                       const std::vector<std::string>& taken = {});

// "b4" after b1, b2, b3; `stem` and a number where there is no such row. Avoids also `taken`.
[[nodiscard]] std::string unusedName(const std::string& text, const scene::Scene& scene, Kind kind,
                                     const std::string& stem,
                                     const std::vector<std::string>& taken = {});

} // namespace editing
