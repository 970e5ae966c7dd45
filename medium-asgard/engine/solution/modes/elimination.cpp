#include "modes/elimination.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace solution {
namespace {

// Of the diagonal:
constexpr double rounding = 1e-13;   // less is that
constexpr double ofContacts = 1e-10; // less is no pivot, where rows that others make are expected
constexpr double ofTilt = 1e-7;      // less is a patch's tilt, where three of its rows are done
constexpr double ofLine = 1e-10;     // less is that of three points in a line
constexpr double narrow = 1e-3;      // less is better taken from another row of the patch,
constexpr double better = 10;        // ... one that has as many times more
constexpr double differing = 1e-11;  // mirrored entries do by rounding

} // namespace

bool Elimination::plan(std::size_t size, std::span<const Place> places, double most) {
    *this = {};
    const auto order = eliminationOrder(size, places, most);
    if (!order)
        return false;
    rowOf_ = order->rows;
    rankOf_.resize(size);
    for (std::size_t rank = 0; rank < size; ++rank)
        rankOf_[rowOf_[rank]] = static_cast<Index>(rank);
    layOut(order->later);
    return true;
}

void Elimination::layOut(std::span<const std::vector<Index>> below) {
    firstBelow_.assign(1, 0);
    below_.clear();
    for (const Index row : rowOf_) {
        const auto first = static_cast<std::ptrdiff_t>(below_.size());
        for (const Index other : below[row])
            below_.push_back(rankOf_[other]);
        std::sort(below_.begin() + first, below_.end());
        firstBelow_.push_back(static_cast<Index>(below_.size()));
    }
    values_.assign(rowOf_.size() + 2 * below_.size(), 0);
    targets_.clear();
    for (std::size_t rank = 0; rank < rowOf_.size(); ++rank)
        for (Index a = firstBelow_[rank + 1]; a-- > firstBelow_[rank];)
            for (Index b = firstBelow_[rank]; b <= a; ++b)
                targets_.push_back(indexOf({rowOf_[below_[a]], rowOf_[below_[b]]}));
    own_.resize(rowOf_.size());
    ordered_.resize(rowOf_.size());
}

Elimination::Index Elimination::indexOf(Place place) const {
    const Index row = rankOf_[place.row], column = rankOf_[place.column];
    if (row == column)
        return row;
    const Index first = std::min(row, column), last = std::max(row, column);
    const auto begin = below_.begin() + firstBelow_[first],
               end = below_.begin() + firstBelow_[first + 1];
    const auto at = std::lower_bound(begin, end, last);
    assert(at != end && *at == last);
    const std::size_t part = rowOf_.size() + (row < column ? below_.size() : 0);
    return static_cast<Index>(part + static_cast<std::size_t>(at - below_.begin()));
}

bool Elimination::isSymmetric() const {
    const std::size_t size = rowOf_.size(), entries = below_.size();
    const double* const lower = values_.data() + size;
    const double* const upper = lower + entries;
    for (std::size_t rank = 0; rank < size; ++rank)
        for (Index a = firstBelow_[rank]; a < firstBelow_[rank + 1]; ++a) {
            const double difference = lower[a] - upper[a];
            if (!(difference * difference <=
                  differing * differing * values_[rank] * values_[below_[a]]))
                return false;
        }
    return true;
}

void Elimination::setPatches(std::span<const Index> patches) {
    mates_.assign(rowOf_.size(), {});
    for (std::size_t rank = 0; rank < rowOf_.size(); ++rank)
        for (std::size_t before = 0; before < rank && patches[rowOf_[rank]] != noPatch; ++before)
            if (patches[rowOf_[before]] == patches[rowOf_[rank]])
                mates_[rank].push_back(static_cast<Index>(before));
}

// A pivot that is less is none. Of rows that others make `values_` has 0.
double Elimination::leastOf(std::size_t rank) const {
    if (mates_.empty() || mates_[rank].size() < 2)
        return rounding;
    const auto done =
        std::ranges::count_if(mates_[rank], [this](Index mate) { return values_[mate] != 0; });
    return done >= 3 ? ofTilt : done == 2 ? ofLine : rounding;
}

// Below the diagonal; none where the matrix has 0.
double* Elimination::entry(std::size_t rank, std::size_t other) {
    const auto [first, last] = std::minmax(rank, other);
    const auto begin = below_.begin() + firstBelow_[first],
               end = below_.begin() + firstBelow_[first + 1];
    const auto at = std::lower_bound(begin, end, static_cast<Index>(last));
    if (at == end || *at != last)
        return nullptr;
    return values_.data() + rowOf_.size() + (at - below_.begin());
}

bool Elimination::areAlike(std::size_t rank, std::size_t mate) {
    for (std::size_t other = 0; other < rowOf_.size(); ++other)
        if (other != rank && other != mate && !entry(rank, other) != !entry(mate, other))
            return false;
    return true;
}

void Elimination::takeBetterMate(std::size_t rank) {
    std::size_t best = rank;
    double most = better * values_[rank] / own_[rank];
    for (std::size_t mate = rank + 1; mate < rowOf_.size(); ++mate)
        if (std::ranges::find(mates_[mate], rank) != mates_[mate].end() &&
            values_[mate] / own_[mate] > most && areAlike(rank, mate)) {
            best = mate;
            most = values_[mate] / own_[mate];
        }
    if (best == rank)
        return;
    std::swap(order_[rank], order_[best]);
    std::swap(values_[rank], values_[best]);
    std::swap(own_[rank], own_[best]);
    for (std::size_t other = 0; other < rowOf_.size(); ++other)
        if (other != rank && other != best && entry(rank, other))
            std::swap(*entry(rank, other), *entry(best, other));
}

double Elimination::invert(std::size_t rank, bool isNone) {
    if (isNone)
        dependent_.push_back(static_cast<Index>(rank));
    return values_[rank] = isNone ? 0 : 1 / values_[rank];
}

bool Elimination::factorise(Take take) {
    const std::size_t size = rowOf_.size();
    std::copy_n(values_.data(), size, own_.data());
    dependent_.clear();
    order_ = rowOf_;
    if (!isSymmetric())
        return false;
    double* const values = values_.data();
    double* const lower = values + size;
    const Index* target = targets_.data();
    const double least = take == Take::all ? ofContacts : leastPivot;
    for (std::size_t rank = 0; rank < size; ++rank) {
        if (take == Take::all && !mates_.empty() && values[rank] <= narrow * own_[rank])
            takeBetterMate(rank);
        const double pivot = values[rank];
        const bool isNone = take == Take::all && std::abs(pivot) <= leastOf(rank) * own_[rank];
        if (!isNone && !(pivot > least * own_[rank]))
            return false;
        const double inverse = invert(rank, isNone);
        const Index begin = firstBelow_[rank];
        for (Index a = firstBelow_[rank + 1]; a-- > begin;) {
            const double l = lower[a] * inverse;
            for (Index b = begin; b <= a; ++b)
                values[*target++] -= l * lower[b];
            lower[a] = l;
        }
    }
    return true;
}

void Elimination::solve(std::span<double> x) {
    const std::size_t size = rowOf_.size();
    const double* const lower = values_.data() + size;
    double* const y = ordered_.data();
    for (std::size_t rank = 0; rank < size; ++rank)
        y[rank] = x[order_[rank]];
    for (const Index rank : dependent_)
        y[rank] = 0;
    for (std::size_t rank = 0; rank < size; ++rank)
        for (Index a = firstBelow_[rank]; a < firstBelow_[rank + 1]; ++a)
            y[below_[a]] -= lower[a] * y[rank];
    for (const Index rank : dependent_)
        y[rank] = 0;
    substituteBack();
    for (std::size_t rank = 0; rank < size; ++rank)
        x[order_[rank]] = y[rank];
}

// Of rows that others make, `ordered_` has their value already, and `values_` has 0.
void Elimination::substituteBack() {
    const std::size_t size = rowOf_.size();
    const double* const inverse = values_.data();
    const double* const lower = inverse + size;
    double* const y = ordered_.data();
    auto left = dependent_.rbegin();
    for (std::size_t rank = size; rank-- > 0;) {
        if (left != dependent_.rend() && *left == rank) {
            ++left;
            continue;
        }
        y[rank] *= inverse[rank];
        for (Index a = firstBelow_[rank]; a < firstBelow_[rank + 1]; ++a)
            y[rank] -= lower[a] * y[below_[a]];
    }
}

void Elimination::kernel(std::size_t which, std::span<double> x) {
    const std::size_t size = rowOf_.size(), own = dependent_[which];
    double* const y = ordered_.data();
    std::fill_n(y, size, 0);
    y[own] = 1;
    substituteBack();
    for (std::size_t rank = 0; rank < size; ++rank)
        x[order_[rank]] = y[rank];
}

} // namespace solution
