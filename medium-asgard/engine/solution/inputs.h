// What a component reads of others during one of its steps: their dense output.
//
// At the end of the step an input may restart; there, and by rounding beyond, the value before its
// event is the right one, whatever is known of what comes later.
#pragma once

#include "solution/histories.h"

#include <algorithm>
#include <span>
#include <vector>

namespace solution {

class Inputs {
public:
    Inputs(const Histories& histories, std::vector<std::size_t> unknowns)
        : histories_(histories), unknowns_(std::move(unknowns)), readers_(unknowns_.size()) {}

    [[nodiscard]] const std::vector<std::size_t>& unknowns() const { return unknowns_; }

    // From here on the times asked for lie in [from, to]. Forgets pieces, which others may have
    // moved since.
    void window(double to) {
        end_ = to;
        for (Reader& reader : readers_)
            reader.pieces.clear();
    }
    void values(double t, std::span<double> out) {
        double origin = infinity, scale = 1, s = 0; // several are often of one component
        for (std::size_t i = 0; i < readers_.size(); ++i) {
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
        for (std::size_t i = 0; i < readers_.size(); ++i)
            out[i] = at(i, t).derivative(t);
    }
    // Until another is asked for.
    [[nodiscard]] const Piece& at(std::size_t i, double t) {
        Reader& reader = readers_[i];
        if (reader.last < reader.pieces.size()) {
            const Piece& last = reader.pieces[reader.last];
            if (last.origin <= t && t <= last.until)
                return last;
        }
        // At a joint the later one.
        const auto known = std::ranges::find_if(reader.pieces, [t](const Piece& piece) {
            return piece.origin <= t && t < piece.until;
        });
        reader.last = static_cast<std::size_t>(known - reader.pieces.begin());
        if (known == reader.pieces.end())
            reader.pieces.push_back(pieceAt(i, t));
        return reader.pieces[reader.last];
    }

private:
    // A step's stages go to and fro between the pieces that it crosses.
    struct Reader {
        std::vector<Piece> pieces; // of the window, that were asked for
        std::size_t last = 0;      // of these
        std::size_t near = 0;      // the step of its history that the window begins in
    };
    [[nodiscard]] Piece pieceAt(std::size_t i, double t) {
        const std::size_t unknown = unknowns_[i];
        if (t >= end_)
            return histories_.pieceBefore(unknown, end_);
        const auto [history, column] = histories_.place(unknown, t);
        if (history->empty() || !histories_.isInOnePlace(unknown))
            return histories_.piece(unknown, t);
        const std::size_t step = history->find(t, readers_[i].near);
        if (readers_[i].pieces.empty())
            readers_[i].near = step;
        return history->piece(step, column);
    }

    const Histories& histories_;
    std::vector<std::size_t> unknowns_;
    std::vector<Reader> readers_;
    double end_ = infinity;
};

} // namespace solution
