// Edits of a document's bytes. An edit replaces only the bytes of its range; everything else
// keeps its spelling.
#pragma once

#include "sgml/tree.h"

#include <string>
#include <string_view>
#include <vector>

namespace sgml {

struct Edit {
    Range range; // bytes of the file before the edit
    std::string text;
    bool operator==(const Edit&) const = default;
};

// Edits that belong together, ordered by place and disjoint, all in offsets of the text before.
using Edits = std::vector<Edit>;

[[nodiscard]] bool areOrdered(const Edits& edits, std::size_t size);
[[nodiscard]] std::string applied(std::string_view text, const Edits& edits);
// The edits that undo them, in offsets of the text after.
[[nodiscard]] Edits inverse(std::string_view text, const Edits& edits);
// Where the byte at `offset` is afterwards; nothing when it was replaced.
[[nodiscard]] std::optional<std::size_t> moved(std::size_t offset, const Edits& edits);

// Replaces [from, to) of a content's unescaped text. More than that range is respelled only where
// the spelling would otherwise change its meaning: a bare brace that loses its partner, and a bare
// backslash that comes to stand before something it would escape, are written escaped.
[[nodiscard]] Edits contentEdit(const Tree& tree, NodeId content, Range unescaped,
                                std::string_view text);
// The same for several ranges, ordered and disjoint, in unescaped offsets.
[[nodiscard]] Edits contentEdits(const Tree& tree, NodeId content, const Edits& unescaped);

// Sets an attribute, adding it behind the others when it is not there. LIMIT: a value holds no `"`,
// which the format cannot spell: each one becomes `'`.
[[nodiscard]] Edits attributeEdit(const Tree& tree, NodeId element, std::string_view name,
                                  std::string_view value);
[[nodiscard]] Edits attributeRemoval(const Tree& tree, NodeId element, std::string_view name);

// `<NAME A="...">{content escaped}</NAME>`
[[nodiscard]] std::string elementText(std::string_view name, std::string_view content);

} // namespace sgml
