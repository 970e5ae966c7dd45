// Which bodies read which, directly or through others? An event that touches a body cuts them, too.
#pragma once

#include "motion/body_motion.h"
#include "solution/event_source.h"

#include <set>
#include <vector>

namespace simulation {

class BodyReaders {
public:
    BodyReaders(const physics::EquationsOfMotion& equations, const std::vector<BodyRecord>& records,
                double start);

    [[nodiscard]] bool isRead(std::size_t body) const { return !readers_[body].empty(); }
    // The bodies that an event touches and all that read them, in order.
    [[nodiscard]] std::vector<std::size_t> cutBy(const solution::Event& event) const;

private:
    std::vector<std::set<std::size_t>> readers_; // by body: others
    std::vector<std::size_t> bodyOf_;            // by unknown
};

} // namespace simulation
