// The shapes of bodies as solids that one can point at, each made once.
//
// LIMIT: one that nobody has prepared yet is made by who asks for it, on the interface's thread
// too: of hundreds of parts that is felt, once.
#include "gestures/picking.h"
#include "scene/shape_of.h"

#include <algorithm>
#include <mutex>

namespace gestures {

namespace {

struct Made {
    std::vector<scene::Part> parts;
    ShapePointer shape;
};

// Of all windows and threads of the process.
struct Store {
    std::mutex mutex;
    std::vector<Made> made;

    [[nodiscard]] const Made* find(const scene::ShapeSet& set) const {
        const auto found = std::ranges::find(made, set.parts, &Made::parts);
        return found == made.end() ? nullptr : &*found;
    }
};

Store& store() {
    static Store one;
    return one;
}

ShapePointer ofSet(const scene::ShapeSet& set) {
    Store& all = store();
    {
        const std::lock_guard lock(all.mutex);
        if (const Made* made = all.find(set))
            return made->shape;
    }
    auto result = scene::shapeOf(set); // not under the lock: it may take long
    ShapePointer shape;
    if (auto* good = std::get_if<geometry::Shape>(&result))
        shape = std::make_shared<const geometry::Shape>(std::move(*good));
    const std::lock_guard lock(all.mutex);
    if (const Made* made = all.find(set)) // another thread was quicker
        return made->shape;
    all.made.push_back({set.parts, shape});
    return shape;
}

} // namespace

ShapePointer shapeOf(const scene::Scene& scene, const std::string& name) {
    const scene::Body* body = scene::findBody(scene, name);
    const scene::ShapeSet* set = body ? scene::findShapeSet(scene, body->shape) : nullptr;
    return set ? ofSet(*set) : nullptr;
}

void prepareShapes(const std::vector<std::shared_ptr<const scene::Scene>>& scenes) {
    for (const auto& scene : scenes)
        for (const scene::ShapeSet& set : scene->shapeSets)
            static_cast<void>(ofSet(set));
    const std::lock_guard lock(store().mutex);
    std::erase_if(store().made, [&](const Made& made) {
        return std::ranges::none_of(scenes, [&](const auto& scene) {
            return std::ranges::find(scene->shapeSets, made.parts, &scene::ShapeSet::parts) !=
                   scene->shapeSets.end();
        });
    });
}

} // namespace gestures
