#include "dense/histories.h"

#include <algorithm>
#include <map>

namespace solution {

// ---------------------------------------------------------------------------------------------
// One component's steps

std::shared_ptr<History> History::ofFlight(std::size_t columns, std::uint8_t coefficients) {
    auto made = std::make_shared<History>(columns);
    made->ofEach_ = coefficients;
    return made;
}

History::Step History::flightStep(std::size_t index) const {
    const std::size_t offset = index % stepsPerChunk * flightRow() + 1;
    return {.origin = origin(index),
            .until = until(index),
            .scale = 1,
            .fresh = true,
            .coefficients = ofEach_,
            .offset = static_cast<std::uint32_t>(offset)};
}

Piece History::piece(std::size_t index, std::size_t column) const {
    const Chunk& chunk = *chunks_[index / stepsPerChunk];
    const Step s = step(index);
    const double* const row = chunk.values.data() + s.offset;
    if (column >= columns_) { // c1 + 2 c2 s
        const double* place = row + (column - columns_) * s.coefficients;
        return {s.origin, s.until, 0.5,
                CoefficientList(std::span(place + 1, s.coefficients - std::size_t{1}))};
    }
    return {s.origin, s.until, s.scale, read(s, row, column)};
}

std::size_t History::find(double t, std::size_t near) const {
    if (size_ == 0)
        return 0;
    if (origin(size_ - 1) <= t) // where events are asked for
        return size_ - 1;
    near = std::min(near, size_ - 1);
    for (std::size_t tries = 0; tries < 4; ++tries) { // readers mostly move a little forward
        const bool started = origin(near) <= t;
        if (started && (near + 1 == size_ || t < origin(near + 1)))
            return near;
        if (!started || near + 1 == size_)
            break;
        ++near;
    }
    std::size_t low = 0, high = size_; // the first step that begins after t
    for (std::size_t ahead = 4; origin(near) <= t; ahead *= 2) { // not far ahead, if it is
        low = near + 1;
        if (near + ahead >= size_)
            break;
        if (origin(near + ahead) > t) {
            high = near + ahead;
            break;
        }
        near += ahead;
    }
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (origin(middle) <= t)
            low = middle + 1;
        else
            high = middle;
    }
    return low == 0 ? 0 : low - 1;
}

History::Chunk& History::writableTail() {
    frozen_.reset();
    if (chunks_.size() <= sharedChunks_) {
        chunks_.back() = std::make_shared<Chunk>(*chunks_.back());
        sharedChunks_ = chunks_.size() - 1;
    }
    return *chunks_.back();
}

void History::append(const Step& step, std::span<const double> rows) {
    std::ranges::copy(rows, append(step).begin());
}

// Most have one step for all time; who has several has many, and who curves at once. Rows are much
// of one length.
void History::Chunk::grow(std::size_t row, std::size_t coefficients) {
    constexpr std::size_t ofFlight = 3;
    const bool isCurved = coefficients > ofFlight && !steps.empty();
    const std::size_t more = isCurved            ? stepsPerChunk
                             : steps.size() < 2  ? steps.size() + 1
                             : steps.size() < 16 ? 16
                                                 : stepsPerChunk;
    steps.reserve(more);
    if (more > 2)
        values.reserve(more * row);
}

std::span<double> History::append(const Step& step) {
    if (size_ % stepsPerChunk == 0) {
        chunks_.push_back(std::make_shared<Chunk>());
        if (size_ > 0) { // there will be more
            chunks_.back()->steps.reserve(stepsPerChunk);
            chunks_.back()->values.reserve(stepsPerChunk * sizeOf(step));
        }
    }
    Chunk& chunk = writableTail();
    if (chunk.steps.size() == chunk.steps.capacity())
        chunk.grow(sizeOf(step), step.coefficients);
    Step placed = step;
    placed.offset = static_cast<std::uint32_t>(chunk.values.size());
    chunk.steps.push_back(placed);
    chunk.values.resize(chunk.values.size() + sizeOf(step));
    numbers_ += sizeOf(step);
    ++size_;
    return std::span(chunk.values).subspan(placed.offset);
}

std::span<double> History::turn(double t) {
    if (size_ > 0 && origin(size_ - 1) >= t)
        (void)cut(t);
    if (size_ % stepsPerChunk == 0)
        chunks_.push_back(std::make_shared<Chunk>());
    std::vector<double, Unwritten<double>>& values = writableTail().values;
    const std::size_t row = flightRow(), first = size_ % stepsPerChunk;
    ++size_;
    if ((first + 1) * row > values.size()) // most of them turn once or twice, or often
        values.resize(row * (size_ <= 2 ? size_ : size_ <= 16 ? 16 : stepsPerChunk));
    endOfLast_ = infinity;
    values[first * row] = t;
    return std::span(values).subspan(first * row + 1, row - 1);
}

void History::dropLast() {
    Chunk& chunk = writableTail();
    if (isFlight()) {
        endOfLast_ = origin(size_ - 1);
    } else {
        numbers_ -= chunk.values.size() - chunk.steps.back().offset;
        chunk.values.resize(chunk.steps.back().offset);
        chunk.steps.pop_back();
    }
    --size_;
    if (size_ % stepsPerChunk == 0)
        chunks_.pop_back();
    sharedChunks_ = std::min(sharedChunks_, chunks_.size());
}

void History::dropAnchor() {
    if (endsInAnchor())
        dropLast();
}

std::size_t History::cut(double t) {
    std::size_t dropped = 0;
    for (; size_ > 0 && origin(size_ - 1) >= t; ++dropped)
        dropLast();
    if (size_ > 0 && step(size_ - 1).until > t) {
        if (isFlight())
            endOfLast_ = t;
        else
            writableTail().steps.back().until = t;
        frozen_.reset();
    }
    return dropped;
}

std::shared_ptr<const History> History::freeze() const {
    if (!frozen_) {
        frozen_ = std::make_shared<History>(*this);
        sharedChunks_ = chunks_.size();
    }
    return frozen_;
}

std::shared_ptr<const History> History::upTo(double t) const {
    auto copy = std::make_shared<History>(columns_);
    copy->ofEach_ = ofEach_;
    copy->order_ = order_;
    copy->size_ = size_;
    copy->numbers_ = numbers_;
    const auto isAfter = [t](const Step& s) { return s.origin > t || (s.origin == t && !s.fresh); };
    while (copy->size_ > 1 && isAfter(step(copy->size_ - 1))) {
        --copy->size_;
        copy->numbers_ -= isFlight() ? 0 : sizeOf(step(copy->size_));
    }
    if (isFlight())
        copy->endOfLast_ = copy->size_ < size_ ? origin(copy->size_) : endOfLast_;
    const std::size_t chunks = (copy->size_ + stepsPerChunk - 1) / stepsPerChunk;
    copy->chunks_.assign(chunks_.begin(), chunks_.begin() + static_cast<std::ptrdiff_t>(chunks));
    copy->sharedChunks_ = chunks;
    return copy;
}

std::size_t History::bytesBefore(double t) const {
    if (t > from() && t < infinity) {
        std::size_t steps = find(t);
        steps += origin(steps) < t ? 1 : 0;
        if (isFlight())
            return steps * flightRow() * sizeof(double);
        std::size_t numbers = steps < size_ ? step(steps).offset : numbers_;
        for (std::size_t chunk = 0; chunk < steps / stepsPerChunk && steps < size_; ++chunk)
            numbers += chunks_[chunk]->values.size();
        return steps * sizeof(Step) + numbers * sizeof(double);
    }
    return t > from() ? bytes() : 0;
}

// ---------------------------------------------------------------------------------------------
// All unknowns

const Histories::Span& Histories::spanAt(std::size_t unknown, double t) const {
    const std::vector<Span>& spans = tracks_[unknown].spans;
    if (spans.size() == 1 || spans.back().from <= t)
        return spans.back();
    const auto after = std::ranges::upper_bound(spans, t, {}, &Span::from);
    return after == spans.begin() ? spans.front() : *(after - 1);
}

Histories::Place Histories::place(std::size_t unknown, double t) const {
    const Span& span = spanAt(unknown, t);
    return {span.history.get(), span.column};
}

double Histories::reached(std::size_t unknown) const {
    const std::vector<Span>& spans = tracks_[unknown].spans;
    for (std::size_t i = spans.size(); i-- > 0;)
        if (!spans[i].history->empty())
            return spans[i].history->until();
    return start_;
}

const Stop* Histories::stop(std::size_t unknown) const {
    const auto& index = tracks_[unknown].stop;
    return index ? &stops_[*index] : nullptr;
}

Piece Histories::piece(std::size_t unknown, double t) const {
    const Track& track = tracks_[unknown];
    const Span* span = &spanAt(unknown, t);
    // A component that was made by an event and has not yet stepped has no pieces: the one before.
    while (span->history->empty() && span != track.spans.data())
        --span;
    if (span->history->empty())
        return {start_, start_, 1, CoefficientList(std::span(&track.initial, 1))};
    Piece piece = span->history->piece(span->history->find(t), span->column);
    // What was 0 for ever until an event woke it is so until then.
    const Span* next = span + 1;
    if (next != track.spans.data() + track.spans.size() && t < next->from)
        piece.until = std::min(piece.until, next->from);
    return piece;
}

Piece Histories::pieceBefore(std::size_t unknown, double t) const {
    const Track& track = tracks_[unknown];
    const Span* span = &spanAt(unknown, t);
    while (span != track.spans.data() && (span->history->empty() || span->from >= t))
        --span;
    if (span->history->empty())
        return piece(unknown, t);
    std::size_t index = span->history->find(t);
    while (index > 0 && span->history->origin(index) >= t)
        --index;
    return span->history->piece(index, span->column);
}

double Histories::value(std::size_t unknown, double t) const { return piece(unknown, t).value(t); }

double Histories::derivative(std::size_t unknown, double t) const {
    return piece(unknown, t).derivative(t);
}

double Histories::secondDerivative(std::size_t unknown, double t) const {
    return piece(unknown, t).secondDerivative(t);
}

template <typename Visit>
void Histories::forEachStep(std::size_t unknown, double t, Visit visit) const {
    const std::vector<Span>& spans = tracks_[unknown].spans;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const double end = i + 1 < spans.size() ? std::min(spans[i + 1].from, t) : t;
        const History& history = *spans[i].history;
        for (std::size_t k = 0; k < history.size(); ++k) {
            const History::Step step = history.step(k);
            if (!(step.origin < end))
                break;
            if (step.origin >= spans[i].from)
                visit(step);
        }
    }
}

std::vector<double> Histories::restarts(std::size_t unknown) const {
    std::vector<double> times;
    forEachStep(unknown, infinity, [&](const History::Step& step) {
        if (step.fresh && step.origin > start_)
            times.push_back(step.origin);
    });
    return times;
}

Histories::Course Histories::course(std::size_t unknown, double t) const {
    Course course;
    forEachStep(unknown, t, [&](const History::Step& step) {
        ++course.steps;
        course.restarts += step.fresh && step.origin > start_ ? 1 : 0;
    });
    return course;
}

std::shared_ptr<const Histories> Histories::upTo(double t) const {
    auto copy = std::make_shared<Histories>(*this);
    copy->known_ = std::min(known_, t);
    std::map<const History*, std::shared_ptr<const History>> shorter;
    for (Track& track : copy->tracks_) {
        track.stop.reset();
        while (track.spans.size() > 1 && track.spans.back().from > t)
            track.spans.pop_back();
        for (Span& span : track.spans) {
            auto& made = shorter[span.history.get()];
            if (!made)
                made = span.history->upTo(t);
            span.history = made;
        }
    }
    std::erase_if(copy->stops_, [t](const Stop& stop) { return stop.time >= t; });
    for (std::size_t s = 0; s < copy->stops_.size(); ++s)
        for (const std::size_t unknown : copy->stops_[s].unknowns)
            copy->tracks_[unknown].stop = s;
    return copy;
}

std::size_t Histories::bytesOf(std::size_t unknown) const {
    std::size_t sum = 0;
    for (const Span& span : tracks_[unknown].spans)
        sum += span.history->bytes();
    return sum;
}

std::size_t Histories::bytesBefore(double t) const {
    std::vector<const History*> seen;
    for (const Track& track : tracks_)
        for (const Span& span : track.spans)
            seen.push_back(span.history.get());
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    std::size_t total = 0;
    for (const History* history : seen)
        total += history->bytesBefore(t);
    return total;
}

} // namespace solution
