// Motion that is kept for the next version of a scene: parts that were solved together, and within
// them units, which are what can be kept or solved again apart from the rest.
#pragma once

#include "accuracy/solve.h"
#include "motion/computed_motion.h"
#include "resimulation/kept_runs.h"
#include "run/budget.h"
#include "scene/difference.h"

#include <memory>
#include <vector>

namespace simulation {

// The means to solve a part further: its problem, whose finish is that of the last search, and the
// runs over it.
struct Reserve {
    explicit Reserve(std::shared_ptr<Problem> posed)
        : problem(std::move(posed)), runs(2 * mostBytes()) {}
    // Too large to be kept: solving again costs less than what this would hold for ever.
    [[nodiscard]] bool isTooLarge() const { return runs.areForgotten(); }
    std::shared_ptr<Problem> problem;
    KeptRuns runs;
};

// One solution of some bodies, the fixed ones around them among these.
struct SolvedPart {
    SolvedPart(const Problem& problem, const Solved& solved);

    ComputedMotion::Part motion;
    std::vector<std::size_t> owners;  // by unknown: its body
    std::vector<MovingBody> bodies;   // of the motion; for one thread
    std::vector<double> until;        // by body: from then on it stands, or the motion is over
    std::vector<geometry::Box> reach; // by body: holds its shape at all times
    std::size_t keptBytes = 0;        // the most that a run over it kept
    bool isFull = false;              // one had to end for it
    std::shared_ptr<Reserve> reserve; // none: it was too large to keep
};
using PartPointer = std::shared_ptr<const SolvedPart>;

// Moving bodies that read each other or came near each other in any of the runs, directly or
// through others that move: their motion is a function of these bodies alone, and of the fixed ones
// near them.
struct Unit {
    PartPointer part;
    std::vector<std::size_t> places; // of its bodies and of the fixed ones near them, in the part
    std::vector<std::size_t> bodies; // the same ones in the scene, in the same order
    std::vector<bool> isFixed;
    std::vector<Impact> impacts; // with indices of the part
    std::vector<std::pair<std::size_t, Stop>> stops;
    std::vector<std::string> notes;
    std::optional<BodyError> error;
    std::size_t components = 0, largestComponent = 0;

    [[nodiscard]] std::size_t bodyAt(std::size_t place) const;
};

using UnitPointer = std::shared_ptr<const Unit>;

// Where a body's motion is.
struct Home {
    PartPointer part;
    std::size_t place = 0;
};

// A part with the places of its bodies in the scene; noElement: such a body is not there any more,
// or it moves otherwise now.
struct PlacedPart {
    PartPointer part;
    std::vector<std::size_t> bodies;
};

// A version of a scene whose motion is known.
struct KnownMotion {
    std::shared_ptr<const scene::Version> version;
    bool isEstimated = true; // by this method errors are
    std::vector<UnitPointer> units;
    std::vector<std::size_t> unitOf; // by body; noElement: fixed
    std::vector<Home> homes;         // by body
    std::vector<PlacedPart> parts;   // that units are of

    // Fills unitOf.
    void index();
    // From scratch, the kept motion may need more than `most`: then where all of it ends is nothing
    // that parts tell.
    [[nodiscard]] bool mayBeFull(std::size_t most) const;
};

// `bodies`: those of the part in the scene, as in PlacedPart; group: of the scene's bodies
// (connections.h).
[[nodiscard]] std::vector<UnitPointer> unitsOf(const PartPointer& part, const Solved& solved,
                                               const std::vector<std::size_t>& bodies,
                                               const std::vector<std::size_t>& group);

// By their collision groups.
[[nodiscard]] bool mayMeet(const scene::Scene& scene, std::size_t a, std::size_t b);

// Do these come so near each other that they cannot be solved apart?
[[nodiscard]] bool meet(const SolvedPart& one, std::size_t first, const SolvedPart& other,
                        std::size_t second);

} // namespace simulation
