// Which pairs of bodies may collide at all?
//
// Not those of one collision group, not those that a link or a joint joins until it is released,
// unless a contact of the pair says so; not those of which a contact says so, and not two fixed
// ones. Two that cannot give way where they meet let each other pass for a while.
#pragma once

#include "collision/broad_phase.h"
#include "scene/connections.h"
#include "scene/scene.h"

#include <map>
#include <optional>
#include <vector>

namespace simulation {

class MayMeet {
public:
    using Pair = collision::Pair;

    explicit MayMeet(const scene::Scene& scene);

    [[nodiscard]] bool operator()(std::size_t a, std::size_t b) const {
        if (a == b || (isFixed_[a] && isFixed_[b]))
            return false;
        return !isChoosy_[a] || !isChoosy_[b] || mayChoosyMeet(a, b);
    }
    // The bodies that these joints and links no longer keep from meeting each other.
    [[nodiscard]] std::vector<std::size_t> release(const scene::Scene& scene,
                                                   const scene::Released& released);
    void letPass(const Pair& pair, double until) { passing_.push_back({pair, until}); }
    [[nodiscard]] bool isPassing(const Pair& pair, double time) const;

private:
    [[nodiscard]] bool mayChoosyMeet(std::size_t a, std::size_t b) const;

    struct Passing {
        Pair pair;
        double until = 0;
    };
    std::vector<char> isFixed_;
    std::vector<char> isChoosy_; // by body: it has a group, joined bodies, or a contact that says
    std::vector<std::optional<std::size_t>> groups_;
    std::vector<std::vector<std::size_t>> joined_; // by body: that it never meets
    std::map<Pair, bool> said_;                    // by contacts
    std::vector<Passing> passing_;
};

} // namespace simulation
