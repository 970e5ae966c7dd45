#include "document/tracker.h"

#include <algorithm>

namespace document {

std::size_t followed(std::size_t offset, Gravity gravity, const sgml::Edits& edits) {
    std::size_t distance = 0; // modulo 2^64: may be backwards
    for (const sgml::Edit& edit : edits) {
        const bool beside = edit.range.from == offset;
        if (edit.range.from > offset ||
            (beside && (!edit.range.empty() || gravity == Gravity::before)))
            break;
        if (edit.range.to > offset)
            return edit.range.from + distance + (gravity == Gravity::behind ? edit.text.size() : 0);
        distance += edit.text.size() - edit.range.size();
    }
    return offset + distance;
}

Tracker::Tracker(const Document& document) {
    connect(&document, &Document::edited, this,
            [this](const sgml::Change& change) { follow(change.edits); });
}

std::shared_ptr<const Tracker::Place> Tracker::track(std::size_t offset, Gravity gravity) {
    const auto place = std::make_shared<Place>(Place{offset, gravity});
    places_.push_back(place);
    return place;
}

std::size_t Tracker::size() const {
    return static_cast<std::size_t>(
        std::count_if(places_.begin(), places_.end(),
                      [](const std::weak_ptr<Place>& place) { return !place.expired(); }));
}

void Tracker::follow(const sgml::Edits& edits) {
    std::erase_if(places_, [](const std::weak_ptr<Place>& place) { return place.expired(); });
    for (const std::weak_ptr<Place>& held : places_)
        if (const std::shared_ptr<Place> place = held.lock())
            place->offset = followed(place->offset, place->gravity, edits);
}

} // namespace document
