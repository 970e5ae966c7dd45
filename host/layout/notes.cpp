#include "layout/notes.h"

#include <algorithm>
#include <utility>

namespace layout {

Notes::Note& Notes::opened(const Pointer& note) {
    const auto known = open_.find(note);
    if (known != open_.end())
        return known->second;
    return open_.emplace(note, Note{Flow(in_, note->blocks), {}, {}}).first->second;
}

// True: at least one strip is ready, and as many as that height takes, if there are.
bool Notes::makeReady(Note& note, double height) {
    while (!note.ended && (note.ready.empty() || note.height <= height)) {
        Strip strip;
        if (note.places.size() == note.ready.size())
            note.places.push_back(note.flow.place());
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

Notes::Wanted Notes::wanted(const std::vector<Pointer>& notes, double most) {
    Wanted result;
    for (const Pointer& pointer : notes) {
        if (result.all > most)
            continue;
        Note& note = opened(pointer);
        if (!makeReady(note, most))
            continue;
        if (result.all == 0)
            result.least = note.ready.front().height;
        const bool divided = note.ready.front().cells || note.ready.back().cells;
        result.all += note.height + (divided ? most : 0);
    }
    return result;
}

void Notes::mark(const Pointer& note, const model::Block* block) {
    waiting_.emplace_back(note, block);
}

void Notes::fill(double room, bool forced) {
    while (!waiting_.empty()) {
        const model::Block* block = waiting_.front().second;
        Note& note = opened(waiting_.front().first);
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
                pieces_.push_back({moved(piece, {0, top}), block});
            for (const Pointer& inner : part.footnotes)
                mark(inner, block);
            height_ = top + part.height;
            note.begun = true;
            note.divided = next.cells && !next.cells->isTaken();
            if (note.divided)
                return;
            note.after = next.after;
            note.height -= next.height;
            note.ready.pop_front();
            note.places.pop_front();
        }
        open_.erase(waiting_.front().first);
        waiting_.pop_front();
    }
}

std::vector<Notes::Taken> Notes::take() {
    height_ = 0;
    for (auto& [number, note] : open_)
        note.begun = false; // on the next page nothing is above it
    return std::exchange(pieces_, {});
}

std::optional<std::vector<Notes::Waiting>> Notes::waiting() const {
    std::vector<Waiting> result;
    for (const auto& [pointer, block] : waiting_) {
        const auto known = open_.find(pointer);
        if (known != open_.end() && known->second.divided)
            return std::nullopt;
        Flow::Place at;
        if (known != open_.end())
            at = known->second.places.empty() ? known->second.flow.place()
                                              : known->second.places.front();
        result.push_back({pointer, at, block});
    }
    return result;
}

void Notes::resume(const std::vector<Waiting>& waiting) {
    open_.clear();
    waiting_.clear();
    for (const Waiting& one : waiting) {
        opened(one.note).flow.seek(one.at);
        mark(one.note, one.block);
    }
}

} // namespace layout
