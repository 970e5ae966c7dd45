// The computed motion of a scene: what every picture, chart and table reads.
//
// A Motion is immutable and shared: the simulation publishes a new one as it gets further, readers
// keep the one they have as long as they like, on any thread. Reading never computes motion.
#pragma once

#include "geometry/pose.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace simulation {

using geometry::Quaternion;
using geometry::Vector;

// State of one body at one time. World coordinates and axes.
struct BodyState {
    Vector position = Vector::Zero(); // of the centre of mass
    Vector velocity = Vector::Zero();
    Quaternion attitude = Quaternion::Identity(); // body to world
    Vector angularVelocity = Vector::Zero();

    // Of a point of the body that is here now.
    [[nodiscard]] Vector velocityAt(const Vector& point) const {
        return velocity + angularVelocity.cross(point - position);
    }
};

// Why a body's motion ended before the finish.
struct Stop {
    // The force or link to blame: the n-th of its kind that names the body, from 0. No place in the
    // text, which changes while the motion stays (report.h finds it).
    struct Culprit {
        std::string body;
        bool isLink = false;
        std::size_t nth = 0;
        std::string option; // "-x": whose expression it is; "": the whole element
        bool operator==(const Culprit&) const = default;
    };
    double time = 0;
    std::string sentence; // with the elements, the quantity and what to look at
    std::optional<Culprit> culprit = {};
};

// One impulse.
struct Impact {
    double time = 0;
    std::size_t first = 0, second = 0; // indices into Scene::bodies
    Vector point, normal;              // world; the normal points from second to first
    double impulse = 0;
    bool isEndOfHops =
        false; // all later hops of a bouncing that ends in rest, at the time of the last
};

class Motion {
public:
    virtual ~Motion() = default;

    [[nodiscard]] virtual double start() const = 0;
    [[nodiscard]] virtual double finish() const = 0;
    // All bodies that did not stop are known up to here; start() <= computed() <= finish().
    [[nodiscard]] virtual double computed() const = 0;
    // Computed with less than the accuracy asked, to be replaced: never exported.
    [[nodiscard]] virtual bool draft() const = 0;

    [[nodiscard]] virtual std::size_t bodies() const = 0;
    // The state at a time in start()..computed(), clamped into it; after an event at exactly that
    // time. Past a body's stop: its last state.
    [[nodiscard]] virtual BodyState at(std::size_t body, double time) const = 0;
    [[nodiscard]] virtual std::optional<Stop> stop(std::size_t body) const = 0;

    // From the shape's origin to the centre of mass, body frame: pose of the shape's frame is
    // position - attitude * centroid.
    [[nodiscard]] virtual Vector centroid(std::size_t body) const = 0;
    [[nodiscard]] virtual double mass(std::size_t body) const = 0; // infinity when fixed

    [[nodiscard]] virtual const std::vector<Impact>& impacts() const = 0; // in order of time
    // Times at which a body's position jumps (a trajectory takes hold elsewhere): trails break.
    [[nodiscard]] virtual std::vector<double> jumps(std::size_t body) const = 0;

    // The estimated largest position error over the size of the scene; none while computing.
    [[nodiscard]] virtual std::optional<double> errorEstimate() const = 0;
    // From this time on the motion is not predictable; none: predictable to the finish.
    [[nodiscard]] virtual std::optional<double> predictableUntil() const = 0;
    // Warnings that belong to the motion (two held bodies met, accuracy not reached, ...).
    [[nodiscard]] virtual const std::vector<std::string>& notes() const = 0;

    // Pose of the shape's own frame (its origin, not the centre of mass).
    [[nodiscard]] geometry::Pose shapePose(std::size_t body, double time) const {
        const BodyState state = at(body, time);
        return {state.position - state.attitude * centroid(body), state.attitude};
    }
};

// A motion whose estimate is over this is not predictable from predictableUntil() on; below, it is
// known, but not to the accuracy.
inline constexpr double unpredictable = 0.03;

using MotionPointer = std::shared_ptr<const Motion>;

} // namespace simulation
