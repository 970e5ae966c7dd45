// The bodies to solve again after an edit: those that it changes, and those of their units.
#pragma once

#include "resimulation/kept_motion.h"
#include "scene/difference.h"

#include <vector>

namespace simulation {

class Edit {
public:
    Edit(const KnownMotion& known, const scene::Version& now);

    // False: something is wrong perhaps that no part of the scene would show.
    [[nodiscard]] bool isPossible() const { return possible_; }
    [[nodiscard]] bool solvesNothing() const { return !marked_ && changedFixed_.empty(); }
    [[nodiscard]] const scene::Difference& difference() const { return difference_; }
    [[nodiscard]] bool isAgain(std::size_t body) const { return again_[body]; }
    [[nodiscard]] bool isChangedFixed(std::size_t body) const;
    [[nodiscard]] bool isKept(std::size_t unit) const { return !isDropped_[unit]; }
    // All that is to be solved again, with all fixed bodies; in order.
    [[nodiscard]] std::vector<std::size_t> chosen() const;

    // The body, its group and its unit before are solved again.
    void mark(std::size_t body);
    // Kept bodies that come near those of the part, or near a fixed one that changed, too. False:
    // there are none. `bodies`: those of the part in the scene.
    [[nodiscard]] bool markWhoComesNear(const SolvedPart& part,
                                        const std::vector<std::size_t>& bodies);

private:
    void addFixed(std::size_t body);
    void drop(std::size_t unit, std::vector<std::size_t>& open);
    void dropUnits();
    [[nodiscard]] bool hasChanged(const Unit& unit) const;

    const KnownMotion& known_;
    const scene::Version& now_;
    const scene::Scene& scene_;
    scene::Difference difference_;
    scene::ByBody members_; // of groups
    std::vector<bool> again_, isDropped_;
    std::vector<std::size_t> changedFixed_;
    bool possible_ = true, marked_ = false;
};

} // namespace simulation
