#include "run/stops.h"

#include "physics/blame.h"
#include "run/squeezed.h"
#include "scene/joint_types.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace simulation {
namespace {

constexpr double largest = solution::largestValue;

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string sentenceAt(double time, const std::string& reason) {
    return "Stopped at t = " + number(time) + ": " + reason + ".";
}

// Values of unknowns a little after a stop, or before it.
physics::Instant instantOf(const Problem& problem, const solution::Histories& histories,
                           double stop, double time) {
    const auto value = [&problem, &histories, stop, time](std::size_t i) {
        const double found =
            time <= stop ? histories.value(i, time)
                         : 2 * histories.value(i, stop) -
                               histories.value(i, std::max(problem.start(), 2 * stop - time));
        // Of what is not solved any value will do.
        return std::isnan(found) ? problem.equations.set.unknowns[i].initial : found;
    };
    return {.value = value, .time = time};
}

// Forces that are not finite at the end, or just after it; else, if asked, the one that grew much
// over the last tenth.
std::vector<physics::Blame> blamesFor(const Problem& problem, const physics::Suspects& suspects,
                                      const solution::Histories& histories,
                                      const std::vector<std::size_t>& bodies, double stop,
                                      bool orGrowing) {
    for (const double part : {0.0, 1e-12, 1e-9, 1e-6}) {
        const double time = stop + part * std::max(1.0, std::abs(stop));
        auto found = suspects.notFinite(instantOf(problem, histories, stop, time), bodies);
        if (!found.empty())
            return found;
    }
    if (!orGrowing)
        return {};
    const double earlier = stop - (stop - problem.start()) / 10;
    if (const auto grown = suspects.growing(instantOf(problem, histories, stop, earlier),
                                            instantOf(problem, histories, stop, stop), bodies))
        return {*grown};
    return {};
}

Stop::Culprit culpritOf(const Problem& problem, const physics::Blame& blame) {
    const auto& contributions = problem.equations.contributions;
    const physics::Contribution& c = contributions[blame.contribution];
    Stop::Culprit culprit{.body = problem.scene.bodies[c.body].name,
                          .isLink = c.kind == physics::Contribution::Kind::link,
                          .nth = 0,
                          .option = physics::optionOf(blame)};
    const auto names = [&](const scene::Link& link) {
        const auto* other = std::get_if<scene::BodyEnd>(&link.second);
        return link.first.body == culprit.body || (other && other->body == culprit.body);
    };
    for (std::size_t e = 0; e < c.element; ++e)
        if (culprit.isLink ? names(problem.scene.links[e])
                           : problem.scene.forces[e].body == culprit.body)
            ++culprit.nth;
    return culprit;
}

// What an author can do about it.
std::string adviceFor(solution::Stop::Reason reason, bool isBlamed, bool isWritten) {
    using Reason = solution::Stop::Reason;
    switch (reason) {
    case Reason::notFinite:
    case Reason::contradiction:
    case Reason::overflow:
    case Reason::stepUnderflow:
    case Reason::notConverged:
        return !isBlamed ? ""
               : isWritten
                   ? "; keep that expression finite there (with ?: or max, say), or let the "
                     "motion finish before (-finish)"
                   : "; let the motion finish before (-finish)";
    case Reason::tooManySteps:
        return "; ask for less accuracy (-accuracy), or let the motion finish before (-finish)";
    case Reason::decisions:
        return "; replace the jump of the expression by a short, steep slope";
    case Reason::bounds:
        return "; ask for another accuracy (-accuracy), or let the motion finish before (-finish)";
    default:
        return "";
    }
}

// "-max_motor 10, -limits {-1 0.5}": what bounds the forces of a joint's coordinate.
std::string boundsOf(const scene::Joint& joint, std::size_t place) {
    const scene::JointCoordinate& c = joint.coordinates[place];
    const std::string suffix = scene::coordinateSuffix(joint.type, place);
    std::string text;
    const auto add = [&](const char* option, const std::string& value) {
        text += (text.empty() ? "" : ", ") + std::string(option) + suffix + " " + value;
    };
    const auto end = [](const std::optional<double>& at) { return at ? number(*at) : "{}"; };
    if (c.maxMotor)
        add("-max_motor", number(*c.maxMotor));
    if (c.friction > 0)
        add("-friction", number(c.friction));
    if (c.lower || c.upper)
        add("-limits", "{" + end(c.lower) + " " + end(c.upper) + "}");
    return text;
}

// A drive that goes on against the stops of its own joint, with whatever force that takes.
bool isDrivenIntoStops(const scene::JointCoordinate& c) {
    return (c.speed || c.position) && !c.maxMotor && (c.lower || c.upper);
}

// The bounds of the joints whose forces were not found, and a remedy.
struct Bounded {
    std::string bounds, remedy; // clauses; "": none
};

Bounded boundedIn(const Problem& problem, const solution::Stop& stop) {
    std::string bounds, remedy;
    std::vector<std::string> told;
    for (const std::size_t unknown : stop.culprits) {
        const std::string& name = problem.equations.set.unknowns[unknown].name;
        const scene::Joint* joint = scene::findJoint(problem.scene, name);
        if (!joint || std::ranges::find(told, name) != told.end())
            continue;
        told.push_back(name);
        for (std::size_t place = 0; place < joint->coordinates.size(); ++place) {
            const scene::JointCoordinate& c = joint->coordinates[place];
            if (const std::string text = boundsOf(*joint, place); !text.empty())
                bounds += (bounds.empty() ? "; " : ", ") + name + " has " + text;
            if (remedy.empty() && isDrivenIntoStops(c))
                remedy = std::string(c.position ? "; -position" : "; -speed") +
                         scene::coordinateSuffix(joint->type, place) + " of " + name +
                         " goes on against its -limits with whatever force it takes: let it stay "
                         "within them, or give it -max_motor";
        }
    }
    // Several joints may contradict each other, whatever bounds stand beside.
    if (stop.reason == solution::Stop::Reason::contradiction && (remedy.empty() || told.size() > 1))
        return {};
    return {bounds, remedy};
}

bool isAnyOf(const scene::Scene& scene, const std::vector<std::size_t>& bodies,
             const std::string& name) {
    return std::ranges::any_of(bodies, [&](std::size_t b) { return scene.bodies[b].name == name; });
}

bool isJointOf(const scene::Scene& scene, const std::vector<std::size_t>& bodies,
               const scene::Joint& joint) {
    return isAnyOf(scene, bodies, joint.body1) ||
           (joint.body2 && isAnyOf(scene, bodies, *joint.body2));
}

bool isNumber(const scene::Expression& expression) {
    const std::string& text = expression;
    double value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size();
}

// The one joint that drives a linkage of these bodies, at a speed that never fails, where nothing
// else moves them in its own way; null: there is none.
const scene::Joint* lockedDrive(const Problem& problem, const std::vector<std::size_t>& bodies) {
    constexpr std::ptrdiff_t least = 3; // joints of a linkage
    const scene::Scene& scene = problem.scene;
    const auto drives = drivenOf(scene, bodies);
    const auto joints = std::ranges::count_if(
        scene.joints, [&](const auto& one) { return isJointOf(scene, bodies, one); });
    const auto isHeld = [&](const std::string& body) { return isAnyOf(scene, bodies, body); };
    if (drives.size() != 1 || joints < least || !scene.gears.empty() ||
        std::ranges::any_of(scene.constraints, isHeld, &scene::Constraint::body))
        return nullptr;
    for (const scene::JointCoordinate& c : drives[0]->coordinates)
        if (c.position || (c.speed && !isNumber(*c.speed)))
            return nullptr;
    return drives[0];
}

struct Known { // of the motion
    const solution::Histories& histories;
    const ContactLog& contacts;
};

struct Why {
    std::string reason; // no time in it
    std::optional<Stop::Culprit> culprit = {};
};

Why whyOf(const Problem& problem, const physics::Suspects& suspects, const Known& known,
          const std::vector<std::size_t>& owners, const solution::Stop& stop) {
    using Reason = solution::Stop::Reason;
    const solution::Histories& histories = known.histories;
    std::string reason = stop.sentence;
    std::vector<physics::Blame> blames;
    std::vector<std::size_t> bodies;
    for (const std::size_t unknown : stop.unknowns)
        bodies.push_back(owners[unknown]);
    std::ranges::sort(bodies);
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    if (stop.reason == Reason::unheld && stop.culprits.empty()) // contacts alone
        if (auto squeezed = squeezedAt(problem, histories, known.contacts, bodies, stop.time))
            return {.reason = std::move(*squeezed)};
    const bool contradicts = stop.reason == Reason::contradiction;
    if (contradicts || stop.reason == Reason::notFinite || stop.reason == Reason::overflow ||
        stop.reason == Reason::stepUnderflow || stop.reason == Reason::notConverged)
        blames = blamesFor(problem, suspects, histories, bodies, stop.time, !contradicts);
    // Beside a flat linkage forces grow without a limit where no force has a fault of its own.
    if ((contradicts || stop.reason == Reason::notFinite) && blames.empty() &&
        areSingular(problem.scene, bodies))
        reason =
            reason.substr(0, reason.find(", which")) +
            ": there are several solutions: the joints stand in a singular position, as a flat "
            "linkage does, from which they can move in two ways; let them start a little "
            "beside it";
    else if (const scene::Joint* drive = lockedDrive(problem, bodies);
             drive && blames.empty() && stop.time > problem.start() &&
             (contradicts || stop.reason == Reason::notFinite))
        reason = reason.substr(0, reason.find(", which")) +
                 ": the joints lock there, and joint \"" + drive->name +
                 "\" drives on, as a crank that is longer than its rod does; make a part longer, "
                 "or give it a -motor in place of its -speed or -position";
    if (stop.reason == Reason::unheld)
        reason += ": there is no solution";
    Bounded bounded;
    if (stop.reason == Reason::unheld || stop.reason == Reason::bounds ||
        (contradicts && blames.empty()))
        bounded = boundedIn(problem, stop);
    reason += bounded.bounds;
    std::string named;
    bool isWritten = false;
    std::vector<std::string> told; // once, though it is on several bodies
    for (const physics::Blame& blame : blames) {
        isWritten = isWritten || physics::hasExpression(problem.equations, blame);
        std::string words = physics::inWords(problem.scene, problem.equations, blame);
        if (std::ranges::find(told, words) != told.end())
            continue;
        named += (named.empty() ? "" : "; ") + words;
        told.push_back(std::move(words));
    }
    if ((contradicts || stop.reason == Reason::notFinite) && !named.empty())
        reason = named;
    else if (!named.empty())
        reason += ", since " + named;
    Why why{.reason =
                reason + (bounded.remedy.empty() ? adviceFor(stop.reason, !named.empty(), isWritten)
                                                 : bounded.remedy)};
    using enum physics::Contribution::Kind;
    if (!blames.empty()) {
        const auto kind = problem.equations.contributions[blames[0].contribution].kind;
        if (kind == force || kind == link)
            why.culprit = culpritOf(problem, blames[0]);
    }
    return why;
}

// What ended first, of which the others read that it had ended.
const solution::Stop& rootOf(const solution::Histories& histories, const solution::Stop& stop) {
    const solution::Stop* root = &stop;
    for (std::size_t i = 0; i < histories.stops().size(); ++i) { // no longer than there are links
        if (root->reason != solution::Stop::Reason::inputEnded || root->culprits.empty())
            break;
        const solution::Stop* before = histories.stop(root->culprits[0]);
        if (!before)
            break;
        root = before;
    }
    return *root;
}

Stop stopOf(const Problem& problem, const physics::Suspects& suspects, const Known& known,
            const std::vector<std::size_t>& owners, const solution::Stop& stop) {
    const solution::Stop& root = rootOf(known.histories, stop);
    Why why = whyOf(problem, suspects, known, owners, root);
    if (owners[root.unknowns[0]] != owners[stop.unknowns[0]])
        why.reason = stop.sentence + ": " + why.reason;
    return {.time = stop.time,
            .sentence = sentenceAt(stop.time, why.reason),
            .culprit = std::move(why.culprit)};
}

// Of which the steps take most.
std::size_t largestBody(const Problem& problem, const solution::Histories& histories) {
    std::size_t found = 0, most = 0;
    for (std::size_t b = 0; b < problem.bodies->size(); ++b) {
        const BodyRecord& body = (*problem.bodies)[b];
        std::size_t bytes = 0;
        for (std::size_t i = 0; i < physics::bodyUnknowns && !body.isFixed; ++i)
            bytes += histories.bytesOf(body.firstUnknown + i);
        if (bytes > most) {
            found = b;
            most = bytes;
        }
    }
    return found;
}

Stop fullStop(const Problem& problem, const solution::Histories& histories,
              const solution::Stop& stop) {
    const std::string& name = problem.scene.bodies[largestBody(problem, histories)].name;
    return {.time = stop.time,
            .sentence = sentenceAt(
                stop.time,
                stop.sentence + ", most of it for body \"" + name +
                    "\"; let its forces and trajectories change more slowly, ask for less accuracy "
                    "(-accuracy), or let the motion finish before (-finish); asgard "
                    "simulate --memory allows more"),
            .culprit = {}};
}

// Of what is solved, by body.
std::map<std::size_t, Stop> solversStops(const Problem& problem, const Known& known) {
    const solution::Histories& histories = known.histories;
    std::map<std::size_t, Stop> stops;
    if (histories.stops().empty())
        return stops;
    const std::vector<std::size_t> owners = ownersOf(problem);
    const physics::Suspects suspects(problem.scene, problem.equations);
    std::optional<Stop> full;
    for (const solution::Stop& stop : histories.stops()) {
        const bool isFull = stop.reason == solution::Stop::Reason::tooMuchKept;
        if (isFull && !full)
            full = fullStop(problem, histories, stop);
        std::optional<Stop> told; // once for all bodies that stop together
        if (isFull)
            told = full;
        for (const std::size_t unknown : stop.unknowns) {
            const std::size_t body = owners[unknown];
            const auto place = stops.find(body);
            if (place != stops.end() && !(stop.time < place->second.time))
                continue;
            if (!told)
                told = stopOf(problem, suspects, known, owners, stop);
            stops[body] = *told;
        }
    }
    return stops;
}

// When a polynomial goes over the largest value that a motion has; none: not up to there.
std::optional<double> overflowOf(const solution::Piece& piece, double until) {
    const double from = piece.origin;
    const auto isOver = [&](double t) { return !(std::abs(piece.value(t)) <= largest); };
    const auto mayBeOver = [&](double t) {
        const auto [low, high] = piece.bounds(from, t);
        return !(low >= -largest && high <= largest);
    };
    if (!(until > from) || !mayBeOver(until))
        return std::nullopt;
    // It is not over as long as its bounds are not; from there on, times in a geometric row.
    constexpr int halvings = 400, looks = 200;
    double within = 0, over = until - from;
    for (int i = 0; i < halvings && over > within * (1 + 1e-15); ++i) {
        const double middle = within > 0 ? std::sqrt(within) * std::sqrt(over) : 1e-8 * over;
        if (middle <= within || middle >= over)
            break;
        (mayBeOver(from + middle) ? over : within) = middle;
    }
    const double ratio = std::pow((until - from) / over, 1.0 / looks);
    double before = within;
    for (double after = over; before < until - from; after *= ratio) {
        after = std::min(after, until - from);
        if (isOver(from + after)) {
            for (int i = 0; i < halvings; ++i) {
                const double middle = (before + after) / 2;
                if (middle <= before || middle >= after)
                    break;
                (isOver(from + middle) ? after : before) = middle;
            }
            return from + before;
        }
        before = after;
        if (!(ratio > 1))
            break;
    }
    return std::nullopt;
}

// Motion in closed form goes on for ever, and is looked at here. LIMIT: only what it does last: to
// come back from beyond, where nothing is, takes a scene that starts there.
void addOverflows(const Problem& problem, const solution::Histories& histories, double until,
                  std::map<std::size_t, Stop>& stops) {
    for (std::size_t b = 0; b < problem.bodies->size(); ++b) {
        const BodyRecord& body = (*problem.bodies)[b];
        std::optional<double> earliest;
        for (std::size_t i = 0; !body.isFixed && i < physics::qw; ++i) {
            const std::size_t unknown = body.firstUnknown + i;
            if (histories.stop(unknown) || histories.reached(unknown) < until)
                continue;
            const auto over = overflowOf(histories.piece(unknown, until), until);
            if (!over || (earliest && *earliest <= *over))
                continue;
            earliest = over;
            const auto known = stops.find(b);
            if (known == stops.end() || known->second.time > *over)
                stops[b] = {.time = *over,
                            .sentence =
                                sentenceAt(*over, problem.equations.set.unknowns[unknown].name +
                                                      " grows over 1e100")};
        }
    }
}

} // namespace

std::vector<const scene::Joint*> drivenOf(const scene::Scene& scene,
                                          const std::vector<std::size_t>& bodies) {
    const auto isDriven = [](const scene::JointCoordinate& c) { return c.speed || c.position; };
    std::vector<const scene::Joint*> driven;
    for (const scene::Joint& joint : scene.joints)
        if (isJointOf(scene, bodies, joint) && std::ranges::any_of(joint.coordinates, isDriven))
            driven.push_back(&joint);
    return driven;
}

bool areSingular(const scene::Scene& scene, const std::vector<std::size_t>& bodies) {
    return std::ranges::any_of(scene.joints,
                               [&](const auto& one) { return isJointOf(scene, bodies, one); }) &&
           drivenOf(scene, bodies).empty() &&
           std::ranges::none_of(
               scene.constraints,
               [&](const std::string& body) { return isAnyOf(scene, bodies, body); },
               &scene::Constraint::body);
}

std::map<std::size_t, Stop> stopsOf(const Problem& problem, const solution::Histories& histories,
                                    const ContactLog& contacts, double until) {
    std::map<std::size_t, Stop> stops = solversStops(problem, {histories, contacts});
    addOverflows(problem, histories, until, stops);
    return stops;
}

} // namespace simulation
