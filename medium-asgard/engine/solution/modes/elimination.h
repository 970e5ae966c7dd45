// Gauss' elimination of a sparse matrix, without a search for pivots, in an order that is found
// once.
//
// A joint couples its conditions with those of neighbouring joints alone. From the leaves of a tree
// of joints on, elimination makes no entry that was 0 another number (Featherstone, Rigid Body
// Dynamics Algorithms, 2008, 8.5), so that the multiplications are in proportion to the joints.
// Loops leave a small dense rest.
//
// The order is that of least degree (Tinney and Walker, Proc. IEEE 55, 1967), the first of equals.
// It asks for no pivots where the matrix is symmetric and positive definite, as J M^-1 J' is. Of
// any other matrix factorise() says whether it may be trusted: with all products l u at most
// `growth` its backward error is at most that many times rounding for each of them (Higham,
// Accuracy and Stability of Numerical Algorithms, 2002, 9.3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace solution {

class Elimination {
public:
    using Index = std::uint32_t;
    struct Place {
        Index row, column;
    };

    // For matrices whose entries of the diagonal are about 1, or 0, and whose others are 0 but at
    // these places and at those that mirror them. False: a factorization takes more than `most`
    // multiplications. Then nothing is planned.
    bool plan(std::size_t size, std::span<const Place> places, double most);
    // Multiplications of one factorization; divisions are not counted.
    [[nodiscard]] std::size_t multiplications() const { return targets_.size(); }

    // The index of an entry among values().
    [[nodiscard]] Index indexOf(Place place) const;
    // Of the matrix, before it is factorised.
    [[nodiscard]] std::span<double> values() { return values_; }
    // Of values(). False: the matrix may be singular, or elimination needs a search for pivots.
    [[nodiscard]] bool factorise();
    // Puts the solution in the place of the right-hand side.
    void solve(std::span<double> x);

private:
    void layOut(std::span<const std::vector<Index>> below);

    // By rank, the order in which rows are eliminated; a row's `below` are the later ranks where
    // its entries may be another number than 0: firstBelow_[rank] to firstBelow_[rank + 1].
    std::vector<Index> rowOf_, rankOf_, firstBelow_, below_;
    // For each row and each two of its `below`, the entry that they change.
    std::vector<Index> targets_;
    std::vector<double> values_; // diagonal; L by columns; U by rows
    std::vector<double> ordered_;
};

} // namespace solution
