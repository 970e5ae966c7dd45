#include "events/collision_record.h"

#include <algorithm>

namespace simulation {

void CollisionRecord::addEvent(double time) {
    if (events_.empty() || events_.back() < time)
        events_.push_back(time);
}

void CollisionRecord::addNote(const Pair& pair, double time, const std::string& sentence) {
    if (noted_.insert(pair).second)
        notes_.push_back({time, sentence});
}

void CollisionRecord::addOverlap(const Pair& pair, double depth) {
    if (noted_.insert(pair).second)
        overlaps_.emplace(pair, depth);
}

bool CollisionRecord::hasEventAt(double time) const {
    return std::ranges::binary_search(events_, time);
}

std::vector<std::string> CollisionRecord::notes(double until) const {
    std::vector<std::string> sentences;
    for (const Note& note : notes_)
        if (note.time <= until)
            sentences.push_back(note.sentence);
    return sentences;
}

std::vector<collision::Pair> CollisionRecord::blocked(double until) const {
    std::vector<Pair> pairs;
    for (const Blocked& blocked : blocked_)
        if (blocked.time <= until)
            pairs.push_back(blocked.pair);
    return pairs;
}

} // namespace simulation
