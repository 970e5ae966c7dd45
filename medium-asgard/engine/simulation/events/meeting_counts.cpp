#include "events/meeting_counts.h"

#include <algorithm>

namespace simulation {
namespace {

using solution::AccumulationLaw;
using Verdict = solution::AccumulationMonitor::Verdict;

constexpr AccumulationLaw ofMeetings{.many = 1000, .within = 1e-5, .close = 200};
// With bodies that give way.
constexpr AccumulationLaw ofTurnings{.many = 1000, .within = 1e-9, .close = 200};
// Of what bears.
constexpr AccumulationLaw ofChanges{.many = 1000, .within = 1e-3, .close = 31, .pause = 1e-9};

} // namespace

bool MeetingCounts::meets(std::size_t body, std::size_t other, bool turnsBack, double time) {
    Meetings& met = meetings_[body];
    met.isGivenWay = met.isGivenWay || turnsBack;
    met.isWithSeveral = met.isWithSeveral || (met.partner && other != met.partner);
    met.partner = other;
    const AccumulationLaw& law = met.isGivenWay ? ofTurnings : ofMeetings;
    const Verdict verdict = met.monitor.add(time - start_, law);
    if (met.monitor.isAtMark(law)) {
        met.isGivenWay = false;
        met.isWithSeveral = met.isWithSeveral && verdict == Verdict::converges;
    }
    return verdict != Verdict::goesOn;
}

bool MeetingCounts::isRestless(std::size_t body, double time) {
    return changes_[body].add(time - start_, ofChanges) != Verdict::goesOn;
}

bool meetsWithoutEnd(const Instant& at, const Pair& pair, MeetingCounts& counts) {
    const auto turnsBack = [&](std::size_t body) { // who only turns does not
        const auto held = at.mobility.heldOf(body, at.time).position;
        return at.givesWay(body) && std::ranges::count(held, true) < 3;
    };
    const auto hasNoEnd = [&](std::size_t body, std::size_t other) {
        return at.givesWay(body) && counts.meets(body, other, turnsBack(other), at.time);
    };
    return hasNoEnd(pair.first, pair.second) || hasNoEnd(pair.second, pair.first);
}

} // namespace simulation
