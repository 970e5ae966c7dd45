// The contacts that last now: bodies that rest, slide and roll on each other.
//
// A contact begins where bodies touch and neither part nor approach: after an impact without
// rebound, or where they are placed so. Its rows become unknowns of the equations
// (physics/contact_rows.h); which of them press, stick or slip is the solver's
// (solution/modes/active_set.h). A contact that has parted, that closes again, or that has left the
// features on which it was, is told by its rows' modes: firstChange() finds when. Then the contacts
// of these bodies are looked at anew.
//
// Rows that end are used again by the next contact of the same body.
#pragma once

#include "contacts/colliders.h"
#include "contacts/contact_places.h"
#include "motion/contact_log.h"
#include "solution/event_source.h"

#include <algorithm>
#include <compare>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace simulation {

// Since when a multiplier is gone, of those times from `from` on; none: not at `until`.
[[nodiscard]] std::optional<double> goneFrom(const solution::Histories& histories, std::size_t row,
                                             double from, double until);

class ContactSet {
public:
    // The colliders must outlive this.
    explicit ContactSet(const Colliders& world) : world_(world) {}

    [[nodiscard]] bool empty() const { return contacts_.empty(); }
    [[nodiscard]] bool isIn(std::size_t body) const { return bodies_.contains(body); }
    [[nodiscard]] bool areIn(std::size_t a, std::size_t b) const;
    [[nodiscard]] bool areIn(std::size_t a, std::size_t partA, std::size_t b,
                             std::size_t partB) const;
    // These bodies and all that are in contact with them, through whomever: they move together.
    [[nodiscard]] std::set<std::size_t> island(std::set<std::size_t> bodies) const;
    // Some contact of these has points of a motion in a plane.
    [[nodiscard]] bool isAnyInPlane(std::span<const std::size_t> bodies) const {
        return std::ranges::any_of(contacts_, [&](const Contact& contact) {
            return contact.of.isInPlane &&
                   std::ranges::any_of(bodies, [&](std::size_t body) { return contact.has(body); });
        });
    }
    // By body on whom it lies or leans.
    [[nodiscard]] std::map<std::size_t, std::vector<std::size_t>> supports() const;

    struct Parts { // of two bodies in contact, since when
        std::size_t body = 0, bodyPart = 0, support = 0, supportPart = 0;
        double from = 0;
    };
    [[nodiscard]] std::vector<Parts> parts() const;

    struct Change {
        double time = 0;
        Pair bodies;
    };
    // The first time, not after `until`, at which a contact has ended, a round end that stands on
    // few points tips, or a trajectory takes hold of one of its bodies, bends or lets go.
    [[nodiscard]] std::optional<Change> firstChange(const solution::Histories& histories,
                                                    double until) const;

    // How round ends of one of the two stand on the other, and on which points they tip then: of
    // those of which no point is gone.
    [[nodiscard]] std::vector<Stand> standsOf(const solution::Histories& histories, std::size_t a,
                                              std::size_t b, double time) const;

    // These are the contacts of these bodies already: the same features of the same parts.
    [[nodiscard]] bool isLike(std::span<const std::size_t> bodies,
                              std::span<const LastingContact> contacts) const;
    // From `time` on these are the contacts of these bodies, and no others. `nextPhase`: when a
    // trajectory next concerns a body.
    void set(std::span<const std::size_t> bodies, std::vector<LastingContact> contacts, double time,
             const std::function<double(std::size_t body)>& nextPhase);
    // Their motion has ended.
    void forget(std::size_t body);
    // Equations from `time` on, as set() said since the last call.
    void write(double time, solution::EquationsInForce& equations, solution::Changes& changes);
    // All that was written.
    [[nodiscard]] const ContactLog& log() const { return log_; }
    // set() changes these bodies' equations, and those of these unknowns, which read contacts.
    [[nodiscard]] const std::set<std::size_t>& concerned() const { return concerned_; }
    [[nodiscard]] std::vector<std::size_t> concernedReaders() const;

private:
    struct Contact {
        LastingContact of;
        std::shared_ptr<const physics::ContactSurfaces> surfaces; // for the log
        std::vector<std::size_t> rows; // unknowns; none yet: write() gives them
        double from = 0, phase = 0;
        // The last step up to which it did not tip: those before it, where they are the same, are
        // not looked at again.
        struct Looked {
            const void* history = nullptr;
            std::size_t step = 0;
            double origin = 0;
        };
        mutable Looked looked = {};
        [[nodiscard]] bool has(std::size_t body) const {
            return of.place.body == body || of.place.support == body;
        }
    };
    struct Tipping { // of a round end, early
        double time = 0;
        Stand stand;
    };
    [[nodiscard]] static std::optional<Tipping> tipsFrom(const solution::Histories& histories,
                                                         const Contact& contact, double until);
    [[nodiscard]] std::size_t ownerOf(const Contact& contact) const;
    void giveRows(Contact& contact, solution::EquationsInForce& equations,
                  solution::Changes& changes);
    void noteBodies();
    // Of a named contact.
    [[nodiscard]] bool isConcerned(const Pair& pair, std::size_t index) const;
    struct Written {
        const Contact* contact;
        std::vector<expression::Node> multipliers;
    };
    void writeReadings(physics::ContactRows& rows, std::span<const Written> written,
                       expression::EquationSet& set, solution::Changes& changes) const;
    void note(double time, std::span<const Written> written, std::span<const std::size_t> moving);
    void writeReaders(double time, expression::EquationSet& set, solution::Changes& changes) const;

    const Colliders& world_;
    std::vector<Contact> contacts_;
    ContactLog log_;
    std::set<std::size_t> bodies_;    // in contacts
    std::set<std::size_t> concerned_; // since write()
    // A row is used again by the owner in the same role: what a scene in a plane leaves out stays
    // out.
    struct Role {
        std::size_t owner = 0, kind = 0; // of a point: 0, of friction and rolling: from 1 on
        auto operator<=>(const Role&) const = default;
    };
    [[nodiscard]] Role roleOf(const Contact& contact, std::size_t place) const;
    std::vector<std::pair<Role, std::size_t>> ended_; // rows, since write()
    std::map<Role, std::vector<std::size_t>> unused_;
};

} // namespace simulation
