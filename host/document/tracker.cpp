#include "document/tracker.h"

#include <algorithm>

namespace document {

Tracker::Tracker(const Document& document) {
    connect(&document, &Document::edited, this,
            [this](const sgml::Change& change) { follow(change.edits); });
}

std::shared_ptr<const Tracker::Place> Tracker::track(std::size_t offset, text::Gravity gravity) {
    const auto place = std::make_shared<Place>(Place{offset, gravity});
    places_.push_back(place);
    return place;
}

std::size_t Tracker::size() const {
    return static_cast<std::size_t>(
        std::count_if(places_.begin(), places_.end(),
                      [](const std::weak_ptr<Place>& place) { return !place.expired(); }));
}

void Tracker::follow(const text::Edits& edits) {
    std::erase_if(places_, [](const std::weak_ptr<Place>& place) { return place.expired(); });
    for (const std::weak_ptr<Place>& held : places_)
        if (const std::shared_ptr<Place> place = held.lock())
            place->offset = text::moved(place->offset, edits, place->gravity);
}

} // namespace document
