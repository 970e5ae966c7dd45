// Bodies that are dragged together, by one way: with all that joints, gears and ropes connect with
// them, and with what holds these to the world (joined.h).
#pragma once

#include "gestures/joined.h"

#include <memory>
#include <string>
#include <vector>

namespace gestures {

class Company {
public:
    Company(const scene::Scene& scene, const std::vector<std::size_t>& bodies);

    [[nodiscard]] const std::vector<std::size_t>& bodies() const { return bodies_; }
    void moveAll(const geometry::Vector& way);
    [[nodiscard]] std::vector<editing::Wish> wishes(const editing::Mapper& mapper) const;

private:
    std::vector<geometry::Pose> poses_;           // at first, of those that nothing holds
    std::vector<std::size_t> bodies_, alone_;     // all of them, and those
    std::vector<std::unique_ptr<Joined>> joined_; // each with others
    geometry::Vector way_ = geometry::Vector::Zero();
};

} // namespace gestures
