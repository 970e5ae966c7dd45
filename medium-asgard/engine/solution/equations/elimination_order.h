// In which order rows of a sparse symmetric matrix are eliminated, and which entries that makes.
//
// The order is that of least degree (Tinney and Walker, Proc. IEEE 55, 1967): of a tree of joints
// from its leaves on, where no entry that was 0 becomes another number (Featherstone, Rigid Body
// Dynamics Algorithms, 2008, 8.5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace solution {

// A pivot that is less, of what the diagonal had, may be what rounding leaves of 0, or what places
// off their conditions, as those within a step, make of it.
inline constexpr double leastPivot = 1e-6;

struct EliminationOrder {
    using Index = std::uint32_t;
    struct Place {
        Index row, column;
    };
    std::vector<Index> rows; // in this order
    // Of each row, the later ones in whose column it has an entry, in order of their numbers.
    std::vector<std::vector<Index>> later;
    std::size_t multiplications = 0; // of one factorization, but one for each entry below
};

// Of rows of the same degree comes the first, or the one that waits for the fewest others in turn:
// so a chain is eliminated from both ends at once.
enum class AmongEquals : std::uint8_t { first, waitsLeast };

// Of matrices whose entries are 0 but on the diagonal, at these places and at those that mirror
// them. None: a factorization takes more than `most` multiplications.
[[nodiscard]] std::optional<EliminationOrder>
eliminationOrder(std::size_t size, std::span<const EliminationOrder::Place> places, double most,
                 AmongEquals among = AmongEquals::first);

// The multiplications beyond which a dense factorization of that size costs less.
[[nodiscard]] double worthEliminating(std::size_t size);

} // namespace solution
