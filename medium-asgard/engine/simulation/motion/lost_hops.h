// The hops that bodies make no more, since they rest instead: no run that is compared has them.
#pragma once

#include <cstddef>
#include <vector>

namespace simulation {

struct LostHop {
    double time = 0, height = 0; // how high it would have been
    std::size_t body = 0;
};

// Of each body those that are higher than all before.
class LostHops {
public:
    void add(const LostHop& hop);
    [[nodiscard]] std::vector<LostHop> upTo(double time) const; // in the order in which they came

private:
    std::vector<LostHop> hops_;
};

} // namespace simulation
