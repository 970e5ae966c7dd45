// What a component reads of others during one of its steps: their dense output.
//
// At the end of the step an input may restart; there, and by rounding beyond, the value before its
// event is the right one, whatever is known of what comes later.
#pragma once

#include "solution/histories.h"

#include <span>
#include <vector>

namespace solution {

class Inputs {
public:
    Inputs(const Histories& histories, std::vector<std::size_t> unknowns)
        : histories_(histories), unknowns_(std::move(unknowns)), pieces_(unknowns_.size()) {}

    [[nodiscard]] const std::vector<std::size_t>& unknowns() const { return unknowns_; }

    // From here on the times asked for lie in [from, to]. Forgets pieces, which others may have
    // moved since.
    void window(double to) {
        end_ = to;
        std::fill(pieces_.begin(), pieces_.end(), Piece{infinity, -infinity, 1, {}});
    }
    void values(double t, std::span<double> out) {
        double origin = infinity, scale = 1, s = 0; // several are often of one component
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            const Piece& piece = at(i, t);
            if (piece.origin != origin || piece.scale != scale) {
                origin = piece.origin;
                scale = piece.scale;
                s = (t - origin) / scale;
            }
            out[i] = evaluate(piece.coefficients, s);
        }
    }
    void rates(double t, std::span<double> out) {
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            out[i] = at(i, t).derivative(t);
    }
    [[nodiscard]] const Piece& at(std::size_t i, double t) {
        Piece& piece = pieces_[i];
        if (t < piece.origin || t > piece.until)
            piece = t >= end_ ? histories_.pieceBefore(unknowns_[i], end_)
                              : histories_.piece(unknowns_[i], t);
        return piece;
    }

private:
    const Histories& histories_;
    std::vector<std::size_t> unknowns_;
    std::vector<Piece> pieces_;
    double end_ = infinity;
};

} // namespace solution
