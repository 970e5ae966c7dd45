// Edits of a document's bytes by what is meant: a content, an attribute. An edit replaces only the
// bytes of its range; everything else keeps its spelling.
#pragma once

#include "sgml/tree.h"
#include "text/edit.h"

#include <string>
#include <string_view>

namespace sgml {

// Replaces [from, to) of a content's unescaped text. More than that range is respelled only where
// the spelling would otherwise change its meaning: a bare brace that loses its partner, and a bare
// backslash that comes to stand before something it would escape, are written escaped.
[[nodiscard]] text::Edits contentEdit(const Tree& tree, NodeId content, text::Range unescaped,
                                      std::string_view text);
// The same for several ranges, ordered and disjoint, in unescaped offsets.
[[nodiscard]] text::Edits contentEdits(const Tree& tree, NodeId content,
                                       const text::Edits& unescaped);

// `NAME="value"`. LIMIT: a value holds no `"`, which the format cannot spell: each one becomes `'`.
[[nodiscard]] std::string attributeText(std::string_view name, std::string_view value);
// Sets an attribute, adding it behind the others when it is not there.
[[nodiscard]] text::Edits attributeEdit(const Tree& tree, NodeId element, std::string_view name,
                                        std::string_view value);
[[nodiscard]] text::Edits attributeRemoval(const Tree& tree, NodeId element, std::string_view name);

// `<NAME A="...">{content escaped}</NAME>`
[[nodiscard]] std::string elementText(std::string_view name, std::string_view content);

} // namespace sgml
