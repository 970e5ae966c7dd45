#include "meetings/releases.h"

#include "contacts/contact_set.h"
#include "physics/forces.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <variant>

namespace simulation {
namespace {

// Unknowns by name: all multipliers of an element have its name.
std::unordered_map<std::string_view, std::vector<std::size_t>>
unknownsOf(const expression::EquationSet& set) {
    std::unordered_map<std::string_view, std::vector<std::size_t>> unknowns;
    for (std::size_t u = 0; u < set.unknowns.size(); ++u)
        unknowns[set.unknowns[u].name].push_back(u);
    return unknowns;
}

// Of a value that switches: when it is not 0.
std::optional<double> notZeroFrom(const solution::Histories& histories, std::size_t unknown,
                                  double from, double until) {
    for (double time = from; time <= until;) {
        if (histories.value(unknown, time) != 0)
            return time;
        const double next = histories.piece(unknown, time).until;
        if (!(next > time))
            break;
        time = next;
    }
    return std::nullopt;
}

} // namespace

Releases::Releases(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
                   double start)
    : start_(start) {
    const auto unknowns = unknownsOf(equations.set);
    const auto add = [&](Kind kind, std::size_t index, const std::string& name) {
        const auto multipliers = unknowns.find(name), release = unknowns.find(name + ".release");
        if (multipliers != unknowns.end() && release != unknowns.end())
            kept_.push_back({kind, index, multipliers->second, release->second[0], start});
    };
    for (std::size_t j = 0; j < scene.joints.size(); ++j)
        if (scene.joints[j].release && scene.joints[j].body2)
            add(&scene::Released::joints, j, scene.joints[j].name);
    for (std::size_t g = 0; g < scene.gears.size(); ++g)
        if (scene.gears[g].release)
            add(&scene::Released::gears, g, scene.gears[g].name);
    for (std::size_t l = 0; l < scene.links.size(); ++l)
        if (const scene::Link& link = scene.links[l];
            link.release && !link.spring && std::holds_alternative<scene::BodyEnd>(link.second))
            add(&scene::Released::links, l, physics::multiplierName(link, l));
}

std::optional<double> Releases::goneSince(const solution::Histories& histories, Element& element,
                                          double until) const {
    for (const std::size_t multiplier : element.multipliers)
        if (multiplier < histories.unknowns() && histories.value(multiplier, until) != 0)
            return goneFrom(histories, multiplier, start_, until);
    const auto gone = notZeroFrom(histories, element.release, element.looked, until);
    if (!gone)
        element.looked = std::max(element.looked, until);
    return gone;
}

std::optional<double> Releases::first(const solution::Histories& histories, double until) {
    std::optional<double> first;
    for (Element& element : kept_)
        if (const auto gone = goneSince(histories, element, until))
            first = std::min(first.value_or(*gone), *gone);
    return first;
}

const scene::Released& Releases::take(const solution::Histories& histories, double time) {
    std::erase_if(kept_, [&](Element& element) {
        const bool isGone = goneSince(histories, element, time).has_value();
        if (isGone)
            (released_.*element.kind).insert(element.index);
        return isGone;
    });
    return released_;
}

void Releases::cut(double time) {
    for (Element& element : kept_)
        element.looked = std::clamp(time, start_, element.looked);
}

} // namespace simulation
