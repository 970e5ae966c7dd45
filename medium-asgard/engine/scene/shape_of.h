// The geometry that a shape set describes: parts turned, then moved, as its author wrote them.
#pragma once

#include "geometry/shape.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>

namespace scene {

// The sentence says why there is none (points in one plane), without a full stop. Of many points it
// takes a while: `meanwhile` is called now and then, and may throw to end it.
[[nodiscard]] std::variant<geometry::Shape, std::string>
shapeOf(const ShapeSet& set, const std::function<void()>& meanwhile = {});

// The shapes of one scene, each made when it is first asked for: collisions and masses share them.
// The scene must not change meanwhile.
class ShapeReader {
public:
    using Made = std::variant<geometry::Shape, std::string>;
    explicit ShapeReader(std::function<void()> meanwhile = {}) : meanwhile_(std::move(meanwhile)) {}

    [[nodiscard]] const Made& of(const ShapeSet& set);

private:
    std::function<void()> meanwhile_;
    std::unordered_map<const ShapeSet*, Made> known_;
};

} // namespace scene
