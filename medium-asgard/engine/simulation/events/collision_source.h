// When do bodies meet, and what happens then? Collisions as the solver's source of events.
//
// The front is the time up to which everything has been looked at. encounter_search.h says what
// comes next:
//
//     next(known):
//         until the front reaches `known`: the earliest of
//             the support of a resting body changes: an event of its own (resting_bodies.h)
//             two bodies meet: gather all that touches at that instant, solve the impact;
//                 some impulse: that is the event; else the search goes on from there
//             the window of a body ends: its next one is searched
//
// A body that meets one whose motion has ended, at its last place, ends there too.
//
// Pairs keep what was found beyond an event that does not concern them (dissertation 5.2.3).
// Bouncing under restitution < 1 whose next hop is lower than RestLimits::hopHeight ends in a
// plastic impact, and then the body rests; so does one that is pressed onto what it touches. Where
// meeting has no end in finite time (a ball between walls that close in), the motion ends with a
// sentence after a thousand meetings within 1e-5 of the time since the start; within 1e-9 of it
// where some of them were with a body that gives way, which turns back after however many
// (Galperin's billiard). encounters.cpp has what happens, ball_encounters.cpp the same for balls in
// flight in closed form, collision_source.cpp when.
#pragma once

#include "contacts/resting_bodies.h"
#include "meetings/encounter_search.h"
#include "motion/impacts.h"
#include "motion/lost_hops.h"
#include "physics/equations_of_motion.h"
#include "physics/impact.h"
#include "physics/joint_rows.h"
#include "solution/event_source.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace simulation {

class CollisionSource final : public solution::EventSource {
public:
    // `equations` must outlive the source. A refusal (a shape that is none) is told by the caller's
    // own reading of the scene: shapes are valid here.
    CollisionSource(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
                    const std::vector<geometry::Shape>& shapes, double start, double finish,
                    std::vector<RestLimits> limits, std::function<bool()> cancelled = {});
    ~CollisionSource() override;

    void use(solution::Turns& turns) override { turns_ = &turns; }
    [[nodiscard]] std::optional<solution::Event> next(const solution::Histories& histories,
                                                      double known) override;
    void apply(const solution::Histories& histories, const solution::Event& event,
               solution::EquationsInForce& equations, solution::Changes& changes) override;
    [[nodiscard]] std::size_t bytesBefore(double t) const override {
        return impacts_.bytesBefore(t);
    }

    // The motion is wanted for longer than before; next() goes on from where it was.
    void lengthen(double finish);
    // The impacts and notes up to a time.
    [[nodiscard]] Impacts impacts(double until) const { return impacts_.upTo(until); }
    [[nodiscard]] std::vector<std::string> notes(double until) const;
    // Pairs of whom one met the other where its motion had ended, up to a time.
    [[nodiscard]] std::vector<collision::Pair> blocked(double until) const;
    // By body that rests or slides where the search stands: on what.
    [[nodiscard]] std::map<std::size_t, std::vector<std::size_t>> supports() const {
        return resting_.supports();
    }
    // An event happened at this very time.
    [[nodiscard]] bool hasEventAt(double time) const;
    [[nodiscard]] std::vector<LostHop> lostHops(double until) const {
        return lostHops_.upTo(until);
    }
    [[nodiscard]] std::size_t pairTests() const { return search_.pairTests(); }
    // Pairs of bodies, the lesser first, that came near each other; in order.
    [[nodiscard]] std::vector<collision::Pair> candidates() { return search_.pairs(); }

private:
    using Pair = collision::Pair;
    struct Cluster { // all that touches at one instant, through bodies that can give way
        std::vector<std::size_t> bodies;              // indices into the scene's
        std::vector<physics::ImpactContact> contacts; // with indices into `bodies`
        // By contact, of its first and its second: the radius of the sphere that touches; 0: a
        // flat part. A sphere's gap follows its centre, whatever its surface does under it.
        std::vector<std::array<double, 2>> radii;
        std::vector<physics::ImpactContact> corners; // of the patches
        std::vector<std::size_t> contactOf;          // by corner
        std::vector<physics::ImpactRow> joints;      // between these bodies
    };
    struct Outcome { // of the event that next() answered last
        struct Resting {
            std::size_t body;
            BodyState state;
            Rest rest;
        };
        std::vector<solution::Changes::Jump> jumps;
        std::vector<solution::Changes::End> ends;
        std::vector<Resting> rests;
    };
    struct Meetings { // of one body, to see that they have no end
        std::size_t count = 0, atOnce = 0;
        std::optional<std::size_t> partner; // the last
        // Since markedAt:
        bool isGivenWay = false;    // by someone
        bool isWithSeveral = false; // not all of them with the same body
        double last = -solution::infinity, markedAt = -solution::infinity;
        void add(std::optional<std::size_t> other, bool otherGivesWay, double time) {
            isGivenWay = isGivenWay || otherGivesWay;
            isWithSeveral = isWithSeveral || (partner && other != partner);
            partner = other;
            atOnce = time == last ? atOnce + 1 : 1;
            last = time;
            ++count;
        }
    };

    void read(const solution::Histories& histories);
    [[nodiscard]] std::optional<solution::Event> announced(solution::Event event);
    void noteEvent(double time);
    void forgetAfterEvent(const solution::Event& event);
    void findDependents();
    // An event: two that had met overlap without having met again, which ends their motion.
    [[nodiscard]] std::optional<solution::Event> renew(const solution::Histories& histories);
    [[nodiscard]] bool hasMet(const Pair& pair, double time) const;
    void stand(const solution::Histories& histories, std::size_t body, double time);
    void lookAtJoined(double time);
    // The outcome of a hit: an event to be announced, or none, and the search goes on from there;
    // or all is done.
    struct Handled {
        std::optional<solution::Event> event;
        bool isDone = false;
    };
    [[nodiscard]] Handled handle(const solution::Histories& histories,
                                 const EncounterSearch::Found& hit);
    [[nodiscard]] std::optional<solution::Event> meet(const solution::Histories& histories,
                                                      const Pair& pair, double time);
    // Both are held, and no impulse at their contact parts them.
    void passThrough(const Pair& pair, double time);
    [[nodiscard]] bool cannotPart(const solution::Histories& histories, const Pair& pair,
                                  double time);
    [[nodiscard]] bool areFreeBalls(const Pair& pair, double time) const;
    [[nodiscard]] double restitutionOf(const Pair& pair) const;
    struct Closeness {                   // of two balls
        double radius = 0, rounding = 0; // the smaller one; of places
        double rate = 0, push = 0;       // the first two derivatives of the gap
        double turning = 0;              // what of the push is their going past each other
        double accelerations = 0;        // that enter
    };
    [[nodiscard]] Closeness closenessOf(const solution::Histories& histories, const Pair& pair,
                                        double time) const;
    // no: it is a hit; tooOften: it would be one too many of those that go side by side.
    enum class Alongside { no, yes, tooOften };
    [[nodiscard]] Alongside goAlongside(const solution::Histories& histories,
                                        const EncounterSearch::Found& hit);
    struct Present { // of two that meet, or one beside them, at an instant
        std::size_t body = 0;
        const collision::BallFlight* flight = nullptr; // none: not in flight
        collision::PlacedBall ball = {};
        Vector velocity = Vector::Zero();
        double speed = 0, farthest = 0; // coordinate
    };
    // Two balls, or a ball and a face, that touch nothing else. None: meet() must answer.
    [[nodiscard]] std::optional<Handled> meetInFlight(const solution::Histories& histories,
                                                      const Pair& pair, double time);
    struct Push { // what two do to each other
        double impulse = 0;
        std::array<Vector, 2> velocities; // then
        bool isClear = false;             // they part faster than rounding tells
    };
    // None: they do not, or it is their last hop.
    [[nodiscard]] std::optional<Push> pushOf(const Present& first, const Present& second,
                                             const Vector& normal) const;
    [[nodiscard]] bool turn(const Pair& pair, double time, const std::array<Vector, 2>& before,
                            const std::array<Vector, 2>& after);
    // Hit after hit, after one of these; an event: one that must be announced.
    [[nodiscard]] std::optional<solution::Event> rally(const solution::Histories& histories,
                                                       const Pair& pair, double until);
    // isOver: the search must answer this hit; isRefused: the solver does not turn on the spot.
    enum class Rallied { goesOn, isOver, isEndless, isRefused, isUnclear };
    [[nodiscard]] Rallied meetInRally(const Rally::Meeting& meeting);
    [[nodiscard]] bool turnInRally(const Rally::Meeting& met, const std::array<Vector, 2>& before,
                                   const std::array<Vector, 2>& then);
    struct Course { // of a rally
        Rallied state = Rallied::goesOn;
        std::size_t hits = 0;
        const Rally::Meeting* last = nullptr;
        double time = -solution::infinity; // of the last
    };
    [[nodiscard]] static Present presentOf(std::size_t body, const collision::BallFlight& flight,
                                           double time);
    [[nodiscard]] bool touchesMoreInRally(const Present& one, const Rally::Ball& ball,
                                          const Rally::Meeting& met, double time) const;
    [[nodiscard]] Present presentAt(std::size_t body, double time) const;
    void readVelocity(const solution::Histories& histories, Present& present, double time) const;
    [[nodiscard]] double toleranceOf(const Present& a, const Present& b, double time) const;
    [[nodiscard]] double speedOf(const Pair& pair, double time) const;
    // Nearer than this they touch at an impact: it is as far off as coordinates and times are
    // resolved, too.
    [[nodiscard]] double contactTolerance(const Pair& pair, double time) const;
    [[nodiscard]] collision::FlightContact flightContact(const Present& first,
                                                         const Present& second, double time) const;
    [[nodiscard]] bool touchesMore(const solution::Histories& histories, const Present& one,
                                   const Present& met, double time);
    [[nodiscard]] bool touchesClosely(const solution::Histories& histories, const Pair& pair,
                                      std::size_t other, double time);
    [[nodiscard]] bool isLastHop(const Present& first, const Present& second, const Vector& normal,
                                 double speed) const;
    [[nodiscard]] std::optional<solution::Event> press(const solution::Histories& histories,
                                                       const Pair& pair, double time);
    [[nodiscard]] solution::Event stir(const solution::Histories& histories, std::size_t body,
                                       double time);
    [[nodiscard]] RestingBodies::States leaving(const solution::Histories& histories,
                                                std::size_t body, double time,
                                                const Rest& rest) const;
    void settle(const solution::Histories& histories, std::size_t body, double time,
                const RestingBodies::States& states, solution::Event& event);
    void jump(std::size_t body, const BodyState& from, const BodyState& to, solution::Event& event);
    [[nodiscard]] std::string bodiesQuoted(const Pair& pair) const;
    [[nodiscard]] std::string leaning(std::size_t a, std::size_t b) const;
    [[nodiscard]] std::string lost(const Pair& pair, double time) const;
    // As canGiveWay(), known at once of what flies.
    [[nodiscard]] bool givesWay(std::size_t body, double time) const;
    [[nodiscard]] bool isWithoutEnd(std::size_t body, std::size_t other, double time);
    [[nodiscard]] solution::Event endWithoutEnd(const solution::Histories& histories,
                                                const Pair& pair, double time);
    [[nodiscard]] bool isRestless(std::size_t body, double time);
    [[nodiscard]] double nextPhase(const Pair& pair, double time) const;
    // A body meets one whose motion ended: its own motion ends there too.
    [[nodiscard]] Handled meetEnded(const solution::Histories& histories, const Pair& pair,
                                    double time);
    [[nodiscard]] solution::Event end(const Pair& pair, double time, const std::string& sentence);
    [[nodiscard]] std::vector<std::size_t> unknownsOf(const Pair& pair, double time) const;
    [[nodiscard]] double pushAt(const solution::Histories& histories, const Cluster& cluster,
                                const physics::ImpactContact& contact,
                                const std::array<double, 2>& radii,
                                std::span<const physics::ImpactBody> bodies, double time) const;
    [[nodiscard]] Cluster clusterAt(const solution::Histories& histories, const Pair& pair,
                                    double time);
    struct Standing { // a corner of what bears, or lands on what bears it already
        Vector point, normal;
        double gap = 0, solved = 0; // where what bears does so exactly, and as solved
        bool bears = false;
    };
    [[nodiscard]] std::vector<Standing> cornersNear(const solution::Histories& histories,
                                                    const Pair& pair, double time, bool isHit);
    [[nodiscard]] std::vector<Standing> cornersAt(const solution::Histories& histories,
                                                  const Pair& pair, double time, bool isHit);
    void addContacts(const solution::Histories& histories, Cluster& cluster, std::size_t a,
                     std::size_t b, double time, bool isHit);
    struct Hop { // that an impact would lead to
        bool approaches = false, isLow = true;
        double settling = 0; // the time that it and all hops after it take
        double height = 0;
    };
    [[nodiscard]] Hop hopOf(const solution::Histories& histories, const Cluster& cluster,
                            const physics::ImpactContact& contact,
                            const std::array<double, 2>& radii,
                            std::span<const physics::ImpactBody> bodies, double time) const;
    // The longest time in which the hops that were cut off would have ended; negative: none was.
    [[nodiscard]] double softenLastHops(const solution::Histories& histories, Cluster& cluster,
                                        std::span<const physics::ImpactBody> bodies, double time);
    void loseHop(const Pair& pair, double time, double height);
    // Balls that go side by side and only hop by their own push move on as one.
    void pressTogether(const solution::Histories& histories, Cluster& cluster,
                       const std::vector<physics::ImpactBody>& bodies, double time) const;
    static void aimAtFastest(Cluster& cluster, const std::vector<physics::ImpactBody>& bodies);
    [[nodiscard]] physics::ImpactResult
    resolve(Cluster& cluster, const std::vector<physics::ImpactBody>& before) const;
    [[nodiscard]] physics::ImpactBody impactBody(const solution::Histories& histories,
                                                 std::size_t body, double time) const;
    void record(const Pair& pair, const collision::FlightContact& contact, double impulse,
                double time);
    void record(const Cluster& cluster, const physics::ImpactResult& result, double time,
                double settling);
    void noteJam(const Cluster& cluster, const physics::ImpactResult& result, double time);
    void noteUnturned(std::size_t body, double time);
    void noteOnce(const Pair& pair, double time, const std::string& sentence);

    const scene::Scene& scene_;
    const physics::EquationsOfMotion& equations_;
    std::vector<BodyRecord> records_;
    std::vector<MovingBody> bodies_;
    double start_, finish_;
    std::vector<RestLimits> limits_;  // by body
    std::function<bool()> cancelled_; // then next() answers early, and nobody reads it

    solution::Turns* turns_ = nullptr;
    const solution::Histories* read_ = nullptr;
    std::set<Pair> noted_;
    std::vector<std::set<std::size_t>>
        dependents_;                  // other bodies that read a body, also through others
    std::vector<std::size_t> bodyOf_; // by unknown

    physics::JointRows joints_;
    RestingBodies resting_;
    EncounterSearch search_;
    EncounterSearch::Renewal renewal_;
    Rally rally_;
    std::vector<std::size_t> cut_;             // by the last event
    std::vector<Meetings> meetings_, changes_; // of what bears
    Outcome outcome_;
    struct Note {
        double time = 0;
        std::string sentence;
    };
    ImpactRecord impacts_;
    std::vector<Note> notes_;
    struct Blocked {
        Pair pair;
        double time = 0;
    };
    std::vector<Blocked> blocked_;
    LostHops lostHops_;
    std::vector<double> events_; // times
};

} // namespace simulation
