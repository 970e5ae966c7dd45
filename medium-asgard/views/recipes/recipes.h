// The Create commands: what each asks to be shown in the picture, and what it writes then
// (dissertation 4.1.2, 4.1.4 to 4.1.8).
#pragma once

#include "point_edits/shape_library.h"
#include "recipes/recipe.h"

#include <functional>
#include <optional>
#include <vector>

namespace views {

enum class BasicShape { sphere, box };

// Of a shape that is there, or of a new one.
[[nodiscard]] Recipe newBody(const std::string& shape, std::vector<scene::Part> ghost = {});
// `times`: as large as usual.
[[nodiscard]] Recipe newBody(BasicShape shape, double times = 1);
[[nodiscard]] Recipe newBody(const editing::LibraryShape& shape, double times = 1);
// A pair at the sides of a body that is shown, on hinges.
[[nodiscard]] Recipe newWheels();
// `perUnit`: how long the arrow of a force of 1 is drawn.
[[nodiscard]] Recipe newForce(bool couple, double perUnit);
// `massOf`: of a body of the scene. `usual`: the acceleration that Return gives.
[[nodiscard]] Recipe newWeight(double perUnit, std::function<double(std::size_t)> massOf,
                               const Vector& usual);
// For each body that can fall and has no weight yet, of all or of these; without steps.
[[nodiscard]] Recipe weightForAll(const Vector& acceleration);
[[nodiscard]] Recipe weightFor(const std::vector<std::size_t>& bodies, const Vector& acceleration);
// The one that all bodies have that can fall, if there are such; none: they differ.
[[nodiscard]] std::optional<Vector> commonGravity(const scene::Scene& scene);
// The one that others have, else the earth's.
[[nodiscard]] Vector usualGravity(const scene::Scene& scene);
[[nodiscard]] Recipe newTrajectoryForce(bool couple);
[[nodiscard]] Recipe newLink(Wanted second);
[[nodiscard]] Recipe newSpring(Wanted second);
// Two bodies, or each two, attract each other as stars do, by a parameter G.
[[nodiscard]] Recipe newAttraction();
[[nodiscard]] Recipe attractionOfAll();
// A body goes round another in a circle, and both attract each other.
[[nodiscard]] Recipe newOrbit();
// Of each type, between a body and another or the ground.
[[nodiscard]] Recipe newJoint(scene::JointType type);
// Two bodies on hinges or sliders roll on each other; the ratio follows from their sizes.
[[nodiscard]] Recipe newGear();
// From a body through other bodies and points of the ground.
[[nodiscard]] Recipe newRope();
[[nodiscard]] Recipe newLight(bool point);
[[nodiscard]] Recipe newTrajectory();
[[nodiscard]] Recipe attachTrajectory();
// Without steps: what a dialog has asked for.
[[nodiscard]] Recipe newParameter(const std::string& name, const std::string& value,
                                  const std::string& minimum, const std::string& maximum);
// `curve`: its name; "": the expression tells it.
[[nodiscard]] Recipe newPlot(const std::string& expression, const std::string& curve = {});
// A plane below everything that is there, without a click.
[[nodiscard]] Recipe newFloor();
// The distance of two points; the text stays as it is.
[[nodiscard]] Recipe measure();
[[nodiscard]] Recipe keptView(const render::Camera& camera, double resolution);

} // namespace views
