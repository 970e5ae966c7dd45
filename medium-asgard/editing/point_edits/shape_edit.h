// A shape set that becomes another, as the smallest change of its text (dissertation 4.1.1).
//
// A shape editor drags vertices, adds and deletes them, adds and deletes parts. Its result is a
// list of parts, each with the part of the scene that it was. The text of unchanged parts is not
// touched; in the others the changed numbers are rewritten where they stand. Parts written as faces
// keep their faces while only places change; another number of vertices writes them as one list of
// points.
//
// Reference: dissertation 4.1.1; docs/scene-language.md, `shape_set`.
#pragma once

#include "editing/value_edit.h"

namespace editing {

struct DraftPart {
    scene::Part part;
    std::optional<std::size_t> was; // its place in the scene's list; none: it is new
};

// As in the scene.
[[nodiscard]] std::vector<DraftPart> draftOf(const scene::ShapeSet& set);

// "-sub {-sphere 1}": a part as it is written.
[[nodiscard]] std::string partText(const scene::Part& part);

// The change that makes the set of `scene`, which was read from `text`, become the draft. What
// computes its description stays; then an offer writes the description out instead.
[[nodiscard]] Answer become(const std::string& text, std::shared_ptr<const scene::Scene> scene,
                            std::size_t shapeSet, const std::vector<DraftPart>& draft);

// Parts as a -desc of their own, in braces; several on a line each.
[[nodiscard]] std::string descriptionText(const std::vector<scene::Part>& parts);
// A new command for a shape set.
[[nodiscard]] std::string shapeSetText(const std::string& name,
                                       const std::vector<scene::Part>& parts);

// Another name for a shape set, where it is made and where bodies name it.
[[nodiscard]] Answer renamed(const std::string& text, const scene::Scene& scene,
                             std::size_t shapeSet, const std::string& name);

} // namespace editing
