#include "events/outcome.h"

#include <algorithm>

namespace simulation {

void Outcome::jump(const physics::BodyMotion& motion, const BodyState& from, const BodyState& to,
                   solution::Event& event) {
    const auto first =
        motion.unknownsOf({from.position, from.velocity, from.attitude, from.angularVelocity});
    const auto then =
        motion.unknownsOf({to.position, to.velocity, to.attitude, to.angularVelocity});
    const bool turns = !std::equal(first.begin() + physics::qw, first.begin() + physics::w1,
                                   then.begin() + physics::qw);
    for (std::size_t k = 0; k < physics::bodyUnknowns; ++k)
        if (k >= physics::qw && k < physics::w1 ? turns : first[k] != then[k]) {
            jumps.push_back({motion.firstUnknown + k, then[k]});
            event.touched.push_back(motion.firstUnknown + k);
        }
}

} // namespace simulation
