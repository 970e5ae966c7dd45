// A body that a hand pulls, with all that joints, gears and ropes connect with it
// (physics/pulling.h): where they stand then, and the wishes that say so in the text.
#pragma once

#include "editing/value_edit.h"
#include "element_edits/closing.h"
#include "physics/pulling.h"

#include <functional>
#include <memory>

namespace gestures {

class Joined {
public:
    // `grabbed`: the point of the world that the hand takes. Null: nothing holds the body, or what
    // holds it is open.
    [[nodiscard]] static std::unique_ptr<Joined> of(const scene::Scene& scene, std::size_t body,
                                                    const geometry::Vector& grabbed);

    // No joint of them leads to what stands, or none lets the point go anywhere: all move along.
    [[nodiscard]] bool movesAsOne() const { return pulling_.movesAsOne(); }
    [[nodiscard]] bool isLoose() const { return pulling_.isLoose(); } // no joint leads there
    [[nodiscard]] bool areTooMany() const {
        return pulling_.state() == physics::Pulling::State::tooMany;
    }
    // A sentence; "": nothing forbids it.
    [[nodiscard]] std::string whyNotPulled() const;
    [[nodiscard]] std::string whyNotThrown() const;
    [[nodiscard]] bool turns() const { return pulling_.turns(); } // where the point goes on
    [[nodiscard]] const std::vector<std::size_t>& bodies() const { return pulling_.bodies(); }

    [[nodiscard]] const geometry::Vector& grabbed() const { return grabbed_; }
    // The point so far from where it was grabbed, as near as joints let it.
    void pull(const geometry::Vector& way);
    // A pull goes only as far as this is so.
    // LIMIT: where one joint is at its limit, others that could go on stay, too.
    void keep(std::function<bool(const Joined&)> isRight) { isRight_ = std::move(isRight); }
    // All by the same way, with what holds them to the world.
    void moveAll(const geometry::Vector& way);
    // Other bodies go the same way: what holds them to these stays as it is.
    void moveWith(std::vector<std::size_t> others) { others_ = std::move(others); }
    [[nodiscard]] double turned() const { return pulling_.turned(); } // radians, of the body
    bool turnTo(double angle) { return pulling_.turnTo(angle); }
    // False: its joints do not let it turn so; it stays.
    bool turnAbout(const geometry::Vector& axis, double angle) {
        way_.reset();
        return pulling_.turnAbout(axis, angle);
    }
    [[nodiscard]] std::string whyNotTurned(char axis) const; // where its joints do not let it

    // Of those that have moved. Their velocities at the start go with them.
    [[nodiscard]] std::vector<editing::NewPlace> places();
    // `ofHand`: the velocity that the point has where it is let go; none: it has its own.
    [[nodiscard]] std::vector<editing::NewPlace>
    thrown(const std::optional<geometry::Vector>& ofHand);
    [[nodiscard]] geometry::Pose poseOf(std::size_t body) const; // of its reference point
    [[nodiscard]] std::vector<editing::Wish> wishes(const editing::Mapper& mapper);

private:
    Joined(const scene::Scene& scene, std::size_t body, const geometry::Vector& grabbed);
    [[nodiscard]] std::vector<physics::Pulling::Velocity> writtenVelocities() const;
    [[nodiscard]] const std::string& name() const { return scene_.bodies[body_].name; }
    [[nodiscard]] std::string holderOf() const;
    [[nodiscard]] std::string together() const;
    [[nodiscard]] bool moves(const std::string& body) const;
    // A point of the world or of a body that stays, as far on as all that move.
    [[nodiscard]] editing::Wish holdOf(const editing::Element& element, const char* option,
                                       const std::optional<std::string>& body,
                                       const geometry::Vector& now) const;
    void addHolds(std::vector<editing::Wish>& wishes) const;
    void addRopeHolds(std::vector<editing::Wish>& wishes) const;

    const scene::Scene scene_;
    std::size_t body_;
    geometry::Vector grabbed_;
    physics::Pulling pulling_;
    std::optional<geometry::Vector> way_;        // of all of them
    std::vector<std::size_t> others_;            // that go the same way
    std::function<bool(const Joined&)> isRight_; // null: always
    geometry::Vector rightWay_ = geometry::Vector::Zero();
};

} // namespace gestures
