// A part of a document's bytes as a whole of its own, for the clipboard of documents.
#pragma once

#include "sgml/tree.h"

namespace exports {

// The innermost element around both ends, cut where the interval ends: its tags and those of the
// elements inside that are cut are there. An end may be in a content or between two tags. "" where
// no element is around both.
[[nodiscard]] std::string fragment(const sgml::Tree& tree, text::Range interval);

} // namespace exports
