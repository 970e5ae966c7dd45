#include "modes/mode.h"

#include <algorithm>

namespace solution {

bool Mode::slidesOn(std::size_t surface) const {
    return std::ranges::find(sliding, surface) != sliding.end();
}

bool Mode::isCoincident(std::size_t surface) const {
    return std::ranges::any_of(coincident, [surface](const std::vector<Coincident>& list) {
        return std::ranges::find(list, surface, &Coincident::surface) != list.end();
    });
}

void Mode::release() {
    sliding.clear();
    sticking.clear();
    leaving.reset();
    std::ranges::fill(isGrazed, 0);
    for (std::vector<Coincident>& list : coincident)
        list.clear();
}

std::string print(const Mode& mode, const ComponentModel& model) {
    std::string text;
    const auto add = [&text](const std::string& entry) {
        text += (text.empty() ? "" : ", ") + entry;
    };
    for (std::size_t s = 0; s < mode.sides.size(); ++s) {
        const Surface& surface = model.surfaces()[s];
        const expression::Decision taken = mode.decisions[surface.members[0].decision];
        std::string entry = std::to_string(s) + ": ";
        if (taken == expression::noBranch)
            entry += "unread";
        else if (mode.slidesOn(s))
            entry += "slides";
        else if (surface.whole)
            entry += (surface.ceiling ? "ceil " : "floor ") + std::to_string(taken);
        else
            entry += mode.sides[s] == Mode::onSurface ? "0" : mode.sides[s] > 0 ? "+" : "-";
        for (const Mode::Coincident& other : mode.coincident[s])
            entry += " with " + std::string(other.orientation > 0 ? "" : "-") +
                     std::to_string(other.surface);
        add(entry);
    }
    for (const std::size_t d : mode.sticking)
        add("direction " + std::to_string(d) + (d == mode.leaving ? ": sets off" : ": sticks"));
    return text;
}

} // namespace solution
