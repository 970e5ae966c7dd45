// Other names for elements, wherever the text names them.
//
// A name stands as a word (-body b1), within lists (a rope's points, a gear's joints), and in
// expressions (-10 * b1.mass); a parameter also as $name. The table of options says which words
// these are.
//
// LIMIT: names that the script puts together ("-body b$i") are not found.
#pragma once

#include "editing/element.h"
#include "editing/value_edit.h"
#include "script/structure.h"

#include <string>

namespace editing {

// The edits that make every mention of the element another name, its own command included.
[[nodiscard]] text::Edits mentionsRenamed(const std::string& text,
                                          const script::Structure& structure, Kind kind,
                                          const std::string& name, const std::string& newName);

// Refuses a name that is taken or that expressions could not read, and an element whose name a loop
// or a procedure makes.
[[nodiscard]] Answer renamed(const std::string& text, const scene::Scene& scene,
                             const Element& element, const std::string& newName);

// Why no edit can be made in the command of that element alone: "is one of 5 that line 3 makes.";
// "": one can. `command`: where it stands.
[[nodiscard]] std::string whyNotAlone(const std::string& text, const script::Structure& structure,
                                      const scene::Scene& scene, const Element& element,
                                      const script::Command*& command);

} // namespace editing
