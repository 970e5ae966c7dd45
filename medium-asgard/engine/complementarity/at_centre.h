// The force of a disc at the centre of its normal forces, and that of a slip, with what they follow
// from.
#pragma once

#include "complementarity/laws.h"

namespace complementarity {

struct AtCentre {
    AtCentre(const Law& disc, const Vector& forces);

    Vector centre, force;
    Matrix byRows;    // changes of the force with the rows of the disc
    Matrix moves;     // changes of the centre with each normal force
    Matrix byNormals; // changes of the force with each normal force
};

// The force of a slip's rows: against its velocity at the centre.
[[nodiscard]] Vector forceOf(const Law& slip, const Vector& forces);
// Its changes with each normal force. None where these pull; where they are just 0, those of a
// press.
[[nodiscard]] Matrix changesOf(const Law& slip, const Vector& forces);

} // namespace complementarity
