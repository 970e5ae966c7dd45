#include "typography/lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace typography {

namespace {

// As TeX has them.
constexpr double perLine = 10;        // so fewer lines are better
constexpr double twoHyphens = 10'000; // demerits, of two lines one after the other
constexpr double hyphenBeforeLast = 5'000;
constexpr double unlikeNeighbours = 10'000; // a tight line beside a loose one
// Our own.
constexpr double shortLastLine = 100'000;
constexpr double rag = 0.2;        // of the width: a ragged line that is shorter is bad
constexpr double leastGive = 0.01; // of the width, beside what blanks give
constexpr double tooLong = 1e18;   // for each unit of the line's width
constexpr double slack = 0.5;      // in the unit of the widths: sums are rounded

constexpr double none = std::numeric_limits<double>::infinity();

std::size_t compared = 0;

enum Fitness { tight, normal, loose, veryLoose, fitnesses };

// The end of a line on the way to some end behind it.
struct Node {
    int at = -1; // index of the break; -1: the paragraph's beginning
    Fitness fitness = normal;
    double demerits = 0;
    int before = -1; // the node where the line begins
};

struct Candidate {
    double demerits = none;
    int before = -1;
};

struct Line {
    double ratio = 0; // how far it is stretched; below -1: it is too long
    double natural = 0;
};

class Search {
public:
    Search(std::span<const Break> breaks, const Column& column, double most, bool goesOn)
        : breaks_(breaks), column_(column), most_(most), goesOn_(goesOn) {}

    std::optional<std::vector<std::size_t>> run() {
        nodes_.push_back({});
        active_.push_back(0);
        for (std::size_t i = 0; i < breaks_.size(); ++i)
            if (!reach(i))
                return std::nullopt;
        return way();
    }

private:
    bool reach(std::size_t at);
    [[nodiscard]] Line lineTo(const Node& from, const Break& to, bool isLast) const;
    [[nodiscard]] bool isShortLast(const Node& from, const Line& line) const {
        return from.at >= 0 && line.natural < column_.leastOfLast;
    }
    [[nodiscard]] double demeritsOf(const Node& from, const Break& to, const Line& line,
                                    Fitness fitness, bool isLast) const;
    [[nodiscard]] std::vector<std::size_t> way() const;

    std::span<const Break> breaks_;
    const Column& column_;
    double most_ = 0;
    bool goesOn_ = false;
    std::vector<Node> nodes_;
    std::vector<int> active_;
};

Fitness fitnessOf(double ratio, bool ragged) {
    if (ragged)
        return normal;
    return ratio < -0.5 ? tight : ratio <= 0.5 ? normal : ratio <= 1 ? loose : veryLoose;
}

Line Search::lineTo(const Node& from, const Break& to, bool isLast) const {
    const bool isFirst = from.at < 0;
    const Break* begin = isFirst ? nullptr : &breaks_[static_cast<std::size_t>(from.at)];
    const double natural = to.end - (begin ? begin->begin : 0) + to.hyphen;
    const double blanks = to.blanksAtEnd - (begin ? begin->blanksAtBegin : 0);
    const double free = (isFirst ? column_.firstWidth : column_.width) - natural;
    if (free >= 0 && isLast)
        return {0, natural};
    if (column_.ragged)
        return {free >= -slack ? free / (rag * column_.width) : -none, natural};
    const double give = free >= 0 ? stretchOfBlank * blanks : shrinkOfBlank * blanks;
    if (free >= give) // a line without blanks is the worse the shorter it is
        return {std::max(1.0, free / (give + leastGive * column_.width)), natural};
    if (give > 0)
        return {free / give, natural};
    return {free >= -slack ? 0 : -none, natural};
}

double Search::demeritsOf(const Node& from, const Break& to, const Line& line, Fitness fitness,
                          bool isLast) const {
    const double badness = 100 * std::pow(std::abs(line.ratio), 3);
    double result = (perLine + badness) * (perLine + badness);
    if (!to.forced && !isLast)
        result += static_cast<double>(to.cost) * to.cost;
    const bool hyphenBefore = from.at >= 0 && breaks_[static_cast<std::size_t>(from.at)].hyphen > 0;
    if (hyphenBefore)
        result += to.hyphen > 0 ? twoHyphens : isLast ? hyphenBeforeLast : 0;
    if (std::abs(static_cast<int>(from.fitness) - static_cast<int>(fitness)) > 1)
        result += unlikeNeighbours;
    if (isLast && isShortLast(from, line))
        result += shortLastLine;
    return result;
}

// Finds the best lines that end here; false: there is none.
bool Search::reach(std::size_t at) {
    const Break& to = breaks_[at];
    const bool isEnd = at + 1 == breaks_.size();
    const bool isForced = isEnd || to.forced;
    // The last line may be short; what goes on is cut anywhere.
    const bool isLast = isForced && !(column_.ragged && column_.even && !(isEnd && goesOn_));
    std::array<Candidate, fitnesses> best;
    Candidate longest; // of those that are too long
    std::size_t kept = 0;
    for (const int index : active_) {
        ++compared;
        const Node& from = nodes_[static_cast<std::size_t>(index)];
        const Line line = lineTo(from, to, isLast);
        const bool fits = line.ratio >= -1 - 1e-9;
        if (fits && !isForced)
            active_[kept++] = index;
        if (!fits) {
            const double demerits = from.demerits + tooLong * line.natural;
            if (demerits < longest.demerits)
                longest = {demerits, index};
            continue;
        }
        const bool endsText = isLast && !(isEnd && goesOn_);
        if (most_ < anything &&
            ((line.ratio > most_ && !isForced) || (endsText && isShortLast(from, line))))
            continue;
        const Fitness fitness = fitnessOf(line.ratio, column_.ragged);
        const double demerits = from.demerits + demeritsOf(from, to, line, fitness, endsText);
        Candidate& known = best[fitness];
        if (demerits <= known.demerits) // of two that are alike the shorter last one
            known = {demerits, index};
    }
    active_.resize(kept);
    double least = none;
    for (const Candidate& one : best)
        least = std::min(least, one.demerits);
    if (least == none && active_.empty()) {
        if (most_ < anything)
            return false;
        best[normal] = longest;
        least = longest.demerits;
    }
    for (std::size_t fitness = 0; fitness < fitnesses; ++fitness) {
        const Candidate& one = best[fitness];
        if (one.demerits == none || one.demerits > least + unlikeNeighbours)
            continue;
        active_.push_back(static_cast<int>(nodes_.size()));
        nodes_.push_back(
            {static_cast<int>(at), static_cast<Fitness>(fitness), one.demerits, one.before});
    }
    return true;
}

std::vector<std::size_t> Search::way() const {
    const auto isWorse = [this](int a, int b) {
        return nodes_[static_cast<std::size_t>(a)].demerits <
               nodes_[static_cast<std::size_t>(b)].demerits;
    };
    std::vector<std::size_t> result;
    for (int node = *std::ranges::min_element(active_, isWorse);
         nodes_[static_cast<std::size_t>(node)].at >= 0;
         node = nodes_[static_cast<std::size_t>(node)].before)
        result.push_back(static_cast<std::size_t>(nodes_[static_cast<std::size_t>(node)].at));
    std::ranges::reverse(result);
    return result;
}

} // namespace

std::optional<std::vector<std::size_t>> bestLines(std::span<const Break> breaks,
                                                  const Column& column, double most, bool goesOn) {
    if (breaks.empty())
        return std::vector<std::size_t>{};
    return Search(breaks, column, most, goesOn).run();
}

double stretchOf(double natural, double blanks, double width) {
    return blanks > 0 ? std::max((width - natural) / blanks, -shrinkOfBlank) : 0;
}

std::size_t comparisons() { return compared; }

} // namespace typography
