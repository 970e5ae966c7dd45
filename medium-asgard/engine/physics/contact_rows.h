// Contacts that last, as conditions with multipliers (expression/equations.h): bodies that rest,
// slide, roll and tip on each other.
//
// Of a contact between two parts each point has a gap g >= 0 between two pieces of surfaces, a
// function of the places of both bodies (surface_gap.h), with a normal force n >= 0. A wheel on its
// side has two, those of its rims; which points of its surface these are changes as it rolls. What
// the surfaces do along each other, where they touch now, has conditions of velocities, whose
// forces are friction:
//
//     point       two directions of the tangent plane            |f| <= mu N
//     line, patch the same, and turning in place                  |(f, c / reach)| <= mu N
//     round       turning about both, with rolling friction R     |c| <= R N
//
// N is the sum of n over the points, c a couple about the centre of these n, at which f acts; the
// rows are those at the middle of the patch, and levers lead from it to its points. `reach` is the
// mean distance of the patch from its centre, so that a patch that turns in place has the couple of
// a uniform pressure, mu N reach. LIMIT: between pure sliding and pure turning the bound is an
// ellipse.
//
// The rate of a gap is the speed, along the normal, at which the bodies part where they are
// nearest. Second rates follow by differentiation along the motion, as for joints; forces act on
// both bodies by the derivatives of the rates (Jacobian transposed). Coordinates that a trajectory
// holds take no part.
#pragma once

#include "physics/contact_readings.h"
#include "physics/equations_of_motion.h"
#include "physics/surface_gap.h"
#include "physics/surface_nearest.h"

#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace physics {

struct ContactPoint {
    SurfaceGap gap;
    double start = 0;   // the gap that it keeps
    bool parts = false; // where it was made
    // While it lasts the point stays on this side of planes and cones of either body, in whose
    // frame, from the centre of mass,
    //     inward . p + radial |q - axis (axis . q)| + offset >= 0      q = p - on
    // p is the place of the gap, moved by `shift` along the normal.
    struct Side {
        std::size_t body = 0;
        Vector inward = Vector::Zero();
        double offset = 0, shift = 0, radial = 0;
        Vector axis = Vector::UnitY(), on = Vector::Zero();
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
    // Of several points that stay on the body the middle, in its frame; else the points' own.
    std::optional<Vector> centre;
    Vector normal = Vector::UnitX(); // world, there
    double size = 1;                 // of the smaller part
    double leaving = 0;              // a gap that has opened so far is none
    double hop = 0;                  // hops lower than that are left out
    // Pieces that are on their side of the plane of the first point; one that comes through it
    // lands. One that is beneath, beside the other's face, may come up again, and over the face.
    struct Landing {
        std::size_t body = 0;
        SurfacePiece piece;
        bool isAbove = true; // of the body, else below, of the support
        bool isBeneath = false;
        double room = 0;
        std::optional<SurfaceGap> gap = {}; // that of the piece itself; none: over the plane
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
    // The force of a contact that was added on one of its bodies, which moves.
    [[nodiscard]] ContactForces forcesOf(const ContactPlace& place,
                                         std::span<const Node> multipliers, std::size_t on);
    // Of other multipliers whose conditions read these bodies' velocities: of joints.
    [[nodiscard]] std::vector<Equation> others(std::span<const std::size_t> bodies);

private:
    using Arms = std::array<NodeVector, 2>; // from the centres of the body and of the support
    struct Twist {                          // along the axes of a body's unknowns
        NodeVector linear, angular;
    };
    struct Rate {
        Node value;
        std::array<Twist, 2> by; // its derivatives by the velocities of the body and of the support
    };
    struct Row {
        Node owner, multiplier, rate;
        expression::Condition condition;
        std::vector<std::pair<std::size_t, Twist>> by; // of the bodies that move
    };
    struct Frame {                // of the surfaces that touch
        NodeVector point, normal; // the middle of the patch
        Arms arms;                // to it
        std::array<NodeVector, 2> along;
    };
    struct Meeting { // of two pieces
        Node gap;
        NodeVector normal, contact, place;
        Node steady;
        Arms arms; // to the contact
    };
    [[nodiscard]] surfaces::Triple<surfaces::Term> terms(const NodeVector& v);
    // Numbers of the contact that is written (node_vector.h).
    [[nodiscard]] Node numberOf(double value);
    [[nodiscard]] NodeVector numbersOf(const Vector& v);
    // One that shapes nothing even where it is 0.
    [[nodiscard]] Node amountOf(double value);
    [[nodiscard]] surfaces::Place<surfaces::Term> poseOf(std::size_t body);
    [[nodiscard]] Meeting meetingOf(const ContactPlace& place, const SurfaceGap& gap);
    [[nodiscard]] Frame frameOf(const ContactPlace& place);
    [[nodiscard]] Node sideOf(const ContactPoint::Side& side, const Meeting& meeting);
    [[nodiscard]] std::optional<Node> tiltOf(const ContactPlace& place, const SurfaceGap& gap,
                                             const Meeting& meeting);
    // Of the point at that arm from its centre, in the world.
    [[nodiscard]] NodeVector velocityAt(std::size_t body, const NodeVector& arm);
    // Of the surfaces along each other.
    [[nodiscard]] NodeVector slipOf(const ContactPlace& place, const Frame& frame);
    [[nodiscard]] std::vector<Node> landingsOf(const ContactPlace& place);
    [[nodiscard]] Rate openingOf(const ContactPlace& place, const SurfaceGap& gap,
                                 const Meeting& meeting);
    void addNormals(const ContactPlace& place, std::span<const Node> multipliers);
    void addFriction(const ContactPlace& place, const Frame& frame,
                     std::span<const Node> multipliers);
    // Of the friction of a patch whose rows are the last: what normal forces aside bring to each.
    void addLevers(const ContactPlace& place, const Frame& frame,
                   std::span<const Node> multipliers);
    void addRolling(const ContactPlace& place, const Frame& frame,
                    std::span<const Node> multipliers);
    [[nodiscard]] Rate rateAlong(const ContactPlace& place, const NodeVector& d,
                                 const NodeVector& velocity, const Arms& arms);
    [[nodiscard]] Rate rateAbout(const ContactPlace& place, const NodeVector& axis, Node length);
    void addRow(const ContactPlace& place, Node multiplier, std::optional<Node> gap,
                const Rate& rate, expression::Condition condition);
    [[nodiscard]] std::vector<Node> along(std::span<const Node> values);
    [[nodiscard]] bool isPushed(std::size_t unknown) const;
    void findParts();
    // A contact's force on a body by its derivatives: what it adds to rates, by unknown.
    void addPushes(expression::ConditionParts& parts, std::size_t body, const Twist& by);
    void addTurning(std::vector<Node>& moving, std::vector<Node>& rates);
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
    std::set<std::size_t> bodies_;                             // in contacts that were added
    std::vector<Row> rows_;
    Node owner_; // of the numbers of the contact that is written
    std::uint32_t amounts_ = 0;
};

} // namespace physics
