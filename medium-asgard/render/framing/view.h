// The scene's own `view` elements as cameras.
//
// Parts of a camera that a view does not give are framed (framing/framing.h). Values bound to
// expressions or trajectories follow time; they are read from the motion by simulation::Quantities,
// prepared once.
#pragma once

#include "framing/camera.h"
#include "framing/extent.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace render {

// Prepared once for a scene, a motion and a picture size; then at() is cheap enough for each frame.
class SceneView {
public:
    // The view of that name, the scene's first when the name is empty, `framed` when there is none.
    // `framed`: so that this is seen; none: the motion. While one edits it is what was seen before.
    SceneView(const scene::Scene& scene, const simulation::MotionPointer& motion,
              const std::string& name, Size size, std::optional<Extent> framed = std::nullopt);
    ~SceneView();
    SceneView(SceneView&&) noexcept;
    SceneView& operator=(SceneView&&) noexcept;

    [[nodiscard]] Camera at(double time) const;
    [[nodiscard]] bool follows() const; // the camera depends on time
    [[nodiscard]] const Extent& framed() const;
    // One sentence for each value that could not be read.
    [[nodiscard]] const std::vector<std::string>& faults() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

// SceneView(...).at(time), for those who want one picture.
[[nodiscard]] Camera cameraOf(const scene::Scene& scene, const simulation::MotionPointer& motion,
                              const std::string& view, double time, Size size);

} // namespace render
