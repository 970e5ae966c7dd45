#include "modes/guards.h"

#include <algorithm>
#include <cmath>

namespace solution {

using expression::Node;

void Guards::refresh() {
    watches_.clear();
    active_.refresh();
    const auto slides = [this](std::size_t s) { return mode_.slidesOn(s); };
    for (std::size_t s = 0; s < model_.surfaces().size(); ++s)
        if (!slides(s))
            mode_.coincident[s].clear();
    const bool mayVary = model_.readSurfaces().mayVary();
    const std::vector<bool> read =
        mayVary ? model_.readSurfaces().on(mode_.decisions) : std::vector<bool>();
    for (std::size_t s = 0; s < model_.surfaces().size(); ++s) {
        if (mode_.isCoincident(s))
            continue;
        if (!slides(s)) {
            if (!mayVary || read[s])
                watches_.push_back({Watch::Kind::side, s});
            continue;
        }
        watches_.push_back({Watch::Kind::least, s});
        watches_.push_back({Watch::Kind::most, s});
    }
}

void Guards::watch(double t, std::span<const double> y, std::span<double> values) {
    f_.fill(t, y);
    const bool isPossible = !mode_.isHeld() || field_.weigh();
    for (std::size_t k = 0; k < mode_.sticking.size(); ++k)
        values[watches_.size() + k] = !isPossible ? -1
                                      : mode_.sticking[k] == mode_.leaving
                                          ? stick_.leeway()
                                          : -field_.excess(mode_.sticking[k]);
    if (!mode_.isHeld() && f_.bound()->laws.size() > 0)
        field_.findOutputs(); // guards may read them
    active_.watch(values.subspan(watches_.size() + mode_.sticking.size()));
    f_.evaluateGuards();
    for (std::size_t k = 0; k < watches_.size(); ++k) {
        const auto [kind, s] = watches_[k];
        const Surface& surface = model_.surfaces()[s];
        const double g = f_.guard(s);
        if (mode_.decisions[surface.members[0].decision] == expression::noBranch) {
            values[k] = 1;
        } else if (kind != Watch::Kind::side) {
            const auto place =
                std::find(mode_.sliding.begin(), mode_.sliding.end(), s) - mode_.sliding.begin();
            const double w =
                isPossible ? f_.weights()[static_cast<std::size_t>(place)] : -1; // it leaves
            values[k] = (kind == Watch::Kind::least ? w : 1 - w) +
                        (mode_.isGrazed[s] ? ModelFunctions::standing : 0);
        } else if (surface.whole) {
            const auto taken = static_cast<double>(mode_.decisions[surface.members[0].decision]);
            values[k] =
                g +
                (mode_.isGrazed[s] ? ModelFunctions::standing * std::max(1.0, std::abs(taken)) : 0);
        } else if (mode_.sides[s] == Mode::onSurface) {
            values[k] = ModelFunctions::standing - std::abs(g);
        } else {
            values[k] = mode_.sides[s] * g + (mode_.isGrazed[s] ? ModelFunctions::standing : 0);
        }
    }
}

std::optional<double> Guards::watchOfPlaces(std::size_t k, double t, std::span<const double> y) {
    const std::size_t first = watches_.size() + mode_.sticking.size();
    if (k < first || active_.readsForces(k - first))
        return std::nullopt;
    f_.fill(t, y);
    return active_.watchOfPlaces(k - first);
}

bool Guards::leadsInside(const Watch& watch, std::span<const double> rates) {
    const Surface& surface = model_.surfaces()[watch.surface];
    if (watch.kind != Watch::Kind::side || surface.whole ||
        mode_.sides[watch.surface] == Mode::onSurface)
        return false;
    const GuardSlope slope = f_.guardRate(watch.surface, rates);
    return !slope.still && slope.rate * mode_.sides[watch.surface] > slope.noise;
}

bool Guards::contradicts(const Violation& violation, double t, std::span<const double> y) {
    if (unknownsOf(violation).empty()) // no polynomial of this component is in them
        return false;
    f_.fill(t, y);
    const std::vector<double> rates = field_.here();
    return std::ranges::all_of(violation.watches, [&](std::size_t k) {
        return k < watches_.size() && leadsInside(watches_[k], rates);
    });
}

bool Guards::grazesByRounding(const Violation& violation, double t, std::span<const double> y) {
    if (violation.watches.size() != 1)
        return false;
    if (const auto active = activeOf(violation); !active.empty()) {
        f_.fill(t, y);
        return active_.grazes(active[0]);
    }
    if (violation.watches[0] >= watches_.size())
        return false;
    const Watch& watch = watches_[violation.watches[0]];
    if (mode_.isGrazed[watch.surface] != 0 || mode_.wasPassed[watch.surface] != 0)
        return false;
    f_.fill(t, y);
    const std::vector<double> rates = field_.here();
    if (!leadsInside(watch, rates))
        return false;
    const GuardSlope slope = f_.guardRate(watch.surface, rates);
    if (!(std::abs(slope.value) <= slope.least))
        return false;
    mode_.setGrazed(watch.surface, true);
    return true;
}

std::vector<std::size_t> Guards::directionsOf(const Violation& violation) const {
    std::vector<std::size_t> found;
    for (const std::size_t k : violation.watches)
        if (k >= watches_.size() && k < watches_.size() + mode_.sticking.size())
            found.push_back(mode_.sticking[k - watches_.size()]);
    return found;
}

std::vector<std::size_t> Guards::activeOf(const Violation& violation) const {
    const std::size_t first = watches_.size() + mode_.sticking.size();
    std::vector<std::size_t> found;
    for (const std::size_t k : violation.watches)
        if (k >= first)
            found.push_back(k - first);
    return found;
}

bool Guards::readForces(const Violation& violation) const {
    const std::size_t first = watches_.size() + mode_.sticking.size();
    return std::ranges::all_of(violation.watches, [&](std::size_t k) {
        return k >= first && active_.readsForces(k - first);
    });
}

bool Guards::isOfPlaces(const Violation& violation) const {
    return std::ranges::any_of(activeOf(violation),
                               [this](std::size_t watch) { return active_.isOfPlaces(watch); });
}

bool Guards::isOffPlaces(const Violation& violation) {
    return std::ranges::any_of(activeOf(violation), [this](std::size_t watch) {
        return active_.isOfPlaces(watch) && active_.isOffPlace(watch);
    });
}

bool Guards::isBeyondPlaces(const Violation& violation) {
    return std::ranges::any_of(activeOf(violation), [this](std::size_t watch) {
        return active_.isOfPlaces(watch) && active_.watchOfPlaces(watch) < 0;
    });
}

std::vector<std::size_t> Guards::multipliersOf(const Violation& violation) const {
    std::vector<std::size_t> found;
    for (const std::size_t watch : activeOf(violation))
        found.push_back(active_.rowOf(watch));
    return found;
}

// Places among the symbols.
std::vector<std::size_t> Guards::symbolsOf(const Violation& violation) const {
    std::vector<Node> guards;
    guards.reserve(violation.watches.size());
    for (const std::size_t k : violation.watches)
        if (k < watches_.size())
            guards.push_back(model_.surfaces()[watches_[k].surface].guard);
    for (const std::size_t direction : directionsOf(violation))
        guards.push_back(model_.directions().lengths[direction]);
    std::vector<std::size_t> found;
    for (const Node symbol : expression::symbolsOf(model_.graph(), guards))
        if (const auto place = model_.placeOf(symbol); place)
            found.push_back(*place);
    return found;
}

std::vector<std::size_t> Guards::surfacesOf(const Violation& violation) const {
    std::vector<std::size_t> found;
    for (const std::size_t k : violation.watches)
        if (k < watches_.size())
            found.push_back(watches_[k].surface);
    return found;
}

std::vector<std::size_t> Guards::unknownsOf(const Violation& violation) const {
    std::vector<std::size_t> found;
    for (const std::size_t place : symbolsOf(violation))
        if (place >= 1 && place <= f_.states().size())
            found.push_back(f_.states()[place - 1]);
    return found;
}

std::vector<std::size_t> Guards::inputsOf(const Violation& violation) const {
    std::vector<std::size_t> found;
    for (const std::size_t place : symbolsOf(violation))
        if (place > f_.states().size() && place < model_.variables())
            found.push_back(f_.inputs().unknowns()[place - 1 - f_.states().size()]);
    return found;
}

} // namespace solution
