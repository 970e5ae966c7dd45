// The scenes of contact and joints that every engine plays, each with its exact motion.
//
// Gravity is along -y, in SI units; bodies have their extent along z, too. All but Bricard's
// mechanism move in the plane z = 0. Bodies that a joint connects never collide.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace bench::contacts {

using Place = std::array<double, 3>;

inline constexpr double standardGravity = 9.81;

struct Body {
    enum class Shape { box, ball, capsule, feet };
    std::string name;
    Shape shape = Shape::box;
    // Edges of a box; a ball has its radius first; a capsule, along its y, its radius and the
    // distance of the centres of its ends. `feet` are two rings of balls, without what joins them:
    // the balls' radius, the rings', and how far they are from the plane z = 0.
    Place size{};
    int feet = 0; // in a ring
    double mass = 1;
    Place at{};       // the centre
    double angle = 0; // about z
    Place velocity{};
    double spin = 0;                // about z
    std::optional<Place> moments{}; // principal ones of inertia; none: of a uniform density

    [[nodiscard]] Place inertia() const;
    // The centres, in the body's frame, of the balls of radius size[0] with which it touches a
    // plane; none: a box. A capsule touches one with its ends.
    [[nodiscard]] std::vector<Place> balls() const;
};

// In the frame of a body that is turned about z by that angle.
[[nodiscard]] Place turned(double angle, const Place& direction);
// From the body's centre, in its frame.
[[nodiscard]] Place inBody(const Body& body, const Place& place);

struct Joint {
    enum class Type { hinge, slider };
    Type type = Type::hinge;
    int body1 = 0, body2 = -1; // -1: the world
    Place at{};
    Place axis{0, 0, 1};
    // A hinge's angle q is that of body1 against body2 about the axis, 0 at the start.
    double couple = 0;             // of a motor, on body1 about the axis; body2 has the reaction
    std::optional<double> speed{}; // of a motor that holds q' with whatever couple that takes
    std::optional<double> least{}; // a stop, at which q' turns round by the case's restitution
    double stiffness = 0;          // a spring: -stiffness (q - rest)
    double rest = 0;
    double dryCouple = 0; // friction, of at most so much
};

// A plane through the origin that rises along +x by `slope`; a wall at the left has -pi/2.
struct Plane {
    std::string name;
    double slope = 0;
};

// All that not every engine has.
enum class Feature { boxOnBox, rebound, stop, heldSpeed, dryCouple };

struct Case {
    std::string name;
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    std::vector<Plane> planes;
    bool collide = true;
    double gravity = standardGravity, restitution = 0;
    double friction = 0, planeFriction = 0;  // of two bodies; of a body and a plane
    std::vector<double> times;               // of the samples; the last one ends the run
    std::vector<std::vector<Place>> right{}; // for each sample, the centres of all bodies

    [[nodiscard]] bool needs(Feature feature) const;
};

// Every case; `few` leaves out the long stacks and chains, and the many boxes.
[[nodiscard]] std::vector<Case> allCases(bool few);

// The largest distance, in m, of a centre from its right place; of what is not a number, that.
[[nodiscard]] double worstDistance(const Case& scene,
                                   const std::vector<std::vector<Place>>& places);

} // namespace bench::contacts
