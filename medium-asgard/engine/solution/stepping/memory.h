// What do later steps depend on besides the values, and what was it at earlier times?
#pragma once

#include "integrators/error_control.h"
#include "integrators/method_choice.h"

#include <cstddef>
#include <vector>

namespace solution {

class Memory {
public:
    struct State {
        std::vector<std::size_t> phases; // in force, of each unknown
        ErrorControl control;
        MethodChoice choice;
    };
    State now;

    // A checkpoint: what is now can be had again by going back to t or later.
    void keep(double t) { kept_.push_back({t, now}); }
    struct Checkpoint {
        double time;
        State state;
    };
    // The last checkpoint that is not after t; later ones go.
    const Checkpoint& backTo(double t);
    [[nodiscard]] std::size_t keptBefore(double t) const;

private:
    std::vector<Checkpoint> kept_;
};

} // namespace solution
