#include "layout/notes.h"

#include <algorithm>
#include <utility>

namespace layout {

Notes::Note& Notes::opened(const Footnote& note) {
    const auto known = open_.find(note);
    if (known != open_.end())
        return known->second;
    return open_.emplace(note, Note{Flow(in_, note->blocks), {}, 0, 0, false, false}).first->second;
}

// True: at least one strip is ready, and as many as that height takes, if there are.
bool Notes::makeReady(Note& note, double height) {
    while (!note.ended && (note.ready.empty() || note.height <= height)) {
        Strip strip;
        const Made made = note.flow.next(strip);
        note.ended = made == Made::end;
        if (made != Made::strip)
            continue;
        const double gap = note.ready.empty() ? 0 : std::max(note.ready.back().after, strip.before);
        note.height += gap + strip.height;
        note.ready.push_back(std::move(strip));
    }
    return !note.ready.empty();
}

Notes::Wanted Notes::wanted(const std::vector<Footnote>& notes, double most) {
    Wanted result;
    for (const Footnote& footnote : notes) {
        if (result.all > most)
            break;
        Note& note = opened(footnote);
        if (!makeReady(note, most))
            continue;
        if (result.all == 0)
            result.least = note.ready.front().height;
        const bool divided = note.ready.front().cells || note.ready.back().cells;
        result.all += note.height + (divided ? most : 0);
    }
    return result;
}

void Notes::fill(double room, bool forced) {
    while (!waiting_.empty()) {
        Note& note = opened(waiting_.front());
        while (makeReady(note, 0)) {
            Strip& next = note.ready.front();
            const double gap = note.begun ? std::max(note.after, next.before) : 0;
            const double top = height_ + gap;
            const bool force = forced && isEmpty();
            Strip part;
            if (next.cells)
                part = next.cells->take(room - top, force);
            else if (top + next.height <= room || force)
                part = next;
            if (part.pieces.empty() && part.height == 0 && (next.cells || next.height > 0))
                return;
            for (const Piece& piece : part.pieces)
                pieces_.push_back(moved(piece, {0, top}));
            for (const Footnote& inner : part.footnotes)
                mark(inner);
            height_ = top + part.height;
            note.begun = true;
            if (next.cells && !next.cells->isTaken())
                return;
            note.after = next.after;
            note.height -= next.height;
            note.ready.pop_front();
        }
        open_.erase(waiting_.front());
        waiting_.pop_front();
    }
}

std::vector<Piece> Notes::take() {
    height_ = 0;
    for (auto& [footnote, note] : open_)
        note.begun = false; // on the next page nothing is above it
    return std::exchange(pieces_, {});
}

} // namespace layout
