#include "document/tracker.h"

#include <algorithm>

namespace document {

Tracker::Tracker(const Document& document) {
    connect(&document, &Document::edited, this,
            [this](const sgml::Change& change, const text::Edits& back, std::uint64_t number) {
                follow(change.edits, back, number);
            });
}

std::shared_ptr<const Tracker::Place> Tracker::track(std::size_t offset, text::Gravity gravity) {
    const auto tracked = std::make_shared<Tracked>(Tracked{.place = {offset, gravity}});
    places_.push_back(tracked);
    return {tracked, &tracked->place};
}

std::size_t Tracker::size() const {
    return static_cast<std::size_t>(
        std::count_if(places_.begin(), places_.end(),
                      [](const std::weak_ptr<Tracked>& place) { return !place.expired(); }));
}

// A change is made, undone and redone in turn: what a place lost by one of these, the next one of
// the same number gives back.
void Tracker::follow(const text::Edits& edits, const text::Edits& back, std::uint64_t number) {
    std::erase_if(places_, [](const std::weak_ptr<Tracked>& place) { return place.expired(); });
    for (const std::weak_ptr<Tracked>& held : places_) {
        const std::shared_ptr<Tracked> tracked = held.lock();
        if (!tracked)
            continue;
        Place& place = tracked->place;
        const std::size_t before = place.offset;
        const auto known = tracked->lost.find(number);
        place.offset = known != tracked->lost.end() ? known->second
                                                    : text::moved(before, edits, place.gravity);
        if (text::moved(place.offset, back, place.gravity) != before)
            tracked->lost[number] = before;
        else if (known != tracked->lost.end())
            tracked->lost.erase(known);
    }
}

} // namespace document
