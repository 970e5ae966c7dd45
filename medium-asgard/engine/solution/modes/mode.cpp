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
    std::ranges::fill(wasPassed, 0);
    for (std::vector<Coincident>& list : coincident)
        list.clear();
}

void Mode::setSide(std::size_t surface, int side) {
    setOwnSide(surface, side);
    for (const Coincident& other : coincident[surface])
        setOwnSide(other.surface, side * other.orientation);
}

void Mode::setOwnSide(std::size_t surface, int side) {
    sides[surface] = side;
    if (model->surfaces()[surface].whole) { // the branches beside that whole number
        decisions[model->surfaces()[surface].members[0].decision] = decisionBeside(surface, side);
        return;
    }
    for (const Surface::Member& member : model->surfaces()[surface].members)
        decisions[member.decision] = expression::Decision{side} * member.orientation;
}

void Mode::setGrazed(std::size_t surface, bool grazes) {
    isGrazed[surface] = grazes ? 1 : 0;
    for (const Coincident& other : coincident[surface])
        isGrazed[other.surface] = isGrazed[surface];
}

expression::Decision Mode::decisionBeside(std::size_t surface, int side) const {
    const expression::Decision above = model->surfaces()[surface].ceiling ? 1 : 0;
    return levels[surface] + above - (side > 0 ? 0 : 1);
}

bool Mode::isOnSide(std::size_t surface) const {
    return !model->surfaces()[surface].whole ||
           decisions[model->surfaces()[surface].members[0].decision] ==
               decisionBeside(surface, sides[surface]);
}

std::string print(const Mode& mode) {
    std::string text;
    const auto add = [&text](const std::string& entry) {
        text += (text.empty() ? "" : ", ") + entry;
    };
    for (std::size_t s = 0; s < mode.sides.size(); ++s) {
        const Surface& surface = mode.model->surfaces()[s];
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
    static constexpr const char* places[] = {"holds", "low", "high", "gone"};
    for (std::size_t m = 0; m < mode.kept.size(); ++m)
        add("multiplier " + std::to_string(m) + ": " +
            places[static_cast<std::size_t>(mode.kept[m])]);
    return text;
}

} // namespace solution
