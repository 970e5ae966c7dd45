// The ways of ropes through their points and around their wheels, as expressions with two rates.
//
// Between two points next to each other a rope has a span. With the centres a and b of both ends,
// d = b - a, the direction u of the span and left(u) = axis x u, a wheel of signed radius r touches
// the span at  centre - r left(u)  (r > 0: the centre lies to the left of the rope; r = 0: a
// point). So
//
//     d = l u + D left(u),   D = r_b - r_a,     l = sqrt(|d|^2 - D^2),   u = (l d - D left(d)) /
//     |d|^2.
//
// All of this is within the wheel's plane, as if a groove held the rope there, but for the length,
// which is that in space: sqrt(|d|^2 - D^2) of the whole d. So a span that is out of the plane
// pulls its ends back towards it.
//
// A wheel between two points lets the rope off where its wrapped angle falls to 0, and takes it
// again there. While it is off, the two stretches beside it are one with a straight span between
// the points, and the rope slides past the wheel: `slid` counts how much, so that what then lies on
// either side of the wheel is known when the rope touches it again.
// LIMIT: a wheel beside another wheel keeps its rope.
//
// Wrapped rope does not slip: with q the angle of u in the wheel's own frame, a span gains
// r_b dq_b - r_a dq_a of rope. What a span has less its length is its gap; its rate is
// - u . (velocities of the wheels' material where it touches them), as of a rod between them.
#pragma once

#include "physics/carried_points.h"
#include "physics/start_values.h"

namespace physics {

struct RopePoint : CarriedPoint {
    double radius = 0;             // signed; 0: no wheel
    Vector axis = Vector::UnitZ(); // of a wheel, along the body's axes
    // Angle of a wheel between two spans at the start; under 0 the rope is off it.
    double wrapped = 0;
    std::optional<Node> slid;    // of a wheel that may let the rope off: an unknown
    std::optional<Node> in, out; // angles of the spans before and behind, where they are wheels
};

struct RopeSpan {
    std::size_t from = 0, to = 0; // points
    // Of an end that is a wheel: the span's direction at the start and what is left of it, along
    // the axes of the body; and the angle of its direction, 0 at the start.
    struct End {
        Vector along = Vector::UnitX(), left = Vector::UnitY();
        Node angle;
    };
    std::array<End, 2> ends;
};

struct RopePath {
    std::vector<RopePoint> points;
    std::vector<RopeSpan> spans;
    // Spans between wheels or ends, as ranges of `spans`: [first, behind the last).
    std::vector<std::pair<std::size_t, std::size_t>> stretches;
    std::vector<std::size_t> moving; // bodies
    double size = 1;                 // what it measures at the start
};

class RopePaths {
public:
    // Of the scene's ropes, in their order. Points that lie off a wheel's plane or within it go to
    // faults.
    RopePaths(Graph& g, const scene::Scene& scene, const Scope& scope,
              std::span<const BodyMotion> bodies, std::vector<std::string>& faults);

    [[nodiscard]] const RopePath& operator[](std::size_t rope) const { return paths_[rope]; }
    [[nodiscard]] std::size_t size() const { return paths_.size(); }
    // The slack of a stretch, of which each has so much rope: negative where its ends are too
    // far apart. Behind a wheel that is off the stretch belongs to the one before it: 0.
    [[nodiscard]] Jet gap(std::size_t rope, std::size_t stretch, std::span<const double> material,
                          const Along& along);
    // Whether the rope is off the wheel before a stretch: 0 or 1.
    [[nodiscard]] Node isOffBefore(std::size_t rope, std::size_t stretch);
    // Nothing moves its ends.
    [[nodiscard]] bool isStill(std::size_t rope, std::size_t stretch);
    // The rate of what has slid past the wheel before a stretch, where it may; and what keeps that
    // with the places, as for angles.
    [[nodiscard]] Node slidRate(std::size_t rope, std::size_t stretch);
    [[nodiscard]] Jet slidTie(std::size_t rope, std::size_t stretch, double material,
                              const Along& along);
    [[nodiscard]] const std::optional<Node>& slidBefore(std::size_t rope,
                                                        std::size_t stretch) const;
    // The angle at an end of a span, which is an unknown.
    [[nodiscard]] Jet angle(std::size_t rope, std::size_t span, std::size_t end,
                            const Along& along);
    // 0 where that unknown agrees with the places; of first order, with the multiplier that is
    // added to the angle's rate.
    [[nodiscard]] Jet tie(std::size_t rope, std::size_t span, std::size_t end, const Along& along);
    void setTie(Node angle, Node multiplier) { ties_.emplace(angle.index, multiplier); }
    [[nodiscard]] Node length(std::size_t rope); // what it measures
    // At an end of a span that is a wheel of a body.
    [[nodiscard]] std::optional<RopeLean> lean(std::size_t rope, std::size_t span, std::size_t end);
    // About ropes that may not be as they are meant.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
    // Free lengths of a stretch at the start.
    [[nodiscard]] double startOf(std::size_t rope, std::size_t stretch);

private:
    struct Plane { // d and u of a span in the frame of a wheel at its end, and its length
        Jet x, y, length, ux, uy;
    };
    [[nodiscard]] RopePath pathOf(const scene::Rope& rope);
    void orient(const scene::Rope& rope, RopePath& path);
    void findFrames(const scene::Rope& rope, RopePath& path);
    void checkWheel(const scene::Rope& rope, const RopePath& path, std::size_t wheel,
                    std::size_t neighbour);
    void noteOtherSide(const scene::Rope& rope, const RopePath& path, std::size_t end);
    [[nodiscard]] bool isTooShort(const scene::Rope& rope, const RopePath& path);
    void divide(const scene::Rope& rope, RopePath& path) const;
    [[nodiscard]] Vector placeOf(const CarriedPoint& point);
    [[nodiscard]] Vector directionOf(const CarriedPoint& point, const Vector& v);
    [[nodiscard]] std::pair<double, Vector> startOf(const RopePath& path, const RopeSpan& span,
                                                    std::size_t end);
    [[nodiscard]] double offOf(const RopePath& path, const RopeSpan& span, std::size_t end);
    [[nodiscard]] Plane planeOf(const RopePath& path, const RopeSpan& span, std::size_t end,
                                const Along& along);
    [[nodiscard]] Jet lengthOf(const RopePath& path, const RopeSpan& span, const Along& along);
    [[nodiscard]] Jet straight(const RopePath& path, std::size_t from, std::size_t to,
                               const Along& along);
    [[nodiscard]] Node wrapOf(const RopePoint& wheel);
    [[nodiscard]] Jet ownGap(std::size_t rope, std::size_t stretch, double material,
                             const Along& along);
    [[nodiscard]] Jet slid(std::size_t rope, std::size_t stretch, const Along& along);
    [[nodiscard]] Jet joining(std::size_t rope, std::size_t stretch, const Along& along);
    [[nodiscard]] Jet wholeGap(std::size_t rope, std::size_t stretch,
                               std::span<const double> material, const Along& along);
    [[nodiscard]] Jet chosen(Node condition, const Jet& a, const Jet& b);

    Graph& g_;
    const Scope& scope_;
    std::span<const BodyMotion> bodies_;
    std::vector<std::string>& faults_;
    std::vector<std::string> notes_;
    StartValues start_;
    CarriedPoints points_;
    std::vector<RopePath> paths_;
    std::unordered_map<std::uint32_t, Node> ties_; // by the angle's symbol
};

} // namespace physics
