// The handles that a graphical viewer shows.
//
// A handle is a small disc of constant size on screen, its colour says of what kind it is
// (dissertation 4.1.3). Some stand at the head of an arrow: a velocity's, an angular velocity's, a
// force's, a torque's, a light's direction. Handles of initial values stand where bodies start,
// those of forces where bodies are now. A force that changes on its own is drawn at its value now
// and has no handle (4.1.5).
//
// Arrows of values have a steady scale on the screen: zooming does not change their length. One
// that would leave the picture is shortened, so that its head can be reached; handles that would
// cover each other stand side by side (handle_layout.h).
#pragma once

#include "drawing/drawing.h"
#include "framing/extent.h"
#include "framing/joint_places.h"
#include "framing/standing_points.h"
#include "handles/vector_values.h"

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace render {

// Pixels, in a picture 480 high. A velocity of zero lies on its body's position, smaller.
[[nodiscard]] double radiusOf(HandleKind kind);

// A start place is drawn as a ring about a point: filled, it would look like a ball of the scene.
[[nodiscard]] constexpr bool isTarget(HandleKind kind) { return kind == HandleKind::position; }

[[nodiscard]] scene::Color colorOf(HandleKind kind);

// Whether the display shows handles of that kind; of any.
[[nodiscard]] bool shows(const Display& display, HandleKind kind);
[[nodiscard]] bool showsHandles(const Display& display);

// Of kinds whose handles stand over everything, as the signs of joints do.
[[nodiscard]] bool isJoint(HandleKind kind);

// A trajectory as a line, fine enough to be drawn.
[[nodiscard]] std::vector<Vector> pathOf(const scene::Trajectory& trajectory);

// View units for a value of 1.
struct ArrowScales {
    double velocity = 1, spin = 1, force = 1, torque = 1;
};

// Prepared once for a scene and a motion; then at() is cheap enough for each picture.
class Handles {
public:
    // Keeps both; the scene must live as long. `before`: scales of the arrows until now, which stay
    // as long as the longest arrow neither leaves the picture nor gets too short to be taken.
    Handles(const scene::Scene& scene, simulation::MotionPointer motion,
            const std::optional<ArrowScales>& before = std::nullopt);

    [[nodiscard]] const ArrowScales& scales() const { return scales_; }

    // Of the kinds that the display shows, as that camera sees them; bodies that are fixed have no
    // velocities.
    [[nodiscard]] HandleSet at(double time, const Display& display, const Camera& camera,
                               Size size);
    // The same where nobody looks: arrows are as long as a picture of the whole motion has them.
    [[nodiscard]] HandleSet at(double time, const Display& display);
    // How many sets this thread has computed, each from all elements.
    [[nodiscard]] static std::size_t setsComputed();
    // How long the arrow of a force, or a torque, of 1 is or would be.
    [[nodiscard]] double arrowLength(HandleKind kind, const Camera& camera) const;

private:
    void addBody(HandleSet& set, std::size_t index, const Display& display) const;
    void addForces(HandleSet& set, double time, const Display& display);
    void addLinks(HandleSet& set, double time, const Display& display);
    void addRopes(HandleSet& set, double time, const Display& display) const;
    void addJoints(HandleSet& set, double time, const Display& display) const;
    void addLimits(HandleSet& set, std::size_t index, const JointPlace& place) const;
    void addLights(HandleSet& set) const;
    void addTrajectories(HandleSet& set, double time, const Display& display) const;
    void addPoints(HandleSet& set, std::size_t trajectory, const Handle& like) const;
    // The force that alone follows it.
    [[nodiscard]] const scene::Force* forceAlong(const scene::Trajectory& trajectory) const;
    void setScales(const std::optional<ArrowScales>& before);
    [[nodiscard]] double massOf(std::size_t body) const;
    [[nodiscard]] std::size_t indexOf(const std::string& body) const;
    [[nodiscard]] Vector pointOn(std::size_t body, const std::optional<Vector>& offset,
                                 const geometry::Pose& pose) const;

    const scene::Scene& scene_;
    simulation::MotionPointer motion_;
    Extent extent_;
    std::unordered_map<std::string, std::size_t> bodies_;
    ArrowScales scales_;
    double viewUnit_ = 1;         // world length of a view unit, of the set that is being made
    std::vector<double> reaches_; // of the bodies
    VectorValues values_;
};

} // namespace render
