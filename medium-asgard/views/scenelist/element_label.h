// Elements in a list: a name, or what they act on.
#pragma once

#include "editing/element.h"

#include <QColor>
#include <QString>

#include <optional>

namespace views {

// "b1"; of what has no name "weight on b1", "b1 – b2", "b1 by path".
[[nodiscard]] QString labelOf(const scene::Scene& scene, const editing::Element& element);

// The group of the list that it stands in, in the plural: "Bodies", "Springs".
[[nodiscard]] QString groupOf(const scene::Scene& scene, const editing::Element& element);

// As a picture draws it; none: it has no colour.
[[nodiscard]] std::optional<QColor> colorOf(const scene::Scene& scene,
                                            const editing::Element& element);

} // namespace views
