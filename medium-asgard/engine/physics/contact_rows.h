// Contacts that last, as conditions with multipliers (expression/equations.h): bodies that rest,
// slide, roll and tip on each other.
//
// Of a contact between two parts each point has a gap g >= 0, a function of the places of both
// bodies, with a normal force n >= 0. What the surfaces do along each other has conditions of
// velocities, whose forces are friction:
//
//     point       two directions of the tangent plane            |f| <= mu N
//     patch       the same at its centre, and turning in place    |(f, c / reach)| <= mu N
//     round       turning about both, with rolling friction R     |c| <= R N
//
// N is the sum of n over the points, c a couple. `reach` is the mean distance of the patch from its
// centre, so that a patch that turns in place has the couple of a uniform pressure, mu N reach.
// LIMIT: between pure sliding and pure turning the bound is an ellipse.
//
// Rates follow from gaps and velocities by differentiation along the motion, as for joints; forces
// act on both bodies by the derivatives of the rates (Jacobian transposed). Coordinates that a
// trajectory holds take no part.
#pragma once

#include "physics/resting.h"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace physics {

struct ContactPoint {
    GapConstraint gap;
    double start = 0;   // the gap that it keeps
    bool parts = false; // where it was made
    // While it lasts the point is on this side of planes of either body: inward . p + offset >= 0,
    // p from the centre of mass in that body's frame.
    struct Side {
        std::size_t body = 0;
        Vector inward = Vector::UnitX();
        double offset = 0;
    };
    std::vector<Side> sides;
};

struct ContactFriction {
    double sticking = 0, sliding = 0, rolling = 0;
    double reach = 0; // of a patch or a line; 0: a point
    // Of the surface along itself, in each body's frame.
    Vector bodySurface = Vector::Zero(), supportSurface = Vector::Zero();
};

struct ContactPlace {
    std::size_t body = 0, support = 0;
    std::vector<ContactPoint> points;
    ContactFriction friction;
    double bodyRadius = 0;           // of a sphere of the body, about the gap's point
    Vector centre = Vector::Zero();  // of several points the middle, in the body's frame
    Vector normal = Vector::UnitX(); // world, there
    double size = 1;                 // of the smaller part
    double leaving = 0;              // a gap that has opened so far is none
    // Vertices that are on their side of the plane of the first point; one that comes through it
    // lands.
    struct Landing {
        std::size_t body = 0;
        Vector vertex = Vector::Zero(); // from the centre of mass, body frame
        bool isAbove = true;            // of the body, else below, of the support
        double room = 0;
    };
    std::vector<Landing> landings;

    [[nodiscard]] bool hasFriction() const { return friction.sticking > 0; }
    [[nodiscard]] bool rolls() const { return friction.rolling > 0; }
    // Points, then directions of friction, then of rolling.
    [[nodiscard]] std::size_t rows() const {
        return points.size() + (hasFriction() ? friction.reach > 0 ? 3 : 2 : 0) + (rolls() ? 2 : 0);
    }
};

// The equations that contacts make, from an instant on.
class ContactRows {
public:
    // `set` is the one in force (its graph grows); `free` are the equations without contacts that
    // it came from.
    ContactRows(expression::EquationSet& set, const EquationsOfMotion& free, double time);

    // The rows' multipliers, by place: these symbols.
    void addContact(const ContactPlace& place, std::span<const Node> multipliers);

    struct Equation {
        std::size_t unknown = 0;
        expression::Phase phase;
        std::vector<expression::Phase> later;
    };
    // Of these bodies' velocities, with all contacts that were added.
    [[nodiscard]] std::vector<Equation> velocities(std::span<const std::size_t> bodies);
    // Of conditions, in the order of addContact(): after velocities().
    [[nodiscard]] std::vector<expression::Phase> conditions();
    // Of other multipliers whose conditions read these bodies' velocities: of joints.
    [[nodiscard]] std::vector<Equation> others(std::span<const std::size_t> bodies);

private:
    struct Push { // on one body, along the axes of its unknowns
        std::size_t body = 0;
        NodeVector linear, angular;
        Node multiplier;
    };
    struct Row {
        Node multiplier;
        std::optional<Node> gap;
        Node rate;
        expression::Condition condition;
    };
    struct Frame { // of the surfaces that touch
        NodeVector point, normal;
        std::array<NodeVector, 2> along;
    };
    [[nodiscard]] Node gapOf(const ContactPlace& place, const GapConstraint& gap);
    [[nodiscard]] NodeVector placeOf(const ContactPlace& place, const GapConstraint& gap);
    [[nodiscard]] NodeVector normalOf(const ContactPlace& place, const GapConstraint& gap);
    [[nodiscard]] NodeVector apartOf(const ContactPlace& place, const GapConstraint& gap);
    [[nodiscard]] NodeVector crossingOf(const ContactPlace& place, const GapConstraint& gap);
    [[nodiscard]] Frame frameOf(const ContactPlace& place);
    [[nodiscard]] NodeVector velocityAt(std::size_t body, const NodeVector& point,
                                        const Vector& surface);
    [[nodiscard]] std::vector<Node> landingsOf(const ContactPlace& place);
    void addNormals(const ContactPlace& place, std::span<const Node> multipliers);
    void addFriction(const ContactPlace& place, const Frame& frame,
                     std::span<const Node> multipliers);
    void addRolling(const ContactPlace& place, const Frame& frame,
                    std::span<const Node> multipliers);
    void addRow(const ContactPlace& place, Node multiplier, std::optional<Node> gap, Node rate,
                expression::Condition condition);
    [[nodiscard]] Node along(Node value);
    [[nodiscard]] Node rateOf(std::size_t unknown) const;
    [[nodiscard]] const BodySymbols& symbols(std::size_t body) const {
        return free_.bodies[body].symbols;
    }

    expression::EquationSet& set_;
    Graph& g_;
    const EquationsOfMotion& free_;
    double time_;
    std::unordered_map<std::uint32_t, std::size_t> unknownOf_; // by symbol
    std::map<std::size_t, Node> rates_;                        // by unknown: others than in force
    std::vector<Push> pushes_;
    std::vector<Row> rows_;
};

} // namespace physics
