#include "dense/inputs.h"

#include <algorithm>

namespace solution {

void Inputs::window(double to) {
    end_ = to;
    for (Source& source : sources_) {
        source.count = 0;
        for (const Member& member : source.members) {
            const auto [history, column] = onlyPlace(member.input);
            areGrouped_ = areGrouped_ && history == source.history && column == member.column;
        }
    }
}

Histories::Place Inputs::onlyPlace(std::size_t input) const {
    if (!histories_.isInOnePlace(unknowns_[input]))
        return {nullptr, 0};
    const auto place = histories_.place(unknowns_[input], end_);
    return place.history->empty() ? Histories::Place{nullptr, 0} : place;
}

void Inputs::group() {
    sources_.clear();
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
        const auto [history, column] = onlyPlace(i);
        auto known = sources_.end();
        if (history)
            known = std::ranges::find(sources_, history, &Source::history);
        if (known == sources_.end())
            known = sources_.insert(known, Source{.history = history, .members = {}, .pieces = {}});
        places_[i] = {static_cast<std::size_t>(known - sources_.begin()), known->members.size()};
        known->members.push_back({i, column});
    }
    areGrouped_ = true;
}

const Piece* Inputs::otherPiecesAt(Source& source, double t) {
    constexpr std::size_t most = 16; // more than a step crosses
    const std::size_t members = source.members.size();
    for (std::size_t k = 0; k < source.count; ++k) { // at a joint the later one
        const Piece& first = source.pieces[k * members];
        if (first.origin <= t && t < first.until) {
            source.last = k;
            return &first;
        }
    }
    source.last = source.count < most ? source.count++ : (source.last + 1) % most;
    source.pieces.resize(std::max(source.pieces.size(), source.count * members));
    Piece* const pieces = source.pieces.data() + source.last * members;
    read(source, t, pieces);
    return pieces;
}

void Inputs::read(Source& source, double t, Piece* pieces) {
    if (!source.history) {
        const std::size_t unknown = unknowns_[source.members.front().input];
        *pieces = t >= end_ ? histories_.pieceBefore(unknown, end_) : histories_.piece(unknown, t);
        return;
    }
    const History& history = *source.history;
    std::size_t step = history.find(std::min(t, end_), source.near);
    while (t >= end_ && step > 0 && history.origin(step) >= end_)
        --step;
    if (source.count == 1)
        source.near = step;
    for (std::size_t m = 0; m < source.members.size(); ++m)
        pieces[m] = history.piece(step, source.members[m].column);
}

} // namespace solution
