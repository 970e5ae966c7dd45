// A scene as its author wrote it: elements, their options, and where each stands in the text.
//
// This is a plain value, made by script/ from one evaluation of the text, and read by everything
// else. Expressions are kept as text (expression/ parses them), shapes as their description
// (geometry/ makes hulls of them). Units are the author's, coherent; angles radians; world
// coordinates unless a comment says "body". Defaults stand here, from the scene language.
//
// Reference: the scene language (docs/scene-language.md), sections "Elements" and "Physics".
#pragma once

#include "geometry/pose.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace scene {

using geometry::Quaternion;
using geometry::Vector;

// Bytes [from, to) of the scene's text, UTF-8. An empty range means that no place is known: the
// element came from a command that the text does not hold literally (an eval of computed text).
struct Range {
    std::size_t from = 0;
    std::size_t to = 0;
    [[nodiscard]] bool known() const { return to > from; }
    bool operator==(const Range&) const = default;
};

// Where one value of an element comes from.
struct Argument {
    std::string option;   // "-init_pos", "-x"; "" for the name and for a shape given by position
    Range word;           // the whole word, braces and quotes included
    bool literal = false; // the word's bytes are the value's own: safe to rewrite
};

// Where an element comes from: one command of the text, which may have run several times.
struct Source {
    Range command;
    int runs = 0; // how often that command ran in the evaluation; > 1: made by a loop or procedure
    int line = 0; // from 1; of the command's first character (or the nearest mapped caller)
    int column = 0; // from 1, in characters
    std::vector<Argument> arguments;
};

using Expression = std::string; // infix text of the scene language, not parsed

struct Color {
    double red = 0.7, green = 0.7, blue = 0.7; // 0..1
    bool operator==(const Color&) const = default;
};

// A value that is not given is inherited: part <- body <- shape set <- the default grey.
struct Appearance {
    std::optional<Color> color;
    std::optional<double> shininess;    // 0 matt .. 1 mirror-like highlight
    std::optional<double> transparency; // 0 opaque .. 1 invisible
    bool operator==(const Appearance&) const = default;
};

// --- shapes ---------------------------------------------------------------------------------

struct SphereShape {
    double radius = 1;
    bool operator==(const SphereShape&) const = default;
};
struct BoxShape {
    Vector edges = Vector::Ones(); // full edge lengths, centred
    bool operator==(const BoxShape&) const = default;
};
struct HullShape {
    std::vector<Vector> points; // the part is their convex hull
    bool operator==(const HullShape&) const = default;
};

// Round parts have the part's y as their axis, and their origin half way up it.
struct CylinderShape {
    double radius = 1, height = 1; // without height: a disc
    bool operator==(const CylinderShape&) const = default;
};
struct ConeShape { // apex at + height / 2
    double radius = 1, height = 1;
    bool operator==(const ConeShape&) const = default;
};
struct CapsuleShape {
    double radius = 1, height = 1; // between the centres of its half spheres
    bool operator==(const CapsuleShape&) const = default;
};
struct EllipsoidShape {
    Vector axes = Vector::Ones(); // half axes along x, y, z
    bool operator==(const EllipsoidShape&) const = default;
};
// Hollow: the radius of the hollow, then that of the outside.
struct TubeShape { // along y
    double inner = 0.9, outer = 1, height = 1;
    bool operator==(const TubeShape&) const = default;
};
struct BowlShape { // the lower half of a shell about the part's origin
    double inner = 0.9, outer = 1;
    bool operator==(const BowlShape&) const = default;
};
// Everything below y = 0, without mass and extent; of bodies that are fixed or held.
struct PlaneShape {
    bool operator==(const PlaneShape&) const = default;
};

struct Part {
    std::variant<SphereShape, BoxShape, HullShape, CylinderShape, ConeShape, CapsuleShape,
                 EllipsoidShape, PlaneShape, TubeShape, BowlShape>
        shape;
    Vector position = Vector::Zero(); // in the shape's frame; the part is turned, then moved
    Vector rotation = Vector::Zero(); // rotation vector
    Appearance appearance;
    std::optional<double> density = {}; // none: the body's
    bool operator==(const Part&) const = default;
};

struct ShapeSet {
    std::string name;
    std::vector<Part> parts; // the shape is their union; not empty
    Appearance appearance;
    Source source;
};

// --- bodies ---------------------------------------------------------------------------------

struct Body {
    std::string name;
    std::string shape;                       // a shape set's name
    Vector initialPosition = Vector::Zero(); // of the reference point (the shape's origin)
    Quaternion initialAttitude = Quaternion::Identity(); // normalised
    Vector initialVelocity = Vector::Zero();             // of the centre of mass
    Vector initialAngularVelocity = Vector::Zero();      // world axes
    std::optional<double> mass;                          // given: the inertia is scaled to it
    // Given: xx yy zz xy xz yz, the tensor's entries about the centre of mass in the body's axes.
    std::optional<std::array<double, 6>> inertia;
    std::optional<Vector> center; // of mass, body frame; given with mass and inertia only
    double density = 1;
    double restitution = 1;
    double friction = 0;                     // Coulomb's coefficient while it slides
    std::optional<double> staticFriction;    // while it sticks; none: the same
    double rollingFriction = 0;              // a length: couple over normal force
    Vector surfaceVelocity = Vector::Zero(); // of its surface along itself, body frame: a conveyor
    bool fixed = false;
    bool countsTurns = false;    // an expression reads B.rx, B.ry or B.rz: they are integrated
    std::string articulatedBody; // -artbody, "" when not given
    std::optional<int> collisionGroup;
    Appearance appearance;
    Source source;
};

// --- what acts ------------------------------------------------------------------------------

enum class Frame { world, body };

struct ComponentForce {
    std::array<Expression, 3> components;
    Frame frame = Frame::world;
};
struct TrajectoryForce {
    std::string trajectory; // its value now is the force, world axes
};
struct GravitationalForce {
    Vector acceleration = Vector::Zero(); // the force is this times the mass
};

struct Force {
    std::string body;
    bool couple = false;          // -torque 1: turns the body, makes no net force
    std::optional<Vector> offset; // body frame, from the reference point; none: the centre of mass
    std::variant<ComponentForce, TrajectoryForce, GravitationalForce> kind;
    std::optional<Expression> release; // not 0: the force is gone from then on
    Source source;
};

struct BodyEnd {
    std::string body;
    std::optional<Vector> offset; // body frame, from the reference point; none: the centre of mass
};
struct PointEnd {
    std::array<Expression, 3> coordinates; // may read positions, not velocities
};
struct TrajectoryEnd {
    std::string trajectory;
};

// The law of a spring, which pulls along the line of its ends (scene language, "Physics").
struct SpringLaw {
    std::optional<double> rest; // L; none: its length at the start
    bool isPullOnly = false;    // no force while it is shorter than L
};

// A link, which pulls the first end to the second in every direction, F = -k d - c v; or a spring.
struct Link {
    std::string name; // of a spring; "" when not given
    BodyEnd first;
    std::variant<BodyEnd, PointEnd, TrajectoryEnd> second;
    double tightness = 0;              // k; a spring's -stiffness
    std::optional<double> damping;     // c; none: critical, 2 sqrt(k m); a spring's is always given
    std::optional<SpringLaw> spring;   // none: a link
    std::optional<Expression> release; // not 0: it is gone from then on
    Source source;
};

// --- joints ---------------------------------------------------------------------------------

// In the order of the table in docs/scene-language.md; joint_types.h has what they leave free.
enum class JointType {
    fixed,
    hinge,
    slider,
    cylindrical,
    universal,
    ball,
    planar,
    distance,
    screw,
};

// One coordinate of a joint. An angle or a length, of body 1 against body 2 (or the world).
struct JointCoordinate {
    std::optional<double> lower, upper; // -limits
    double limitRestitution = 0;
    // At most one of them. motor: force or couple along the coordinate, on body 1; speed and
    // position: dq or q as a function of the time and of others' states, whatever force that takes.
    std::optional<Expression> motor, speed, position;
    std::optional<double> maxMotor;              // none: no bound on the force of speed or position
    double stiffness = 0, rest = 0, damping = 0; // force -stiffness (q - rest) - damping dq
    double friction = 0;                         // the most that the dry force or couple can be
    double from = 0;                             // its value where the bodies start
    // Some option of it was written, but -from.
    bool isGiven = false;
};

// An exact condition between two bodies, or a body and the world.
struct Joint {
    std::string name;
    JointType type = JointType::fixed;
    std::string body1;
    std::optional<Vector> offset1;    // frame of body 1, from its reference point; none: its centre
    std::optional<std::string> body2; // none: the world
    // Frame of body 2 (the world). None: where offset1 is at the start; of a distance, the centre
    // of mass of body 2, and without body 2 it is always given.
    std::optional<Vector> offset2;
    Vector axis = Vector::Zero(); // frame of body 1, as written; zero for a type without an axis
    std::optional<Vector> axis2;  // frame of body 2 (the world)
    double pitch = 0;             // screw: sliding in one turn; negative: left-handed
    std::vector<JointCoordinate> coordinates; // as many as the type has, q1 first
    std::optional<Expression> release;        // not 0: the joint is gone from then on
    Source source;
};

// The sum of ratio * q of its terms stays what it is at the start.
struct Gear {
    struct Term {
        std::string joint;
        std::size_t coordinate = 0; // of the joint, from 0
        double ratio = 1;
        bool operator==(const Term&) const = default;
    };
    std::string name;
    std::vector<Term> terms; // -joint1 J -joint2 K -ratio R: {J 1} {K -R}
    std::optional<Expression> release;
    Source source;
};

// A massless rope of fixed length, which pulls and never pushes. It slides through its middle
// points without friction; around wheels it is wrapped and does not slip.
struct Rope {
    struct Point {
        std::optional<std::string> body; // none: a point of the world
        // Frame of the body, from its reference point, or the world. None: its centre of mass.
        std::optional<Vector> place;
        double radius = 0;             // of a wheel; negative: the rope goes round its other side
        Vector axis = Vector::UnitZ(); // of a wheel, frame of the body
    };
    std::string name;
    std::vector<Point> points;
    std::optional<double> length; // none: what it measures at the start
    double restitution = 0;       // of the impact when it becomes taut
    bool isClosed = false;        // from the last point back to the first: a belt
    std::optional<Expression> release;
    Source source;
};

// Where two bodies touch: what is given overrides what follows from the bodies (contact_pairs.h).
struct Contact {
    std::string name; // "" when not given
    std::string body1, body2;
    std::optional<double> friction; // while it sticks, too, without a static one
    std::optional<double> staticFriction, rollingFriction, restitution;
    std::optional<bool> collides; // whatever collision groups, links and joints say
    Source source;
};

// --- trajectories ---------------------------------------------------------------------------

// One Bezier curve over [from, to), its parameter linear in time. One control point: a constant.
struct BezierCurve {
    double from = 0, to = 0;
    std::vector<Vector> control;
    bool operator==(const BezierCurve&) const = default;
};

struct Trajectory {
    std::string name;
    std::vector<BezierCurve> curves; // ordered in time, disjoint; gaps are allowed
    // As written by -points: t and place of each; empty for -bezier.
    std::vector<std::pair<double, Vector>> points;
    Source source;
};

enum class Held {
    position,        // of the reference point, three components
    attitude,        // a curve of rotation vectors
    velocity,        // of the centre of mass
    angularVelocity, // world axes
    x,
    y,
    z, // one component, from the trajectory's first
    dx,
    dy,
    dz,
};

struct Constraint {
    std::string body;
    Held held = Held::position;
    std::string trajectory;
    std::optional<double> from, to; // none: the trajectory's own intervals
    Source source;
};

// --- what is looked at ----------------------------------------------------------------------

struct LightSource {
    std::string name; // "" when not given
    std::optional<Vector> direction;
    std::optional<Vector> position; // without direction: a point light
    Color color{1, 1, 1};
    Source source;
};

using VectorValue =
    std::variant<Vector, std::array<Expression, 3>, std::string>; // string: a trajectory
using ScalarValue = std::variant<double, Expression>;

// A point p of the world is seen at scale * R(rotation) * (p - center) + position: the screen's x
// right, y up, z towards the viewer. With eye and look instead: the camera stands at eye, looks at
// look, with up upwards.
struct View {
    std::string name;
    std::optional<VectorValue> position, rotation, center;
    std::optional<ScalarValue> scale;
    std::optional<VectorValue> eye, look, up;
    Source source;
};

struct Parameter {
    std::string name;
    double value = 0;
    std::optional<double> minimum, maximum;
    std::string label, unit;
    Source source;
};

struct Plot {
    std::string name;
    std::vector<Expression> values;
    std::vector<std::string> labels;
    std::string title;
    bool beside = false; // pictures have its values, too, beside what they are of
    Source source;
};

struct Simulator {
    double start = 0;
    double finish = 10;
    std::optional<double> firstStep;
    double accuracy = 1e-4; // largest position error over the size of the scene
    std::string method = "auto";
    bool collisions = true;
    std::optional<Source> source; // none: the scene has no simulator command
};

struct Scene {
    Simulator simulator;
    std::vector<ShapeSet> shapeSets;
    std::vector<Body> bodies; // in the order of the text, which is the order of output columns
    std::vector<Force> forces;
    std::vector<Link> links; // and springs, in the order of the text
    std::vector<Joint> joints;
    std::vector<Gear> gears;
    std::vector<Rope> ropes;
    std::vector<Contact> contacts;
    std::vector<Trajectory> trajectories;
    std::vector<Constraint> constraints;
    std::vector<LightSource> lights;
    std::vector<View> views;
    std::vector<Parameter> parameters;
    std::vector<Plot> plots;
};

// The element of that name, or null.
[[nodiscard]] const ShapeSet* findShapeSet(const Scene& scene, const std::string& name);
[[nodiscard]] const Body* findBody(const Scene& scene, const std::string& name);
[[nodiscard]] const Trajectory* findTrajectory(const Scene& scene, const std::string& name);
[[nodiscard]] const Joint* findJoint(const Scene& scene, const std::string& name);
// Of these two bodies, in either order.
[[nodiscard]] const Contact* findContact(const Scene& scene, const std::string& body1,
                                         const std::string& body2);

// Of the ball about the part's origin that holds it; of a half space 0.
[[nodiscard]] double reachOf(const Part& part);
[[nodiscard]] bool hasPlane(const ShapeSet& set);
// Of its parts some have a volume; a body of discs or half spaces alone has none.
[[nodiscard]] bool hasVolume(const ShapeSet& set);

} // namespace scene
