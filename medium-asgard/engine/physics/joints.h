// Joints and gears as conditions on places and velocities, which multipliers keep
// (expression/equations.h).
//
// A condition g(q, t) = 0 with the rate  g' = J v + ...  pushes the bodies by J' m, so that it does
// no work; m is a force (conditions on angles are lengths: the angle times the joint's size). With
// d the first point less the second, n the axis and e, f two directions across it, each carried by
// the body (1 or 2) that its index says:
//
//     fixed         d,  n1.e2,  n1.f2,  e1.f2          planar     n1.e2,  n1.f2,  n2.d
//     hinge         d,  n1.e2,  n1.f2                  ball       d
//     slider        e2.d,  f2.d,  n1.e2,  n1.f2, e1.f2 universal  d,  n1.a2   (a2: -axis2)
//     cylindrical   e2.d,  f2.d,  n1.e2,  n1.f2        distance   |d| - its value at the start
//     screw         as cylindrical, and  n2.d - P q / 2 pi
//
// Angles that are not wrapped are unknowns of their own, q' = n2.(w1 - w2). Where a condition reads
// one, the angle itself is kept: s cos q - c sin q = 0, with c = e1.e2 and s = e1.f2.
//
// Stops, brakes and motors of limited force are multipliers with bounds.
//
// Contract: docs/scene-language.md, "Joints".
#pragma once

#include "physics/equations_of_motion.h"
#include "physics/jets.h"

#include <functional>
#include <limits>
#include <unordered_map>

namespace physics {

class JointReader {
public:
    // Names of joints mean something in the scope from here on.
    JointReader(Graph& g, const scene::Scene& scene, Scope& scope,
                std::span<const BodyMotion> bodies, std::vector<std::string>& faults);

    // What joints add to bodies: multipliers, motors, springs.
    void contribute(std::vector<Contribution>& contributions);
    // The unknowns of joints, behind those of the bodies. Joints that the bodies miss go to faults;
    // velocities at the start that joints do not allow, to notes. Answers with the conditions that
    // joints put on velocities.
    [[nodiscard]] std::vector<JointRow> addUnknowns(expression::EquationSet& set,
                                                    std::vector<std::size_t>& owners,
                                                    std::vector<std::string>& notes);

private:
    struct End {
        std::optional<std::size_t> body; // none: the world
        Vector arm = Vector::Zero();     // from the centre of mass, along the body's axes
        Vector axis = Vector::UnitZ(), across = Vector::UnitX(), third = Vector::UnitY();
    };
    struct Frame {
        std::array<End, 2> ends;
        double size = 1;           // of the joint: an angle times it is a length
        std::vector<double> start; // what its coordinates that are lengths were
        std::vector<Node> angles;  // symbols, by coordinate
    };
    // The equations along which rates are taken, and when; none: with accelerations of 0.
    struct Along {
        const expression::EquationSet* set = nullptr;
        double time = 0;
    };
    struct Condition {
        Jet jet;
        // value: the rate is the multiplier less what it is to be.
        enum class Order { first, second, velocity, value } order = Order::second;
    };
    struct Bounds { // of a multiplier; of a stop, restitution
        double low = -std::numeric_limits<double>::infinity();
        double high = std::numeric_limits<double>::infinity();
        double restitution = 0;
    };
    // A condition with its multiplier; it is made again for each phase.
    struct Kept {
        Node multiplier;
        std::string element; // "pin"
        int line = 0;
        std::size_t owner = 0; // a moving body
        std::vector<std::size_t> bodies;
        std::function<Condition(const Along&)> make;
        Bounds bounds = {};
        std::optional<Node> release = {};
        std::vector<std::size_t> trajectories = {}; // that it reads
    };
    struct Angle {
        Node symbol, rate;
        double size = 1;
        std::size_t owner = 0;
        std::optional<Node> tie; // multiplier that keeps it with the attitudes
    };

    [[nodiscard]] std::optional<std::size_t> bodyNamed(const std::string& name) const;
    [[nodiscard]] Frame frameOf(const scene::Joint& joint);
    void findAxes(const scene::Joint& joint, Frame& frame) const;
    [[nodiscard]] double sizeOf(const Frame& frame) const;
    [[nodiscard]] const BodySymbols& bodyOf(const End& end) const;
    [[nodiscard]] geometry::Pose poseOf(const End& end) const;

    [[nodiscard]] BodyRates ratesOf(const End& end, const Along& along) const;
    [[nodiscard]] JetVector carried(const End& end, const Vector& v, const Along& along);
    [[nodiscard]] JetVector apart(const Frame& frame, const Along& along); // d
    [[nodiscard]] JetVector turning(const Frame& frame, const Along& along);
    [[nodiscard]] std::vector<Jet> conditionsOf(std::size_t joint, const Along& along);
    [[nodiscard]] Jet coordinateOf(std::size_t joint, std::size_t coordinate, const Along& along);
    [[nodiscard]] Jet angleOf(const Frame& frame, std::size_t coordinate, const JetVector& axis,
                              const Along& along);
    [[nodiscard]] Jet ballAngle(const Frame& frame, const Along& along);
    [[nodiscard]] Condition tieOf(std::size_t joint, std::size_t coordinate, const Along& along);

    void nameJoint(std::size_t joint);
    void addForce(std::size_t joint, std::span<const Contribution> contributions);
    void drive(std::size_t joint, std::size_t coordinate, std::vector<Contribution>& contributions);
    // Names the unknown that releases what is added from now on; nothing: nothing does.
    void releaseBy(const std::optional<scene::Expression>& text, const scene::Source& source,
                   const std::string& element, std::size_t owner);
    void readReleases();
    // The force itself, or where it may be released a multiplier that is it.
    [[nodiscard]] Node releasable(Node force, const scene::Source& source,
                                  const std::string& element,
                                  const std::vector<std::size_t>& moving);
    void limit(std::size_t joint, std::size_t coordinate, std::vector<Contribution>& contributions);
    void brake(std::size_t joint, std::size_t coordinate, std::vector<Contribution>& contributions);
    void keepGear(std::size_t gear, std::vector<Contribution>& contributions);
    void tie(std::size_t joint, std::size_t coordinate);
    void addKept(const scene::Source& source, const std::string& element,
                 std::vector<std::size_t> bodies, std::function<Condition(const Along&)> make);
    // J of a condition whose multiplier was added last.
    void keepRow(Node rate, std::span<const std::size_t> bodies);
    // J' force, with J of this rate.
    void push(Node rate, Node force, const Contribution& from, std::span<const std::size_t> bodies,
              std::vector<Contribution>& contributions);
    [[nodiscard]] std::vector<std::size_t> movingOf(const Frame& frame) const;
    [[nodiscard]] std::optional<Node> parsed(const scene::Expression& text,
                                             const scene::Source& source, const std::string& what,
                                             scene::Reading reading);
    [[nodiscard]] Node rateOf(Node node, const Along& along);
    void addUnknown(expression::EquationSet& set, const Angle& angle) const;
    void addUnknown(expression::EquationSet& set, const Kept& kept);
    void checkStart(const expression::EquationSet& set, std::size_t first,
                    std::vector<std::string>& notes);
    [[nodiscard]] std::pair<double, double> extents() const;

    Graph& g_;
    const scene::Scene& scene_;
    Scope& scope_;
    std::span<const BodyMotion> bodies_;
    std::vector<std::string>& faults_;
    BodySymbols world_;
    std::vector<Frame> frames_;     // by joint
    std::vector<JointNodes> nodes_; // by joint
    std::vector<JointRow> rows_;
    std::vector<Kept> kept_;
    std::vector<Angle> angles_;
    struct Release { // a given unknown
        Node symbol;
        scene::Expression text;
        int line = 0;
        std::string element;
        Node value;
        std::size_t owner = 0;
    };
    std::vector<Release> releases_;
    std::optional<Node> release_; // of the element whose conditions are added now
    std::unordered_map<std::uint32_t, std::size_t> unknownOf_; // by symbol
};

} // namespace physics
