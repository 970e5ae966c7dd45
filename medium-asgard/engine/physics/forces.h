// Forces and links as what they add to each body.
//
// Link (scene language, "Physics"): with d the first end less the second, and v its rate,
//     F = -k d - c v        on the first body at its point, and -F on the second at its own
//     c = 2 sqrt(k m)       critical damping, unless given; m is the mass of the first body, and
//                           between two bodies the reduced mass m1 m2 / (m1 + m2), a fixed one
//                           counting as infinite
// Spring: with l = |d| and L its length without a force,
//     F = -(k (l - L) + c l') d/l      on the first body, -F on the second; with -pull_only 0 while
//                                      l < L. At l = 0 there is no direction, and no force.
//
// From its -release on a force, link or spring is gone: it is multiplied by a multiplier whose
// condition is that it is 1 (joint_multipliers.h).
#pragma once

#include "physics/equations_of_motion.h"
#include "physics/joint_multipliers.h"
#include "physics/start_values.h"

namespace physics {

// Of the multiplier that a -release of a force or link ends: the link's name, or one of its place.
[[nodiscard]] std::string multiplierName(const scene::Force& force, std::size_t index);
[[nodiscard]] std::string multiplierName(const scene::Link& link, std::size_t index);

// Sentences about expressions that cannot be read go to `faults`.
class ForceReader {
public:
    // The quantities of springs go to the scope.
    ForceReader(Graph& g, const scene::Scene& scene, Scope& scope, JointMultipliers& multipliers,
                std::vector<std::string>& faults);

    void read(std::vector<Contribution>& contributions, std::vector<LinkNodes>& links);

private:
    struct End {
        NodeVector place;    // of the centre of mass, or the point itself
        NodeVector arm;      // from there to the point, world axes
        NodeVector velocity; // of the place
        NodeVector turning;  // velocity of the point relative to the place
    };

    [[nodiscard]] std::optional<std::size_t> bodyNamed(const std::string& name) const;
    [[nodiscard]] const ScopeTrajectory* trajectoryNamed(const std::string& name) const;
    NodeVector parsed(const std::array<scene::Expression, 3>& texts, const scene::Source& source,
                      const std::string& element, scene::Reading reading);

    void readForce(std::size_t index, std::vector<Contribution>& contributions);
    NodeVector forceVector(const scene::Force& force, double mass, bool& isInBodyAxes);
    // A link's or a spring's law: what it adds to its first body, and the energy that it holds.
    struct Law {
        NodeVector force;
        Node energy;
        SpringNodes spring; // of a spring
    };
    void nameSprings();
    [[nodiscard]] LinkNodes geometryOf(const scene::Link& link, const End& a, const End& b) const;
    [[nodiscard]] Law lawOf(const scene::Link& link, const LinkNodes& nodes);
    [[nodiscard]] Law springLaw(const scene::Link& link, const LinkNodes& nodes);
    [[nodiscard]] double restOf(const scene::Link& link, Node length);
    void readLink(std::size_t index, std::vector<Contribution>& contributions,
                  std::vector<LinkNodes>& links);
    // 1, and 0 from its release on, of an element that acts on these bodies.
    [[nodiscard]] Node strengthOf(const std::optional<scene::Expression>& release, const char* kind,
                                  const std::string& name, std::span<const std::size_t> bodies);
    End bodyEnd(const scene::BodyEnd& end, std::size_t body);
    End secondEnd(const scene::Link& link);
    void findPositionRates();
    [[nodiscard]] NodeVector rateOfPoint(const NodeVector& point);
    [[nodiscard]] double dampingOf(const scene::Link& link) const;
    // A force in world axes at `arm` (body frame) from the centre of mass.
    [[nodiscard]] Contribution at(std::size_t body, const Vector& arm, const NodeVector& force);

    Graph& g_;
    const scene::Scene& scene_;
    Scope& scope_;
    JointMultipliers& multipliers_;
    std::optional<StartValues> start_;
    std::vector<std::string>& faults_;
    std::unordered_map<std::string, std::size_t> bodies_, trajectories_; // by name
    std::unordered_map<std::uint32_t, Node> positionRates_; // of each symbol of a place or attitude
};

} // namespace physics
