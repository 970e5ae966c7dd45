#include "contacts/contact_set.h"

#include "surfaces/surface_pieces.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace simulation {

using solution::Histories;
using solution::infinity;

namespace {

std::shared_ptr<const physics::ContactSurfaces> surfacesOf(const physics::ContactPlace& place) {
    physics::ContactSurfaces made{.gaps = {},
                                  .normal = place.normal,
                                  .friction = place.friction.sticking,
                                  .bodySurface = place.friction.bodySurface,
                                  .supportSurface = place.friction.supportSurface,
                                  .resolution = place.leaving};
    for (const physics::ContactPoint& point : place.points)
        made.gaps.push_back(point.gap);
    return std::make_shared<const physics::ContactSurfaces>(std::move(made));
}

} // namespace

bool ContactSet::areIn(std::size_t a, std::size_t b) const {
    return std::ranges::any_of(contacts_,
                               [&](const Contact& c) { return c.has(a) && c.has(b) && a != b; });
}

bool ContactSet::areIn(std::size_t a, std::size_t partA, std::size_t b, std::size_t partB) const {
    return std::ranges::any_of(contacts_, [&](const Contact& c) {
        const std::array is{c.of.place.body, c.of.bodyPart, c.of.place.support, c.of.supportPart};
        return is == std::array{a, partA, b, partB} || is == std::array{b, partB, a, partA};
    });
}

std::set<std::size_t> ContactSet::island(std::set<std::size_t> bodies) const {
    const auto isMoving = [&](std::size_t body) {
        return !world_.isFixed(body) && bodies.contains(body);
    };
    for (std::size_t before = 0; before != bodies.size();) {
        before = bodies.size();
        for (const Contact& contact : contacts_)
            if (isMoving(contact.of.place.body) || isMoving(contact.of.place.support))
                bodies.insert({contact.of.place.body, contact.of.place.support});
    }
    std::erase_if(bodies, [&](std::size_t body) { return world_.isFixed(body); });
    return bodies;
}

std::map<std::size_t, std::vector<std::size_t>> ContactSet::supports() const {
    std::map<std::size_t, std::vector<std::size_t>> supports;
    for (const Contact& contact : contacts_) {
        auto& known = supports[contact.of.place.body];
        if (std::ranges::find(known, contact.of.place.support) == known.end())
            known.push_back(contact.of.place.support);
    }
    return supports;
}

std::vector<ContactSet::Parts> ContactSet::parts() const {
    std::vector<Parts> found;
    for (const Contact& contact : contacts_)
        found.push_back({contact.of.place.body, contact.of.bodyPart, contact.of.place.support,
                         contact.of.supportPart, contact.from});
    return found;
}

void ContactSet::forget(std::size_t body) {
    std::erase_if(contacts_, [&](const Contact& contact) { return contact.has(body); });
    noteBodies();
}

// Once gone it stays so: the first of the steps at whose begin it is.
std::optional<double> goneFrom(const Histories& histories, std::size_t row, double from,
                               double until) {
    if (row >= histories.unknowns() || histories.value(row, until) != solution::releasedMode)
        return std::nullopt;
    const Histories::Place place = histories.place(row, until);
    if (place.history->empty()) // of what an event has just made
        return std::nullopt;
    std::size_t step = place.history->find(until);
    double since = place.history->origin(step);
    while (step > 0 && place.history->origin(step) > from) {
        const solution::Piece before = place.history->piece(step - 1, place.column);
        if (before.value(before.origin) != solution::releasedMode)
            break;
        since = place.history->origin(--step);
    }
    return std::max(since, from);
}

std::optional<ContactSet::Change> ContactSet::firstChange(const Histories& histories,
                                                          double until) const {
    std::optional<Change> first;
    const auto note = [&](double time, const Contact& contact) {
        if (time <= until && (!first || time < first->time))
            first = {.time = time,
                     .bodies = std::minmax(contact.of.place.body, contact.of.place.support)};
    };
    for (const Contact& contact : contacts_) {
        note(contact.phase, contact);
        for (std::size_t k = 0; k < contact.of.place.points.size() && !contact.rows.empty(); ++k)
            if (const auto gone = goneFrom(histories, contact.rows[k], contact.from, until))
                note(*gone, contact);
        if (const auto tips = tipsFrom(histories, contact, until))
            note(tips->time, contact);
    }
    return first;
}

// At the begin of the first of the steps at which it does.
std::optional<ContactSet::Tipping> ContactSet::tipsFrom(const Histories& histories,
                                                        const Contact& contact, double until) {
    if (!contact.of.stand.stands || contact.rows.empty())
        return std::nullopt;
    std::vector<Histories::Place> places;
    for (std::size_t k = 0; k < contact.of.place.points.size(); ++k) {
        if (contact.rows[k] >= histories.unknowns())
            return std::nullopt;
        places.push_back(histories.place(contact.rows[k], until));
        if (places[k].history->empty() || places[k].history != places[0].history)
            return std::nullopt;
    }
    const auto& history = *places[0].history;
    const std::size_t last = history.find(until);
    Tipping tipping{.time = contact.from, .stand = contact.of.stand};
    Contact::Looked& looked = contact.looked;
    const bool isThere = looked.history == &history && looked.step <= last &&
                         history.origin(looked.step) == looked.origin;
    for (std::size_t step = isThere ? looked.step : history.find(contact.from); step <= last;
         ++step) {
        tipping.stand.carries.clear();
        for (const Histories::Place& place : places) {
            const solution::Piece piece = history.piece(step, place.column);
            tipping.stand.carries.push_back(piece.value(piece.origin) == solution::heldMode ? 1
                                                                                            : 0);
        }
        if (tipping.stand.tipsEarly()) {
            tipping.time = std::max(history.origin(step), contact.from);
            return tipping;
        }
    }
    looked = {.history = &history, .step = last, .origin = history.origin(last)};
    return std::nullopt;
}

std::vector<Stand> ContactSet::standsOf(const Histories& histories, std::size_t a, std::size_t b,
                                        double time) const {
    std::vector<Stand> stands;
    for (const Contact& contact : contacts_) {
        const auto isGone = [&](std::size_t row) {
            return row >= histories.unknowns() ||
                   histories.value(row, time) == solution::releasedMode;
        };
        const std::size_t points = std::min(contact.of.place.points.size(), contact.rows.size());
        if (!contact.has(a) || !contact.has(b) || !contact.of.stand.stands ||
            std::ranges::any_of(std::span(contact.rows).first(points), isGone))
            continue;
        const auto tipping = tipsFrom(histories, contact, time);
        Stand& stand = stands.emplace_back(tipping ? tipping->stand : contact.of.stand);
        stand.bodyPart = contact.of.bodyPart;
        stand.supportPart = contact.of.supportPart;
    }
    return stands;
}

std::size_t ContactSet::ownerOf(const Contact& contact) const {
    const auto [body, support] = std::pair(contact.of.place.body, contact.of.place.support);
    return world_.isFixed(body) ? support : body;
}

void ContactSet::noteBodies() {
    bodies_.clear();
    for (const Contact& contact : contacts_)
        bodies_.insert({contact.of.place.body, contact.of.place.support});
}

namespace {

bool areLike(const physics::SurfaceGap& a, const physics::SurfaceGap& b, double size) {
    return isOnePiece(a.body, b.body, size) && isOnePiece(a.support, b.support, size);
}

bool areLike(const LastingContact& a, const LastingContact& b) {
    if (a.place.body != b.place.body || a.place.support != b.place.support ||
        a.bodyPart != b.bodyPart || a.supportPart != b.supportPart ||
        a.place.points.size() != b.place.points.size())
        return false;
    for (std::size_t k = 0; k < a.place.points.size(); ++k)
        if (!areLike(a.place.points[k].gap, b.place.points[k].gap, a.place.size))
            return false;
    return true;
}

} // namespace

bool ContactSet::isLike(std::span<const std::size_t> bodies,
                        std::span<const LastingContact> contacts) const {
    std::size_t count = 0;
    for (const Contact& contact : contacts_) {
        if (std::ranges::none_of(bodies, [&](std::size_t body) { return contact.has(body); }))
            continue;
        ++count;
        if (std::ranges::none_of(
                contacts, [&](const LastingContact& other) { return areLike(contact.of, other); }))
            return false;
    }
    return count == contacts.size();
}

void ContactSet::set(std::span<const std::size_t> bodies, std::vector<LastingContact> contacts,
                     double time, const std::function<double(std::size_t body)>& nextPhase) {
    concerned_.insert(bodies.begin(), bodies.end());
    const auto isOf = [&](const Contact& contact) {
        return std::ranges::any_of(bodies, [&](std::size_t b) { return contact.has(b); });
    };
    for (const Contact& contact : contacts_) {
        if (!isOf(contact))
            continue;
        concerned_.insert({contact.of.place.body, contact.of.place.support});
        for (std::size_t k = 0; k < contact.rows.size(); ++k)
            ended_.emplace_back(roleOf(contact, k), contact.rows[k]);
    }
    std::erase_if(contacts_, isOf);
    for (LastingContact& of : contacts) {
        concerned_.insert({of.place.body, of.place.support});
        const double phase = std::min(nextPhase(of.place.body), nextPhase(of.place.support));
        auto surfaces = surfacesOf(of.place);
        contacts_.push_back({.of = std::move(of),
                             .surfaces = std::move(surfaces),
                             .rows = {},
                             .from = time,
                             .phase = phase});
    }
    noteBodies();
}

void ContactSet::giveRows(Contact& contact, solution::EquationsInForce& equations,
                          solution::Changes& changes) {
    expression::EquationSet& set = equations.changing();
    const std::size_t owner = ownerOf(contact);
    const std::string name =
        world_.name(contact.of.place.body) + " on " + world_.name(contact.of.place.support);
    for (std::size_t k = 0; k < contact.of.place.rows(); ++k) {
        std::vector<std::size_t>& unused = unused_[roleOf(contact, k)];
        if (!unused.empty()) {
            contact.rows.push_back(unused.front());
            unused.erase(unused.begin());
            set.unknowns[contact.rows.back()].name = name;
            continue;
        }
        const std::size_t row = set.unknowns.size() + changes.additions.size();
        contact.rows.push_back(row);
        expression::Unknown unknown;
        unknown.name = name; // in sentences; the symbol is one for each row
        unknown.symbol = set.graph.symbol(world_.name(owner) + ".contact" + std::to_string(row));
        unknown.phases.emplace_back();
        unknown.phases[0].derivative = set.graph.constant(0);
        unknown.phases[0].given = set.graph.constant(0);
        changes.additions.push_back({std::move(unknown), world_.records[owner].firstUnknown});
    }
}

ContactSet::Role ContactSet::roleOf(const Contact& contact, std::size_t place) const {
    const physics::ContactPlace& of = contact.of.place;
    const std::size_t points = of.points.size(), rolling = of.rows() - (of.rolls() ? 2 : 0);
    constexpr std::size_t friction = 1, turning = 4; // the first of each
    return {ownerOf(contact), place < points    ? 0
                              : place < rolling ? friction + place - points
                                                : turning + place - rolling};
}

bool ContactSet::isConcerned(const Pair& pair, std::size_t index) const {
    const auto isIt = [&](std::size_t body) {
        return !world_.isFixed(body) && concerned_.contains(body);
    };
    return world_.equations.scope->contacts()[index] && (isIt(pair.first) || isIt(pair.second));
}

std::vector<std::size_t> ContactSet::concernedReaders() const {
    std::vector<std::size_t> readers;
    const auto& named = world_.pairs.all();
    if (std::ranges::any_of(named,
                            [this](const auto& of) { return isConcerned(of.first, of.second); }))
        for (const physics::ContactReader& reader : world_.equations.contactReaders)
            readers.push_back(reader.unknown);
    return readers;
}

// The named contacts of bodies that are concerned: what all contacts of a pair do together.
void ContactSet::writeReadings(physics::ContactRows& rows, std::span<const Written> written,
                               expression::EquationSet& set, solution::Changes& changes) const {
    expression::Graph& g = set.graph;
    for (const auto& [pair, index] : world_.pairs.all()) {
        const auto& nodes = world_.equations.scope->contacts()[index];
        if (!isConcerned(pair, index))
            continue;
        physics::ContactForces::Nodes sum;
        sum.fill(g.constant(0));
        int count = 0;
        for (const Written& one : written) {
            const physics::ContactPlace& place = one.contact->of.place;
            if (Pair(std::minmax(place.body, place.support)) != pair)
                continue;
            ++count;
            const auto part = rows.forcesOf(place, one.multipliers, nodes->moving).nodes();
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] = g.add(sum[i], part[i]);
        }
        const bool isOnFirst = world_.name(nodes->moving) == world_.scene.contacts[index].body1;
        const std::size_t first = physics::firstReadingOf(set, *nodes);
        using Forces = physics::ContactForces;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            if (i >= Forces::firstOfSlip && count > 1)
                sum[i] = g.divide(sum[i], g.constant(count));
            const bool isForce = i >= Forces::firstOfForce && i < Forces::firstOfMoment;
            changes.readings.push_back(
                {first + i, isForce && !isOnFirst ? g.negate(sum[i]) : sum[i]});
        }
    }
}

void ContactSet::note(double time, std::span<const Written> written,
                      std::span<const std::size_t> moving) {
    ContactLog::Entry entry{.time = time, .moving = {moving.begin(), moving.end()}, .contacts = {}};
    for (const Written& one : written) {
        const physics::ContactPlace& place = one.contact->of.place;
        const auto& rows = one.contact->rows;
        const auto normals = static_cast<std::ptrdiff_t>(place.points.size());
        const auto rolling = static_cast<std::ptrdiff_t>(rows.size()) - (place.rolls() ? 2 : 0);
        entry.contacts.push_back({.bodies = std::minmax(place.body, place.support),
                                  .normals = {rows.begin(), rows.begin() + normals},
                                  .friction = {rows.begin() + normals, rows.begin() + rolling},
                                  .body = place.body,
                                  .support = place.support,
                                  .surfaces = one.contact->surfaces});
    }
    log_.add(std::move(entry));
}

// The given unknowns that read contacts.
void ContactSet::writeReaders(double time, expression::EquationSet& set,
                              solution::Changes& changes) const {
    if (world_.equations.contactReaders.empty() || changes.readings.empty())
        return;
    std::unordered_map<std::uint32_t, expression::Node> now;
    for (const expression::Reading& reading : set.readings)
        now[reading.symbol.index] = reading.valueAt(time).node;
    for (const solution::Changes::Reading& changed : changes.readings)
        now[set.readings[changed.reading].symbol.index] = changed.node;
    for (const physics::ContactReader& reader : world_.equations.contactReaders) {
        expression::Phase phase;
        phase.from = time;
        phase.derivative = set.graph.constant(0);
        phase.given = substitute(set.graph, reader.value, now);
        changes.equations.push_back({reader.unknown, std::move(phase), {}});
    }
}

void ContactSet::write(double time, solution::EquationsInForce& equations,
                       solution::Changes& changes) {
    expression::EquationSet& set = equations.changing();
    expression::Graph& g = set.graph;
    std::set<std::size_t> ending;
    for (const auto& [role, row] : ended_) {
        unused_[role].push_back(row);
        std::ranges::sort(unused_[role]);
        ending.insert(row);
    }
    ended_.clear();
    std::vector<std::size_t> moving;
    for (const std::size_t body : concerned_)
        if (!world_.isFixed(body))
            moving.push_back(body);
    physics::ContactRows rows(set, world_.equations, time);
    std::vector<Written> written;
    for (Contact& contact : contacts_) {
        if (std::ranges::none_of(moving, [&](std::size_t body) { return contact.has(body); }))
            continue;
        if (contact.rows.empty())
            giveRows(contact, equations, changes);
        std::vector<expression::Node> multipliers;
        for (const std::size_t row : contact.rows) {
            ending.erase(row);
            const std::size_t known = set.unknowns.size();
            multipliers.push_back(row < known ? set.unknowns[row].symbol
                                              : changes.additions[row - known].unknown.symbol);
        }
        rows.addContact(contact.of.place, multipliers);
        written.push_back({&contact, std::move(multipliers)});
    }
    for (physics::ContactRows::Equation& equation : rows.velocities(moving))
        changes.equations.push_back(
            {equation.unknown, std::move(equation.phase), std::move(equation.later)});
    const std::vector<expression::Phase> conditions = rows.conditions();
    std::size_t next = 0;
    for (const Written& one : written)
        for (const std::size_t row : one.contact->rows) {
            changes.equations.push_back({row, conditions[next++], {}});
            changes.jumps.push_back({row, 0}); // whatever its last contact was
        }
    note(time, written, moving);
    writeReadings(rows, written, set, changes);
    writeReaders(time, set, changes);
    for (physics::ContactRows::Equation& equation : rows.others(moving))
        changes.equations.push_back(
            {equation.unknown, std::move(equation.phase), std::move(equation.later)});
    for (const std::size_t row : ending) {
        expression::Phase none;
        none.derivative = g.constant(0);
        none.given = g.constant(0);
        changes.equations.push_back({row, none, {}});
    }
    concerned_.clear();
}

} // namespace simulation
