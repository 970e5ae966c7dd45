#include "editing/changes.h"

#include "editing/fingerprint.h"
#include "text/difference.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace editing {

namespace {

// What is known of one element on either side.
struct Card {
    Element element;
    std::string name, fingerprint, bodies;
    std::optional<std::size_t> place; // in the text after
    std::size_t run = 0;              // of its command: 0 is the first
    bool taken = false;
};

using Cards = std::vector<Card>;

template <class PlaceOf> Cards cardsOf(const scene::Scene& scene, PlaceOf placeOf) {
    Cards cards;
    std::map<std::pair<Kind, std::size_t>, std::size_t> runs;
    for (const Element& element : elementsOf(scene)) {
        Card card;
        card.element = element;
        card.name = element.kind == Kind::simulator ? "simulator" : nameOf(scene, element);
        card.fingerprint = fingerprintOf(scene, element);
        card.bodies = bodiesOf(scene, element);
        const scene::Source* source = sourceOf(scene, element);
        if (source && source->command.known()) {
            card.place = placeOf(source->command.from);
            card.run = runs[{element.kind, source->command.from}]++;
        }
        cards.push_back(std::move(card));
    }
    return cards;
}

class Matching {
public:
    Matching(Cards before, Cards after) : before_(std::move(before)), after_(std::move(after)) {}

    Changes changes() {
        const auto name = [](const Card& c) { return c.name; };
        const auto place = [](const Card& c) {
            return c.place ? std::to_string(*c.place) + "/" + std::to_string(c.run) : "";
        };
        const auto unnamed = [](const Card& c, std::string key) {
            return c.name.empty() ? std::move(key) : std::string();
        };
        match(name);
        match([&](const Card& c) {
            return unnamed(c, place(c).empty() ? "" : c.fingerprint + "@" + place(c));
        });
        match([&](const Card& c) { return unnamed(c, c.fingerprint); });
        match([&](const Card& c) {
            return unnamed(c, place(c).empty() ? "" : c.bodies + "@" + place(c));
        });
        match([&](const Card& c) { return unnamed(c, c.bodies); });
        match([&](const Card& c) { return unnamed(c, place(c)); });
        for (const Card& card : before_)
            if (!card.taken)
                changes_.removed.push_back(card.element);
        for (const Card& card : after_)
            if (!card.taken)
                changes_.added.push_back(card.element);
        std::ranges::sort(changes_.kept, {}, &Kept::after);
        return std::move(changes_);
    }

private:
    // Those that are left, of one kind and with the same key that is not "", in order.
    template <class KeyOf> void match(KeyOf keyOf) {
        std::map<std::pair<Kind, std::string>, std::vector<Card*>> left;
        for (Card& card : after_)
            if (!card.taken)
                left[{card.element.kind, keyOf(card)}].push_back(&card);
        std::map<std::pair<Kind, std::string>, std::size_t> used;
        for (Card& card : before_) {
            const std::pair key{card.element.kind, card.taken ? std::string() : keyOf(card)};
            const auto found = left.find(key);
            if (key.second.empty() || found == left.end() || used[key] == found->second.size())
                continue;
            Card& other = *found->second[used[key]++];
            card.taken = other.taken = true;
            changes_.kept.push_back(
                {card.element, other.element, card.fingerprint != other.fingerprint});
        }
    }

    Cards before_, after_;
    Changes changes_;
};

template <class List> void append(std::vector<Element>& elements, Kind kind, const List& list) {
    for (std::size_t i = 0; i < list.size(); ++i)
        elements.push_back({kind, i});
}

} // namespace

std::optional<Element> Changes::now(const Element& before) const {
    for (const Kept& one : kept)
        if (one.before == before)
            return one.after;
    return std::nullopt;
}

Changes changesBetween(const Reading& before, const Reading& after) {
    const text::Edits edits{text::difference(before.text, after.text)};
    const auto places = [&](std::size_t at) {
        return at <= edits.front().range.from ? std::optional(at) : text::movedByte(at, edits);
    };
    return Matching(cardsOf(before.scene, places),
                    cardsOf(after.scene, [](std::size_t at) { return std::optional(at); }))
        .changes();
}

std::vector<Renamed> renamedBetween(const scene::Scene& before, const scene::Scene& after) {
    std::vector<Renamed> all;
    const std::vector<Element> elements = elementsOf(before);
    if (elements != elementsOf(after))
        return all;
    std::set<std::pair<Kind, std::string>> old, now;
    for (const Element& element : elements) {
        old.emplace(element.kind, nameOf(before, element));
        now.emplace(element.kind, nameOf(after, element));
    }
    for (const Element& element : elements) {
        const std::string was = nameOf(before, element), is = nameOf(after, element);
        if (!was.empty() && !is.empty() && !now.contains({element.kind, was}) &&
            !old.contains({element.kind, is}))
            all.push_back({element, was, is});
    }
    return all;
}

std::vector<Element> elementsOf(const scene::Scene& scene) {
    std::vector<Element> elements;
    if (scene.simulator.source)
        elements.push_back({Kind::simulator, 0});
    append(elements, Kind::shapeSet, scene.shapeSets);
    append(elements, Kind::body, scene.bodies);
    append(elements, Kind::force, scene.forces);
    append(elements, Kind::link, scene.links);
    append(elements, Kind::joint, scene.joints);
    append(elements, Kind::gear, scene.gears);
    append(elements, Kind::rope, scene.ropes);
    append(elements, Kind::contact, scene.contacts);
    append(elements, Kind::trajectory, scene.trajectories);
    append(elements, Kind::constraint, scene.constraints);
    append(elements, Kind::light, scene.lights);
    append(elements, Kind::view, scene.views);
    append(elements, Kind::parameter, scene.parameters);
    append(elements, Kind::plot, scene.plots);
    return elements;
}

std::vector<Element> elementsAt(const scene::Scene& scene, scene::Range range) {
    std::vector<Element> elements;
    if (!range.known())
        return elements;
    for (const Element& element : elementsOf(scene)) {
        const scene::Range command = sourceOf(scene, element)->command;
        if (command.known() && command.from <= range.from && range.to <= command.to)
            elements.push_back(element);
    }
    return elements;
}

} // namespace editing
