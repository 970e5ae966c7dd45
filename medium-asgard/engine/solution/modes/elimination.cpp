#include "modes/elimination.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace solution {
namespace {

constexpr double leastPivot = 1e-10; // of the diagonal; less may be what rounding leaves of 0
constexpr double differing = 1e-11;  // of the diagonal; mirrored entries do by rounding

} // namespace

bool Elimination::plan(std::size_t size, std::span<const Place> places, double most) {
    std::vector<std::vector<Index>> next(size); // of each row, in order
    for (const auto& [row, column] : places)
        if (row != column) {
            next[row].push_back(column);
            next[column].push_back(row);
        }
    for (std::vector<Index>& of : next) {
        std::ranges::sort(of);
        of.erase(std::unique(of.begin(), of.end()), of.end());
    }
    rowOf_.clear();
    rankOf_.assign(size, 0);
    std::vector<char> isDone(size, 0);
    std::vector<Index> joined;
    double multiplications = 0;
    while (rowOf_.size() < size) {
        std::size_t least = size;
        for (std::size_t row = 0; row < size; ++row)
            if (isDone[row] == 0 && (least == size || next[row].size() < next[least].size()))
                least = row;
        const auto count = static_cast<double>(next[least].size());
        multiplications += count * (count + 1) / 2;
        if (multiplications > most)
            return false;
        rankOf_[least] = static_cast<Index>(rowOf_.size());
        rowOf_.push_back(static_cast<Index>(least));
        isDone[least] = 1;
        for (const Index row : next[least]) {
            joined.clear();
            std::ranges::set_union(next[row], next[least], std::back_inserter(joined));
            std::erase_if(joined, [&](Index i) { return i == row || i == least; });
            next[row] = joined;
        }
    }
    layOut(next);
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

bool Elimination::factorise() {
    if (!isSymmetric())
        return false;
    const std::size_t size = rowOf_.size();
    double* const values = values_.data();
    double* const lower = values + size;
    const Index* target = targets_.data();
    std::copy_n(values, size, own_.data());
    for (std::size_t rank = 0; rank < size; ++rank) {
        const double pivot = values[rank];
        if (!(pivot > leastPivot * own_[rank]))
            return false;
        const double inverse = 1 / pivot;
        values[rank] = inverse;
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
    const double* const inverse = values_.data();
    const double* const lower = inverse + size;
    const Index* const below = below_.data();
    double* const y = ordered_.data();
    for (std::size_t rank = 0; rank < size; ++rank)
        y[rank] = x[rowOf_[rank]];
    for (std::size_t rank = 0; rank < size; ++rank) {
        const double known = y[rank];
        for (Index a = firstBelow_[rank]; a < firstBelow_[rank + 1]; ++a)
            y[below[a]] -= lower[a] * known;
        y[rank] = known * inverse[rank];
    }
    for (std::size_t rank = size; rank-- > 0;) {
        double known = y[rank];
        for (Index a = firstBelow_[rank]; a < firstBelow_[rank + 1]; ++a)
            known -= lower[a] * y[below[a]];
        y[rank] = known;
        x[rowOf_[rank]] = known;
    }
}

} // namespace solution
