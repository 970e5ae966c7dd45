// What a Create command asks to be shown in the picture, and what it writes then.
#pragma once

#include "drawing/drawing.h"
#include "editing/value_edit.h"
#include "element_edits/creation.h"
#include "geometry/pose.h"

#include <QString>

#include <functional>
#include <optional>
#include <string>
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
    bool isTyped = false;
    double resolution = 0; // what the pointer tells apart there
    std::string at;        // the thing that drew the point to it: "a corner of b1"
};

// The words beside the pointer: what a click there means, or why it is not taken.
struct Judged {
    QString words; // "": those of its place
    bool isTaken = true;
};

// A thing as it would be, outlined.
struct Outline {
    std::vector<scene::Part> parts;
    geometry::Pose pose;
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
    // Of a body that is pointed at, a point or a hold; null: every one will do.
    std::function<Judged(const scene::Scene& scene, const std::vector<Indicated>& shown,
                         const Indicated& next)>
        judge = {};
    // Of a point that is the head of an arrow: where it is for the value that is typed; null: the
    // numbers are its place.
    std::function<Vector(const std::vector<Indicated>& shown, const Vector& value)> headOf = {};
    // The things that a click on that body would make; null: nothing is outlined.
    std::function<std::vector<Outline>(const scene::Scene& scene, const Indicated& next)> outlines =
        {};
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
    // Changes of bodies that are there, which make room for it; null: none.
    std::function<std::vector<editing::Wish>(const scene::Scene& scene,
                                             const std::vector<Indicated>& shown)>
        moves = {};
    // The same thing, as many times as large as usual; null: it has its size.
    std::function<Recipe(double times)> sized = {};
    // Of what makes nothing: the answer, said in the end.
    std::function<QString(const std::vector<Indicated>& shown)> tells = {};
    bool keepsSelection = false; // it is done to many, and one goes on with what one has
};

} // namespace views
