// The scenes of contact and joints that every engine plays, each with its exact motion.
//
// All move in the plane z = 0 under gravity 9.81 along -y, in SI units; bodies have their extent
// along z, too. The floor is a plane through the origin that rises along +x by `slope`. Friction
// and restitution are those of every pair. Bodies that a joint connects never collide.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace bench::contacts {

using Place = std::array<double, 3>;

inline constexpr double standardGravity = 9.81;

struct Body {
    enum class Shape { box, ball, feet };
    std::string name;
    Shape shape = Shape::box;
    // Edges of a box; a ball has its radius first. `feet` are two rings of balls, without what
    // joins them: the balls' radius, the rings', and how far they are from the plane z = 0.
    Place size{};
    int feet = 0; // in a ring
    double mass = 1;
    Place at{};       // the centre
    double angle = 0; // about z
    Place velocity{};
    double spin = 0; // about z

    [[nodiscard]] Place inertia() const; // principal, of a uniform density
    // The centres, in the body's frame, of the balls of radius size[0] that it is; none: a box.
    [[nodiscard]] std::vector<Place> balls() const;
};

struct Joint {
    enum class Type { hinge, slider }; // about z, along x
    Type type = Type::hinge;
    int body1 = 0, body2 = -1; // -1: the world
    Place at{};
    double couple = 0; // of a motor, on body1 about z; body2 has the reaction
};

struct Case {
    std::string name;
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    bool floor = false, collide = true;
    double slope = 0, gravity = standardGravity, friction = 0, restitution = 0;
    std::vector<double> times;             // of the samples; the last one ends the run
    std::vector<std::vector<Place>> right; // for each sample, the centres of all bodies
};

// Every case; `few` leaves out the long stacks and chains, and the many boxes.
[[nodiscard]] std::vector<Case> allCases(bool few);

// The largest distance, in m, of a centre from its right place; of what is not a number, that.
[[nodiscard]] double worstDistance(const Case& scene,
                                   const std::vector<std::vector<Place>>& places);

} // namespace bench::contacts
