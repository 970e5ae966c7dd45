// The list of impacts, in order of time.
//
// Hits of a rally on a line (line_rally.h) have most of what they are in common with others of the
// same pair. So they are kept in 32 bytes each, and become an Impact when somebody asks for it.
// A list shares what it holds: copies cost little, any thread may read them, and a record that goes
// on changes none of those that were taken of it.
#pragma once

#include "simulation/motion.h"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace simulation {

// Pairs that hit each other on a line along an axis, by what all of their impacts are but for time,
// impulse and that coordinate of the point.
struct ImpactLine {
    std::size_t axis = 0;
    std::vector<Impact> ofPair;
};
struct LineImpact {
    double time = 0, impulse = 0, place = 0;
    std::uint32_t pair = 0;
};

class Impacts {
public:
    Impacts() = default;
    explicit Impacts(std::vector<Impact> list)
        : plain_(std::make_shared<const std::vector<Impact>>(std::move(list))) {}

    [[nodiscard]] std::size_t size() const { return plain_->size() + onLines_; }
    [[nodiscard]] bool empty() const { return size() == 0; }
    // All of them; those on lines are written out when this is asked first.
    [[nodiscard]] const std::vector<Impact>& all() const;
    [[nodiscard]] auto begin() const { return all().begin(); }
    [[nodiscard]] auto end() const { return all().end(); }
    // No two at once.
    [[nodiscard]] bool isStrictlyOrdered() const;
    // visit(first, second, times): each pair that hit each other, maybe in several parts.
    template <class Visit> void forEachPair(const Visit& visit) const;
    // visit(impact), in order of time: all that are not on lines.
    template <class Visit> void forEachPlain(const Visit& visit) const {
        for (const Impact& impact : *plain_)
            visit(impact);
    }

private:
    friend class ImpactRecord;
    struct Block { // of one line
        std::shared_ptr<const ImpactLine> line;
        std::shared_ptr<std::vector<LineImpact>> impacts;
        std::size_t after = 0; // as many plain ones
        std::size_t size = 0;  // of those in it: there may be more by now
        [[nodiscard]] Impact at(std::size_t index) const;
    };
    [[nodiscard]] std::vector<Impact> written() const;

    std::shared_ptr<const std::vector<Impact>> plain_ =
        std::make_shared<const std::vector<Impact>>();
    std::vector<Block> blocks_; // in order
    std::size_t onLines_ = 0;
    struct Written;
    std::shared_ptr<Written> written_; // none without blocks
};

// Of impacts as they are found. Most are found at their own time; hops that were cut off count
// later.
class ImpactRecord {
public:
    void add(const Impact& impact, double found);
    // In order of time.
    void add(const std::shared_ptr<const ImpactLine>& line, std::span<const LineImpact> impacts);
    // The impacts found until then.
    [[nodiscard]] Impacts upTo(double until) const;
    [[nodiscard]] bool haveMet(const std::pair<std::size_t, std::size_t>& pair, double since) const;
    [[nodiscard]] bool hasOnLineAt(double time) const;
    // Of what was hit before t: as it is kept here, and as an Impact for who reads it.
    [[nodiscard]] std::size_t bytesBefore(double t) const;

private:
    struct Recorded {
        Impact impact;
        double found = 0;
    };
    std::vector<Recorded> plain_; // in order of their own times
    [[nodiscard]] Impacts::Block& blockFor(const std::shared_ptr<const ImpactLine>& line,
                                           std::size_t after);

    static constexpr std::size_t mostInBlock = 1024;
    std::vector<Impacts::Block> blocks_;
    std::size_t onLines_ = 0;       // in all of them
    mutable bool isShared_ = false; // the last of them: it is not written any more
};

template <class Visit> void Impacts::forEachPair(const Visit& visit) const {
    for (const Impact& impact : *plain_)
        visit(impact.first, impact.second, std::size_t{1});
    for (const Block& block : blocks_) {
        std::vector<std::size_t> times(block.line->ofPair.size());
        for (std::size_t i = 0; i < block.size; ++i)
            ++times[(*block.impacts)[i].pair];
        for (std::size_t pair = 0; pair < times.size(); ++pair)
            if (times[pair] > 0)
                visit(block.line->ofPair[pair].first, block.line->ofPair[pair].second, times[pair]);
    }
}

} // namespace simulation
