#include "reports/instants.h"

#include "equations/prepared_equations.h"
#include "motion/contact_slips.h"
#include "physics/forces.h"
#include "reports/switch_instants.h"
#include "run/jams.h"
#include "run/stops.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

namespace simulation {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

// Of a multiplier, as its history keeps it.
enum class Mode { none, holds, low, high, gone, jammed, jammedLoose };
static_assert(static_cast<int>(Mode::holds) == static_cast<int>(solution::heldMode));
static_assert(static_cast<int>(Mode::gone) == static_cast<int>(solution::releasedMode));
static_assert(static_cast<int>(Mode::jammed) == static_cast<int>(solution::jammedMode));
static_assert(static_cast<int>(Mode::jammedLoose) == static_cast<int>(solution::jammedLooseMode));

Mode modeAt(const solution::Histories& histories, std::size_t row, double time) {
    const double value = row < histories.unknowns() ? histories.value(row, time) : 0;
    return static_cast<Mode>(std::lround(value));
}

// Calls for each piece of the row's mode that begins after `from`, up to `until`.
void followMode(const solution::Histories& histories, std::size_t row, double from, double until,
                const std::function<void(double time, Mode mode)>& call) {
    double time = from;
    while (row < histories.unknowns()) {
        const solution::Piece piece = histories.piece(row, time);
        const double next = piece.until;
        if (!(next > time) || !(next <= until))
            return;
        time = next;
        call(time, modeAt(histories, row, time));
    }
}

class Lister {
public:
    Lister(const scene::Scene& scene, const ComputedMotion& motion)
        : scene_(scene), motion_(motion) {}

    std::vector<ListedInstant> all() {
        addImpacts();
        addSwitches();
        const auto& parts = motion_.contents().parts;
        for (std::size_t p = 0; p < parts.size(); ++p)
            if (parts[p].equations && parts[p].histories) {
                addConditions(parts[p]);
                addContacts(p);
            }
        for (const ComputedMotion::Part& part : parts)
            if (part.histories)
                addEnds(part);
        dropPassedOn();
        std::ranges::stable_sort(found_, {}, &ListedInstant::time);
        return std::move(found_);
    }

private:
    void addImpacts();
    void addSwitches();
    void addEnds(const ComputedMotion::Part& part);
    void dropPassedOn();
    void addConditions(const ComputedMotion::Part& part);
    void addCondition(const ComputedMotion::Part& part, std::size_t row);
    void addContacts(std::size_t part);
    [[nodiscard]] std::string namesOf(const Pair& bodies) const {
        return scene_.bodies[bodies.first].name + " " + scene_.bodies[bodies.second].name;
    }
    [[nodiscard]] std::string namesOf(const std::string& element) const;
    [[nodiscard]] std::string kindOf(const std::string& element,
                                     const expression::Condition& condition, Mode before,
                                     Mode now) const;
    void add(double time, const std::string& kind, const std::string& names) {
        if (!kind.empty() && seen_.emplace(time, kind, names).second)
            found_.push_back({time, kind, names});
    }

    const scene::Scene& scene_;
    const ComputedMotion& motion_;
    std::vector<ListedInstant> found_;
    std::set<std::tuple<double, std::string, std::string>> seen_;
};

// Of one pair in order of time, first and end: those that are not listed, since a bouncing that
// ends in rest has more than so many. It is as long as each of its hops is shorter than the one
// before, but for rounding in short ones.
std::vector<std::pair<std::size_t, std::size_t>> leftOut(const std::vector<Impact>& impacts) {
    constexpr std::size_t most = 100;
    constexpr double rounding = 2, isShort = 1e-3; // ratio of two hops, part of the longest
    const auto hop = [&](std::size_t i) { return impacts[i + 1].time - impacts[i].time; };
    std::vector<std::pair<std::size_t, std::size_t>> out;
    for (std::size_t end = 0; end < impacts.size(); ++end) {
        if (!impacts[end].isEndOfHops)
            continue;
        std::size_t first = end;
        double longest = 0;
        while (first > 0 && !impacts[first - 1].isEndOfHops &&
               (first + 1 >= end || hop(first - 1) * rounding > hop(first)))
            longest = std::max(longest, hop(--first));
        for (std::size_t i = first + 1; i + 1 < end; ++i)
            if (hop(i) > hop(i - 1) && hop(i) > isShort * longest)
                first = i;
        if (first + most < end)
            out.emplace_back(first + most, end);
    }
    return out;
}

// One for each pair and time.
void Lister::addImpacts() {
    std::map<Pair, std::vector<Impact>> byPair;
    for (const Impact& impact : motion_.impacts()) {
        std::vector<Impact>& known = byPair[std::minmax(impact.first, impact.second)];
        if (known.empty() || known.back().time != impact.time)
            known.push_back(impact);
        else
            known.back().impulse += impact.impulse;
    }
    for (const auto& [pair, impacts] : byPair) {
        std::set<std::size_t> out;
        for (const auto& [first, end] : leftOut(impacts)) {
            found_.push_back({impacts[first].time, "omitted",
                              namesOf(pair) + " " + std::to_string(end - first)});
            for (std::size_t i = first; i < end; ++i)
                out.insert(i);
        }
        for (std::size_t i = 0; i < impacts.size(); ++i)
            if (const Impact& impact = impacts[i]; impact.isEndOfHops)
                add(impact.time, "rest", namesOf(pair));
            else if (!out.contains(i))
                found_.push_back({impact.time, "impact", namesOf(pair), impact.impulse});
    }
}

void Lister::addSwitches() {
    for (const auto& [time, body] : switchInstants(scene_, motion_))
        add(time, "switch", scene_.bodies[body].name);
}

// The motion ends if no forces keep the laws, or several motions do.
void Lister::addEnds(const ComputedMotion::Part& part) {
    using Reason = solution::Stop::Reason;
    for (const auto& [body, stop] : motion_.contents().stops) {
        const ComputedMotion::Place place = motion_.contents().places[body];
        if (&motion_.contents().parts[place.part] != &part)
            continue;
        for (const solution::Stop& ended : part.histories->stops()) {
            if (ended.time != stop.time)
                continue;
            if (ended.reason == Reason::contradiction && areSingular(scene_, {body}))
                add(stop.time, "indeterminate", scene_.bodies[body].name);
            else if (ended.reason == Reason::contradiction || ended.reason == Reason::unheld ||
                     ended.reason == Reason::bounds)
                add(stop.time, "inconsistent", scene_.bodies[body].name);
        }
    }
}

// A rope that lifts off a wheel or touches it again is neither slack nor taut of late: one of its
// spans passes its tension on to the next.
void Lister::dropPassedOn() {
    const auto isPassedOn = [this](const ListedInstant& instant) {
        const bool isTaut = instant.kind == "taut";
        return (isTaut || instant.kind == "slack") &&
               seen_.contains({instant.time, isTaut ? "slack" : "taut", instant.names});
    };
    std::erase_if(found_, isPassedOn);
}

std::string Lister::namesOf(const std::string& element) const {
    std::string names;
    if (const scene::Joint* joint = scene::findJoint(scene_, element))
        names = joint->body1 + " " + (joint->body2 ? *joint->body2 + " " : "");
    for (const scene::Rope& rope : scene_.ropes)
        if (rope.name == element)
            for (const scene::Rope::Point& point : rope.points)
                if (point.body)
                    names += *point.body + " ";
    const std::size_t dot = element.find('.');
    if (dot != std::string::npos) // of a force or link without a name
        return element.substr(0, dot) + " " + element.substr(dot + 1);
    for (const scene::Link& link : scene_.links)
        if (link.name == element) {
            const auto* second = std::get_if<scene::BodyEnd>(&link.second);
            names = link.first.body + " " + (second ? second->body + " " : "");
        }
    return names + element;
}

// Between two modes of a multiplier of a joint, gear or rope; "": nothing that is listed.
std::string Lister::kindOf(const std::string& element, const expression::Condition& condition,
                           Mode before, Mode now) const {
    if (now == Mode::gone)
        return condition.release ? "release" : "";
    const bool isBounded = std::isfinite(condition.low) || std::isfinite(condition.high);
    if (!isBounded || before == Mode::none || now == Mode::none)
        return "";
    const bool holds = now == Mode::holds;
    const scene::Joint* joint = scene::findJoint(scene_, element);
    if (condition.gap)
        return joint ? holds ? "limit" : "unlimit" : holds ? "taut" : "slack";
    if (!holds && before != Mode::holds)
        return "reverse";
    const auto isMotor = [&](const scene::JointCoordinate& coordinate) {
        return coordinate.maxMotor && *coordinate.maxMotor == condition.high &&
               coordinate.friction != condition.high;
    };
    if (joint && std::ranges::any_of(joint->coordinates, isMotor))
        return holds ? "hold" : "yield";
    return holds ? "stick" : "slip";
}

void Lister::addCondition(const ComputedMotion::Part& part, std::size_t row) {
    const expression::Unknown& unknown = part.equations->unknowns[row];
    const std::string names = namesOf(unknown.name);
    Mode before = modeAt(*part.histories, row, motion_.start());
    followMode(
        *part.histories, row, motion_.start(), motion_.computed(), [&](double time, Mode now) {
            const auto& condition = unknown.phases[solution::phaseAt(unknown, time)].condition;
            if (now != before && condition)
                add(time, kindOf(unknown.name, *condition, before, now), names);
            before = now;
        });
}

// Of joints, gears and ropes, whose names their multipliers have.
void Lister::addConditions(const ComputedMotion::Part& part) {
    for (std::size_t row = 0; row < part.equations->unknowns.size(); ++row) {
        const auto& phases = part.equations->unknowns[row].phases;
        const auto isElements = [](const expression::Phase& phase) {
            return phase.condition && !phase.condition->leaving && !phase.condition->friction;
        };
        if (std::ranges::all_of(phases, isElements))
            addCondition(part, row);
    }
}

// Of all contacts of a pair: 0 open, 1 they stick, 2 they slip.
int stateOf(const solution::Histories& histories, const std::vector<ContactLog::Contact>& contacts,
            double time) {
    int state = 0;
    for (const ContactLog::Contact& contact : contacts) {
        const auto holds = [&](std::size_t row) { return holdsAt(histories, row, time); };
        if (std::ranges::none_of(contact.normals, holds))
            continue;
        const bool sticks = !contact.friction.empty() && holds(contact.friction[0]);
        state = std::max(state, sticks ? 1 : 2);
    }
    return state;
}

// A pair of bodies closes, sticks, slips and opens; each change is told. A slip is not told when
// the surfaces move along each other by no more than their resolution: as a body tips, its contacts
// are laid anew, and begin with a small velocity that rounding and the tilt leave.
class PairFollower {
public:
    using Tell = std::function<void(double time, const char* kind)>;
    PairFollower(const ComputedMotion& motion, const ComputedMotion::Part& part,
                 const std::map<std::size_t, std::size_t>& bodies, Tell tell)
        : motion_(motion), histories_(*part.histories), bodies_(bodies), tell_(std::move(tell)),
          from_(motion.start()) {}

    void takeEntry(double time, std::vector<ContactLog::Contact> contacts) {
        lookUpTo(time);
        slideUpTo(time);
        now_ = std::move(contacts);
        from_ = time;
        look(time);
    }
    void end() {
        lookUpTo(motion_.computed());
        if (slips_)
            goOver(slipsFrom_, slipping);
    }

private:
    static constexpr int open = 0, slipping = 2;

    void lookUpTo(double until) {
        std::set<double> times;
        for (const ContactLog::Contact& contact : now_)
            for (const auto* rows : {&contact.normals, &contact.friction})
                for (const std::size_t row : *rows)
                    followMode(histories_, row, from_, until,
                               [&](double time, Mode) { times.insert(time); });
        for (const double time : times)
            if (time < until)
                look(time);
    }
    void look(double time) {
        slideUpTo(time);
        const int next = stateOf(histories_, now_, time);
        if (next == slipping && state_ != slipping && !slips_) {
            slips_ = true;
            slipsFrom_ = slidUpTo_ = time;
            slid_ = 0;
        } else if (next != slipping) {
            if (std::exchange(slips_, false))
                goOver(slipsFrom_, 1);
            goOver(time, next);
        }
    }
    // Of a slip that is not told yet.
    void slideUpTo(double time) {
        if (!slips_)
            return;
        const double lasts = time - slidUpTo_;
        double way = 0, resolution = 0;
        for (const ContactLog::Contact& contact : now_) {
            resolution = std::max(resolution, contact.surfaces->resolution);
            for (const double part : {0.0, 0.5})
                way = std::max(way, lasts * speedOf(contact, slidUpTo_ + part * lasts));
        }
        slid_ += way;
        slidUpTo_ = time;
        if (slid_ > resolution) {
            slips_ = false;
            goOver(slipsFrom_, slipping);
        }
    }
    [[nodiscard]] double speedOf(const ContactLog::Contact& contact, double time) const {
        return slipSpeedAt(motion_, histories_, contact, bodies_.at(contact.body),
                           bodies_.at(contact.support), time);
    }
    void goOver(double time, int next) {
        const int before = std::exchange(state_, next);
        if (before < 0 ? time == motion_.start() || next == open : next == before)
            return;
        tell_(time, next == open     ? "open"
                    : before <= open ? "close"
                    : next == 1      ? "stick"
                                     : "slip");
    }

    const ComputedMotion& motion_;
    const solution::Histories& histories_;
    const std::map<std::size_t, std::size_t>& bodies_; // of the scene, by the part's
    Tell tell_;
    std::vector<ContactLog::Contact> now_;
    double from_;
    int state_ = -1; // that was told; not known yet
    bool slips_ = false;
    double slipsFrom_ = 0, slidUpTo_ = 0, slid_ = 0;
};

void Lister::addContacts(std::size_t part) {
    const ComputedMotion::Part& of = motion_.contents().parts[part];
    std::map<std::size_t, std::size_t> bodies; // of the scene, by the part's
    for (std::size_t b = 0; b < motion_.contents().places.size(); ++b)
        if (const auto& place = motion_.contents().places[b]; place.part == part)
            bodies.emplace(place.body, b);
    const auto& entries = of.contacts.entries();
    std::set<Pair> pairs;
    for (const auto& entry : entries)
        for (const ContactLog::Contact& contact : entry->contacts)
            if (bodies.contains(contact.bodies.first) && bodies.contains(contact.bodies.second))
                pairs.insert(contact.bodies);
    for (const Jam& jam : jamsOf(*of.histories, of.contacts, motion_.computed()))
        if (bodies.contains(jam.bodies.first) && bodies.contains(jam.bodies.second))
            add(jam.time, "inconsistent",
                namesOf(Pair{bodies.at(jam.bodies.first), bodies.at(jam.bodies.second)}));
    for (const Pair& pair : pairs) {
        const std::string names = namesOf(Pair{bodies.at(pair.first), bodies.at(pair.second)});
        PairFollower follower(motion_, of, bodies, [&](double time, const std::string& kind) {
            add(time, kind, names);
        });
        for (const auto& entry : entries) {
            if (!entry->moving.contains(pair.first) && !entry->moving.contains(pair.second))
                continue;
            std::vector<ContactLog::Contact> now;
            std::ranges::copy_if(
                entry->contacts, std::back_inserter(now),
                [&](const ContactLog::Contact& contact) { return contact.bodies == pair; });
            follower.takeEntry(entry->time, std::move(now));
        }
        follower.end();
    }
}

} // namespace

std::vector<ListedInstant> instantsOf(const scene::Scene& scene, const Motion& motion) {
    const auto* computed = dynamic_cast<const ComputedMotion*>(&motion);
    return computed ? Lister(scene, *computed).all() : std::vector<ListedInstant>();
}

namespace {

// Of multipliers that are gone; of those that sleep, as they bear nothing, the expression tells.
std::set<std::string> namesGone(const ComputedMotion::Part& part, double start, double time) {
    constexpr std::string_view ending = ".release"; // the name of the expression's unknown
    std::set<std::string> gone;
    for (std::size_t row = 0; row < part.equations->unknowns.size(); ++row) {
        const expression::Unknown& unknown = part.equations->unknowns[row];
        if (unknown.phases[solution::phaseAt(unknown, time)].condition) {
            if (modeAt(*part.histories, row, time) == Mode::gone)
                gone.insert(unknown.name);
        } else if (unknown.name.ends_with(ending)) {
            bool isTrue = part.histories->value(row, start) != 0;
            followMode(*part.histories, row, start, time, [&](double at, Mode) {
                isTrue = isTrue || part.histories->value(row, at) != 0;
            });
            if (isTrue)
                gone.insert(unknown.name.substr(0, unknown.name.size() - ending.size()));
        }
    }
    return gone;
}

} // namespace

scene::Released releasedBy(const scene::Scene& scene, const Motion& motion, double time) {
    std::set<std::string> gone;
    if (const auto* computed = dynamic_cast<const ComputedMotion*>(&motion))
        for (const ComputedMotion::Part& part : computed->contents().parts)
            if (part.equations && part.histories)
                gone.merge(namesGone(part, motion.start(), time));
    scene::Released released;
    const auto add = [&](const auto& elements, std::set<std::size_t>& indices, const auto& nameOf) {
        for (std::size_t i = 0; i < elements.size(); ++i)
            if (elements[i].release && gone.contains(nameOf(elements[i], i)))
                indices.insert(i);
    };
    const auto own = [](const auto& element, std::size_t) { return element.name; };
    const auto multipliers = [](const auto& element, std::size_t i) {
        return physics::multiplierName(element, i);
    };
    add(scene.joints, released.joints, own);
    add(scene.gears, released.gears, own);
    add(scene.ropes, released.ropes, own);
    add(scene.links, released.links, multipliers);
    add(scene.forces, released.forces, multipliers);
    return released;
}

} // namespace simulation
