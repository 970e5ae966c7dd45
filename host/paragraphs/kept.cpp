#include "paragraphs/kept.h"

#include <utility>

namespace paragraphs {

Kept& Kept::texts() {
    static Kept& kept = *new Kept;
    return kept;
}

Kept& Kept::lines() {
    static Kept& kept = *new Kept;
    return kept;
}

Kept::Place Kept::add(const Owner& of, int item, int letters) {
    items_.push_front({&of, item, static_cast<std::size_t>(letters)});
    letters_ += items_.front().letters;
    while (letters_ > most && items_.size() > fewest) {
        const Item last = items_.back();
        remove(std::prev(items_.end()));
        last.of->forget(last.item);
    }
    return items_.begin();
}

void Kept::use(Place place, int letters) {
    items_.splice(items_.begin(), items_, place);
    letters_ -= std::exchange(place->letters, static_cast<std::size_t>(letters));
    letters_ += place->letters;
}

void Kept::remove(Place place) {
    letters_ -= place->letters;
    items_.erase(place);
}

} // namespace paragraphs
