// Which multipliers with bounds hold their conditions, and what ends that?
//
//     low < m < high    the condition holds: its second rate is 0
//     m = low, high     the condition is left: a stop is open, a brake or a motor slips
//
// A condition with a gap is a stop: gap >= 0, m >= 0, one of both 0. One of velocities is a brake
// or a motor: its force is low while the rate is positive, and high while it is negative. The rows
// of a disc of friction hold together, or slip together with a force against their velocity.
//
// Between events the set is held. A force that reaches a bound, a gap or a rate that reaches 0 ends
// it (watch()). A gap that closes is a blow: velocities jump by Newton's law, in one solve with all
// that hangs together. Stops that touch and approach take part in it, and those that would hop
// lower than their resolution close. Then the second rates and the laws give the next set
// (complementarity/), a little ahead of the event: at a bound itself they have two answers.
//
// A contact (expression/equations.h) opens and slips here, as stops and brakes do. That it closes,
// has parted, or has lost its place, is told by its mode: then it is gone, and the source of events
// that made it says how all goes on from there.
//
// The direction of a slip that is next to none turns within next to no time, which no step follows:
// such a slip is 0, and the laws say whether it rests or which way it goes on.
//
// The friction of a body that slides and turns shifts the centre at which it acts (slip_forces.h).
// Its equations may have several answers. The motion goes on with that of the step before. When
// this answer comes to an end, the motion goes on with another: forces jump, velocities do not.
//
// LIMIT: of several other answers the one is taken that the search finds first. A contact that the
// impact of a jam parts may stay closed until the next event. Forces of a jam that are over ten
// times the loads count as an impact, and after eight impacts at an instant the motion ends. A step
// of a jam that takes slow slips to rest changes velocities by up to a thousandth of the fastest.
//
// A contact that a blow of its source leaves parting, and that its load brings back from no higher
// than its `hop`, closes at once. One that has fallen from there closes without such a blow, and
// so does one that the blow leaves approaching. Their impulses have the friction of what slips
// (closing_impulses.h).
//
// LIMIT: hops lower than a condition's resolution, or a contact's hop, are left out. A blow of a
// stop passes through contacts without friction. Brakes and motors that hold take the impulse of a
// low hop whole. Low hops that do not close together stay hops, all of them.
#pragma once

#include "complementarity/laws.h"
#include "modes/multipliers.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace solution {

class ActiveSet {
public:
    ActiveSet(ModelFunctions& functions, Multipliers& multipliers, Mode& mode);

    // A contact whose slip turns rests if it slips slower than `part` of the fastest velocity, or
    // of the velocity after a fall through the extent; or if friction would stop it on that way.
    // The integration errs by more.
    struct Slow {
        double part = 0, extent = 0, way = 0;
    };
    void setSlow(const Slow& slow) { slow_ = slow; }
    // There are bounds.
    [[nodiscard]] bool empty() const { return bounded_.empty(); }
    // The set is another.
    void refresh();
    // Functions that end it when they fall below 0, of the mode that was refreshed last.
    [[nodiscard]] std::size_t size() const { return watches_.size(); }
    // The watch of a disc that slips.
    [[nodiscard]] std::size_t turnOf(std::size_t disc) const {
        const auto isIt = [disc](const Watch& watch) {
            return watch.kind == Kind::turn && watch.row == disc;
        };
        return static_cast<std::size_t>(std::ranges::find_if(watches_, isIt) - watches_.begin());
    }
    // The multiplier of a watch; of friction, the first of its disc.
    [[nodiscard]] std::size_t rowOf(std::size_t watch) const;
    // At the point of the functions, for which the multipliers are solved.
    void watch(std::span<double> values);
    // A watch that does not read forces, at the point of the functions.
    [[nodiscard]] bool readsForces(std::size_t watch) const;
    [[nodiscard]] double watchOfPlaces(std::size_t watch);
    // A contact closes there, or loses its place.
    [[nodiscard]] bool isOfPlaces(std::size_t watch) const;
    // That watch is not 0 at the point of the functions.
    [[nodiscard]] bool isOffPlace(std::size_t watch);
    // The gap of this watch grows at the point of the functions, and is within the resolution of
    // its contact: only an error of polynomials has crossed it. From then on twice that gap counts
    // as open.
    [[nodiscard]] bool grazes(std::size_t watch);
    // The set that follows from the values alone, where some may touch and approach.
    void decide(double t, std::span<double> y);
    // The set after these watches fell; y with what blows give. False: no forces keep the laws.
    // `rates` of the states led there.
    [[nodiscard]] bool cross(std::span<const std::size_t> watches, double t, std::span<double> y,
                             std::span<const double> rates);
    // Friction that slips does so as these states move.
    void takeSlips(double t, std::span<const double> y);
    // At the end of a step: the next one seeks forces of slips from the centres that they have
    // here, if these have moved far.
    void followCentres(double t, std::span<const double> y);
    // There are contacts.
    [[nodiscard]] bool hasContacts() const { return hasContacts_; }
    // One of them slips.
    [[nodiscard]] bool slips() const;
    // One of them slipped slowly at the last event.
    [[nodiscard]] bool slipsSlowly() const;
    // Of friction: it jammed at the last event. No forces kept the laws of its slip, which an
    // impact without a collision has changed.
    [[nodiscard]] bool hasJammed(std::size_t row) const { return jammed_[row] != 0; }

private:
    static constexpr double atRest = 1e-12;  // of the rates that enter: none
    static constexpr double noForce = 1e-11; // of the largest, between bodies in contact
    static constexpr double rateOf = 1e-3;   // of a resolution, in the unit of time
    [[nodiscard]] static bool isIn(std::span<const std::size_t> list, std::size_t value) {
        return std::ranges::find(list, value) != list.end();
    }
    // From how high a gap with this rate and second rate comes, or comes back.
    [[nodiscard]] static double hopOf(double rate, double second) {
        return second < 0 ? rate * rate / (-2 * second) : complementarity::unbounded;
    }
    enum class Kind { gap, least, most, forward, backward, parted, invalid, cone, turn, unsolved };
    struct Watch {
        std::size_t row; // of cone and turn: the disc; of unsolved: any that holds
        Kind kind;
        std::uint32_t confine = 0; // of invalid: which
    };
    // The rows of one system: first all without a disc, then of each disc its normal forces next
    // to each other, and its own rows.
    struct Rows {
        std::vector<std::size_t> rows;
        complementarity::Laws laws;
        std::vector<std::size_t> discs; // that may hold
        bool hasBounds = false;
    };
    [[nodiscard]] const BoundModel::Law& law(std::size_t row) const {
        return f_.bound()->laws[row];
    }
    [[nodiscard]] std::span<const BoundModel::Disc> discs() const { return f_.bound()->discs; }
    [[nodiscard]] bool isStop(std::size_t row) const;
    [[nodiscard]] bool isContact(std::size_t row) const { return law(row).leaving.has_value(); }
    [[nodiscard]] bool holds(std::size_t row) const {
        return mode_.kept[row] == complementarity::State::inside;
    }
    [[nodiscard]] bool isGone(std::size_t row) const { return mode_.kept[row] == Mode::gone; }
    void beginEvent(double t);
    void noteOpened(std::span<const complementarity::State> before, double t,
                    std::span<const double> y);
    void watchRow(std::size_t row);
    void watchDisc(std::size_t disc);
    [[nodiscard]] double beyondRounding(double force) const;
    [[nodiscard]] double valueOf(const Watch& watch) const;
    [[nodiscard]] complementarity::Laws lawsOf(std::span<const std::size_t> rows,
                                               std::span<const std::size_t> shut) const;
    [[nodiscard]] bool touches(std::size_t row) const;
    void addTouching(std::vector<std::size_t>& hit) const;
    void addClosing(std::vector<std::size_t>& fallen, double t) const;
    [[nodiscard]] std::vector<std::size_t> drivenLow(std::span<const std::size_t> hit,
                                                     std::span<const double> restitutions);
    void blow(std::span<const std::size_t> hit, double t, std::span<double> y);
    void closeLow(std::vector<std::size_t> closed, double none, double fastest, double t,
                  std::span<double> y);
    [[nodiscard]] bool isOpenContact(std::size_t row) const;
    [[nodiscard]] bool endDriven(std::vector<std::size_t>& closing, double none, double t,
                                 std::span<double> y);
    void land(std::span<const std::size_t> fallen, double t, std::span<double> y);
    [[nodiscard]] bool endRates(std::span<const std::size_t> closing, double t,
                                std::span<double> y);
    void give(std::span<const std::size_t> hit, std::span<const std::size_t> shut,
              std::span<const double> restitutions, double t, std::span<double> y);
    // By fallen watches: what may hold from here on, takes a blow, and has come to rest. Unsolved:
    // no forces were found that keep what holds, and slow slips rest.
    struct Ended {
        std::vector<std::size_t> candidates = {}, hit = {}, stopped = {};
        bool isUnsolved = false;
    };
    [[nodiscard]] Ended endBy(std::span<const std::size_t> fallen, double elapsed);
    [[nodiscard]] bool hasForces(double t, std::span<const double> y);
    void slip(double fastest, double t, std::span<const double> y);
    void setDisc(std::size_t disc, complementarity::State state);
    void setCentre(std::size_t disc, const DiscFriction::Centre& centre);
    // With that speed; or as its states move.
    void setSlip(std::size_t disc, const DiscFriction::InDisc& direction, double speed);
    void setSlip(std::size_t disc);
    [[nodiscard]] double leastOf(const BoundModel::Disc& disc) const {
        return 2 * rateOf * law(disc.rows[0]).resolution;
    }
    // `weight`: the largest of the accelerations that contacts take away.
    [[nodiscard]] double slowestOf(std::span<const double> y, double weight) const;
    [[nodiscard]] double fallenSlow(double weight) const;
    struct SlowSlip {
        std::size_t disc = 0;
        double speed = 0;
    };
    [[nodiscard]] std::vector<SlowSlip> slowSlips(std::span<const std::size_t> stopped) const;
    [[nodiscard]] bool stopNext(std::vector<SlowSlip>& slow, std::vector<std::size_t>& stopped,
                                double slowest, bool isDone, double t, std::span<const double> y);
    [[nodiscard]] bool settleWith(std::vector<std::size_t> hit, std::vector<std::size_t> candidates,
                                  std::span<const std::size_t> stopped, double t,
                                  std::span<double> y, std::span<const double> rates);
    [[nodiscard]] bool isLow(std::size_t row, double rate);
    [[nodiscard]] bool hasFallenLow(std::size_t row) const;
    [[nodiscard]] bool isCandidate(std::size_t row, double fastest) const;
    [[nodiscard]] bool hasStopped(std::size_t disc, double elapsed);
    [[nodiscard]] double secondOf(std::size_t disc) const; // the largest of its rows
    void halt(std::span<const std::size_t> discs, double t, std::span<double> y);
    struct Known { // an answer, by multiplier
        std::vector<double> forces = {};
        std::vector<complementarity::State> kept = {};
    };
    // No forces of these keep the laws: what slips among them may jam. True: it did; false: nothing
    // has changed.
    [[nodiscard]] bool endJam(std::span<const std::size_t> candidates, double t,
                              std::span<double> y, std::span<const double> rates);
    void settleAgain(std::span<const std::size_t> candidates, double t, std::span<double> y,
                     std::span<const double> rates);
    struct JamStep {
        bool isImpact = false;
        std::vector<std::size_t> held = {}, slipped = {}; // rows, discs
        Known known = {};
    };
    // None: the laws of the step have no answer, or nothing moves. Its duration is that part of the
    // time in which the strongest brake would stop the fastest.
    [[nodiscard]] std::optional<JamStep> jamStep(std::span<const std::size_t> candidates,
                                                 double part, double t, std::span<double> y);
    [[nodiscard]] bool mayHold(std::size_t disc, std::span<const std::size_t> fallen,
                               double fastest) const;
    // `slipping`: discs that slip, though they have no velocity yet.
    [[nodiscard]] Rows rowsFor(std::span<const std::size_t> fallen, double fastest,
                               const std::vector<char>& slipping);
    void openUnpressed();
    void takeForces();
    // The bound up to which each of these forces may grow; of one without a bound the largest
    // force.
    [[nodiscard]] std::vector<double> roomsOf(std::span<const double> forces) const;
    [[nodiscard]] bool areWithinBounds() const;
    [[nodiscard]] bool settle(std::span<const std::size_t> fallen, double fastest, double t,
                              std::span<const double> y, const Known* guess = nullptr);
    void addLaw(Rows& rows, std::size_t disc, std::span<const std::size_t> normals);
    // The multipliers, as the mode holds what switches. False: none keep the conditions that hold.
    bool solve();
    [[nodiscard]] Multipliers::System systemOf(std::span<const std::size_t> rows);
    // On each surface that is slid upon, its upper side and the weight of that.
    template <typename Visit> void onUpperSides(Visit&& visit);
    [[nodiscard]] bool solveLaws(const Rows& rows, const Known* guess);
    void take(const Rows& rows, const complementarity::Answer& answer, double faulty);

    ModelFunctions& f_;
    Multipliers& multipliers_;
    Mode& mode_;
    std::vector<std::size_t> bounded_; // multipliers
    std::vector<Watch> watches_;
    bool hasContacts_ = false;
    std::vector<double> opened_; // by multiplier: the gap that counts as open, at most 0
    std::vector<char> jammed_;   // by multiplier
    double largest_ = 0;         // of the multipliers, where watches are asked
    Slow slow_;
    double slowest_ = 0;               // at the last event
    double lastCross_ = 0, ahead_ = 0; // the last event, and how far its laws looked ahead
};

} // namespace solution
