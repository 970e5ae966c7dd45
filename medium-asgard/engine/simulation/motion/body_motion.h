// One body's solved motion, in the two forms that its readers need: its state at a time, and the
// polynomial pieces that collision searches.
#pragma once

#include "collision/moving_shape.h"
#include "dense/histories.h"
#include "motion/motion.h"
#include "physics/equations_of_motion.h"

#include <optional>

namespace simulation {

// The facts of a body that readers of motion need; independent of how it moves.
struct BodyRecord {
    bool isFixed = false;
    bool isSpinInWorldAxes = true;
    geometry::Pose start; // centre of mass; of a fixed body at all times
    std::size_t firstUnknown = 0;
    double mass = 0;               // infinity when fixed
    double radius = 0;             // of the shape about the centre of mass
    std::vector<Vector> arms = {}; // to points of joints outside that, body frame
    Vector centroid = Vector::Zero();
    // Unknowns that tell of it beyond its thirteen: angles and multipliers of joints.
    std::vector<std::size_t> more = {};
};

[[nodiscard]] std::vector<BodyRecord> recordsOf(const physics::EquationsOfMotion& equations);

enum class Side { after, before }; // which value counts at an event's own time

[[nodiscard]] BodyState stateOf(const BodyRecord& body, const solution::Histories& histories,
                                double time, Side side = Side::after);
// Of the values of its thirteen unknowns.
[[nodiscard]] BodyState stateOf(const BodyRecord& body, std::span<const double> values);
// The least time up to which an unknown of the body is known; infinity when fixed.
[[nodiscard]] double knownUntil(const BodyRecord& body, const solution::Histories& histories);

// When the first of so many unknowns of the body ended; none: all go on.
[[nodiscard]] std::optional<double> endOf(const BodyRecord& body,
                                          const solution::Histories& histories,
                                          std::size_t unknowns = physics::bodyUnknowns);

// Linear acceleration of the centre of mass and angular acceleration, world axes.
struct Acceleration {
    Vector linear = Vector::Zero(), angular = Vector::Zero();
};
[[nodiscard]] Acceleration accelerationOf(const BodyRecord& body,
                                          const solution::Histories& histories, double time);

class MovingBody final : public collision::MovingShape {
public:
    MovingBody(const BodyRecord& record, geometry::Shape shape)
        : record_(record), shape_(std::move(shape)),
          isBall_(shape_.parts.size() == 1 && shape_.parts[0].isSphere() &&
                  shape_.parts[0].center() == record_.centroid) {}

    // The histories that pieceAt() reads; they must outlive its calls. Forgets pieces read before.
    void read(const solution::Histories& histories);
    // Its motion has ended: from here on it stands like a fixed body, its centre of mass here.
    void standAt(const geometry::Pose& centre);
    // The values read: the motion was cut.
    void forget() const { piece_.reset(); }

    [[nodiscard]] const geometry::Shape& shape() const override { return shape_; }
    [[nodiscard]] Vector pivot() const override { return record_.centroid; }
    // One sphere about the centre of mass: its pieces do not turn, and end where those of its place
    // do, however far its attitude is known.
    [[nodiscard]] bool isBall() const { return isBall_; }
    [[nodiscard]] const collision::MotionPiece& pieceAt(double t) const override;

private:
    [[nodiscard]] collision::MotionPiece solvedPiece(double t) const;

    BodyRecord record_;
    geometry::Shape shape_;
    bool isBall_;
    const solution::Histories* histories_ = nullptr;
    mutable std::optional<collision::MotionPiece> piece_;
    mutable bool isContinued_ = false; // beyond its end, where more may be known soon
};

} // namespace simulation
