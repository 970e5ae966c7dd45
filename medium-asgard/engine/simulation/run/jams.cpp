#include "run/jams.h"

#include <algorithm>

namespace simulation {
namespace {

// Times at which the mark begins.
std::vector<double> marksOf(const solution::Histories& histories, std::size_t row, double from,
                            double until) {
    std::vector<double> times;
    bool wasMarked = false;
    for (double time = from; time < until;) {
        const solution::Piece piece = histories.piece(row, time);
        const bool isMarked = solution::isJammed(piece.value(time));
        if (isMarked && !wasMarked)
            times.push_back(time);
        wasMarked = isMarked;
        if (!(piece.until > time))
            break;
        time = piece.until;
    }
    return times;
}

} // namespace

std::vector<Jam> jamsOf(const solution::Histories& histories, const ContactLog& contacts,
                        double until) {
    std::vector<Jam> found;
    const auto& entries = contacts.entries();
    for (auto entry = entries.begin(); entry != entries.end(); ++entry)
        for (const ContactLog::Contact& contact : (*entry)->contacts) {
            const auto isNext = [&](const ContactLog::EntryPointer& later) {
                return later->moving.contains(contact.bodies.first) ||
                       later->moving.contains(contact.bodies.second);
            };
            const auto next = std::find_if(entry + 1, entries.end(), isNext);
            const double end = next == entries.end() ? until : std::min(until, (*next)->time);
            if (contact.friction.empty() || contact.friction[0] >= histories.unknowns())
                continue;
            for (const double time : marksOf(histories, contact.friction[0], (*entry)->time, end))
                found.push_back({time, contact.bodies});
        }
    return found;
}

} // namespace simulation
