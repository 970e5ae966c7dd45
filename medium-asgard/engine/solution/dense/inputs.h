// The inputs of a component during one of its steps: the dense output of others.
//
// At the end of the step an input may restart; there, and by rounding beyond, the value before its
// event is the right one, whatever is known of what comes later.
#pragma once

#include "dense/histories.h"

#include <span>
#include <vector>

namespace solution {

class Inputs {
public:
    Inputs(const Histories& histories, std::vector<std::size_t> unknowns)
        : histories_(histories), unknowns_(std::move(unknowns)), places_(unknowns_.size()) {}

    [[nodiscard]] const std::vector<std::size_t>& unknowns() const { return unknowns_; }

    // From here on the times asked for lie in [from, to]. Forgets pieces, which others may have
    // moved since.
    void window(double to);
    void values(double t, std::span<double> out) {
        for (Source& source : sources()) {
            const Piece* const pieces = piecesAt(source, t);
            double scale = pieces->scale, s = (t - pieces->origin) / scale;
            for (std::size_t m = 0; m < source.members.size(); ++m) {
                const Piece& piece = pieces[m];
                if (piece.scale != scale) { // rates of a flight
                    scale = piece.scale;
                    s = (t - piece.origin) / scale;
                }
                out[source.members[m].input] = evaluate(piece.coefficients, s);
            }
        }
    }
    void rates(double t, std::span<double> out) {
        for (std::size_t i = 0; i < unknowns_.size(); ++i)
            out[i] = at(i, t).derivative(t);
    }
    // Until another is asked for.
    [[nodiscard]] const Piece& at(std::size_t i, double t) {
        Source& source = sources()[places_[i].source];
        return piecesAt(source, t)[places_[i].member];
    }

private:
    struct Member {
        std::size_t input, column;
    };
    // Inputs of one component, whose pieces begin and end together. A step's stages go to and fro
    // between those that it crosses.
    struct Source {
        const History* history; // none: its only input is, or was, in several, or has none yet
        std::vector<Member> members;
        std::vector<Piece> pieces; // of each member, for each step of it that was asked for
        std::size_t count = 0;     // of these steps
        std::size_t last = 0;      // of these
        std::size_t near = 0;      // the step that the window begins in
    };
    struct Place {
        std::size_t source = 0, member = 0;
    };
    [[nodiscard]] std::vector<Source>& sources() {
        if (!areGrouped_)
            group();
        return sources_;
    }
    [[nodiscard]] const Piece* piecesAt(Source& source, double t) {
        if (source.last < source.count) {
            const Piece* const last = source.pieces.data() + source.last * source.members.size();
            if (last->origin <= t && t <= last->until)
                return last;
        }
        return otherPiecesAt(source, t);
    }
    [[nodiscard]] const Piece* otherPiecesAt(Source& source, double t);
    void read(Source& source, double t, Piece* pieces);
    // No history: there are several, or it has no steps.
    [[nodiscard]] Histories::Place onlyPlace(std::size_t input) const;
    void group();

    const Histories& histories_;
    std::vector<std::size_t> unknowns_;
    std::vector<Source> sources_;
    std::vector<Place> places_; // of each input
    bool areGrouped_ = false;   // as histories are now
    double end_ = infinity;
};

} // namespace solution
