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
#pragma once

#include "collision/time_of_impact.h"
#include "contacts/contact_set.h"
#include "contacts/mobility.h"
#include "contacts/side_by_side.h"
#include "flights/flight_meetings.h"
#include "meetings/earliest.h"
#include "meetings/hit_queue.h"
#include "meetings/neighbourhood.h"
#include "meetings/tested_pairs.h"
#include "solution/event_source.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace simulation {

class EncounterSearch {
public:
    struct Next {
        double time = 0;
        bool isHit = false; // else a window ends
    };

    // All must outlive this.
    EncounterSearch(const Colliders& world, const ContactSet& contacts, const Mobility& mobility);

    // The next thing to be done; it is done by takeHit() or renew().
    [[nodiscard]] Next next();
    [[nodiscard]] Found takeHit() { return hits_.take(); }
    struct Renewal {
        std::size_t body = 0; // its window ended
        bool ended = false;   // its motion has ended, too: stand() says where it stays
    };
    [[nodiscard]] Renewal renew(const solution::Histories& histories);

    // A body whose motion ended is met where it stands from then on: its MovingBody says where.
    void stand(std::size_t body, double time);
    // The motion of the body was cut at `time`.
    void cut(std::size_t body, double time);
    // A ball in flight that flies on for ever, if nobody turns it: turn() tells who does.
    [[nodiscard]] bool isFollowed(std::size_t body) const { return windows_[body].isFollowed; }
    void turn(std::size_t body, const solution::Turn& turn, double time);
    // From `time` on these joints and links keep nobody from meeting.
    void release(const scene::Released& released, double time);
    // After both of a pair: what cut() of both and renew() would do.
    void goOn(const Pair& turned, double time);
    // The pair's hit at `time` was none, or is let pass: search it from there on.
    void searchOn(const Pair& pair, double time);
    // Balls that touch and neither part nor approach.
    [[nodiscard]] SideBySide& sideBySide() { return sideBySide_; }
    [[nodiscard]] const SideBySide& sideBySide() const { return sideBySide_; }
    [[nodiscard]] double depth(const Pair& pair) const { return sideBySide_.depth(pair); }
    [[nodiscard]] double gapOfBalls(const Pair& pair, double time) const;
    // They let each other pass until then.
    void letPass(const Pair& pair, double until) { near_.mayMeet.letPass(pair, until); }

    [[nodiscard]] std::vector<std::size_t> partners(std::size_t body) const {
        return near_.all(body);
    }
    // The same, in no order.
    template <typename Visit> void forEachPartner(std::size_t body, Visit&& visit) {
        near_.forEach(body, std::forward<Visit>(visit));
    }
    [[nodiscard]] bool hasEnded(std::size_t body) const { return near_.hasEnded(body); }
    // When what is searched of it ended: of a free ball its way, however far its attitude is known.
    [[nodiscard]] std::optional<double> endOf(const solution::Histories& histories,
                                              std::size_t body) const {
        return simulation::endOf(world_.records[body], histories,
                                 isFreeBall_[body] ? physics::qw : physics::bodyUnknowns);
    }
    [[nodiscard]] bool hasAnyEnded(const Pair& pair) const {
        return hasEnded(pair.first) || hasEnded(pair.second);
    }

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

    [[nodiscard]] std::size_t pairTests() const { return tested_.tests(); }
    [[nodiscard]] std::vector<Pair> pairs() { return tested_.all(); } // that were searched
    struct Overlap {
        Pair pair;
        double depth = 0;
    };
    // Pairs that overlapped without having met, since this was asked last.
    [[nodiscard]] std::vector<Overlap> takeOverlaps() { return std::exchange(overlaps_, {}); }

private:
    using Crossing = collision::BallCells::Crossing;
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
    // Balls near one in its cell; beyond: beyond the face that it came through.
    enum class Around { all, beyond };

    void addFixed(std::size_t body);
    void endBody(std::size_t body);
    [[nodiscard]] bool isOver(const solution::Histories& histories, std::size_t body,
                              double time) const;
    [[nodiscard]] bool openFlight(const solution::Histories& histories, std::size_t body,
                                  Window& window) const;
    void openWindow(const solution::Histories& histories, std::size_t body, double time);
    void openPieceWindow(std::size_t body, double time);
    void openFlightWindow(std::size_t body, double time);
    [[nodiscard]] Crossing enterCell(std::size_t body, double time, bool isNew);
    void boxFlight(std::size_t body);
    void enterTree(std::size_t body);
    void findPartners(std::size_t body, const geometry::Box& leaf);
    static constexpr std::size_t nobody = ~std::size_t{0};
    void searchAround(std::size_t body, double time, std::size_t but = nobody);
    void searchFlight(std::size_t body, std::size_t other, double time);
    void searchGenerally(const Pair& pair, collision::Interval during);
    void search(const Pair& pair, double from);
    [[nodiscard]] bool keep(const Pair& pair, const collision::FlightMeeting& met);

    const Colliders& world_;
    const ContactSet& contacts_;
    const Mobility& mobility_;
    std::vector<bool> isFreeBall_;
    std::vector<std::vector<collision::StandingPart>> standing_;

    Neighbourhood near_;
    std::vector<Window> windows_;
    Earliest ends_;                                 // of windows
    std::vector<std::vector<std::size_t>> unclear_; // balls in flight that formulas do not answer
    HitQueue hits_;
    SideBySide sideBySide_;
    Around around_ = Around::all; // of the ball that entered a cell last
    std::vector<Overlap> overlaps_;
    TestedPairs tested_;
};

} // namespace simulation
