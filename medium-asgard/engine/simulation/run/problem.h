// A scene, posed for the solver: everything that does not depend on tolerances.
#pragma once

#include "equations/prepared_equations.h"
#include "motion/computed_motion.h"
#include "physics/equations_of_motion.h"
#include "run/options.h"
#include "solution/solver.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace simulation {

// A scene with everything that does not depend on tolerances worked out.
struct Problem {
    scene::Scene scene; // with the options' parameters, accuracy and finish
    physics::EquationsOfMotion equations;
    std::vector<geometry::Shape> shapes; // by body
    std::shared_ptr<const std::vector<BodyRecord>> bodies;
    Options options;
    // Of `equations`, which stay with the problem: what all runs share.
    std::shared_ptr<const solution::PreparedEquations> prepared;
    // By body: the least of those that read each other, directly or through others.
    std::vector<std::size_t> readers;
    // Unknowns that are read of the motion or by collisions; none: all.
    std::optional<std::vector<std::size_t>> asked;

    [[nodiscard]] double start() const { return scene.simulator.start; }
    [[nodiscard]] double finish() const { return scene.simulator.finish; }
    [[nodiscard]] double accuracy() const { return scene.simulator.accuracy; }
    [[nodiscard]] bool collides() const;
};

// Or the sentences that say why nothing can be computed; none at all: it was cancelled.
[[nodiscard]] std::variant<std::shared_ptr<Problem>, std::vector<std::string>>
problemOf(const scene::Scene& scene, const Options& options, const Observer& observer = {});

// The relative error that one step may have in the first run of a search for this accuracy.
[[nodiscard]] double firstTolerance(double accuracy);

// By unknown: its body.
[[nodiscard]] std::vector<std::size_t> ownersOf(const Problem& problem);

// tolerances: of one step, relative, by body.
[[nodiscard]] solution::Options solverOptions(const Problem& problem,
                                              const std::vector<double>& tolerances);

} // namespace simulation
