// Which bodies meet next, and when?
//
// Every body is looked at in windows of its own: no longer than a piece of its motion, nor than it
// takes to go a few of its sizes, nor than some seconds, twice as far and as long in each window in
// which nothing cut its motion. The box that holds the body during its window lies in a tree
// (collision/box_tree.h); a body whose box overlaps it is a partner, and partners are searched for
// hits during what their windows share:
//
//     next():   the earliest of   a window that ends   ->   renew(): its next window and box, new
//                                                           partners, one search with each
//                                 a hit
//     cut(b):   hits of b are forgotten; its next window begins at the cut
//
// So a hit costs the search of its two bodies among their neighbours, however many bodies there
// are. Windows and hits follow from the motion of their own bodies alone. Neither other bodies, nor
// the time up to which motion is known, nor its end change them: a body far away moves no bit of a
// hit here, so an edit can keep all motion that it does not concern. Balls in
// flight and faces that stand still are searched in closed form (collision/ball_flight.h), all else
// by collision/time_of_impact.h.
//
// A body whose motion has ended stays in the tree at its last place, and is met there.
//
// Balls in flight are not in the tree but in cells (collision/ball_cells.h), and a window of theirs
// is the way through a cell. Two of them are searched once for as long as they fly: when one turns,
// or comes into the cells about the other. Where the solver settles their hits on the spot
// (solution/event_source.h), the search knows their flights without reading them again:
//
//     turn(b, ...), goOn(pair):   what cut() of both and renew() would do
//
// A few that meet nobody but each other and what stands still leave for a rally: rally.h.
#pragma once

#include "collision/ball_cells.h"
#include "collision/box_tree.h"
#include "collision/broad_phase.h"
#include "collision/time_of_impact.h"
#include "contacts/resting_bodies.h"
#include "contacts/side_by_side.h"
#include "flights/rally.h"
#include "meetings/earliest.h"
#include "physics/equations_of_motion.h"
#include "scene/scene.h"
#include "solution/event_source.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace simulation {

class EncounterSearch final : public Neighbours {
public:
    using Pair = collision::Pair; // the lesser index first

    struct Found {
        double time = 0;
        Pair pair;
        bool pressing = false, isLost = false; // collision::Hit
    };
    struct Next {
        double time = 0;
        bool isHit = false; // else a window ends
    };

    // All must outlive this. Boxes hold what comes as near as `slack` of the body's radius.
    EncounterSearch(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
                    const std::vector<BodyRecord>& records, const std::vector<MovingBody>& bodies,
                    const RestingBodies& resting, double start, double slack);

    // The next thing to be done; it is done by takeHit() or renew().
    [[nodiscard]] Next next();
    [[nodiscard]] Found takeHit();
    // The body whose window ended, and whether it has partners now that it had not.
    struct Renewal {
        std::size_t body = 0;
        bool ended = false;              // its motion has ended: stand() says where it stays
        std::vector<std::size_t> joined; // its partners that had no such partner before
    };
    void renew(const solution::Histories& histories, Renewal& renewal);

    // A body whose motion ended is met where it stands from then on: its MovingBody says where.
    void stand(std::size_t body, double time, Renewal& renewal);
    // The motion of the body was cut at `time`.
    void cut(std::size_t body, double time);
    // A ball in flight that flies on for ever, if nobody turns it: turn() tells who does.
    [[nodiscard]] bool isFollowed(std::size_t body) const { return windows_[body].isFollowed; }
    void turn(std::size_t body, const solution::Turn& turn, double time);
    // After both of a pair: what cut() of both and renew() would do.
    void goOn(const Pair& turned, double time, Renewal& renewal);
    // The pair's hit at `time` was none, or is let pass: search it from there on.
    void searchOn(const Pair& pair, double time);
    // Balls that touch and neither part nor approach.
    [[nodiscard]] SideBySide& sideBySide() { return sideBySide_; }
    [[nodiscard]] const SideBySide& sideBySide() const { return sideBySide_; }
    [[nodiscard]] double depth(const Pair& pair) const { return sideBySide_.depth(pair); }
    // They let each other pass until then.
    void letPass(const Pair& pair, double until) { passing_.push_back({pair, until}); }

    // The balls of a hit that turned them, and those they may meet, leave for a rally (rally.h), in
    // which they meet by these; false: there is none to be had. They come back as they are then.
    [[nodiscard]] bool gather(const Pair& pair, Rally& rally);
    void dissolve(const Rally& rally);
    [[nodiscard]] bool turned(Rally& rally, const Rally::Meeting& met, double time,
                              bool parted) const {
        return rally.turned(met, time, parted, cells_, slack_);
    }
    [[nodiscard]] double slack() const { return slack_; }

    [[nodiscard]] std::vector<std::size_t> partners(std::size_t body) const override;
    // The same, in no order.
    template <typename Visit> void forEachPartner(std::size_t body, Visit&& visit) {
        for (const std::size_t other : partners_[body])
            if (!ended_[other])
                visit(other);
        if (cells_.contains(body))
            for (const std::size_t other : cells_.near(body))
                if (mayMeet(body, other))
                    visit(other);
    }
    [[nodiscard]] bool hasEnded(std::size_t body) const { return ended_[body]; }
    // When what is searched of it ended: of a free ball its way, however far its attitude is known.
    [[nodiscard]] std::optional<double> endOf(const solution::Histories& histories,
                                              std::size_t body) const {
        return simulation::endOf(records_[body], histories,
                                 isFreeBall_[body] ? physics::qw : physics::bodyUnknowns);
    }
    [[nodiscard]] bool hasAnyEnded(const Pair& pair) const {
        return ended_[pair.first] || ended_[pair.second];
    }
    [[nodiscard]] double windowEnd(std::size_t body) const override { return windows_[body].until; }

    // The flight of a free ball in its present window; none: not a ball, or no flight.
    [[nodiscard]] const collision::BallFlight* flight(std::size_t body) const {
        return windows_[body].isFlight ? &windows_[body].flight : nullptr;
    }
    // The box that holds a fixed body.
    [[nodiscard]] const geometry::Box& box(std::size_t body) const { return windows_[body].box; }
    // The faces of a fixed body with flat faces.
    [[nodiscard]] std::span<const collision::StandingPart> standing(std::size_t body) const {
        return standing_[body];
    }

    [[nodiscard]] std::size_t pairTests() const { return pairTests_; }
    [[nodiscard]] std::vector<Pair> pairs(); // that were searched, in order
    // Pairs that overlapped without having met, since this was asked last.
    [[nodiscard]] std::vector<Pair> takeOverlaps() { return std::exchange(overlaps_, {}); }

private:
    struct Window {
        double from = 0, until = 0;
        int number = 0; // since the last cut
        geometry::Box box;
        bool isFlight = false, isFollowed = false;
        collision::BallFlight flight;
        double pieceEnd = 0; // of the flight
        int growth = 0;      // of its cell
        collision::BallCells::Exit exit, crossed;
    };
    struct Hit { // in the queue; ordered by time
        double time = 0;
        std::uint32_t first = 0, second = 0, versionFirst = 0, versionSecond = 0;
        bool pressing = false, isLost = false;
    };
    struct Later {
        bool operator()(const Hit& a, const Hit& b) const;
    };
    using Crossing = collision::BallCells::Crossing;
    // Balls near one in its cell; beyond: beyond the face that it came through.
    enum class Around { all, beyond };

    [[nodiscard]] bool mayMeet(std::size_t a, std::size_t b) const {
        if (a == b || (records_[a].isFixed && records_[b].isFixed))
            return false;
        return !isChoosy_[a] || !isChoosy_[b] || mayChoosyMeet(a, b);
    }
    [[nodiscard]] bool mayChoosyMeet(std::size_t a, std::size_t b) const;
    [[nodiscard]] bool isOutdated(const Hit& hit) const;
    void push(const Hit& hit);
    void drop();
    void leave(std::size_t body);
    [[nodiscard]] bool isOver(const solution::Histories& histories, std::size_t body,
                              double time) const;
    [[nodiscard]] bool openFlight(const solution::Histories& histories, std::size_t body,
                                  Window& window) const;
    void openWindow(const solution::Histories& histories, std::size_t body, double time,
                    Renewal& renewal);
    void openFlightWindow(std::size_t body, double time);
    [[nodiscard]] Crossing enterCell(std::size_t body, double time, bool isNew);
    void boxFlight(std::size_t body);
    [[nodiscard]] geometry::Box leafOfBlock(std::size_t body) const;
    void enterTree(std::size_t body, Renewal& renewal);
    void findPartners(std::size_t body, const geometry::Box& leaf, Renewal& renewal);
    static constexpr std::size_t nobody = ~std::size_t{0};
    void searchAround(std::size_t body, double time, std::size_t but = nobody);
    void searchFlight(std::size_t body, std::size_t other, double time);
    void searchGenerally(const Pair& pair, collision::Interval during);
    [[nodiscard]] double gapOfBalls(const Pair& pair, double time) const;
    void search(const Pair& pair, double from);
    [[nodiscard]] bool isRallying(std::size_t body) const;
    [[nodiscard]] bool join(std::size_t body, Rally& rally) const;
    [[nodiscard]] bool gatherBalls(std::size_t body, Rally& rally);
    [[nodiscard]] bool gatherStanding(std::size_t ball, Rally& rally) const;
    [[nodiscard]] bool gatherBodies(const Pair& pair, Rally& rally);
    [[nodiscard]] bool keep(const Pair& pair, const collision::FlightMeeting& met);
    void keep(const Pair& pair, double time, bool pressing, bool isLost);
    [[nodiscard]] bool isPassing(const Pair& pair, double time) const;
    void remember(const Pair& pair);
    std::size_t sortPairs();

    const std::vector<BodyRecord>& records_;
    const std::vector<MovingBody>& bodies_;
    const RestingBodies& resting_;
    double slack_;

    std::vector<std::optional<std::size_t>> groups_;
    std::vector<std::vector<std::size_t>> joined_; // that it never meets, by body
    std::vector<char> isChoosy_;                   // has a group or joined bodies
    std::vector<bool> isFreeBall_;
    std::vector<std::vector<collision::StandingPart>> standing_;

    collision::BoxTree tree_;
    collision::BallCells cells_;
    std::vector<Window> windows_;
    std::vector<std::uint32_t> version_;             // of the motion: one more with each cut
    Earliest ends_;                                  // of windows
    std::vector<std::vector<std::size_t>> partners_; // but for balls in cells near one in a cell
    std::vector<std::vector<std::size_t>> unclear_;  // balls in flight that formulas do not answer
    std::vector<bool> ended_;
    std::vector<Hit> queue_;
    std::size_t queueLimit_ = 0; // longer, and outdated hits are taken out
    struct Passing {
        Pair pair;
        double until = 0;
    };
    std::vector<Passing> passing_; // pairs that cannot give way
    SideBySide sideBySide_;
    Around around_ = Around::all; // of the ball that entered a cell last
    std::vector<Pair> overlaps_;
    std::size_t pairTests_ = 0;
    std::vector<std::uint64_t> pairs_;        // as numbers; some several times
    std::size_t pairsKept_ = 0;               // that are known to be different
    std::vector<std::uint64_t> recentPairs_;  // of pairs_, by a few of their bits
    std::vector<std::size_t> found_, before_; // kept between calls
};

} // namespace simulation
