// When are joints, gears and links gone that keep their bodies from colliding?
//
// A -release ends them: their multipliers are gone from then on, which the histories tell. Those of
// a joint that bears nothing sleep; then it is the expression's own value.
#pragma once

#include "physics/equations_of_motion.h"
#include "scene/connections.h"
#include "scene/scene.h"
#include "solution/dense/histories.h"

#include <optional>
#include <set>
#include <vector>

namespace simulation {

class Releases {
public:
    Releases(const scene::Scene& scene, const physics::EquationsOfMotion& equations, double start);

    // The first time up to `until` at which one is gone that was there.
    [[nodiscard]] std::optional<double> first(const solution::Histories& histories, double until);
    // All that are gone at that time; they are no longer looked for.
    [[nodiscard]] const scene::Released& take(const solution::Histories& histories, double time);
    // The motion is another from there on.
    void cut(double time);

private:
    using Kind = std::set<std::size_t> scene::Released::*;
    struct Element {
        Kind kind = nullptr;
        std::size_t index = 0;                // of the scene's elements of that kind
        std::vector<std::size_t> multipliers; // unknowns
        std::size_t release = 0;              // the same
        double looked = 0;                    // up to then its expression is 0
    };
    [[nodiscard]] std::optional<double> goneSince(const solution::Histories& histories,
                                                  Element& element, double until) const;
    double start_;
    std::vector<Element> kept_; // that may still be released
    scene::Released released_;
};

} // namespace simulation
