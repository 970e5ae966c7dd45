// The Create commands: what each asks to be shown in the picture, and what it writes then
// (dissertation 4.1.2, 4.1.4 to 4.1.8).
#pragma once

#include "drawing/drawing.h"
#include "element_edits/creation.h"
#include "geometry/pose.h"
#include "point_edits/shape_library.h"

#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace views {

using geometry::Vector;

using HandleSwitch = bool render::Display::*; // one kind of handle shown or not

// The thing that a click is to show.
enum class Wanted {
    point,      // in the plane of the screen through what was shown before, or, if it snaps, in
                // the upright or level one
    body,       // the front-most one, and where on its surface
    trajectory, // the nearest line
    hold,       // a body, or where no other body is the ground; as deep as the first body's centre
};

struct Step {
    Wanted wanted = Wanted::point;
    QString prompt;       // "Click on the body that it acts on."
    QString otherwise;    // what Return does instead, "" when there is no such thing
    bool repeats = false; // again and again, until Return
    bool whole = false;   // of a body: wherever it is shown, its centre of mass is meant
    bool deep = false;    // of a body: as deep as its centre, and on its axes where that is near
    std::optional<std::size_t> offered = {}; // the body that Return takes
    bool snaps = false;   // of a point: things and round numbers nearby draw it to them
    bool surface = false; // of a point: on the body that is shown there, if it is one
    bool rests = false;   // of a point: so that the ghost rests on that body
};

// The thing that was shown for one step; nothing of it: Return.
struct Indicated {
    bool given = false;
    Vector point = Vector::Zero(); // world
    std::optional<std::size_t> body;
    Vector onBody = Vector::Zero();  // in the body's frame
    Vector onFirst = Vector::Zero(); // of what holds a body: in the first body's frame
    // Of the body, now; of a place where a new body rests, its own.
    geometry::Quaternion attitude = geometry::Quaternion::Identity();
    Vector sight = Vector::UnitZ(); // towards the viewer
    bool atCenter = false;          // of mass, as near as the pointer can tell
    std::optional<std::size_t> trajectory;
    double resolution = 0; // what the pointer tells apart there
    std::string at;        // the thing that drew the point to it: "a corner of b1"
};

struct Recipe {
    QString label; // "New Force": for the undo stack and the prompt
    std::vector<Step> steps;
    std::function<std::vector<editing::NewElement>(
        const std::string& text, const scene::Scene& scene, const std::vector<Indicated>& shown)>
        make;
    HandleSwitch handles = nullptr;      // shown afterwards
    QString otherwise = {};              // said when there is nothing to make
    std::vector<scene::Part> ghost = {}; // outlined under the pointer before the click
    // Of what makes nothing: the answer, said in the end.
    std::function<QString(const std::vector<Indicated>& shown)> tells = {};
};

enum class BasicShape { sphere, box };

// Of a shape that is there, or of a new one.
[[nodiscard]] Recipe newBody(const std::string& shape, std::vector<scene::Part> ghost = {});
[[nodiscard]] Recipe newBody(BasicShape shape);
[[nodiscard]] Recipe newBody(const editing::LibraryShape& shape);
// `perUnit`: how long the arrow of a force of 1 is drawn.
[[nodiscard]] Recipe newForce(bool couple, double perUnit);
// `massOf`: of a body of the scene. `usual`: the acceleration that Return gives.
[[nodiscard]] Recipe newWeight(double perUnit, std::function<double(std::size_t)> massOf,
                               const Vector& usual);
// For each body that can fall and has no weight yet; without steps.
[[nodiscard]] Recipe weightForAll(const Vector& acceleration);
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
// A hinge, a slider, a ball, a fixed joint or a distance, between a body and another or the ground.
[[nodiscard]] Recipe newJoint(scene::JointType type);
// From a body through other bodies and points of the ground.
[[nodiscard]] Recipe newRope();
[[nodiscard]] Recipe newLight(bool point);
[[nodiscard]] Recipe newTrajectory();
[[nodiscard]] Recipe attachTrajectory();
// Without steps: what a dialog has asked for.
[[nodiscard]] Recipe newParameter(const std::string& name, const std::string& value,
                                  const std::string& minimum, const std::string& maximum);
[[nodiscard]] Recipe newPlot(const std::string& expression);
// A plane below everything that is there, without a click.
[[nodiscard]] Recipe newFloor();
// The distance of two points; the text stays as it is.
[[nodiscard]] Recipe measure();
[[nodiscard]] Recipe keptView(const render::Camera& camera, double resolution);

} // namespace views
