// Gauss' elimination of a sparse symmetric matrix, L D L', in an order that is found once.
//
// A joint couples its conditions with those of neighbouring joints alone. From the leaves of a tree
// of joints on, elimination makes no entry that was 0 another number, so that the multiplications
// are in proportion to the joints (equations/elimination_order.h). Loops leave a small dense rest.
//
// Of a positive definite matrix, as J M^-1 J' is, elimination needs no search for pivots: its
// backward error is rounding for each product (Higham, Accuracy and Stability of Numerical
// Algorithms, 2002, 10.1). A pivot that rounding alone keeps from 0 belongs to a row that those
// before it make, as the fourth corner of a face does: such a row is left out, and what it may have
// is the matrix' kernel, of which kernel() gives a basis. Any other matrix is refused.
//
// Two points of a patch that are next to each other, or three next to a line, would leave a small
// pivot and large errors: the row of a better point of the patch takes the place, which has the
// same entries.
#pragma once

#include "equations/elimination_order.h"

#include <cstdint>
#include <span>
#include <vector>

namespace solution {

class Elimination {
public:
    using Index = EliminationOrder::Index;
    using Place = EliminationOrder::Place;

    // For matrices whose entries are 0 but on the diagonal, at these places and at those that
    // mirror them. False: a factorization takes more than `most` multiplications. Then nothing is
    // planned, and what was planned before is gone.
    bool plan(std::size_t size, std::span<const Place> places, double most);
    // Of each row the patch whose point it is, or `noPatch`. The rows of one patch are those of
    // three of them, but for a small tilt, whose square a further pivot is: it counts as none.
    static constexpr Index noPatch = 0xffffffff;
    // plan() forgets them.
    void setPatches(std::span<const Index> patches);
    // Multiplications of one factorization, but one for each entry of L.
    [[nodiscard]] std::size_t multiplications() const { return targets_.size(); }

    // The index of an entry among values().
    [[nodiscard]] Index indexOf(Place place) const;
    // Of the matrix, before it is factorised.
    [[nodiscard]] std::span<double> values() { return values_; }
    // Of values(). False: the matrix is refused; so is one that is singular where it is to be
    // regular.
    enum class Take { regular, all };
    [[nodiscard]] bool factorise(Take take = Take::regular);
    // Rows that others make, in the order of elimination.
    [[nodiscard]] std::span<const Index> dependent() const { return dependent_; }
    // Puts the solution in the place of the right-hand side; 0 for rows that others make.
    void solve(std::span<double> x);
    // Puts in x what the matrix makes 0: 1 for this of the rows that others make, 0 for the rest of
    // them.
    void kernel(std::size_t which, std::span<double> x);

private:
    void layOut(std::span<const std::vector<Index>> below);
    [[nodiscard]] bool isSymmetric() const;
    // In the place of the pivot: its inverse; of a row that others make 0.
    double invert(std::size_t rank, bool isNone);
    [[nodiscard]] double leastOf(std::size_t rank) const;
    void takeBetterMate(std::size_t rank);
    [[nodiscard]] bool areAlike(std::size_t rank, std::size_t mate);
    [[nodiscard]] double* entry(std::size_t rank, std::size_t other);
    void substituteBack();

    // By rank, the order in which rows are eliminated; a row's `below` are the later ranks where
    // its entries may be another number than 0: firstBelow_[rank] to firstBelow_[rank + 1].
    std::vector<Index> rowOf_, rankOf_, firstBelow_, below_;
    // For each row and each two of its `below`, the entry that they change: of the last one with
    // all up to it, then of the one before.
    std::vector<Index> targets_;
    std::vector<double>
        values_;              // diagonal; then what is below it by columns; what is above by rows
    std::vector<double> own_; // the diagonal, before it is factorised
    std::vector<double> ordered_;
    std::vector<Index> order_; // rowOf_, with rows of a patch exchanged
    // By rank, the earlier ranks of the same patch; empty: no row has one.
    std::vector<std::vector<Index>> mates_;
    std::vector<Index> dependent_;
};

} // namespace solution
