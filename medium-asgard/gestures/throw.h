// A body in the hand while the motion is past its start: the moment becomes the start, with the
// body where it is let go. Thrown, it has the velocity of the hand; else it is put there and keeps
// its own. What joints hold goes and moves as they let it, with what is joined to it. One step of
// undo brings the motion back as it was.
//
// A graphical viewer and a document's picture throw with this. Time stands still meanwhile: that is
// theirs to see to.
#pragma once

#include "gestures/ground.h"
#include "gestures/joined.h"
#include "gestures/picking.h"
#include "gestures/present.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gestures {

// The joined bodies as they stand at that moment, held under the pointer; null: nothing holds it.
[[nodiscard]] std::unique_ptr<Joined> joinedAt(const Ground& ground, double moment,
                                               std::size_t body, const Sight& sight,
                                               const Eigen::Vector2d& pixels);
// Why what the text says lets no hand take the body out of its way at that moment; "": it may, as
// far as joints let it (Joined::whyNotThrown()). None: a drag does not mean that; it is the start,
// or the body stands.
[[nodiscard]] std::optional<std::string> whyNotTaken(const Ground& ground, double time,
                                                     std::size_t body);

class Throw {
public:
    using Poses = std::vector<std::pair<std::size_t, geometry::Pose>>;
    // `company`: others that go by the same way, with this one, and where they are.
    Throw(Ground ground, double moment, std::size_t body, const Sight& sight,
          const Eigen::Vector2d& pixels, Poses company = {});

    // `seconds`: of the hand's clock.
    void move(const Sight& sight, const Eigen::Vector2d& pixels, double seconds);
    [[nodiscard]] bool moved() const { return !way_.empty(); }
    // The change of the text. `rate`: seconds of the motion for each of the hand, whose velocity at
    // that second it gets; none: it is put where it is.
    [[nodiscard]] editing::Answer answer(const Sight& sight, std::optional<double> rate,
                                         double seconds);
    [[nodiscard]] const Ground& ground() const { return ground_; }
    [[nodiscard]] double moment() const { return moment_; }
    [[nodiscard]] std::string name() const; // "b1", "b1 and 2 more"
    // The poses of the bodies in the hand, and the body's own way there.
    [[nodiscard]] Poses poses() const;
    [[nodiscard]] std::pair<geometry::Vector, geometry::Vector> way() const;

private:
    struct Place {
        double seconds;
        geometry::Vector place;
    };
    [[nodiscard]] geometry::Vector velocity(double rate, double seconds) const;
    [[nodiscard]] std::vector<Put> allPut(double resolution,
                                          const std::optional<geometry::Vector>& velocity);

    Ground ground_;
    double moment_;
    std::size_t body_;
    geometry::Pose pose_;  // when it was taken
    geometry::Vector off_; // from the place under the pointer to the body's
    std::vector<Place> way_;
    std::unique_ptr<Joined> joined_; // null: nothing holds it
    Poses company_;
};

} // namespace gestures
