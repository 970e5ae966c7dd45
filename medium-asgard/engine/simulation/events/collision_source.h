// When do bodies meet, and what happens then? Collisions as the solver's source of events.
//
// The front is the time up to which everything has been looked at. encounter_search.h says what
// comes next:
//
//     next(known):
//         until the front reaches `known`: the earliest of
//             a contact that lasts ends: an event of its own (contact_set.h)
//             two bodies meet: gather all that touches at that instant, solve the impact;
//                 some impulse: that is the event; else the search goes on from there
//             the window of a body ends: its next one is searched
//
// A body that meets one whose motion has ended, at its last place, ends there too.
//
// Pairs keep what was found beyond an event that does not concern them (dissertation 5.2.3).
// Bouncing under restitution < 1 whose next hop is lower than ContactResolution::hopHeight ends in
// a plastic impact, and then the body rests; so does one that is pressed onto what it touches.
// Where meeting has no end in finite time (a ball between walls that close in), the motion ends
// with a sentence after a thousand meetings within 1e-5 of the time since the start; within 1e-9 of
// it where some of them were with a body that gives way, which turns back after however many
// (Galperin's billiard). collision_source.cpp has when something happens, encounters.cpp what.
#pragma once

#include "contacts/hollow_faults.h"
#include "events/collision_record.h"
#include "events/flight_impacts.h"
#include "events/impact_cluster.h"
#include "events/meeting_counts.h"
#include "events/outcome.h"
#include "meetings/releases.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace simulation {

class CollisionSource final : public solution::EventSource {
public:
    struct Collision { // of what
        const scene::Scene& scene;
        const physics::EquationsOfMotion& equations;
        const std::vector<geometry::Shape>& shapes;
    };
    // All of `of` must outlive the source. A refusal (a shape that is none) is told by the caller's
    // own reading of the scene: shapes are valid here.
    CollisionSource(const Collision& of, double start, double finish,
                    std::vector<ContactResolution> resolution,
                    std::function<bool()> cancelled = {});
    ~CollisionSource() override;

    void use(solution::Turns& turns) override {
        turns_ = &turns;
        flights_.use(turns);
    }
    [[nodiscard]] std::optional<solution::Event> next(const solution::Histories& histories,
                                                      double known) override;
    void apply(const solution::Histories& histories, const solution::Event& event,
               solution::EquationsInForce& equations, solution::Changes& changes) override;
    [[nodiscard]] std::size_t bytesBefore(double t) const override {
        return record_.bytesBefore(t);
    }

    // The motion is wanted for longer than before; next() goes on from where it was.
    void lengthen(double finish);
    [[nodiscard]] const CollisionRecord& record() const { return record_; }
    // By body that rests or slides where the search stands: on what.
    [[nodiscard]] std::map<std::size_t, std::vector<std::size_t>> supports() const {
        return contacts_.supports();
    }
    [[nodiscard]] const ContactLog& contactLog() const { return contacts_.log(); }
    [[nodiscard]] std::size_t pairTests() const { return search_.pairTests(); }
    // Pairs of bodies, the lesser first, that came near each other; in order.
    [[nodiscard]] std::vector<Pair> candidates() { return search_.pairs(); }

private:
    using Event = solution::Event;
    using Histories = solution::Histories;

    [[nodiscard]] Instant at(const Histories& histories, double time) const {
        return {world_, contacts_, mobility_, search_, histories, time};
    }
    [[nodiscard]] Event announced(Event event);
    void cut(const Event& event);
    // Steps of the two are ended before it: it must be found again.
    [[nodiscard]] bool isOffConditions(const Histories& histories, const Found& hit);
    // With these states they overlap by no more than that, beside what is in contact already.
    [[nodiscard]] bool areApart(const Instant& instant, const Pair& pair,
                                const ChangedStates& states, double tolerance) const;
    // Windows and partners. An event: two that had met overlap without having met again, which ends
    // their motion.
    [[nodiscard]] std::optional<Event> renew(const Histories& histories);
    [[nodiscard]] bool hasMet(const Instant& instant, const Pair& pair) const;
    void stand(const Histories& histories, std::size_t body, double time);

    // The outcome of a hit: an event to be announced, or none, and the search goes on from there;
    // or all is done.
    struct Handled {
        std::optional<Event> event;
        bool isDone = false;
    };
    [[nodiscard]] Handled handle(const Histories& histories, const Found& hit);
    [[nodiscard]] std::optional<Handled> meetInFlight(const Instant& instant, const Pair& pair);
    [[nodiscard]] std::optional<Event> meet(const Instant& instant, const Pair& pair);
    // A body meets one whose motion ended: its own motion ends there too.
    [[nodiscard]] Handled meetEnded(const Instant& instant, const Pair& pair);
    // Both are held, and no impulse at their contact parts them.
    void passThrough(const Instant& instant, const Pair& pair);
    [[nodiscard]] std::optional<Event> press(const Instant& instant, const Pair& pair,
                                             bool isPressed);
    [[nodiscard]] std::optional<Event> partAnew(const Instant& instant, const Pair& pair);
    // Contacts of these bodies that last from now on; forced: though they be the same as before.
    // `pressed`: what the search for meetings found to be pressed together, whatever is left of its
    // rate.
    void settle(const Instant& instant, std::span<const std::size_t> bodies,
                const ChangedStates& states, Event& event, bool isForced = false,
                const std::optional<Pair>& pressed = {});
    // `entering`: speeds before the blow; `plane`: in which points lie.
    [[nodiscard]] std::vector<LastingContact>
    contactsBetween(const Instant& instant, const Pair& pair, const ChangedStates& states,
                    double entering, const std::optional<MotionPlane>& plane, bool isPressed) const;
    [[nodiscard]] std::vector<std::size_t> together(std::set<std::size_t> bodies,
                                                    std::span<const LastingContact> found) const;
    [[nodiscard]] std::vector<LastingContact> contactsOf(const Instant& instant,
                                                         std::span<const std::size_t> bodies,
                                                         const ChangedStates& states,
                                                         const std::optional<Pair>& pressed) const;
    // Of a pair with a hollow part: what of it is not modelled, and why not.
    [[nodiscard]] std::optional<std::string> unmodelledOf(const Instant& instant,
                                                          const Pair& pair) const;
    [[nodiscard]] std::optional<Event> crossWall(const Histories& histories, double until);
    // No impulses part what meets. None: they are settled, and nothing is crushed.
    [[nodiscard]] std::optional<Event> endUnparted(const Instant& instant,
                                                   const ImpactCluster& cluster,
                                                   std::span<const physics::ImpactBody> before,
                                                   const Pair& pair, bool isSettled);
    void refuse(const Instant& instant, const Pair& pair, const std::string& sentence,
                Event& event);
    [[nodiscard]] Event renewContacts(const Instant& instant, const Pair& pair);
    void keepImpulses(const Instant& instant, const ImpactCluster& cluster,
                      const physics::ImpactResult& result, double settling);
    void noteJam(const Instant& instant, const ImpactCluster& cluster,
                 const physics::ImpactResult& result);
    void noteUnturned(const Instant& instant, std::size_t body);
    [[nodiscard]] Event end(const Instant& instant, const Pair& pair, const std::string& sentence);
    void forget(const Instant& instant, const Pair& pair);
    [[nodiscard]] Event endWithoutEnd(const Instant& instant, const Pair& pair);

    Colliders world_;
    solution::Turns* turns_ = nullptr;
    double finish_;
    std::function<bool()> cancelled_; // then next() answers early, and nobody reads it
    BodyReaders readers_;
    ContactSet contacts_;
    Mobility mobility_;
    EncounterSearch search_;
    Releases releases_;
    CollisionRecord record_;
    FlightImpacts flights_;
    MeetingCounts counts_;
    WallWatch walls_;
    Outcome outcome_; // of the event that next() answered last
};

} // namespace simulation
