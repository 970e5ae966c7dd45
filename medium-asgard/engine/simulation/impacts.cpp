#include "simulation/impacts.h"

#include "dense/polynomial.h"

#include <algorithm>
#include <mutex>

namespace simulation {

struct Impacts::Written {
    std::once_flag once;
    std::vector<Impact> all;
};

Impact Impacts::Block::at(std::size_t index) const {
    const LineImpact& one = (*impacts)[index];
    Impact impact = line->ofPair[one.pair];
    impact.time = one.time;
    impact.impulse = one.impulse;
    impact.point[static_cast<Eigen::Index>(line->axis)] = one.place;
    return impact;
}

std::vector<Impact> Impacts::written() const {
    std::vector<Impact> all;
    all.reserve(size());
    auto plain = plain_->begin();
    for (const Block& block : blocks_) {
        const auto until = plain_->begin() + static_cast<std::ptrdiff_t>(block.after);
        for (; plain < until; ++plain)
            all.push_back(*plain);
        for (std::size_t i = 0; i < block.size; ++i)
            all.push_back(block.at(i));
    }
    all.insert(all.end(), plain, plain_->end());
    return all;
}

const std::vector<Impact>& Impacts::all() const {
    if (!written_)
        return *plain_;
    std::call_once(written_->once, [this] { written_->all = written(); });
    return written_->all;
}

bool Impacts::isStrictlyOrdered() const {
    double last = -solution::infinity;
    bool is = true;
    const auto see = [&](double time) { is = is && std::exchange(last, time) < time; };
    auto plain = plain_->begin();
    for (const Block& block : blocks_) {
        const auto until = plain_->begin() + static_cast<std::ptrdiff_t>(block.after);
        for (; plain < until; ++plain)
            see(plain->time);
        for (std::size_t i = 0; i < block.size; ++i)
            see((*block.impacts)[i].time);
    }
    for (; plain < plain_->end(); ++plain)
        see(plain->time);
    return is;
}

// --- the record -------------------------------------------------------------------------------

namespace {

// Where an impact comes that is found last.
template <class List> std::size_t placeIn(const List& plain, double time) {
    if (plain.empty() || plain.back().impact.time <= time)
        return plain.size();
    const auto timeOf = [](const auto& recorded) { return recorded.impact.time; };
    const auto place = std::ranges::upper_bound(plain, time, {}, timeOf);
    return static_cast<std::size_t>(place - plain.begin());
}

} // namespace

void ImpactRecord::add(const Impact& impact, double found) {
    const auto place = static_cast<std::ptrdiff_t>(placeIn(plain_, impact.time));
    plain_.insert(plain_.begin() + place, {impact, found});
}

// With room for another one.
Impacts::Block& ImpactRecord::blockFor(const std::shared_ptr<const ImpactLine>& line,
                                       std::size_t after) {
    if (blocks_.empty() || isShared_ || blocks_.back().line != line ||
        blocks_.back().after != after || blocks_.back().size == mostInBlock) {
        const bool isMore = !blocks_.empty() && blocks_.back().line == line;
        blocks_.push_back({line, std::make_shared<std::vector<LineImpact>>(), after});
        blocks_.back().impacts->reserve(isMore ? mostInBlock : 16);
        isShared_ = false;
    }
    return blocks_.back();
}

void ImpactRecord::add(const std::shared_ptr<const ImpactLine>& line,
                       std::span<const LineImpact> impacts) {
    while (!impacts.empty()) {
        const std::size_t after = placeIn(plain_, impacts[0].time);
        Impacts::Block& block = blockFor(line, after);
        std::size_t count = std::min(impacts.size(), mostInBlock - block.size);
        if (after < plain_.size()) { // one that was found early
            const auto next =
                std::ranges::lower_bound(impacts, plain_[after].impact.time, {}, &LineImpact::time);
            count = std::min(count, static_cast<std::size_t>(next - impacts.begin()));
        }
        const auto added = impacts.first(count);
        block.impacts->insert(block.impacts->end(), added.begin(), added.end());
        block.size += count;
        onLines_ += count;
        impacts = impacts.subspan(count);
    }
}

Impacts ImpactRecord::upTo(double until) const {
    std::vector<Impact> plain;
    plain.reserve(plain_.size());
    for (const Recorded& recorded : plain_)
        if (recorded.found <= until) {
            plain.push_back(recorded.impact);
            plain.back().time = std::min(plain.back().time, until);
        }
    Impacts taken(std::move(plain));
    std::size_t seen = 0, kept = 0; // of the plain ones
    for (Impacts::Block block : blocks_) {
        const auto& impacts = *block.impacts;
        while (block.size > 0 && impacts[block.size - 1].time > until)
            --block.size;
        if (block.size == 0)
            break;
        for (; seen < block.after; ++seen)
            kept += plain_[seen].found <= until ? 1 : 0;
        block.after = kept;
        taken.onLines_ += block.size;
        taken.blocks_.push_back(std::move(block));
    }
    if (!taken.blocks_.empty())
        taken.written_ = std::make_shared<Impacts::Written>();
    isShared_ = true;
    return taken;
}

bool ImpactRecord::haveMet(const std::pair<std::size_t, std::size_t>& pair, double since) const {
    const auto areThey = [&](const Impact& impact) {
        return std::pair<std::size_t, std::size_t>(std::minmax(impact.first, impact.second)) ==
               pair;
    };
    return std::ranges::any_of(plain_,
                               [&](const Recorded& recorded) {
                                   return recorded.found > since && areThey(recorded.impact);
                               }) ||
           std::ranges::any_of(blocks_, [&](const Impacts::Block& block) {
               return std::ranges::any_of(*block.impacts, [&](const LineImpact& impact) {
                   return impact.time > since && areThey(block.line->ofPair[impact.pair]);
               });
           });
}

std::size_t ImpactRecord::bytesBefore(double t) const {
    std::size_t plain = plain_.size(), onLines = onLines_;
    if (!plain_.empty() && plain_.back().impact.time >= t) {
        const auto timeOf = [](const Recorded& recorded) { return recorded.impact.time; };
        const auto after = std::ranges::lower_bound(plain_, t, {}, timeOf);
        plain = static_cast<std::size_t>(after - plain_.begin());
    }
    for (std::size_t b = blocks_.size(); b-- > 0 && !(blocks_[b].impacts->back().time < t);) {
        const std::vector<LineImpact>& impacts = *blocks_[b].impacts;
        onLines -= static_cast<std::size_t>(
            impacts.end() - std::ranges::lower_bound(impacts, t, {}, &LineImpact::time));
    }
    return plain * (sizeof(Recorded) + sizeof(Impact)) + onLines * sizeof(LineImpact);
}

bool ImpactRecord::hasOnLineAt(double time) const {
    return std::ranges::any_of(blocks_, [&](const Impacts::Block& block) {
        return std::ranges::binary_search(*block.impacts, time, {}, &LineImpact::time);
    });
}

} // namespace simulation
