// Who is near whom? Boxes in a tree, balls in flight in cells, and the partners of each.
//
// A box holds a body during its window; balls in flight are not in the tree but in cells, with a
// window that is the way through a cell. A body whose box overlaps another's is its partner. A ball
// in a cell has partners in the tree only; whoever is in the tree has them everywhere.
#pragma once

#include "collision/ball_cells.h"
#include "collision/box_tree.h"
#include "meetings/may_meet.h"
#include "motion/body_motion.h"

#include <algorithm>
#include <vector>

namespace simulation {

inline constexpr double boxRounding = 1e-12; // of coordinates

class Neighbourhood {
public:
    // The records must outlive it. Boxes hold what comes as near as `slack` of the body's radius.
    Neighbourhood(const scene::Scene& scene, const std::vector<BodyRecord>& records, double slack)
        : mayMeet(scene), tree(records.size()), cells(records.size()), records_(records),
          slack_(slack), partners_(records.size()), ended_(records.size(), false) {}

    MayMeet mayMeet;
    collision::BoxTree tree;
    collision::BallCells cells;

    // With room for what is as near as the slack.
    [[nodiscard]] double slackOf(std::size_t body) const { return slack_ * records_[body].radius; }
    // The box in the tree may be larger than the body's, so that short windows seldom change it.
    // False: it still holds the body.
    [[nodiscard]] bool enterTree(std::size_t body, const geometry::Box& box, bool isFlight);
    // The part of the tree that concerns a ball in a cell.
    [[nodiscard]] geometry::Box leafOfBlock(std::size_t body) const;
    // Where the tree has the body, or its block: its partners anew. `boxed` is told of balls in
    // cells that had no partner before.
    template <typename Boxed>
    void findPartners(std::size_t body, const geometry::Box& leaf, Boxed&& boxed) {
        for (const std::size_t other : partners_[body])
            if (!records_[other].isFixed)
                std::erase(partners_[other], body);
        found_.clear();
        tree.overlapping(leaf, found_);
        if (!cells.contains(body))
            cells.forEachIn(leaf, [&](std::size_t ball) {
                if (!leafOfBlock(ball).intersects(leaf))
                    return;
                found_.push_back(ball);
                if (partners_[ball].empty())
                    boxed(ball);
            });
        takeFound(body);
    }
    // The motion of a body has ended: it is nowhere, until it is put where it stands.
    void leave(std::size_t body);
    [[nodiscard]] bool hasEnded(std::size_t body) const { return ended_[body]; }

    // In the tree, in order; ended ones, too.
    [[nodiscard]] const std::vector<std::size_t>& partners(std::size_t body) const {
        return partners_[body];
    }
    // All that the body may meet, in order, but for those that ended.
    [[nodiscard]] std::vector<std::size_t> all(std::size_t body) const;
    // The same, in no order.
    template <typename Visit> void forEach(std::size_t body, Visit&& visit) {
        for (const std::size_t other : partners_[body])
            if (!ended_[other])
                visit(other);
        if (cells.contains(body))
            for (const std::size_t other : cells.near(body))
                if (mayMeet(body, other))
                    visit(other);
    }

private:
    void takeFound(std::size_t body);

    const std::vector<BodyRecord>& records_;
    double slack_;
    std::vector<std::vector<std::size_t>> partners_; // but for balls in cells near one in a cell
    std::vector<bool> ended_;
    std::vector<std::size_t> found_; // kept between calls
};

// The box, larger by this on all sides.
void grow(geometry::Box& box, double by);

} // namespace simulation
