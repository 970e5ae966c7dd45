// The IDs of a document: each names one element.
#pragma once

#include "sgml/tree.h"

#include <set>
#include <string>
#include <string_view>

namespace authoring {

using Ids = std::set<std::string, std::less<>>;

[[nodiscard]] Ids idsOf(const sgml::Tree& tree);
// "figure-2" for FIGURE: the first that is not taken.
[[nodiscard]] std::string freeId(const Ids& taken, std::string_view stem);
// A document's bytes, to come into another document. An element with an ID that is taken there, or
// that comes twice, gets another one, which references from within follow; without such references
// it has none.
[[nodiscard]] std::string withFreeIds(const sgml::Tree& into, const std::string& bytes);

} // namespace authoring
